#include "base/toml_table.h"

#include <gtest/gtest.h>

#include "tests/support/expect_input_error.h"

namespace wedgesim {
namespace {

/// What reading `text` with `read` says.
template <typename Read>
std::string error_of(const std::string& text, const Read& read) {
  return input_error_of([&] {
    const toml::table root = parse_toml(text, "a.toml");
    const TomlTable table(root, "a.toml");
    read(table);
    table.reject_unknown();
  });
}

TEST(TomlTable, ReadsWhatIsThere) {
  const std::string text =
      "n = 3\nx = 2\nf = 1.5\nb = true\ns = 'text'\nv = [1, 2.5, 3]\n"
      "l = [[1, 2], [3, 4]]\n[t]\nk = 1\n[[a]]\nk = 1\n[[a]]\nk = 2\n";
  EXPECT_EQ(error_of(text,
                     [](const TomlTable& table) {
                       EXPECT_EQ(table.integer("n"), 3);
                       EXPECT_EQ(table.number("x"), 2.0);
                       EXPECT_EQ(table.number("f"), 1.5);
                       EXPECT_TRUE(table.boolean("b"));
                       EXPECT_EQ(table.text("s"), "text");
                       EXPECT_EQ(table.vec3("v"), glm::dvec3(1.0, 2.5, 3.0));
                       EXPECT_EQ(table.vec2_list("l")[1], glm::dvec2(3.0, 4.0));
                       EXPECT_EQ(table.table("t").integer("k"), 1);
                       EXPECT_EQ(table.tables("a")[1].integer("k"), 2);
                       EXPECT_EQ(table.number("missing", 7.0), 7.0);
                       EXPECT_EQ(table.vec3("also", glm::dvec3(1.0)), glm::dvec3(1.0));
                       EXPECT_TRUE(table.tables("none").empty());
                       EXPECT_EQ(table.one_or_more_tables("a").size(), 2U);
                     }),
            "");
}

TEST(TomlTable, UnknownKeyIsNamedWithItsLine) {
  EXPECT_EQ(error_of("size = 1\n\nzzz = 2\nsise = 2\n",
                     [](const TomlTable& table) {
                       table.number("size");
                       table.number("height", 1.0);
                     }),
            "a.toml:3: unknown key 'zzz'; expected one of size, height");
}

TEST(TomlTable, EveryMistakeHasItsLine) {
  const auto number = [](const TomlTable& t) { t.number("x", {}, {0.0, 2.0}); };
  EXPECT_EQ(error_of("\nx = 'a'", number), "a.toml:2: 'x' is not a number; expected a number");
  EXPECT_EQ(error_of("x = 3", number), "a.toml:1: 'x' is 3; expected a number from 0 to 2");
  EXPECT_EQ(error_of("x = nan", number), "a.toml:1: 'x' is nan; expected a number from 0 to 2");
  EXPECT_EQ(error_of("y = 1", number), "a.toml:1: 'x' is missing; expected a number");
  EXPECT_EQ(error_of("x = inf", [](const TomlTable& t) { t.number("x"); }),
            "a.toml:1: 'x' is inf; expected a finite number");
  EXPECT_EQ(error_of("x = 1.5", [](const TomlTable& t) { t.integer("x"); }),
            "a.toml:1: 'x' is not an integer; expected an integer");
  EXPECT_EQ(error_of("x = 9", [](const TomlTable& t) { t.integer("x", {}, 1, 8); }),
            "a.toml:1: 'x' is 9; expected an integer from 1 to 8");
  EXPECT_EQ(error_of("x = 1", [](const TomlTable& t) { t.boolean("x"); }),
            "a.toml:1: 'x' is not a boolean; expected true or false");
  EXPECT_EQ(error_of("x = 1", [](const TomlTable& t) { t.text("x"); }),
            "a.toml:1: 'x' is not a string; expected a string");
  EXPECT_EQ(error_of("x = [1, 2]", [](const TomlTable& t) { t.vec3("x"); }),
            "a.toml:1: 'x' is not an array of 3 numbers; expected an array of 3 numbers");
  EXPECT_EQ(error_of("x = [1,\n 'b', 3]", [](const TomlTable& t) { t.vec3("x"); }),
            "a.toml:2: 'x' is not a number; expected an array of 3 numbers");
  EXPECT_EQ(error_of("x = 1", [](const TomlTable& t) { t.table("x"); }),
            "a.toml:1: 'x' is not a table; expected a table [x]");
  EXPECT_EQ(error_of("x = [1]", [](const TomlTable& t) { t.tables("x"); }),
            "a.toml:1: 'x' is not an array of tables; expected tables [[x]]");
}

TEST(TomlTable, TextThatIsNotTomlHasItsLine) {
  const std::string error = error_of("a = 1\nb = = 2\n", [](const TomlTable&) {});
  EXPECT_EQ(error.substr(0, 9), "a.toml:2:") << error;
}

}  // namespace
}  // namespace wedgesim
