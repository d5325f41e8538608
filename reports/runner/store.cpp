#include "reports/runner/store.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "base/error.h"
#include "base/file.h"
#include "reports/runner/value.h"

namespace wedgesim::reports {
namespace {

constexpr std::array<std::string_view, 4> kStates{"done", "failed", "crashed", "overtime"};
constexpr std::string_view kSchema = "wedgesim.study/1";

constexpr const char* kTables[] = {
    "CREATE TABLE IF NOT EXISTS study (key TEXT PRIMARY KEY, value TEXT NOT NULL)",
    "CREATE TABLE IF NOT EXISTS frames (label TEXT PRIMARY KEY, position INTEGER, key TEXT, "
    "scene TEXT, parameters TEXT, checksum TEXT, wedges INTEGER, failure TEXT, pictures TEXT, "
    "seconds REAL, sources TEXT)",
    "CREATE TABLE IF NOT EXISTS points (frame TEXT, key TEXT, position INTEGER, measure TEXT, "
    "configuration TEXT, state TEXT, message TEXT, metrics TEXT, seconds REAL, sources TEXT, "
    "PRIMARY KEY (frame, key))"};

std::filesystem::path made(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder.string(), error.message(), "a folder that can be written");
  return results_path(folder);
}

PointState parse_state(std::string_view text) {
  for (std::size_t i = 0; i < kStates.size(); ++i) {
    if (kStates[i] == text) return static_cast<PointState>(i);
  }
  return PointState::failed;
}

Json head_json(const StudyHead& study) {
  Json plots = Json::array();
  for (const Plot& plot : study.plots) {
    plots.push_back({{"kind", plot.kind},
                     {"title", plot.title},
                     {"x", plot.x},
                     {"y", plot.y},
                     {"series", plot.series}});
  }
  return {{"name", study.name},
          {"title", study.title},
          {"question", study.question},
          {"measure", study.measure},
          {"axes", study.axes},
          {"by", study.by},
          {"metrics", study.metrics},
          {"modes_tables", study.modes_tables},
          {"claims", study.claims},
          {"check_pixels", study.check_pixels},
          {"plots", plots}};
}

StudyHead head_of(const Json& json) {
  StudyHead study;
  json.at("name").get_to(study.name);
  json.at("title").get_to(study.title);
  json.at("question").get_to(study.question);
  json.at("measure").get_to(study.measure);
  json.at("axes").get_to(study.axes);
  json.at("by").get_to(study.by);
  json.at("metrics").get_to(study.metrics);
  json.at("modes_tables").get_to(study.modes_tables);
  json.at("claims").get_to(study.claims);
  json.at("check_pixels").get_to(study.check_pixels);
  for (const Json& plot : json.at("plots")) {
    study.plots.push_back(
        {plot.at("kind"), plot.at("title"), plot.at("x"), plot.at("y"), plot.at("series")});
  }
  return study;
}

std::string hex(std::uint64_t checksum) { return fmt::format("{:016x}", checksum); }

std::uint64_t checksum_of(const std::string& text) {
  std::uint64_t checksum = 0;
  std::from_chars(text.data(), text.data() + text.size(), checksum, 16);
  return checksum;
}

constexpr const char* kFrameColumns =
    "label, key, scene, parameters, checksum, wedges, failure, pictures, seconds";

FrameRow frame_of(const Statement& row) {
  FrameRow frame;
  frame.label = row.text(0);
  frame.key = row.text(1);
  frame.scene = row.text(2);
  frame.parameters = values_of(Json::parse(row.text(3)));
  frame.checksum = checksum_of(row.text(4));
  frame.wedges = row.integer(5);
  frame.failure = row.text(6);
  frame.pictures = row.text(7);
  frame.seconds = row.number(8);
  return frame;
}

PointRow point_of(const Statement& row) {
  PointRow point;
  point.frame = row.text(0);
  point.key = row.text(1);
  point.measure = row.text(2);
  point.configuration = values_of(Json::parse(row.text(3)));
  point.state = parse_state(row.text(4));
  point.message = row.text(5);
  point.metrics = values_of(Json::parse(row.text(6)));
  point.seconds = row.number(7);
  return point;
}

std::string study_value(Database& database, std::string_view key) {
  Statement row(database, "SELECT value FROM study WHERE key = ?");
  row.bind(key);
  return row.step() ? row.text(0) : std::string();
}

}  // namespace

std::filesystem::path results_path(const std::filesystem::path& folder) {
  return folder / "results.sqlite";
}

std::string_view spelling(PointState state) { return kStates[static_cast<std::size_t>(state)]; }

Store::Store(const std::filesystem::path& folder, std::string sources)
    : database_(made(folder), Database::Access::exclusive), sources_(std::move(sources)) {
  for (const char* table : kTables) database_.run(table);
}

Store::~Store() {
  try {
    database_.run("PRAGMA journal_mode = DELETE");
  } catch (const InputError&) {  // then the journal stays beside it
  }
}

void Store::begin(const StudyHead& study, std::int64_t points) {
  Transaction transaction(database_);
  database_.run("DELETE FROM study");
  Statement insert(database_, "INSERT INTO study VALUES (?, ?)");
  const std::pair<const char*, std::string> values[] = {{"schema", std::string(kSchema)},
                                                        {"sources", sources_},
                                                        {"study", head_json(study).dump()},
                                                        {"points", std::to_string(points)}};
  for (const auto& [key, value] : values) insert.bind(key).bind(value).run();
  database_.run("UPDATE frames SET position = NULL");
  database_.run("UPDATE points SET position = NULL");
  transaction.commit();
}

std::map<std::string, FrameRow> Store::known_frames() {
  Statement rows(database_, fmt::format("SELECT {} FROM frames WHERE sources = ?", kFrameColumns));
  rows.bind(sources_);
  std::map<std::string, FrameRow> frames;
  while (rows.step()) {
    FrameRow frame = frame_of(rows);
    frames.emplace(frame.key, std::move(frame));
  }
  return frames;
}

void Store::write(const FrameRow& frame, Position position) {
  Statement(database_, "INSERT OR REPLACE INTO frames VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(frame.label)
      .bind(position)
      .bind(frame.key)
      .bind(frame.scene)
      .bind(to_json(frame.parameters).dump())
      .bind(hex(frame.checksum))
      .bind(frame.wedges)
      .bind(frame.failure)
      .bind(frame.pictures)
      .bind(frame.seconds)
      .bind(sources_)
      .run();
}

void Store::keep(const FrameRow& frame, Position position) {
  Transaction transaction(database_);
  write(frame, position);
  transaction.commit();
}

std::map<std::string, PointState> Store::point_states(const std::string& frame) {
  Statement rows(database_, "SELECT key, state FROM points WHERE frame = ? AND sources = ?");
  rows.bind(frame).bind(sources_);
  std::map<std::string, PointState> states;
  while (rows.step()) states.emplace(rows.text(0), parse_state(rows.text(1)));
  return states;
}

PointState Store::failure_state(const FrameRow& frame) {
  Statement row(database_,
                "SELECT state FROM points WHERE frame = ? AND message = ? AND sources = ?");
  row.bind(frame.label).bind(frame.failure).bind(sources_);
  return row.step() ? parse_state(row.text(0)) : PointState::failed;
}

void Store::place(const std::string& frame, const std::map<std::string, Position>& positions) {
  Transaction transaction(database_);
  Statement update(database_, "UPDATE points SET position = ? WHERE frame = ? AND key = ?");
  for (const auto& [key, position] : positions) update.bind(position).bind(frame).bind(key).run();
  transaction.commit();
}

void Store::write(const PointRow& point, Position position) {
  Statement(database_, "INSERT OR REPLACE INTO points VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(point.frame)
      .bind(point.key)
      .bind(position)
      .bind(point.measure)
      .bind(to_json(point.configuration).dump())
      .bind(spelling(point.state))
      .bind(point.message)
      .bind(to_json(point.metrics).dump())
      .bind(point.seconds)
      .bind(sources_)
      .run();
}

void Store::keep(const PointRow& point, Position position) {
  Transaction transaction(database_);
  write(point, position);
  transaction.commit();
}

void Store::keep_all(const std::map<Position, FrameRow>& frames,
                     const std::map<Position, PointRow>& points) {
  Transaction transaction(database_);
  for (const auto& [position, frame] : frames) write(frame, position);
  for (const auto& [position, point] : points) write(point, position);
  transaction.commit();
}

Stored read_stored(const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::exists(results_path(folder), error)) {
    throw InputError(folder.string(), "holds no results.sqlite", "the folder of a study");
  }
  Database database(results_path(folder), Database::Access::read);
  if (study_value(database, "schema") != kSchema) {
    database.fail(fmt::format("does not hold {}", kSchema));
  }
  Stored stored;
  try {
    stored.study = head_of(Json::parse(study_value(database, "study")));
    stored.sources = study_value(database, "sources");
    stored.points_planned = std::stoll(study_value(database, "points"));
    Statement frames(database, fmt::format("SELECT {}, position FROM frames WHERE position IS NOT "
                                           "NULL",
                                           kFrameColumns));
    while (frames.step()) stored.frames.emplace(frames.integer(9), frame_of(frames));
    Statement points(database,
                     "SELECT frame, key, measure, configuration, state, message, metrics, seconds, "
                     "position FROM points WHERE position IS NOT NULL");
    while (points.step()) stored.points.emplace(points.integer(8), point_of(points));
  } catch (const Json::exception& wrong) {
    database.fail(wrong.what());
  }
  return stored;
}

Results read_results(const std::filesystem::path& folder) {
  Stored stored = read_stored(folder);
  Results results;
  results.study = std::move(stored.study);
  results.points_planned = stored.points_planned;
  for (auto& [position, frame] : stored.frames) results.frames.push_back(std::move(frame));
  for (auto& [position, point] : stored.points) results.points.push_back(std::move(point));
  return results;
}

}  // namespace wedgesim::reports
