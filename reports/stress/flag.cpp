#include "reports/stress/flag.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>

#include "model/count/wedge_check.h"

namespace wedgesim::reports::stress {
namespace {

// Roundings to nearest are spread evenly over one unit: a variance of 1/12 each.
bool rounds_too_often(std::uint32_t contributions, const model::Datapath& datapath) {
  const double deviation = std::sqrt(contributions / 12.0) / datapath.one();
  return 5.0 * deviation > datapath.tolerance();
}

// A primitive's error at a pixel from here on counts: several may add up to the tolerance.
constexpr double kVisible = 0.125 / 255.0;

// A reversed depth w has 24 bits however small it is, but 1 - w in double has none beyond 2^-53:
// below w = 2^-26 its rounding is more than 1/8 step of w.
bool is_finer_than_double(const traces::TraceView& trace, std::size_t pixel) {
  if (trace.header.depth_format != traces::fb::DepthFormat_float32_reversed) return false;
  const auto stored = std::bit_cast<float>(trace.depth[pixel]);
  return stored > 0.0F && stored < 0x1p-26F;
}

bool differ(const Evaluation::Part& part, const Evaluation::Part& exact) {
  auto other = exact.shares.begin();
  for (const Evaluation::Share& share : part.shares) {
    for (; other != exact.shares.end() && other->pixel < share.pixel; ++other) {
      if (std::fabs(other->li) > kVisible) return true;
    }
    const bool both = other != exact.shares.end() && other->pixel == share.pixel;
    if (std::fabs(share.li - (both ? other->li : 0.0)) > kVisible) return true;
    if (both) ++other;
  }
  return std::any_of(other, exact.shares.end(),
                     [](const Evaluation::Share& share) { return std::fabs(share.li) > kVisible; });
}

}  // namespace

std::vector<Flagged> flag(const traces::TraceView& trace, const model::Datapath& datapath,
                          const Evaluation& evaluation, const Evaluation& exact) {
  std::map<std::uint32_t, std::string_view> reasons;
  std::set<std::uint32_t> by_constants;
  for (const model::WedgeFlag& found : model::flag_wedges(trace, datapath)) {
    reasons.emplace(found.wedge, model::describe(found.reason));
    by_constants.insert(found.wedge);
  }
  for (std::size_t i = 0; i < evaluation.parts.size(); ++i) {
    const Evaluation::Part& part = evaluation.parts[i];
    if (part.uncertain) {
      reasons.emplace(part.number, "a plane of it passes a pixel by less than its rounding");
    } else if (part.rounding > 0.25 * datapath.tolerance()) {
      reasons.emplace(part.number,
                      "rounding may move its edge in the light by a quarter of the bar");
    } else if (differ(part, exact.parts[i])) {
      reasons.emplace(part.number, "it differs visibly from double precision at a pixel");
    }
  }
  const auto add_at = [&](const auto& concerns, std::string_view reason) {
    std::vector<std::size_t> pixels;
    for (std::size_t i = 0; i < evaluation.sums.size(); ++i) {
      if (concerns(i)) pixels.push_back(i);
    }
    for (const auto& numbers : wedges_at(trace, pixels)) {
      for (const std::uint32_t number : numbers) reasons.emplace(number, reason);
    }
  };
  if (datapath.kind == model::DatapathKind::fixed) {
    add_at([&](std::size_t i) { return !datapath.li_holds(evaluation.sums[i]); },
           "LI leaves its word at a pixel");
    add_at([&](std::size_t i) { return rounds_too_often(evaluation.contributions[i], datapath); },
           "too many contributions are rounded at a pixel");
  }
  const auto li = [](const Evaluation& of, std::size_t i, double one) {
    return static_cast<double>(of.sums[i]) / one;
  };
  const double exact_one = model::Datapath().one();
  add_at(
      [&](std::size_t i) {
        const double error = li(evaluation, i, datapath.one()) - li(exact, i, exact_one);
        return std::fabs(error) > 0.5 * datapath.tolerance();
      },
      "its pixel's sum differs visibly from double precision");
  add_at([&](std::size_t i) { return is_finer_than_double(trace, i); },
         "a pixel's stored depth is finer than its window depth in double precision");
  if (!trace.expected_li.empty()) {
    // What the trace's matrices and planes have lost, all datapaths lack.
    add_at(
        [&](std::size_t i) {
          const double sensitivity = trace.li_sensitivity.empty() ? 0.0 : trace.li_sensitivity[i];
          const double error = li(exact, i, exact_one) - trace.expected_li[i];
          return std::fabs(error) > 0.25 * datapath.tolerance() + sensitivity;
        },
        "the block and the renderer differ at a pixel");
  }
  std::vector<Flagged> flagged;
  for (const auto& [number, reason] : reasons) {
    flagged.push_back({number, std::string(reason), by_constants.contains(number)});
  }
  return flagged;
}

}  // namespace wedgesim::reports::stress
