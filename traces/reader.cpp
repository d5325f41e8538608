#include "traces/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "base/check.h"
#include "base/error.h"
#include "traces/format.h"
#include "traces/verify.h"

namespace wedgesim::traces {
namespace {

using Bytes = std::span<const std::byte>;

// Checks the first 32 bytes against the file; returns the payload's checksum.
std::uint64_t check_header(Bytes file, std::string_view place) {
  if (file.empty()) throw InputError(place, "is empty", "a trace file");
  if (std::memcmp(file.data(), kMagic.data(), std::min(file.size(), kMagic.size())) != 0) {
    throw InputError(place, "is not a trace", "a file that begins with WTRACE and a line end");
  }
  if (file.size() < sizeof(FileHeader)) {
    throw InputError(place, fmt::format("is truncated to {} bytes", file.size()),
                     fmt::format("a header of {} bytes", sizeof(FileHeader)));
  }
  FileHeader header;
  std::memcpy(&header, file.data(), sizeof header);
  if (header.version != kVersion) {
    throw InputError(place, fmt::format("is a trace of version {}", header.version),
                     fmt::format("version {}", kVersion));
  }
  if (header.reserved != 0) {
    throw InputError(place, fmt::format("its reserved word is {}", header.reserved), "0");
  }
  const Bytes payload = file.subspan(sizeof header);
  if (payload.size() != header.payload_bytes) {
    throw InputError(place,
                     fmt::format("is {} at {} bytes of payload",
                                 payload.size() < header.payload_bytes ? "truncated" : "too long",
                                 payload.size()),
                     fmt::format("{} as its header says", header.payload_bytes));
  }
  const std::uint64_t checksum = checksum_of(payload);
  if (checksum != header.checksum) {
    throw InputError(place, fmt::format("is damaged, its checksum is {:016x}", checksum),
                     fmt::format("{:016x} as its header says", header.checksum));
  }
  return checksum;
}

const fb::Trace& check_flatbuffer(Bytes payload, std::string_view place) {
  flatbuffers::Verifier::Options limits;
  limits.max_depth = 3;
  limits.max_tables = kMaxLights + kMaxCasters + 2;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(payload.data());
  if (payload.size() <= kMaxPayloadBytes) {
    flatbuffers::Verifier verifier(bytes, payload.size(), limits);
    if (fb::VerifyTraceBuffer(verifier)) return *fb::GetTrace(bytes);
  }
  throw InputError(place, "its payload is not a sound FlatBuffer",
                   "one of the schema traces/trace.fbs");
}

// Copies what is small, and points to what is big. A crafted file may name the same bytes from many
// tables: all copies together may not pass the payload's size.
class Loader {
 public:
  Loader(const fb::Trace& trace, std::size_t budget, std::string_view place)
      : trace_(trace), budget_(budget), place_(place) {}

  TraceView load() {
    TraceView view;
    view.header = header();
    view.vertices = table(trace_.vertices(), "vertices");
    view.indices = table(trace_.indices(), "indices");
    view.planes = table(trace_.planes(), "planes");
    view.faces = table(trace_.faces(), "faces");
    view.wedges = table(trace_.wedges(), "wedges");
    view.umbra_polygons = table(trace_.umbra_polygons(), "umbra_polygons");
    view.depth = table(trace_.depth(), "depth");
    view.expected_li = table(trace_.expected_li(), "expected_li");
    view.li_sensitivity = table(trace_.li_sensitivity(), "li_sensitivity");
    return view;
  }

 private:
  template <typename T>
  const T& required(const T* value, std::string_view name) const {
    if (value == nullptr) throw InputError(place_, fmt::format("{} is absent", name), "it present");
    return *value;
  }

  template <typename T>
  std::span<const T> span_of(const std::uint8_t* data, std::size_t size,
                             std::string_view name) const {
    if (size == 0) return {};
    if (reinterpret_cast<std::uintptr_t>(data) % alignof(T) != 0) {
      throw InputError(place_, fmt::format("{} is not aligned", name),
                       fmt::format("a multiple of {} bytes", alignof(T)));
    }
    return {reinterpret_cast<const T*>(data), size};
  }
  template <typename T>  // scalars
  std::span<const T> table(const flatbuffers::Vector<T>* v, std::string_view name) const {
    return v == nullptr ? std::span<const T>() : span_of<T>(v->Data(), v->size(), name);
  }
  template <typename T>  // structs
  std::span<const T> table(const flatbuffers::Vector<const T*>* v, std::string_view name) const {
    return v == nullptr ? std::span<const T>() : span_of<T>(v->Data(), v->size(), name);
  }

  void spend(std::size_t bytes) {
    if (bytes > budget_) throw InputError(place_, "names or textures share bytes", "each its own");
    budget_ -= bytes;
  }

  std::string text(const flatbuffers::String* string) {
    if (string == nullptr) return {};
    spend(string->size());
    return string->str();
  }

  Header header() {
    Header header;
    header.name = text(trace_.name());
    header.width = trace_.width();
    header.height = trace_.height();
    header.camera = camera(required(trace_.camera(), "camera"));
    if (trace_.lights() != nullptr) {
      for (const fb::Light* value : *trace_.lights()) header.lights.push_back(light(*value));
    }
    if (trace_.casters() != nullptr) {
      for (const fb::Caster* value : *trace_.casters()) {
        header.casters.push_back({text(value->name()), value->triangles(), value->z_fail_needed()});
      }
    }
    header.depth_format = trace_.depth_format();
    header.z_fail_needed = trace_.z_fail_needed();
    header.expected_z_method = trace_.expected_z_method();
    return header;
  }

  Camera camera(const fb::Camera& value) const {
    const auto corners =
        table(&required(value.near_rectangle(), "camera.near_rectangle"), "camera.near_rectangle");
    Camera camera;
    if (corners.size() != camera.near_rectangle.size()) {
      throw InputError(place_, fmt::format("camera.near_rectangle has {} corners", corners.size()),
                       "4");
    }
    std::copy(corners.begin(), corners.end(), camera.near_rectangle.begin());
    camera.eye = required(value.eye(), "camera.eye");
    camera.window_from_world = required(value.window_from_world(), "camera.window_from_world");
    camera.world_from_window = required(value.world_from_window(), "camera.world_from_window");
    return camera;
  }

  Light light(const fb::Light& value) {
    Light light;
    light.shape = value.shape();
    light.centre = required(value.centre(), "lights.centre");
    if (value.half_u() != nullptr) light.half_u = *value.half_u();
    if (value.half_v() != nullptr) light.half_v = *value.half_v();
    light.radius = value.radius();
    if (value.colour() != nullptr) light.colour = *value.colour();
    light.texture_width = value.texture_width();
    light.texture_height = value.texture_height();
    const auto texture = table(value.texture(), "lights.texture");
    spend(texture.size_bytes());
    light.texture.assign(texture.begin(), texture.end());
    light.light_from_window = required(value.light_from_window(), "lights.light_from_window");
    return light;
  }

  const fb::Trace& trace_;
  std::size_t budget_;
  std::string_view place_;
};

}  // namespace

TraceView view_of(std::span<const std::byte> file, std::string_view place) {
  CHECK_EQ(reinterpret_cast<std::uintptr_t>(file.data()) % kPayloadAlignment, 0U);
  const std::uint64_t checksum = check_header(file, place);
  const Bytes payload = file.subspan(sizeof(FileHeader));
  TraceView view = Loader(check_flatbuffer(payload, place), payload.size(), place).load();
  view.header.checksum = checksum;
  verify(view, place);
  return view;
}

TraceFile::TraceFile(const std::filesystem::path& path)
    : file_(path), view_(view_of(file_.bytes(), path.string())) {}

}  // namespace wedgesim::traces
