#include <gtest/gtest.h>

#include "tests/cli/command.h"

namespace wedgesim::cli {
namespace {

constexpr const char* kStudy =
    "[frames]\nscene = [\"cylinder\", \"plain-columns\"]\nframe = [0, 9]\nsize = \"48x32\"\n"
    "[[grid]]\nblock.tile = [4, 8, 16]\nblock.mode = [\"three-pass\", \"single-pass\"]\n"
    "[[grid]]\nmeasure = \"cycles\"\nblock.tile = [4, 8]\npenumbra.lanes = [1, 4]\n";

struct StudyShards : testing::Test {
  TemporaryFolder folder;

  StudyShards() { write_text(folder / "s.toml", kStudy); }
  std::string at(const std::string& name) const { return (folder / name).string(); }
  Outcome study(const std::string& out, const std::vector<std::string>& options) const {
    std::vector<std::string> arguments{"study", at("s.toml"), "-o", at(out)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_command(arguments);
  }
  void run_shards(const std::string& out) const {
    for (const char* shard : {"1/3", "2/3", "3/3"}) expect_good(study(out, {"--shard", shard}));
  }
  std::vector<std::string> shards(const std::string& out) const {
    return {at(out + "/shard-1-of-3"), at(out + "/shard-2-of-3"), at(out + "/shard-3-of-3")};
  }
  Outcome merge(std::vector<std::string> from, const std::string& to) const {
    from.insert(from.begin(), {"study", "merge", "-o", at(to)});
    return run_command(from);
  }
  void expect_same(const std::string& a, const std::string& b) const {
    const Outcome outcome = run_command({"study", "compare", at(a), at(b)});
    expect_good(outcome);
    EXPECT_EQ(outcome.out, "no difference, timing aside\n");
    for (const char* file : {"results.csv", "summary.txt"}) {
      EXPECT_EQ(read_text(folder / a / file), read_text(folder / b / file)) << a << ' ' << b;
    }
  }
};

TEST_F(StudyShards, OneWorkerTwoWorkersAndThreeShardsGiveTheSameRows) {
  expect_good(study("one", {"--jobs", "1"}));
  expect_good(study("two", {"--jobs", "2"}));
  run_shards("shards");
  expect_good(merge(shards("shards"), "merged"));
  expect_same("one", "two");
  expect_same("one", "merged");
  const Outcome on = study("merged", {});
  expect_good(on);
  EXPECT_NE(on.out.find("nothing was computed"), std::string::npos) << "traces are there, too";
}

TEST_F(StudyShards, AMergeWithoutAShardSaysSoAndTheStudyGoesOn) {
  run_shards("shards");
  std::vector<std::string> two = shards("shards");
  two.pop_back();
  const Outcome outcome = merge(two, "merged");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.out.find("26 of 40 points from 2 folders"), std::string::npos) << outcome.out;
  const Outcome on = study("merged", {});
  expect_good(on);
  EXPECT_NE(on.out.find("26 of 40 points were there already, 14 were measured"), std::string::npos);
}

TEST_F(StudyShards, OnlyShardsOfOneStudyAreMerged) {
  run_shards("shards");
  write_text(folder / "s.toml", std::string(kStudy) + "[[grid]]\nblock.tile = 32\n");
  expect_good(study("other", {}));
  expect_bad_input(merge({shards("shards")[0], at("other")}, "merged"),
                   {at("other"), "holds another study", "shards of one study"});
  expect_bad_input(merge({at("nowhere")}, "merged"), {"nowhere", "holds no results.sqlite"});
  EXPECT_FALSE(std::filesystem::exists(folder / "merged"));
}

TEST_F(StudyShards, AMergeReplacesNoOtherStudy) {
  const std::string small = "[frames]\nscene = \"cylinder\"\nsize = \"24x16\"\n";
  write_text(folder / "s.toml", small);
  expect_good(study("a", {}));
  write_text(folder / "s.toml", small + "[[grid]]\nblock.tile = [4, 16]\n");
  expect_good(study("b", {}));
  const std::string before = read_text(folder / "a/results.csv");
  expect_bad_input(merge({at("b")}, "a"), {at("a") + ": holds another study", "without results"});
  EXPECT_EQ(read_text(folder / "a/results.csv"), before);
  expect_good(merge({at("b")}, "merged"));
  expect_good(merge({at("b")}, "merged"));
}

TEST_F(StudyShards, AMergeTakesNoDamagedTrace) {
  write_text(folder / "s.toml",
             "[frames]\nscene = \"cylinder\"\nsize = \"24x16\"\n"
             "[[grid]]\nblock.tile = [4, 16]\n"
             "block.mode = [\"three-pass\", \"single-pass\"]\n");
  expect_good(study("a", {}));
  std::string trace = read_text(folder / "a/cylinder.wtrace");
  trace.replace(trace.size() / 2, 4, "oops");
  write_text(folder / "a/cylinder.wtrace", trace);
  expect_good(merge({at("a")}, "merged"));
  EXPECT_FALSE(std::filesystem::exists(folder / "merged/cylinder.wtrace"));
  expect_good(study("merged", {}));
  EXPECT_TRUE(std::filesystem::exists(folder / "merged/cylinder.wtrace"));
}

TEST_F(StudyShards, AMergeWritesThePageOfTheClaims) {
  write_text(folder / "s.toml",
             "claims = true\n[frames]\nscene = \"cylinder\"\nsize = \"24x16\"\n");
  expect_good(study("a", {}));
  expect_good(merge({at("a")}, "merged"));
  EXPECT_EQ(read_text(folder / "merged/claims.md"), read_text(folder / "a/claims.md"));
}

TEST_F(StudyShards, ASchedulerChoosesTheShard) {
  setenv("OMPI_COMM_WORLD_RANK", "1", 1);
  setenv("OMPI_COMM_WORLD_SIZE", "3", 1);
  const Outcome outcome = study("out", {});
  unsetenv("OMPI_COMM_WORLD_RANK");
  unsetenv("OMPI_COMM_WORLD_SIZE");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "rank 1 of Open MPI: shard-2-of-3\n");
  EXPECT_TRUE(std::filesystem::exists(folder / "out/shard-2-of-3/results.sqlite"));
}

TEST_F(StudyShards, CompareNamesEachDifference) {
  expect_good(study("a", {}));
  std::string text = kStudy;
  text.replace(text.find("48x32"), 5, "32x24");
  text.replace(text.find("[4, 8, 16]"), 10, "[4, 8, 32]");
  write_text(folder / "s.toml", text);
  expect_good(study("b", {}));
  const Outcome outcome = run_command({"compare", at("a"), at("b")});
  EXPECT_EQ(outcome.code, 1);
  for (const char* line :
       {"cylinder-f0: width: 48 against 32\n", "cylinder-f0: trace: ",
        "cylinder-f0 count block.tile=16 block.mode=three-pass: only in the first results\n",
        "cylinder-f0 count block.tile=32 block.mode=three-pass: only in the second results\n",
        "cylinder-f0 count block.tile=4 block.mode=three-pass: z_reads: "}) {
    EXPECT_NE(outcome.out.find(line), std::string::npos) << line << outcome.out.substr(0, 3000);
  }
  expect_bad_input(run_command({"compare", at("a"), at("nowhere")}), {"nowhere", "results.sqlite"});
}

}  // namespace
}  // namespace wedgesim::cli
