#include "reports/runner/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "base/limits.h"
#include "base/toml_table.h"
#include "reports/runner/axes.h"
#include "reports/runner/value.h"
#include "traces/reader.h"

namespace wedgesim::reports {
namespace {

namespace fb = traces::fb;

// Enough to know a frame by: what it is rendered with changes the row's `sources`, not its key.
std::string content_hash(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return "missing";
  return hash_of(MappedFile(file).text());
}

int whole(const std::string& text) {
  int number = -1;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && stop == end ? number : -1;
}

/// "5" or "0-34" or "0-34:5".
struct FrameRange {
  int first = 0, last = -1, step = 1;

  std::size_t count() const {
    return first > last ? 0 : static_cast<std::size_t>((last - first) / step) + 1;
  }
  void append_to(std::vector<int>& numbers) const {
    for (std::size_t i = 0; i < count(); ++i) {
      numbers.push_back(first + static_cast<int>(i) * step);
    }
  }
};

// An empty one if the text is none.
FrameRange frame_range(const std::string& text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::size_t dash = std::min(text.find('-'), colon);
  const int first = whole(text.substr(0, dash));
  const int last = dash < colon ? whole(text.substr(dash + 1, colon - dash - 1)) : first;
  const int step = colon < text.size() ? whole(text.substr(colon + 1)) : 1;
  if (first < 0 || step < 1) return {};
  return {first, last, step};
}

std::optional<std::pair<int, int>> size_of(const std::string& text) {
  const std::size_t by = text.find('x');
  if (by == std::string::npos) return {};
  const int width = whole(text.substr(0, by));
  const int height = whole(text.substr(by + 1));
  if (width < 1 || height < 1 || width > kMaxFrameEdge || height > kMaxFrameEdge) return {};
  return std::pair(width, height);
}

/// What a scene may be rendered with: each key's words, the same for every scene.
struct Options {
  std::vector<int> frames{0};
  std::vector<std::optional<std::pair<int, int>>> sizes{std::nullopt};
  std::vector<double> light_scales{1.0};
  std::vector<std::optional<int>> field_sides{std::nullopt};
  std::vector<std::string> kinds{"coverage"}, lights{"scene"}, depths{"unorm24"};
};

class Reader {
 public:
  Reader(const toml::table& table, const std::string& file) : table_(table), file_(file) {}

  std::vector<Value> values(const std::string& key) const {
    const toml::node* node = table_.get(key);
    return node == nullptr ? std::vector<Value>() : read_axis(key, *node, file_).values;
  }
  std::vector<std::string> words(const std::string& key, std::vector<std::string> fallback) const {
    const std::vector<Value> found = values(key);
    if (found.empty()) return fallback;
    std::vector<std::string> words;
    for (const Value& value : found) words.push_back(to_text(value));
    refuse_twice(key, words);
    return words;
  }
  template <typename T>
  void choices(const std::string& key, std::vector<std::string>& words,
               const std::map<std::string, T>& known) const {
    words = this->words(key, words);
    std::string names;
    for (const auto& [name, value] : known) names += (names.empty() ? "" : ", ") + name;
    for (const std::string& word : words) {
      if (!known.contains(word)) fail(key, fmt::format("is '{}'", word), "one of " + names);
    }
  }
  template <typename T>
  void refuse_twice(const std::string& key, std::vector<T> values) const {
    std::ranges::sort(values);
    if (std::ranges::adjacent_find(values) != values.end()) {
      fail(key, "names a value twice", "each value once");
    }
  }
  bool has(const std::string& key) const { return table_.contains(key); }
  [[noreturn]] void fail(const std::string& key, const std::string& problem,
                         const std::string& expected) const {
    TomlTable(table_, file_).fail(key, problem, expected);
  }
  std::string place(const std::string& key) const { return TomlTable(table_, file_).place(key); }

 private:
  const toml::table& table_;
  const std::string& file_;
};

const std::map<std::string, fb::WedgeKind> kKinds{{"coverage", fb::WedgeKind_coverage},
                                                  {"linear", fb::WedgeKind_linear}};
const std::map<std::string, std::optional<functional::LightShape>> kLights{
    {"scene", std::nullopt},
    {"rect", functional::LightShape::rectangle},
    {"sphere", functional::LightShape::sphere}};

std::map<std::string, fb::DepthFormat> depth_formats() {
  std::map<std::string, fb::DepthFormat> formats;
  for (const fb::DepthFormat format : fb::EnumValuesDepthFormat()) {
    formats.emplace(fb::EnumNameDepthFormat(format), format);
  }
  return formats;
}

Options read_options(const Reader& reader, const FrameOverrides& overrides) {
  Options options;
  if (const std::vector<std::string> frames = reader.words("frame", {}); !frames.empty()) {
    options.frames.clear();
    for (const std::string& word : frames) {
      const FrameRange range = frame_range(word);
      if (range.count() == 0) {
        reader.fail("frame", fmt::format("is '{}'", word),
                    "frames such as 5, \"0-34\", \"0-34:5\"");
      }
      if (options.frames.size() + range.count() > kMostPoints) {
        reader.fail("frame", fmt::format("has too many frames in '{}'", word),
                    fmt::format("at most {}", kMostPoints));
      }
      range.append_to(options.frames);
    }
    reader.refuse_twice("frame", options.frames);
  }
  if (const std::vector<std::string> sizes = reader.words("size", {}); !sizes.empty()) {
    options.sizes.clear();
    for (const std::string& word : sizes) {
      options.sizes.push_back(size_of(word));
      if (options.sizes.back()) continue;
      reader.fail("size", fmt::format("is '{}'", word),
                  fmt::format("WIDTHxHEIGHT, 1 to {} pixels each way", kMaxFrameEdge));
    }
  }
  if (overrides.size) options.sizes = {overrides.size};
  if (const std::vector<Value> scales = reader.values("light_scale"); !scales.empty()) {
    options.light_scales.clear();
    for (const Value& value : scales) {
      const double scale = number_of(value).value_or(0.0);
      if (!(scale >= 1e-3 && scale <= 1e3)) {
        reader.fail("light_scale", fmt::format("is '{}'", to_text(value)), "0.001 to 1000");
      }
      options.light_scales.push_back(scale);
    }
    reader.refuse_twice("light_scale", options.light_scales);
  }
  if (const std::vector<Value> sides = reader.values("field_side"); !sides.empty()) {
    options.field_sides.clear();
    for (const Value& value : sides) {
      const int side = whole(to_text(value));
      if (side < 1 || side > functional::kMostFieldSide) {
        reader.fail("field_side", fmt::format("is '{}'", to_text(value)),
                    fmt::format("1 to {}", functional::kMostFieldSide));
      }
      options.field_sides.emplace_back(side);
    }
    reader.refuse_twice("field_side", options.field_sides);
  }
  reader.choices("kind", options.kinds, kKinds);
  reader.choices("light", options.lights, kLights);
  reader.choices("depth", options.depths, depth_formats());
  return options;
}

/// Makes the frames of a scene.
class SceneFrames {
 public:
  SceneFrames(std::string name_or_file, const Reader& reader, std::vector<FrameSpec>& out)
      : name_or_file_(std::move(name_or_file)),
        reader_(reader),
        out_(out),
        source_(functional::scene_source(name_or_file_)) {
    for (const auto& file : source_.files) content_ += content_hash(file);
    if (reader_.has("field_side") && !source_.has_field) {
      reader_.fail("field_side", fmt::format("is set, but {} has no field", source_.name),
                   "a scene with an object that has the key 'field'");
    }
  }

  void add_all(const Options& options) {
    for (const int frame : options.frames) {
      if (frame >= source_.frames) {
        throw InputError(reader_.place("frame"),
                         fmt::format("'{}' has no frame {}", source_.name, frame),
                         fmt::format("0 to {}", source_.frames - 1));
      }
      for (const auto& size : options.sizes) {
        for (const auto side : options.field_sides) {
          for (const double scale : options.light_scales) {
            for (const std::string& kind : options.kinds) {
              for (const std::string& light : options.lights) {
                for (const std::string& depth : options.depths) {
                  add(options, {frame, size, side, scale, kind, light, depth});
                }
              }
            }
          }
        }
      }
    }
  }

 private:
  /// One value of each option.
  struct Choice {
    int frame;
    std::optional<std::pair<int, int>> size;
    std::optional<int> field_side;
    double light_scale;
    std::string kind, light, depth;
  };

  void add(const Options& options, const Choice& choice) {
    FrameSpec spec;
    spec.source = name_or_file_;
    spec.files = source_.files;
    spec.scene.frame = choice.frame;
    spec.scene.size = choice.size;
    spec.scene.field_side = choice.field_side;
    spec.scene.light_scale = choice.light_scale;
    spec.scene.light_shape = kLights.at(choice.light);
    spec.options.kind = kKinds.at(choice.kind);
    spec.options.depth_format = depth_formats().at(choice.depth);
    const auto [width, height] = choice.size.value_or(std::pair(source_.width, source_.height));
    FrameRow& row = spec.row;
    row.scene = source_.name;
    row.parameters = {{"frame", std::int64_t{choice.frame}},
                      {"width", std::int64_t{width}},
                      {"height", std::int64_t{height}},
                      {"light_scale", choice.light_scale},
                      {"kind", choice.kind},
                      {"light", choice.light},
                      {"depth", choice.depth}};
    if (choice.field_side) row.parameters["field_side"] = std::int64_t{*choice.field_side};
    row.label = source_.name;
    if (options.frames.size() > 1) row.label += fmt::format("-f{}", choice.frame);
    if (options.sizes.size() > 1) row.label += fmt::format("-{}x{}", width, height);
    if (options.field_sides.size() > 1) row.label += fmt::format("-n{}", *choice.field_side);
    if (options.light_scales.size() > 1) row.label += fmt::format("-l{}", choice.light_scale);
    if (options.kinds.size() > 1) row.label += '-' + choice.kind;
    if (options.lights.size() > 1) row.label += '-' + choice.light;
    if (options.depths.size() > 1) row.label += '-' + choice.depth;
    row.key = hash_of(source_.name + source_.text + content_ + to_json(row.parameters).dump());
    out_.push_back(std::move(spec));
  }

  std::string name_or_file_;
  const Reader& reader_;
  std::vector<FrameSpec>& out_;
  functional::SceneSource source_;
  std::string content_;
};

FrameSpec trace_frame(const std::filesystem::path& path) {
  const traces::TraceFile trace(path);
  const traces::Header& header = trace.view().header;
  FrameSpec spec;
  spec.source = path.string();
  spec.is_trace = true;
  spec.files = {path};
  spec.row.label = path.stem().string();
  spec.row.scene = header.name;
  spec.row.parameters = {{"width", std::int64_t{header.width}},
                         {"height", std::int64_t{header.height}},
                         {"depth", std::string(fb::EnumNameDepthFormat(header.depth_format))}};
  spec.row.key = hash_of(fmt::format("trace {:016x}", header.checksum));
  return spec;
}

void refuse_equal_labels(const std::vector<FrameSpec>& frames) {
  std::map<std::string, std::string> sources;  // by label
  for (const FrameSpec& frame : frames) {
    const auto [first, is_new] = sources.try_emplace(frame.row.label, frame.source);
    if (is_new) continue;
    throw InputError(frame.source, fmt::format("writes the same files as {}", first->second),
                     "scenes and traces of different names");
  }
}

// A name, or a path that starts at the study's folder.
std::string resolved(const std::string& name_or_file, const std::filesystem::path& folder) {
  const std::filesystem::path path(name_or_file);
  if (path.extension() != ".toml" && !path.has_parent_path()) return name_or_file;
  return (folder / path).string();
}

void read_table(const toml::table& table, const std::string& file, const FrameOverrides& overrides,
                std::vector<FrameSpec>& frames) {
  const TomlTable known(table, file);
  for (const char* key :
       {"scene", "trace", "frame", "size", "field_side", "light_scale", "kind", "light", "depth"}) {
    (void)known.has(key);
  }
  known.reject_unknown();
  const Reader reader(table, file);
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::vector<std::string> scenes = overrides.scenes;
  std::vector<std::string> traces;
  if (scenes.empty()) {
    for (const std::string& scene : reader.words("scene", {})) {
      scenes.push_back(resolved(scene, folder));
    }
    traces = reader.words("trace", {});
  }
  if (scenes.empty() && traces.empty()) {
    known.fail("scene", "is missing", "scenes, or traces in 'trace'");
  }
  const Options options = read_options(reader, overrides);
  for (const std::string& scene : scenes) SceneFrames(scene, reader, frames).add_all(options);
  for (const std::string& trace : traces) frames.push_back(trace_frame(folder / trace));
}

}  // namespace

std::vector<FrameSpec> read_frames(const toml::node& node, const std::string& file,
                                   const FrameOverrides& overrides) {
  std::vector<FrameSpec> frames;
  if (const toml::table* table = node.as_table()) {
    read_table(*table, file, overrides, frames);
  } else if (const toml::array* tables = node.as_array();
             tables != nullptr && tables->is_homogeneous(toml::node_type::table)) {
    for (const toml::node& each : *tables) {
      read_table(*each.as_table(), file, overrides, frames);
      if (!overrides.scenes.empty()) break;  // those of the first
    }
  } else {
    throw InputError(fmt::format("{}:{}", file, node.source().begin.line), "'frames' is no table",
                     "[frames], or several [[frames]]");
  }
  refuse_equal_labels(frames);
  return frames;
}

}  // namespace wedgesim::reports
