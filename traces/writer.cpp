#include "traces/writer.h"

#include <fmt/format.h>

#include <fstream>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "traces/format.h"
#include "traces/verify.h"

namespace wedgesim::traces {
namespace {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

// An upper bound of the payload: the tables' bytes, and room for offsets, tables and padding.
std::uint64_t payload_bound(const TraceView& trace) {
  std::uint64_t bytes = 4096 + trace.header.name.size();
  for (const Light& light : trace.header.lights) {
    bytes += 512 + sizeof(float) * light.texture.size();
  }
  for (const Caster& caster : trace.header.casters) bytes += 64 + caster.name.size();
  return bytes + trace.vertices.size_bytes() + trace.indices.size_bytes() +
         trace.planes.size_bytes() + trace.faces.size_bytes() + trace.wedges.size_bytes() +
         trace.umbra_polygons.size_bytes() + trace.depth.size_bytes() +
         trace.expected_li.size_bytes() + trace.li_sensitivity.size_bytes();
}

Offset<fb::Light> add(FlatBufferBuilder& builder, const Light& light) {
  const auto texture = light.texture.empty() ? Offset<flatbuffers::Vector<float>>()
                                             : builder.CreateVector(light.texture);
  return fb::CreateLight(builder, light.shape, &light.centre, &light.half_u, &light.half_v,
                         light.radius, &light.colour, light.texture_width, light.texture_height,
                         texture, &light.light_from_window);
}

Offset<fb::Caster> add(FlatBufferBuilder& builder, const Caster& caster) {
  const auto name = builder.CreateString(caster.name);
  return fb::CreateCaster(builder, name, caster.triangles, caster.z_fail_needed);
}

Offset<fb::Camera> add(FlatBufferBuilder& builder, const Camera& camera) {
  const auto corners =
      builder.CreateVectorOfStructs(camera.near_rectangle.data(), camera.near_rectangle.size());
  return fb::CreateCamera(builder, &camera.eye, corners, &camera.window_from_world,
                          &camera.world_from_window);
}

template <typename Table, typename Value>
auto add_all(FlatBufferBuilder& builder, const std::vector<Value>& values) {
  std::vector<Offset<Table>> offsets;
  offsets.reserve(values.size());
  for (const Value& value : values) offsets.push_back(add(builder, value));
  return builder.CreateVector(offsets);
}

template <typename T>
auto add_table(FlatBufferBuilder& builder, std::span<const T> table) {
  if constexpr (std::is_arithmetic_v<T>) {
    return builder.CreateVector(table.data(), table.size());
  } else {
    return builder.CreateVectorOfStructs(table.data(), table.size());
  }
}

// An empty frame is left out: absent.
template <typename T>
Offset<flatbuffers::Vector<T>> add_frame(FlatBufferBuilder& builder, std::span<const T> frame) {
  return frame.empty() ? Offset<flatbuffers::Vector<T>>() : add_table(builder, frame);
}

void build(FlatBufferBuilder& builder, const TraceView& trace) {
  const Header& header = trace.header;
  const auto li_sensitivity = add_frame(builder, trace.li_sensitivity);
  const auto expected_li = add_frame(builder, trace.expected_li);
  const auto depth = add_table(builder, trace.depth);
  const auto umbra_polygons = add_table(builder, trace.umbra_polygons);
  const auto wedges = add_table(builder, trace.wedges);
  const auto faces = add_table(builder, trace.faces);
  const auto planes = add_table(builder, trace.planes);
  const auto indices = add_table(builder, trace.indices);
  const auto vertices = add_table(builder, trace.vertices);
  const auto casters = add_all<fb::Caster>(builder, header.casters);
  const auto lights = add_all<fb::Light>(builder, header.lights);
  const auto camera = add(builder, header.camera);
  const auto name = builder.CreateString(header.name);
  fb::FinishTraceBuffer(
      builder,
      fb::CreateTrace(builder, name, header.width, header.height, camera, lights, casters, vertices,
                      indices, planes, faces, wedges, umbra_polygons, header.depth_format, depth,
                      header.z_fail_needed, header.expected_z_method, expected_li, li_sensitivity));
}

}  // namespace

void require_room(std::string_view place, int width, int height) {
  constexpr std::uint64_t kBytes = sizeof(TraceView::depth[0]) + sizeof(TraceView::expected_li[0]) +
                                   sizeof(TraceView::li_sensitivity[0]);
  constexpr std::uint64_t kMost = kMaxPayloadBytes / kBytes;
  if (static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) > kMost) {
    throw InputError(place, fmt::format("{}x{} pixels pass a trace's 2 GB", width, height),
                     fmt::format("at most {} pixels", kMost));
  }
}

std::uint64_t write_trace(const std::filesystem::path& path, const Trace& trace) {
  return write_trace(path, trace.view());
}

std::uint64_t write_trace(const std::filesystem::path& path, const TraceView& trace) {
  const std::uint64_t bound = payload_bound(trace);
  if (bound > kMaxPayloadBytes) {
    throw InputError(path.string(), fmt::format("the trace needs {} bytes", bound),
                     fmt::format("at most {}: fewer pixels, or no expected_li", kMaxPayloadBytes));
  }
  verify(trace, path.string());
  FlatBufferBuilder builder(bound);  // at once: to grow would copy
  build(builder, trace);
  const auto payload = std::as_bytes(std::span(builder.GetBufferPointer(), builder.GetSize()));
  FileHeader header;
  header.payload_bytes = payload.size();
  header.checksum = checksum_of(payload);
  write_atomically(path, [&](const std::filesystem::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out.write(reinterpret_cast<const char*>(&header), sizeof header);
    out.write(reinterpret_cast<const char*>(payload.data()),
              static_cast<std::streamsize>(payload.size()));
    out.close();
    if (!out) throw InputError(path.string(), "cannot be written", "a writable file with room");
  });
  return header.checksum;
}

}  // namespace wedgesim::traces
