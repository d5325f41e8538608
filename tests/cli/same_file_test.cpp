#include <gtest/gtest.h>

#include "tests/cli/command.h"

namespace wedgesim::cli {
namespace {

constexpr const char* kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
constexpr const char* kScene =
    "description = \"x\"\n[camera]\neye = [0.0, 3.0, 5.0]\ntarget = [0.0, 0.0, 0.0]\n"
    "[light]\nshape = \"point\"\ncentre = [0.0, 9.0, 0.0]\n"
    "[[object]]\nshape = \"mesh\"\nfile = \"m.obj\"\ncasts = true\n";

// What is read is never written over: every output of every command, by any name.
struct SameFile : testing::Test {
  TemporaryFolder folder;

  std::string at(const std::string& name) const { return (folder / name).string(); }
  // Refused in one line, and nothing in the folder is another than before.
  void expect_refused(const std::vector<std::string>& arguments, const std::string& file) const {
    const std::string before = read_text(file);
    const std::size_t entries = folder.entries();
    expect_bad_input(run_command(arguments), {"is read, too", "another file"});
    EXPECT_EQ(read_text(file), before);
    EXPECT_EQ(folder.entries(), entries);
  }
};

TEST_F(SameFile, ResultsOfATrace) {
  const std::string trace = make_trace(folder).string();
  const std::string link = at("link");
  std::filesystem::create_symlink(trace, link);
  for (const auto& [in, out] : {std::pair{trace, trace}, {trace, link}, {link, trace}}) {
    expect_refused({"count", in, "--json", out}, trace);
    expect_refused({"dump", in, "--obj", out}, trace);
  }
  for (const char* map : {"p_z_reads.png", "p_li_writes.exr", "p_li.png", "p_difference.exr"}) {
    std::filesystem::copy_file(trace, at(map));
    expect_refused({"count", at(map), "--maps", at("p"), "--mode", "single-pass"}, at(map));
    std::filesystem::remove(at(map));
  }
}

TEST_F(SameFile, ScenesAndTheirMeshes) {
  write_text(folder / "s.toml", kScene);
  write_text(folder / "m.obj", kTetrahedron);
  expect_refused({"trace", at("s.toml"), "-o", at("s.toml")}, at("s.toml"));
  expect_refused({"trace", at("s.toml"), "-o", at("m.obj")}, at("m.obj"));
  expect_refused({"trace", "mesh", "--mesh", at("m.obj"), "-o", at("m.obj")}, at("m.obj"));
  std::filesystem::create_symlink(at("s.toml"), at("image.png"));
  expect_refused({"render", at("s.toml"), "-o", at("image.png")}, at("s.toml"));
}

TEST_F(SameFile, ScenesOfAStudy) {
  write_text(folder / "m.obj", kTetrahedron);
  const std::string out = folder.path().string();
  for (const char* name : {"summary.txt", "results.csv", "results.json", "x.wtrace"}) {
    write_text(folder / name, kScene);
    expect_refused({"study", "paper2", "-o", out, "--scenes", "cylinder," + at(name)}, at(name));
    std::filesystem::remove(at(name));
  }
  write_text(folder / "x_li.png", kScene);  // what x.toml would write
  write_text(folder / "x.toml", kScene);
  const std::string both = at("x.toml") + "," + at("x_li.png");
  expect_refused({"study", "paper2", "-o", out, "--scenes", both}, at("x_li.png"));
  expect_refused({"study", "paper2", "-o", at("x.toml"), "--scenes", at("x.toml")}, at("x.toml"));
}

}  // namespace
}  // namespace wedgesim::cli
