#include "base/error.h"

#include <gtest/gtest.h>

namespace wedgesim {
namespace {

TEST(InputError, SaysPlaceProblemAndExpectation) {
  const InputError error("scene.toml:7", "unknown key 'widht'", "one of: width, height");
  EXPECT_STREQ(error.what(), "scene.toml:7: unknown key 'widht'; expected one of: width, height");
}

TEST(InputError, NeedsNoExpectation) {
  EXPECT_STREQ(InputError("--size", "is empty").what(), "--size: is empty");
}

TEST(InputError, IsNoBrokenInvariant) {
  // The command tells the two apart: exit code 2 is the user's, anything else is ours.
  try {
    throw InputError("a", "b");
  } catch (const std::logic_error&) {
    FAIL() << "an InputError was taken for a CheckError";
  } catch (const std::runtime_error&) {
  }
}

}  // namespace
}  // namespace wedgesim
