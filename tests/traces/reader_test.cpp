#include "traces/reader.h"

#include <fmt/format.h>

#include <cstring>
#include <random>
#include <utility>

#include "tests/traces/files.h"
#include "tests/traces/sample.h"
#include "traces/format.h"
#include "traces/writer.h"

namespace wedgesim::traces {
namespace {

namespace fs = std::filesystem;

/// A sound file, and the refusals of what a test makes of it.
class Reader : public testing::Test {
 protected:
  Reader() {
    write_trace(path_, sample_trace());
    sound_ = read_bytes(path_);
  }

  /// What the reader says of these bytes, without the leading file name.
  std::string refusal(const Bytes& bytes) const {
    write_bytes(path_, bytes);
    const std::string message = input_error([&] { const TraceFile file(path_); });
    const std::string place = path_.string() + ": ";
    EXPECT_EQ(message.substr(0, place.size()), place);
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message.substr(std::min(place.size(), message.size()));
  }

  FileHeader header() const {
    FileHeader result;
    std::memcpy(&result, sound_.data(), sizeof result);
    return result;
  }
  Bytes with(const FileHeader& header) const {
    Bytes bytes = sound_;
    std::memcpy(bytes.data(), &header, sizeof header);
    return bytes;
  }
  /// The bytes with size and checksum made right.
  static Bytes signed_again(Bytes bytes) {
    FileHeader header;
    header.payload_bytes = bytes.size() - sizeof header;
    header.checksum = checksum_of(std::as_bytes(std::span(bytes)).subspan(sizeof header));
    std::memcpy(bytes.data(), &header, sizeof header);
    return bytes;
  }

  Folder folder_;
  fs::path path_ = folder_ / "a.wtrace";
  Bytes sound_;
};

TEST_F(Reader, MissingFile) {
  const fs::path path = folder_ / "none.wtrace";
  EXPECT_EQ(input_error([&] { const TraceFile file(path); }),
            path.string() + ": No such file or directory; expected a readable file");
}

TEST_F(Reader, Directory) {
  EXPECT_EQ(input_error([&] { const TraceFile file(folder_.path()); }),
            folder_.path().string() + ": is not a regular file; expected a readable file");
}

TEST_F(Reader, EmptyFile) { EXPECT_EQ(refusal({}), "is empty; expected a trace file"); }

TEST_F(Reader, WrongMagic) {
  const std::string expected =
      "is not a trace; expected a file that begins with WTRACE and a line end";
  for (const std::string text :
       {"x", "# a text file that is longer than a header is", "WTRACE\n"}) {
    EXPECT_EQ(refusal(Bytes(text.begin(), text.end())), expected) << text;
  }
}

TEST_F(Reader, WrongVersion) {
  FileHeader changed = header();
  changed.version = 2;
  EXPECT_EQ(refusal(with(changed)), "is a trace of version 2; expected version 1");
}

TEST_F(Reader, ReservedWord) {
  FileHeader changed = header();
  changed.reserved = 7;
  EXPECT_EQ(refusal(with(changed)), "its reserved word is 7; expected 0");
}

TEST_F(Reader, BytesAfterThePayload) {
  Bytes longer = sound_;
  longer.push_back(0);
  const std::size_t payload = sound_.size() - 32;
  EXPECT_EQ(refusal(longer), fmt::format("is too long at {} bytes of payload; expected {} as its "
                                         "header says",
                                         payload + 1, payload));
}

TEST_F(Reader, TruncatedAnywhere) {
  const std::size_t payload = sound_.size() - 32;
  for (std::size_t i = 1; i < 50; ++i) {
    const std::size_t length = sound_.size() * i / 50;
    const std::string expected =
        length < 32 ? fmt::format("is truncated to {} bytes; expected a header of 32 bytes", length)
                    : fmt::format(
                          "is truncated at {} bytes of payload; expected {} as its header "
                          "says",
                          length - 32, payload);
    EXPECT_EQ(refusal(Bytes(sound_.begin(), sound_.begin() + static_cast<std::ptrdiff_t>(length))),
              expected);
  }
}

TEST_F(Reader, WrongChecksum) {
  FileHeader changed = header();
  const std::uint64_t right = changed.checksum++;
  EXPECT_EQ(refusal(with(changed)),
            fmt::format("is damaged, its checksum is {:016x}; expected {:016x} as its header says",
                        right, right + 1));
}

TEST_F(Reader, EveryBitOfTheHeaderCounts) {
  for (std::size_t bit = 0; bit < 8 * sizeof(FileHeader); ++bit) {
    Bytes flipped = sound_;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    EXPECT_FALSE(refusal(flipped).empty()) << "bit " << bit;
  }
}

TEST_F(Reader, FlippedBitsAreRefused) {
  constexpr std::uint64_t kSeed = 20020701;
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 1000; ++i) {
    const std::size_t bit = 8 * 32 + random() % (8 * (sound_.size() - 32));
    Bytes flipped = sound_;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    EXPECT_EQ(refusal(flipped).substr(0, 27), "is damaged, its checksum is")
        << "seed " << kSeed << ", bit " << bit;
  }
}

// With a checksum that is right again, the verifiers are on their own: each flip either still means
// something or is refused in one line.
TEST_F(Reader, SignedDamageNeverPassesUnchecked) {
  constexpr std::uint64_t kSeed = 20030708;
  std::mt19937_64 random(kSeed);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::size_t bit = 8 * 32 + random() % (8 * (sound_.size() - 32));
    Bytes flipped = sound_;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    write_bytes(path_, signed_again(flipped));
    try {
      const TraceFile file(path_);
    } catch (const InputError&) {
      ++refused;
    } catch (const std::exception& error) {
      FAIL() << error.what() << ", seed " << kSeed << ", bit " << bit;
    }
  }
  EXPECT_GT(refused, 100);
  EXPECT_LT(refused, 2900);
}

TEST_F(Reader, PayloadThatIsNoFlatBuffer) {
  const std::string expected =
      "its payload is not a sound FlatBuffer; expected one of the schema traces/trace.fbs";
  EXPECT_EQ(refusal(signed_again(Bytes(32))), expected);
  EXPECT_EQ(refusal(signed_again(Bytes(100))), expected);
}

/// A file of a trace table made by hand, as another renderer might make it.
Bytes foreign(
    const std::function<flatbuffers::Offset<fb::Trace>(flatbuffers::FlatBufferBuilder&)>& make) {
  flatbuffers::FlatBufferBuilder builder;
  fb::FinishTraceBuffer(builder, make(builder));
  Bytes bytes(sizeof(FileHeader) + builder.GetSize());
  std::memcpy(&bytes[sizeof(FileHeader)], builder.GetBufferPointer(), builder.GetSize());
  return bytes;
}

flatbuffers::Offset<fb::Camera> camera_with(flatbuffers::FlatBufferBuilder& builder,
                                            std::size_t corners) {
  const std::vector<fb::Vec3> rectangle(corners);
  const fb::Vec3 eye;
  const fb::Matrix4 matrix;
  return fb::CreateCamera(builder, &eye, builder.CreateVectorOfStructs(rectangle), &matrix,
                          &matrix);
}

TEST_F(Reader, AbsentCamera) {
  EXPECT_EQ(refusal(signed_again(foreign([](auto& builder) {
              fb::TraceBuilder trace(builder);
              return trace.Finish();
            }))),
            "camera is absent; expected it present");
}

TEST_F(Reader, WrongNumberOfCorners) {
  EXPECT_EQ(refusal(signed_again(foreign([](auto& builder) {
              const auto camera = camera_with(builder, 3);
              fb::TraceBuilder trace(builder);
              trace.add_camera(camera);
              return trace.Finish();
            }))),
            "camera.near_rectangle has 3 corners; expected 4");
}

TEST_F(Reader, LightWithoutMatrix) {
  EXPECT_EQ(refusal(signed_again(foreign([](auto& builder) {
              const auto camera = camera_with(builder, 4);
              const fb::Vec3 centre;
              fb::LightBuilder light(builder);
              light.add_centre(&centre);
              const auto lights = builder.CreateVector(std::vector{light.Finish()});
              fb::TraceBuilder trace(builder);
              trace.add_camera(camera);
              trace.add_lights(lights);
              return trace.Finish();
            }))),
            "lights.light_from_window is absent; expected it present");
}

// Sections that are absent from a file are empty in the view; a depth buffer is required.
TEST_F(Reader, AbsentSections) {
  const std::vector<std::uint32_t> depth = {7};
  write_bytes(path_, signed_again(foreign([&](auto& builder) {
                const auto camera = camera_with(builder, 4);
                const auto words = builder.CreateVector(depth);
                fb::TraceBuilder trace(builder);
                trace.add_width(1);
                trace.add_height(1);
                trace.add_camera(camera);
                trace.add_depth(words);
                return trace.Finish();
              })));
  const TraceFile file(path_);
  EXPECT_EQ(file.view().header.name, "");
  EXPECT_TRUE(file.view().header.lights.empty());
  EXPECT_TRUE(file.view().wedges.empty());
  EXPECT_TRUE(file.view().expected_li.empty());
  EXPECT_TRUE(file.view().li_sensitivity.empty());
  ASSERT_EQ(file.view().depth.size(), 1U);
  EXPECT_EQ(file.view().depth[0], 7U);
}

// Many casters that share one long name would grow the file's size a thousandfold in memory.
TEST_F(Reader, SharedNamesAreRefused) {
  EXPECT_EQ(refusal(signed_again(foreign([](auto& builder) {
              const auto camera = camera_with(builder, 4);
              const auto caster =
                  fb::CreateCaster(builder, builder.CreateString(std::string(5000, 'x')));
              const auto casters = builder.CreateVector(std::vector(1000, caster));
              fb::TraceBuilder trace(builder);
              trace.add_camera(camera);
              trace.add_casters(casters);
              return trace.Finish();
            }))),
            "names or textures share bytes; expected each its own");
}

// A table of doubles that begins at an odd word cannot be read in place.
TEST_F(Reader, MisalignedTable) {
  const Bytes file = foreign([](auto& builder) {
    const auto camera = camera_with(builder, 4);
    const auto room = builder.CreateVector(std::vector<std::uint32_t>(17));
    const auto odd = builder.CreateVector(std::vector<std::uint32_t>(1));  // aligned to 4 alone
    fb::TraceBuilder trace(builder);
    trace.add_camera(camera);
    trace.add_indices(room);
    trace.add_planes(odd.o);
    return trace.Finish();
  });
  EXPECT_EQ(refusal(signed_again(file)), "planes is not aligned; expected a multiple of 8 bytes");
}

TEST_F(Reader, ViewStaysWhenTheFileIsMoved) {
  write_bytes(path_, sound_);
  TraceFile first(path_);
  const fb::Wedge* wedges = first.view().wedges.data();
  const TraceFile second = std::move(first);
  EXPECT_EQ(second.view().wedges.data(), wedges);
  EXPECT_EQ(second.view().wedges[1].plane_count(), 4U);
}

// The tables are the mapping itself: read in place, aligned.
TEST_F(Reader, TablesPointIntoTheFile) {
  alignas(kPayloadAlignment) static std::byte file[1 << 14];
  ASSERT_LE(sound_.size(), sizeof file);
  std::memcpy(file, sound_.data(), sound_.size());
  const TraceView view = view_of(std::span(file, sound_.size()), "memory");
  const auto inside = [&](const auto& table) {
    const auto* begin = reinterpret_cast<const std::byte*>(table.data());
    return begin > file && begin + table.size_bytes() <= file + sound_.size() &&
           reinterpret_cast<std::uintptr_t>(begin) % alignof(decltype(table[0])) == 0;
  };
  EXPECT_TRUE(inside(view.vertices));
  EXPECT_TRUE(inside(view.wedges));
  EXPECT_TRUE(inside(view.depth));
  EXPECT_TRUE(inside(view.expected_li));
}

TEST_F(Reader, MisalignedMemoryIsACheck) {
  alignas(kPayloadAlignment) static std::byte file[64];
  EXPECT_THROW(view_of(std::span(file + 1, 40), "memory"), CheckError);
}

}  // namespace
}  // namespace wedgesim::traces
