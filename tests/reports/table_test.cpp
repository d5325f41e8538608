#include "reports/table.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace wedgesim::reports {
namespace {

TEST(Table, AlignsColumns) {
  Table table;
  table.add_column("name", Table::Align::left);
  table.add_column("n", Table::Align::right);
  table.add_row({"a", "1"});
  table.add_row({"longer", "123"});
  EXPECT_EQ(table.text(),
            "name      n\n"
            "-----------\n"
            "a         1\n"
            "longer  123\n");
}

TEST(Table, IndentsAndRules) {
  Table table;
  table.add_column("x", Table::Align::left);
  table.add_row({"1"});
  table.add_rule();
  table.add_row({"2"});
  EXPECT_EQ(table.text(2), "  x\n  -\n  1\n  -\n  2\n");
}

TEST(Table, GroupsStandOverTheirColumns) {
  Table table;
  table.add_column("", Table::Align::left);
  table.add_column("a", Table::Align::right, "first");
  table.add_column("b", Table::Align::right);
  table.add_column("c", Table::Align::right, "second");
  table.add_row({"row", "1", "2", "3"});
  EXPECT_EQ(table.text(),
            "      first   second\n"
            "       a  b        c\n"
            "--------------------\n"
            "row    1  2        3\n");
}

TEST(Table, MissingCellsAreBlankWithoutTrailingSpace) {
  Table table;
  table.add_column("a", Table::Align::left);
  table.add_column("bbb", Table::Align::left);
  table.add_row({"x"});
  EXPECT_EQ(table.text(), "a  bbb\n------\nx\n");
}

TEST(Table, MoreCellsThanColumnsAreABug) {
  Table table;
  table.add_column("a", Table::Align::left);
  EXPECT_THROW(table.add_row({"1", "2"}), CheckError);
}

TEST(Grouped, SeparatesThousands) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(123456), "123,456");
  EXPECT_EQ(grouped(18446744073709551615U), "18,446,744,073,709,551,615");
}

}  // namespace
}  // namespace wedgesim::reports
