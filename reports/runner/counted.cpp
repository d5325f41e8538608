#include "reports/runner/counted.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "reports/runner/metrics.h"
#include "reports/runner/value.h"
#include "reports/table.h"

namespace wedgesim::reports {
namespace {

constexpr const char* kKeys[] = {"block.mode",       "block.tile",   "block.cull",
                                 "block.umbra_cull", "block.accept", "block.share"};

std::string key_of(const PointRow& point) {
  std::string key;
  for (const char* name : kKeys) key += to_text(find_value(point.configuration, name)) + ' ';
  return key;
}

std::string key_of(const model::CountConfig& config) {
  return fmt::format("{} {} {} {} {} {} ", spelling(config.mode), config.tile,
                     spelling(config.cull), spelling(config.umbra_cull), spelling(config.accept),
                     spelling(config.share));
}

std::uint64_t whole(const PointRow& point, std::string_view metric) {
  return static_cast<std::uint64_t>(number_of(find_value(point.metrics, metric)).value_or(0.0));
}

double number(const PointRow& point, std::string_view metric) {
  return number_of(find_value(point.metrics, metric)).value_or(0.0);
}

}  // namespace

Accesses accesses_of(const PointRow& point) {
  return {whole(point, "z_reads"), whole(point, "li_writes"), whole(point, "tile_visits")};
}

CountedPoints::CountedPoints(const Results& results) {
  for (const PointRow& point : results.points) {
    if (point.measure != "count" || point.state != PointState::done) continue;
    by_frame_[point.frame].push_back(&point);
    by_configuration_.emplace(std::pair(point.frame, key_of(point)), &point);
    const auto tile = number_of(find_value(point.configuration, "block.tile"));
    tiles_.insert(static_cast<unsigned>(tile.value_or(0.0)));
  }
}

const PointRow* CountedPoints::find(const std::string& frame,
                                    const model::CountConfig& config) const {
  const auto found = by_configuration_.find(std::pair(frame, key_of(config)));
  return found == by_configuration_.end() ? nullptr : found->second;
}

const std::vector<const PointRow*>& CountedPoints::of(const std::string& frame) const {
  static const std::vector<const PointRow*> none;
  const auto found = by_frame_.find(frame);
  return found == by_frame_.end() ? none : found->second;
}

unsigned CountedPoints::best_tile(const std::string& frame, model::CountConfig config,
                                  std::uint64_t visit_cost) const {
  unsigned best = 0;
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  for (const unsigned tile : tiles_) {
    config.tile = tile;
    const PointRow* point = find(frame, config);
    if (point == nullptr) continue;
    const Accesses accesses = accesses_of(*point);
    const std::uint64_t cost = accesses.total() + visit_cost * accesses.visits;
    if (cost < least) {
      least = cost;
      best = tile;
    }
  }
  return best;
}

std::string pixels_text(const std::vector<const PointRow*>& points) {
  if (points.empty()) return "pixels: none compared";
  std::uint64_t compared = 0, mismatched = 0, wrong = 0;
  double max_error = 0.0, rms_error = 0.0, tolerance = 0.0;
  bool has_rms = false;
  std::string failed;
  for (const PointRow* point : points) {
    compared = std::max(compared, whole(*point, "compared"));
    mismatched += whole(*point, "mismatched");
    wrong += whole(*point, "wrong_contributions");
    max_error = std::max(max_error, number(*point, "max_error"));
    rms_error = std::max(rms_error, number(*point, "rms_error"));
    has_rms |= point->metrics.contains("rms_error");  // the block's check has none
    tolerance = std::max(tolerance, number(*point, "tolerance"));
    if (held(*point)) continue;
    failed += fmt::format("\nFAILED: {}: {}: {} pixels mismatched, {} contributions lost",
                          point->frame, key_of(*point), grouped(whole(*point, "mismatched")),
                          grouped(whole(*point, "wrong_contributions")));
  }
  return fmt::format(
             "pixels: {} compared in {} configurations; max error {:.2g}, RMS {:.2g}, {} "
             "mismatched "
             "(tolerance {:g} plus sensitivity)",
             grouped(compared), points.size(), max_error, rms_error, grouped(mismatched),
             tolerance) +
         failed;
}

}  // namespace wedgesim::reports
