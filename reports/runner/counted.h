#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/count/config.h"
#include "reports/accesses.h"
#include "reports/runner/results.h"

namespace wedgesim::reports {

Accesses accesses_of(const PointRow& point);

/// The points of a study that counts, by frame and configuration.
class CountedPoints {
 public:
  /// \param results  outlives this
  explicit CountedPoints(const Results& results);

  /// Null if the study does not hold it; z and tile_build are not looked at.
  const PointRow* find(const std::string& frame, const model::CountConfig& config) const;
  /// The points of a frame in the study's order.
  const std::vector<const PointRow*>& of(const std::string& frame) const;
  const std::set<unsigned>& tiles() const { return tiles_; }
  /// The tile edge with the fewest accesses if a tile visit costs some too; 0 if there is none.
  /// \param config      of every tile size
  /// \param visit_cost  accesses a tile visit
  unsigned best_tile(const std::string& frame, model::CountConfig config,
                     std::uint64_t visit_cost) const;

 private:
  std::map<std::string, std::vector<const PointRow*>> by_frame_;
  std::map<std::pair<std::string, std::string>, const PointRow*> by_configuration_;
  std::set<unsigned> tiles_;
};

/// What the check of some points' pixels found, in a line; for each that failed, another.
std::string pixels_text(const std::vector<const PointRow*>& points);

}  // namespace wedgesim::reports
