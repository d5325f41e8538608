#include "base/file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/error.h"
#include "tests/base/temporary_folder.h"

namespace wedgesim {
namespace {
namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_half_and_fail(const fs::path& temporary) {
  std::ofstream(temporary) << "half";
  throw std::runtime_error("out of ideas");
}

TEST(WriteFile, MakesFoldersAndReplaces) {
  const TemporaryFolder folder;
  const fs::path path = folder / "a/b/c.json";
  write_file(path, std::string_view("first, and longer"));
  write_file(path, std::string_view("second"));
  EXPECT_EQ(content(path), "second");
}

TEST(WriteFile, KeepsEveryByte) {
  const TemporaryFolder folder;
  std::string bytes;
  for (int value = 0; value < 256; ++value) bytes.push_back(static_cast<char>(value));
  write_file(folder / "bytes", std::string_view(bytes));
  EXPECT_EQ(content(folder / "bytes"), bytes);
  write_file(folder / "empty", std::string_view());
  EXPECT_EQ(fs::file_size(folder / "empty"), 0u);
}

TEST(WriteAtomically, FailureLeavesNothing) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_atomically(folder / "new.csv", write_half_and_fail), std::runtime_error);
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(WriteAtomically, FailureKeepsTheOldFile) {
  const TemporaryFolder folder;
  write_file(folder / "old.csv", std::string_view("old"));
  EXPECT_THROW(write_atomically(folder / "old.csv", write_half_and_fail), std::runtime_error);
  EXPECT_EQ(content(folder / "old.csv"), "old");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(WriteAtomically, AWriterThatWritesNothingIsAnError) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_atomically(folder / "none", [](const fs::path&) {}), InputError);
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(WriteAtomically, TemporaryHasTheExtensionAndTheFolder) {
  const TemporaryFolder folder;
  write_atomically(folder / "x.exr", [&](const fs::path& temporary) {
    EXPECT_EQ(temporary.extension(), ".exr");
    EXPECT_EQ(temporary.parent_path(), folder.path());
    std::ofstream(temporary) << "x";
  });
  EXPECT_EQ(folder.entries(), 1u);
}

// What could be written and what could not, without a trace of either.
TEST(RequireWritable, SaysBeforehandWhatWritingWould) {
  const TemporaryFolder folder;
  write_file(folder / "file", std::string_view("x"));
  for (const fs::path& path : {folder / "new", folder / "file", folder / "a/b/c"}) {
    EXPECT_NO_THROW(require_writable(path)) << path;
  }
  EXPECT_NO_THROW(require_writable("new"));
  EXPECT_NO_THROW(require_writable("/dev/null"));
  for (const fs::path& path :
       {folder.path(), folder / "file/below", folder / "new/", folder / std::string(300, 'n'),
        fs::path("/proc/x"), fs::path("/proc/none/x")}) {
    EXPECT_THROW(require_writable(path), InputError) << path;
  }
  EXPECT_EQ(folder.entries(), 1U);
  EXPECT_EQ(content(folder / "file"), "x");
}

TEST(WriteFile, RefusesWhatIsNoPlaceForAFile) {
  const TemporaryFolder folder;
  write_file(folder / "file", std::string_view("x"));
  EXPECT_THROW(write_file(folder.path(), std::string_view("x")), InputError);
  EXPECT_THROW(write_file(folder / "file/below", std::string_view("x")), InputError);
  EXPECT_THROW(write_file(folder / "new/", std::string_view("x")), InputError);
  EXPECT_THROW(write_file(folder / std::string(300, 'n'), std::string_view("x")), InputError);
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(WriteFile, WritesThroughALink) {
  const TemporaryFolder folder;
  write_file(folder / "target", std::string_view("old, and longer"));
  fs::create_symlink(folder / "target", folder / "link");
  write_file(folder / "link", std::string_view("new"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(content(folder / "target"), "new");
}

TEST(WriteFile, NeverReplacesAPipe) {
  const TemporaryFolder folder;
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::fstream reader(pipe, std::ios::in | std::ios::out);  // both, so that no open waits
  write_file(pipe, std::string_view("through\n"));
  ASSERT_TRUE(fs::is_fifo(pipe));
  std::string line;
  std::getline(reader, line);
  EXPECT_EQ(line, "through");
}

TEST(RequireApart, RefusesTwoOutputsInOneFile) {
  const TemporaryFolder folder;
  using Paths = std::vector<fs::path>;
  EXPECT_NO_THROW(require_apart(Paths{folder / "a", folder / "b", {}, {}}));
  EXPECT_NO_THROW(require_apart(Paths{"/dev/null", "/dev/null"}));
  EXPECT_THROW(require_apart(Paths{folder / "a", folder / "b", folder / "a"}), InputError);
  EXPECT_THROW(require_apart(Paths{folder / "a", folder.path() / "x" / ".." / "a"}), InputError);
}

TEST(RequireNotRead, KnowsAFileByEveryName) {
  const TemporaryFolder folder;
  write_file(folder / "in", std::string_view("x"));
  write_file(folder / "other", std::string_view("x"));
  fs::create_symlink(folder / "in", folder / "link");
  const std::vector<fs::path> inputs{folder / "missing", folder / "in"};
  for (const fs::path& same :
       {folder / "in", folder / "./in", folder.path() / "x" / ".." / "in", folder / "link"}) {
    fs::create_directories(folder / "x");
    EXPECT_THROW(require_not_read(same, inputs), InputError) << same;
  }
  // Through a folder that writing would make.
  EXPECT_THROW(require_not_read(folder.path() / "new" / ".." / "in", inputs), InputError);
  EXPECT_NO_THROW(require_not_read(folder / "other", inputs));
  EXPECT_NO_THROW(require_not_read(folder / "missing", inputs));
  EXPECT_NO_THROW(require_not_read(folder / "in", {}));
}

TEST(MappedFile, ShowsTheBytes) {
  const TemporaryFolder folder;
  write_file(folder / "f", std::string_view("wedge"));
  MappedFile file(folder / "f");
  const MappedFile moved(std::move(file));
  ASSERT_EQ(moved.bytes().size(), 5u);
  EXPECT_EQ(moved.bytes()[4], std::byte{'e'});
}

TEST(MappedFile, OfAnEmptyFileIsEmpty) {
  const TemporaryFolder folder;
  write_file(folder / "empty", std::string_view());
  EXPECT_TRUE(MappedFile(folder / "empty").bytes().empty());
}

TEST(MappedFile, RefusesWhatIsNoFile) {
  const TemporaryFolder folder;
  EXPECT_THROW(MappedFile(folder / "missing"), InputError);
  EXPECT_THROW(MappedFile{folder.path()}, InputError);
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THROW(MappedFile(folder / "pipe"), InputError);
}

}  // namespace
}  // namespace wedgesim
