// Does the page's script get every value, and each shared one only once?
#include "reports/page/page_data.h"

#include <gtest/gtest.h>

#include "tests/reports/page/sample.h"

namespace wedgesim::reports::page {
namespace {

Json data_of(const Results& results, std::vector<HeatMap> maps = {}) {
  const Columns columns(results);
  return page_data({results, std::move(maps), {}, {}, {}}, columns, make_charts(columns));
}

const Json& column(const Json& data, const std::string& key) {
  for (const Json& one : data["columns"]) {
    if (one["key"] == key) return one;
  }
  throw std::out_of_range(key);
}

TEST(PageData, SharedValuesAreStoredOnce) {
  const Results results = tests::counted_results();
  const Json data = data_of(results);
  EXPECT_EQ(column(data, "block.accept")["all"], "none");
  EXPECT_FALSE(column(data, "block.accept").contains("values"));
  EXPECT_EQ(column(data, "block.mode")["words"], Json({"three-pass", "single-pass"}));
  EXPECT_EQ(column(data, "block.mode")["at"].size(), results.points.size());
}

TEST(PageData, NumbersAreThoseOfThePoints) {
  const Results results = tests::counted_results();
  const Json data = data_of(results);
  const Json& reads = column(data, "z_reads")["values"];
  for (const std::size_t i : {0U, 100U, 200U}) {
    EXPECT_EQ(reads[i], std::get<std::int64_t>(results.points[i].metrics.at("z_reads")));
  }
  EXPECT_TRUE(reads.back().is_null());  // crashed
  EXPECT_EQ(column(data, "state")["words"], Json({"done", "crashed"}));
}

TEST(PageData, TheTableShowsWhatDiffers) {
  const Results results = tests::timed_results();
  const Json table = data_of(results)["table"];
  const auto has = [&table](const char* key) {
    return std::ranges::find(table, Json(key)) != table.end();
  };
  EXPECT_TRUE(has("memory.dram.preset"));
  EXPECT_TRUE(has("memory.dram.banks"));  // no axis, but it differs
  EXPECT_FALSE(has("block.accept"));
  EXPECT_TRUE(has("cycles"));
}

TEST(PageData, OfManyPointsOnlyWhatIsShown) {
  const Results whole = tests::large_results(kMostWholePoints);
  EXPECT_NO_THROW(column(data_of(whole), "unit.count_3"));
  const Results many = tests::large_results(kMostWholePoints + 1);
  const Json data = data_of(many);
  EXPECT_THROW(column(data, "unit.count_3"), std::out_of_range);
  EXPECT_NO_THROW(column(data, "z_reads"));
  EXPECT_NO_THROW(column(data, "unit.key_3"));
}

TEST(PageData, EqualPicturesAreStoredOnce) {
  const Results results = tests::counted_results();
  const std::vector<HeatMap> maps = tests::sample_maps(results);
  const Json data = data_of(results, maps)["maps"];
  EXPECT_EQ(data["list"].size(), 64U);
  // Of each frame the LI writes are one picture; z reads are the same from tile 64 on.
  EXPECT_EQ(data["images"].size(), 2U * (1U + 6U));
  EXPECT_EQ(data["images"][0].get<std::string>().substr(0, 8), "iVBORw0K");  // a PNG's first bytes
}

}  // namespace
}  // namespace wedgesim::reports::page
