// Writes small traces into a folder: the fuzzer's first corpus.
#include <filesystem>
#include <string>

#include "tests/traces/sample.h"
#include "traces/writer.h"

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const std::filesystem::path folder = arguments[1];
  wedgesim::traces::write_trace(folder / "sample.wtrace", wedgesim::traces::sample_trace());
  for (unsigned seed = 0; seed < 24; ++seed) {
    wedgesim::traces::write_trace(folder / ("random" + std::to_string(seed) + ".wtrace"),
                                  wedgesim::traces::random_trace(seed));
  }
}
