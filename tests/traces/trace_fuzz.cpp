// libFuzzer target of the trace reader: any bytes are either a sound trace, which can then be
// walked to its end, or one InputError; never a crash. How to run it: docs/trace.md, "Fuzzing".
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <span>
#include <streambuf>
#include <vector>

#include "base/error.h"
#include "traces/dump.h"
#include "traces/format.h"
#include "traces/reader.h"
#include "traces/record.h"
#include "traces/writer.h"

namespace wedgesim::traces {
namespace {

// Takes everything and keeps nothing.
class NullBuffer final : public std::streambuf {
 protected:
  int overflow(int c) override { return c == EOF ? 0 : c; }
  std::streamsize xsputn(const char*, std::streamsize n) override { return n; }
};

template <typename T>
std::uint64_t sum_bytes(std::span<const T> table) {
  std::uint64_t sum = 0;
  for (const std::byte b : std::as_bytes(table)) sum += std::to_integer<std::uint64_t>(b);
  return sum;
}

// Touches every byte and follows every reference.
std::uint64_t walk(const TraceView& trace) {
  std::uint64_t sum = sum_bytes(trace.vertices) + sum_bytes(trace.indices) +
                      sum_bytes(trace.planes) + sum_bytes(trace.faces) + sum_bytes(trace.wedges) +
                      sum_bytes(trace.umbra_polygons) + sum_bytes(trace.depth) +
                      sum_bytes(trace.expected_li) + sum_bytes(trace.li_sensitivity);
  for (std::uint32_t i = 0; i < trace.wedges.size(); ++i) sum += wedge_record_bytes(trace, i);
  NullBuffer nowhere;
  std::ostream out(&nowhere);
  dump_json(out, trace);
  dump_obj(out, trace);
  return sum + summary(trace).size();
}

void read(std::span<const std::byte> file) {
  try {
    const TraceView view = view_of(file, "fuzz");
    volatile const std::uint64_t keep = walk(view);
    static_cast<void>(keep);
  } catch (const InputError&) {
    // The right answer to most inputs.
  }
}

// Memory of exactly this size, aligned as a mapped file is, so that sanitizers see its end.
class AlignedCopy {
 public:
  explicit AlignedCopy(std::span<const std::byte> bytes)
      : data_(static_cast<std::byte*>(
            ::operator new (bytes.size(), std::align_val_t{kPayloadAlignment}))),
        bytes_(data_, bytes.size()) {
    if (!bytes.empty()) std::memcpy(data_, bytes.data(), bytes.size());
  }
  AlignedCopy(const AlignedCopy&) = delete;
  AlignedCopy& operator=(const AlignedCopy&) = delete;
  ~AlignedCopy() { ::operator delete (data_, std::align_val_t{kPayloadAlignment}); }

  std::span<std::byte> bytes() { return bytes_; }

 private:
  std::byte* data_;
  std::span<std::byte> bytes_;
};

}  // namespace

void fuzz(std::span<const std::byte> input) {
  AlignedCopy file(input);
  read(file.bytes());
  if (input.size() < sizeof(FileHeader)) return;
  // The same with a right header, so that the payload's verifiers are reached.
  FileHeader header;
  const auto payload = file.bytes().subspan(sizeof header);
  header.payload_bytes = payload.size();
  header.checksum = checksum_of(payload);
  std::memcpy(file.bytes().data(), &header, sizeof header);
  read(file.bytes());
}

}  // namespace wedgesim::traces

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  wedgesim::traces::fuzz(std::as_bytes(std::span(data, size)));
  return 0;
}
