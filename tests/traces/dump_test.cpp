#include "traces/dump.h"

#include <flatbuffers/idl.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/traces/files.h"
#include "tests/traces/sample.h"
#include "traces/format.h"
#include "traces/reader.h"
#include "traces/writer.h"

namespace wedgesim::traces {
namespace {

using nlohmann::json;

std::string json_text(const Trace& trace) {
  std::ostringstream out;
  dump_json(out, trace.view());
  return out.str();
}

bool same_bits(const json& value, double number) {
  return value.is_number() &&
         std::bit_cast<std::uint64_t>(value.get<double>()) == std::bit_cast<std::uint64_t>(number);
}

TEST(DumpJson, FieldsOfTheSample) {
  const Trace trace = sample_trace();
  const json dump = json::parse(json_text(trace));
  EXPECT_EQ(dump["name"], trace.header.name);
  EXPECT_EQ(dump["width"], 4);
  EXPECT_EQ(dump["height"], 3);
  EXPECT_TRUE(same_bits(dump["camera"]["eye"]["z"], -0.0));
  EXPECT_EQ(dump["camera"]["near_rectangle"][2]["y"], 3.0);
  EXPECT_EQ(dump["camera"]["world_from_window"]["columns"][11], 1.0);
  EXPECT_EQ(dump["lights"][0]["shape"], "rectangle");
  EXPECT_EQ(dump["lights"][0]["texture"].size(), 6U);
  EXPECT_TRUE(dump["lights"][1]["texture"].is_null());
  EXPECT_EQ(dump["casters"][0],
            json::parse(R"({"name": "box", "triangles": 12, "z_fail_needed": true})"));
  EXPECT_EQ(dump["vertices"][3], json::parse(R"({"x": -128, "y": 512, "z": 1.5})"));
  EXPECT_EQ(dump["indices"], json(trace.indices));
  EXPECT_TRUE(same_bits(dump["planes"][2]["d"], 1.0 / 3.0));
  EXPECT_EQ(dump["faces"][2],
            json::parse(R"({"first_index": 9, "index_count": 4, "plane": 4, "z_min": 0.25,
                            "z_max": 1.5})"));
  EXPECT_EQ(dump["wedges"][1]["planes"], json::parse("[1, 2, 4, 5, 0, 0, 0, 0]"));
  EXPECT_EQ(dump["wedges"][1]["kind"], "linear");
  EXPECT_EQ(dump["wedges"][1]["umbra"], kNone);
  EXPECT_EQ(dump["wedges"][0]["umbra_plane"], 5);
  EXPECT_TRUE(same_bits(dump["wedges"][1]["linear_factors"][5], 5e-324));
  EXPECT_EQ(dump["umbra_polygons"][1]["role"], "bottom");
  EXPECT_EQ(dump["depth_format"], "unorm24");
  EXPECT_EQ(dump["depth"], json(trace.depth));
  EXPECT_EQ(dump["z_fail_needed"], true);
  EXPECT_EQ(dump["expected_z_method"], "fail");
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_TRUE(same_bits(dump["expected_li"][i], trace.expected_li[i])) << i;
    EXPECT_EQ(dump["li_sensitivity"][i].get<float>(), trace.li_sensitivity[i]) << i;
  }
}

TEST(DumpJson, AbsentSectionsAreNull) {
  Trace trace = sample_trace();
  trace.expected_li.clear();
  trace.li_sensitivity.clear();
  const json dump = json::parse(json_text(trace));
  EXPECT_TRUE(dump.at("expected_li").is_null());
  EXPECT_TRUE(dump.at("li_sensitivity").is_null());
}

TEST(DumpJson, NameThatIsNotUtf8) {
  Trace trace = sample_trace();
  trace.header.name = "\xff\x01";
  EXPECT_EQ(json::parse(json_text(trace))["name"], "\xef\xbf\xbd\x01");
}

std::string schema_text() {
  std::ifstream file(std::string(WEDGESIM_SOURCE_DIR) + "/traces/trace.fbs");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// FlatBuffers' own parser knows the schema's names and refuses others: what it makes of the dump,
// written as a trace file, has the bytes of the trace written at once.
TEST(DumpJson, SchemaReadsItBack) {
  const Folder folder;
  flatbuffers::Parser parser;
  ASSERT_TRUE(parser.Parse(schema_text().c_str())) << parser.error_;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Trace trace = random_trace(seed);
    ASSERT_TRUE(parser.Parse(json_text(trace).c_str())) << parser.error_ << " seed " << seed;
    const auto& builder = parser.builder_;
    FileHeader header;
    header.payload_bytes = builder.GetSize();
    header.checksum =
        checksum_of(std::as_bytes(std::span(builder.GetBufferPointer(), builder.GetSize())));
    Bytes bytes(sizeof header + builder.GetSize());
    std::memcpy(bytes.data(), &header, sizeof header);
    std::memcpy(&bytes[sizeof header], builder.GetBufferPointer(), builder.GetSize());
    write_bytes(folder / "parsed.wtrace", bytes);
    write_trace(folder / "again.wtrace", TraceFile(folder / "parsed.wtrace").view());
    write_trace(folder / "direct.wtrace", trace);
    ASSERT_EQ(read_bytes(folder / "again.wtrace"), read_bytes(folder / "direct.wtrace"))
        << "seed " << seed;
  }
}

struct Mesh {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::pair<std::string, std::vector<std::size_t>>> faces;  // group, 1-based vertices
};

Mesh parse_obj(const std::string& text) {
  Mesh mesh;
  std::istringstream lines(text);
  std::string group;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string what;
    words >> what;
    if (what == "v") {
      std::array<double, 3> v{};
      words >> v[0] >> v[1] >> v[2];
      EXPECT_FALSE(words.fail()) << line;
      mesh.vertices.push_back(v);
    } else if (what == "g") {
      words >> group;
    } else if (what == "f") {
      std::vector<std::size_t> face;
      for (std::size_t index = 0; words >> index;) face.push_back(index);
      mesh.faces.emplace_back(group, face);
    } else {
      EXPECT_EQ(what, "#") << line;
    }
  }
  return mesh;
}

std::string obj_text(const Trace& trace) {
  std::ostringstream out;
  dump_obj(out, trace.view());
  return out.str();
}

// The sample's matrix: world = 2 * (x, y, z) / (1 + z), x and y in pixels.
TEST(DumpObj, WedgesOfTheSample) {
  const Mesh mesh = parse_obj(obj_text(sample_trace()));
  ASSERT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.vertices[0], (std::array<double, 3>{0.0, 0.0, 0.4}));
  EXPECT_EQ(mesh.vertices[1], (std::array<double, 3>{2.0 / 1.5, 0.0, 1.0 / 1.5}));
  EXPECT_EQ(mesh.vertices[3], (std::array<double, 3>{-1.0 / 2.5, 4.0 / 2.5, 3.0 / 2.5}));
  ASSERT_EQ(mesh.faces.size(), 3U);
  EXPECT_EQ(mesh.faces[0], (std::pair{std::string("wedge_0"), std::vector<std::size_t>{1, 2, 3}}));
  EXPECT_EQ(mesh.faces[1].first, "wedge_0");
  EXPECT_EQ(mesh.faces[2],
            (std::pair{std::string("wedge_1"), std::vector<std::size_t>{1, 2, 3, 4}}));
}

TEST(DumpObj, VertexBehindTheEyeLeavesItsFacesOut) {
  Trace trace = sample_trace();
  trace.vertices[1].mutate_z(-1.0);  // w = 0
  const Mesh mesh = parse_obj(obj_text(trace));
  EXPECT_EQ(mesh.vertices.size(), 4U);
  ASSERT_EQ(mesh.faces.size(), 1U);
  EXPECT_EQ(mesh.faces[0].second, (std::vector<std::size_t>{1, 3, 4}));
}

TEST(Summary, CountsOfTheSample) {
  Trace trace = sample_trace();
  trace.header.name = "sam\nple";
  trace.header.checksum = 0xabcU;
  trace.li_sensitivity.clear();
  EXPECT_EQ(summary(trace.view()),
            "name            \"sam\\nple\"\n"
            "checksum        0000000000000abc\n"
            "size            4x3\n"
            "lights          2\n"
            "casters         2\n"
            "vertices        4\n"
            "planes          3\n"
            "faces           3\n"
            "wedges          2 (1 coverage, 1 linear)\n"
            "umbra_polygons  3 (1 side, 1 bottom, 1 cap)\n"
            "depth           unorm24\n"
            "z_fail_needed   true\n"
            "expected_li     present, z-fail\n"
            "li_sensitivity  absent\n");
}

}  // namespace
}  // namespace wedgesim::traces
