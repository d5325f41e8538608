#include "model/datapath/formats.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/file.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::model::datapath {
namespace {

class FormatsFile : public testing::Test {
 protected:
  ~FormatsFile() override { std::filesystem::remove(file_); }

  Formats read(std::string_view text) {
    write_file(file_, text);
    return read_formats(file_);
  }
  std::string error(std::string_view text) {
    return input_error_of([&] { read(text); });
  }

  const std::filesystem::path file_ =
      std::filesystem::path(testing::TempDir()) / "wedgesim_formats_test.toml";
};

TEST_F(FormatsFile, ChangesOnlyWhatItNames) {
  const Formats formats = read("li_fraction_bits = 14\nform_bits = 40\n");
  EXPECT_EQ(formats.li.fraction_bits, 14);
  EXPECT_EQ(formats.form_bits, 40);
  EXPECT_EQ(formats.significand_bits, Formats{}.significand_bits);
}

TEST_F(FormatsFile, SaysWhichKeyIsWrongAndWhatItMayBe) {
  EXPECT_NE(error("li_bits = 3\n").find(":1: unknown key 'li_bits'; expected one of form_bits"),
            std::string::npos)
      << error("li_bits = 3\n");
  EXPECT_NE(error("\nsignificand_bits = 26\n").find("8"), std::string::npos);
  EXPECT_NE(error("form_bits = 'x'\n").find("form_bits"), std::string::npos);
  EXPECT_NE(input_error_of([] { read_formats("no_such_file.toml"); }), "");
}

TEST(Widths, HoldTheDefaults) {
  Formats formats;
  for (const Width& width : kWidths) {
    EXPECT_GE(width.of(formats), width.low) << width.key;
    EXPECT_LE(width.of(formats), width.high) << width.key;
  }
}

}  // namespace
}  // namespace wedgesim::model::datapath
