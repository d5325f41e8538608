#include "traces/writer.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

#include "base/error.h"
#include "tests/traces/files.h"
#include "tests/traces/sample.h"
#include "traces/format.h"
#include "traces/reader.h"

namespace wedgesim::traces {
namespace {

namespace fs = std::filesystem;

bool same_bits(const fb::Vec3& a, const fb::Vec3& b) { return !std::memcmp(&a, &b, sizeof a); }
bool same_bits(const fb::Matrix4& a, const fb::Matrix4& b) {
  return !std::memcmp(&a, &b, sizeof a);
}

template <typename T>
void expect_same(std::span<const T> a, std::span<const T> b, const char* name) {
  ASSERT_EQ(a.size(), b.size()) << name;
  EXPECT_TRUE(a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0) << name;
}

void expect_same(const Camera& a, const Camera& b) {
  EXPECT_TRUE(same_bits(a.eye, b.eye));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(same_bits(a.near_rectangle[i], b.near_rectangle[i])) << i;
  }
  EXPECT_TRUE(same_bits(a.window_from_world, b.window_from_world));
  EXPECT_TRUE(same_bits(a.world_from_window, b.world_from_window));
}

void expect_same(const Light& a, const Light& b) {
  EXPECT_EQ(a.shape, b.shape);
  EXPECT_TRUE(same_bits(a.centre, b.centre));
  EXPECT_TRUE(same_bits(a.half_u, b.half_u));
  EXPECT_TRUE(same_bits(a.half_v, b.half_v));
  EXPECT_EQ(a.radius, b.radius);
  EXPECT_TRUE(same_bits(a.colour, b.colour));
  EXPECT_EQ(a.texture_width, b.texture_width);
  EXPECT_EQ(a.texture_height, b.texture_height);
  EXPECT_EQ(a.texture, b.texture);
  EXPECT_TRUE(same_bits(a.light_from_window, b.light_from_window));
}

/// Every field but the checksum, bit by bit.
void expect_same(const TraceView& a, const TraceView& b) {
  EXPECT_EQ(a.header.name, b.header.name);
  EXPECT_EQ(a.header.width, b.header.width);
  EXPECT_EQ(a.header.height, b.header.height);
  EXPECT_EQ(a.header.depth_format, b.header.depth_format);
  EXPECT_EQ(a.header.z_fail_needed, b.header.z_fail_needed);
  EXPECT_EQ(a.header.expected_z_method, b.header.expected_z_method);
  expect_same(a.header.camera, b.header.camera);
  ASSERT_EQ(a.header.lights.size(), b.header.lights.size());
  for (std::size_t i = 0; i < a.header.lights.size(); ++i) {
    expect_same(a.header.lights[i], b.header.lights[i]);
  }
  ASSERT_EQ(a.header.casters.size(), b.header.casters.size());
  for (std::size_t i = 0; i < a.header.casters.size(); ++i) {
    EXPECT_EQ(a.header.casters[i].name, b.header.casters[i].name);
    EXPECT_EQ(a.header.casters[i].triangles, b.header.casters[i].triangles);
    EXPECT_EQ(a.header.casters[i].z_fail_needed, b.header.casters[i].z_fail_needed);
  }
  expect_same(a.vertices, b.vertices, "vertices");
  expect_same(a.indices, b.indices, "indices");
  expect_same(a.planes, b.planes, "planes");
  expect_same(a.faces, b.faces, "faces");
  expect_same(a.wedges, b.wedges, "wedges");
  expect_same(a.umbra_polygons, b.umbra_polygons, "umbra_polygons");
  expect_same(a.depth, b.depth, "depth");
  expect_same(a.expected_li, b.expected_li, "expected_li");
  expect_same(a.li_sensitivity, b.li_sensitivity, "li_sensitivity");
}

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(Writer, ReaderGivesBackEveryField) {
  const Folder folder;
  const Trace trace = sample_trace();
  const std::uint64_t checksum = write_trace(folder / "a.wtrace", trace);
  const TraceFile file(folder / "a.wtrace");
  expect_same(file.view(), trace.view());
  EXPECT_EQ(file.view().header.checksum, checksum);
  EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST(Writer, RandomTracesComeBack) {
  const Folder folder;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Trace trace = random_trace(seed);
    write_trace(folder / "a.wtrace", trace);
    const TraceFile file(folder / "a.wtrace");
    expect_same(file.view(), trace.view());
    if (HasFatalFailure() || HasNonfatalFailure()) return;
  }
}

TEST(Writer, HeaderIsAsDocumented) {
  const Folder folder;
  const std::uint64_t checksum = write_trace(folder / "a.wtrace", sample_trace());
  const Bytes file = read_bytes(folder / "a.wtrace");
  ASSERT_GT(file.size(), 40U);
  EXPECT_EQ(std::memcmp(file.data(), "WTRACE\r\n\1\0\0\0\0\0\0\0", 16), 0);
  std::uint64_t words[2];
  std::memcpy(words, file.data() + 16, sizeof words);
  EXPECT_EQ(words[0], file.size() - 32);
  EXPECT_EQ(words[1], checksum);
  EXPECT_EQ(std::memcmp(file.data() + 36, "WTRC", 4), 0);  // FlatBuffers' own identifier
}

TEST(Writer, SameTraceSameBytes) {
  const Folder folder;
  write_trace(folder / "a.wtrace", sample_trace());
  write_trace(folder / "b.wtrace", sample_trace());
  EXPECT_EQ(read_bytes(folder / "a.wtrace"), read_bytes(folder / "b.wtrace"));
}

TEST(Writer, RefusesNaNAndWritesNothing) {
  const Folder folder;
  Trace trace = sample_trace();
  trace.vertices[2] = {0, 0, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(input_error([&] { write_trace(folder / "a.wtrace", trace); }),
            (folder / "a.wtrace").string() + ": vertices[2].z is nan; expected a finite number");
  EXPECT_EQ(files_in(folder.path()), 0U);
}

TEST(Writer, RefusesMoreThanTwoGigabytes) {
  const Folder folder;
  // Address space alone: sizes decide before anything is read.
  constexpr std::size_t kPixels = std::size_t{16384} * 16384;
  void* space = mmap(nullptr, kPixels * 8, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(space, MAP_FAILED);
  TraceView trace;
  trace.header.width = trace.header.height = 16384;
  trace.expected_li = {static_cast<const double*>(space), kPixels};
  EXPECT_EQ(input_error([&] { write_trace(folder / "a.wtrace", trace); }),
            (folder / "a.wtrace").string() +
                ": the trace needs 2147487744 bytes; expected at most 2147483646: fewer pixels, or "
                "no expected_li");
  munmap(space, kPixels * 8);
  EXPECT_EQ(files_in(folder.path()), 0U);
}

TEST(Writer, RoomIsKnownBeforehand) {
  EXPECT_NO_THROW(require_room("x.toml", 8192, 16383));
  EXPECT_EQ(input_error([] { require_room("x.toml", 16384, 16384); }),
            "x.toml: 16384x16384 pixels pass a trace's 2 GB; expected at most 134217727 pixels");
}

TEST(Writer, FolderThatIsAFile) {
  const Folder folder;
  write_bytes(folder / "file", {});
  const fs::path path = folder / "file" / "a.wtrace";
  EXPECT_EQ(input_error([&] { write_trace(path, sample_trace()); }),
            path.string() + ": its folder cannot be made; expected a writable folder");
}

TEST(Writer, TargetThatIsAFolder) {
  const Folder folder;
  fs::create_directory(folder / "a.wtrace");
  EXPECT_EQ(input_error([&] { write_trace(folder / "a.wtrace", sample_trace()); }),
            (folder / "a.wtrace").string() + ": is a folder; expected a file name");
  EXPECT_EQ(files_in(folder.path()), 1U);
}

// A limit on file sizes stands for a full disk: the write fails in the middle.
TEST(Writer, FullDiskLeavesTheOldFile) {
  const Folder folder;
  write_bytes(folder / "a.wtrace", Bytes(7));
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit old = {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
  const rlimit small = {512, old.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message =
      input_error([&] { write_trace(folder / "a.wtrace", sample_trace()); });
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &old), 0);
  EXPECT_EQ(message, (folder / "a.wtrace").string() +
                         ": cannot be written; expected a writable file with room");
  EXPECT_EQ(read_bytes(folder / "a.wtrace").size(), 7U);
  EXPECT_EQ(files_in(folder.path()), 1U);
}

}  // namespace
}  // namespace wedgesim::traces
