#include "functional/scene/off_indices.h"

#include <gtest/gtest.h>

#include <fstream>

#include "functional/scene/mesh_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::functional {
namespace {

struct OffIndices : testing::Test {
  TemporaryFolder folder;
  std::filesystem::path path = folder / "a.off";
  std::string error_of(const std::string& text) const {
    std::ofstream(path) << text;
    return input_error_of([this] { check_off_indices(path); });
  }
  std::string refused(const std::string& what) const { return path.string() + ": " + what; }
};

TEST_F(OffIndices, TheFirstOutOfRangeIsNamed) {
  const std::string start = "OFF\n3 2 3\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(error_of(start + "3 0 1 2\n3 2 1 0\n"), "");
  EXPECT_EQ(error_of(start + "3 0 1 2\n3 2 3 9\n"), refused("face 1: index 3; expected 0..2"));
  EXPECT_EQ(error_of(start + "3 0 -1 2\n3 2 1 0\n"), refused("face 0: index -1; expected 0..2"));
}

TEST_F(OffIndices, CommentsColoursAndMissingNamesAreRead) {
  const std::string bad = refused("face 0: index 7; expected 0..2");
  EXPECT_EQ(error_of("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"), bad);
  EXPECT_EQ(error_of("3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"), bad);
  EXPECT_EQ(error_of("COFF\r\n# c\n\n3 1 0\n0 0 0 9 9 9\n1 0 0 9 9 9 # c\n0 1 0 9 9 9\n"
                     "3 0 1 7 255 255 255\n"),
            bad);
  EXPECT_EQ(error_of("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 255 255\n"), "");
}

TEST_F(OffIndices, OtherDamageIsLeftToTheReader) {
  for (const char* text : {"", "OFF", "OFF\n3", "OFF\n3 1 0\n0 0 0\n", "junk\njunk\n",
                           "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0\n"}) {
    EXPECT_EQ(error_of(text), "") << text;
  }
}

TEST_F(OffIndices, AreLookedAtWhenAMeshIsLoaded) {
  std::ofstream(path) << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n";
  EXPECT_EQ(input_error_of([this] { load_mesh(path); }), refused("face 0: index 7; expected 0..2"));
}

}  // namespace
}  // namespace wedgesim::functional
