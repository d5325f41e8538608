#include "reports/stress/flag.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "model/count/rounding_bound.h"
#include "model/count/wedge_check.h"

namespace wedgesim::reports::stress {
namespace {

// A reversed depth w has 24 bits however small it is, but 1 - w in double has none beyond 2^-53:
// below w = 2^-26 its rounding is more than 1/8 step of w.
bool is_finer_than_double(const traces::TraceView& trace, std::size_t pixel) {
  if (trace.header.depth_format != traces::fb::DepthFormat_float32_reversed) return false;
  const auto stored = std::bit_cast<float>(trace.depth[pixel]);
  return stored > 0.0F && stored < 0x1p-26F;
}

// What the roundings of contributions, to a word and in the operators before, may add up to: they
// are spread evenly over one unit, a variance of 1/12 each; five standard deviations.
double rounded_together(std::uint32_t contributions, const model::Datapath& datapath) {
  const bool fixed = datapath.kind == model::DatapathKind::fixed;
  const bool single = datapath.kind == model::DatapathKind::float32;
  const double word = fixed ? 1.0 / datapath.one() : 0.0;
  const int bits = fixed ? datapath.formats.significand_bits : (single ? 24 : 53);
  const double operators = std::ldexp(1.0, 2 - bits);
  return 5.0 * std::sqrt(contributions / 12.0) * std::hypot(word, operators);
}

class Flagging {
 public:
  Flagging(const traces::TraceView& trace, const model::Datapath& datapath,
           const Evaluation& evaluation, const Evaluation& exact,
           const std::vector<TraceRounding>& roundings)
      : trace_(trace),
        datapath_(datapath),
        evaluation_(evaluation),
        exact_(exact),
        roundings_(roundings) {}

  std::vector<Flagged> run() {
    foreseen_ = true;
    if (datapath_.kind == model::DatapathKind::fixed) {
      add_at([&](std::size_t i) { return !datapath_.li_holds(evaluation_.sums[i]); },
             "LI leaves its word at a pixel");
    }
    add_constants();
    add_uncertain();
    add_doubtful();
    if (datapath_.kind == model::DatapathKind::exact) {
      add_at([&](std::size_t i) { return is_finer_than_double(trace_, i); },
             "a pixel's stored depth is finer than its window depth in double precision");
    }
    foreseen_ = false;
    add_differing();
    std::vector<Flagged> flagged;
    for (auto& [number, one] : flagged_) flagged.push_back(std::move(one));
    return flagged;
  }

 private:
  // The first reason stays.
  void add(std::uint32_t number, std::string_view reason) {
    flagged_.try_emplace(number, Flagged{number, std::string(reason), foreseen_});
  }

  template <typename Concerns>
  void add_at(const Concerns& concerns, std::string_view reason) {
    std::vector<std::size_t> pixels;
    for (std::size_t i = 0; i < trace_.depth.size(); ++i) {
      if (concerns(i)) pixels.push_back(i);
    }
    for (const auto& numbers : wedges_at(trace_, pixels)) {
      for (const std::uint32_t number : numbers) add(number, reason);
    }
  }

  // Of the trace's numbers, which are double precision.
  void add_constants() {
    for (const model::WedgeFlag& found : model::flag_wedges(trace_, {})) {
      add(found.wedge, model::describe(found.reason));
    }
  }

  // What the trace's matrices and planes, in double precision, have lost: all datapaths lack it.
  void add_uncertain() {
    for (const TraceRounding& rounding : roundings_) {
      if (rounding.uncertain) {
        add(rounding.number, "a plane of it passes a pixel by less than its rounding");
      } else if (rounding.moved > 0.25 * datapath_.tolerance()) {
        add(rounding.number, "rounding may move its edge or its planes by a quarter of the bar");
      }
    }
  }

  void add_doubtful() {
    const model::Operands operands(trace_, datapath_);
    const model::RoundingBound bound(operands, datapath_);
    const model::ZMethod method = trace_.header.expected_z_method == traces::fb::ZMethod_fail
                                      ? model::ZMethod::fail
                                      : model::ZMethod::pass;
    struct Sum {
      double li = 0.0, nearer = 0.0, farther = 0.0;
      std::uint32_t parts = 0;  // that are in doubt
    };
    std::vector<Sum> sums(trace_.depth.size());
    std::vector<std::pair<std::uint32_t, model::Doubt>> doubts;
    const auto look = [&](std::uint32_t number, const model::Primitive& primitive) {
      for (const model::Doubt& doubt : bound(primitive)) {
        Sum& sum = sums[doubt.pixel];
        sum.li += doubt.li;
        sum.nearer += doubt.nearer;
        sum.farther += doubt.farther;
        sum.parts += doubt.li > 0.0 ? 1 : 0;
        if (doubt.li > 0.0) doubts.emplace_back(number, doubt);
      }
    };
    const auto count = static_cast<std::uint32_t>(trace_.wedges.size());
    for (std::uint32_t w = 0; w < count; ++w) {
      look(w, model::wedge_primitive(operands, method, w));
    }
    for (const std::uint32_t i : model::lone_polygons(trace_, method)) {
      look(count + i, model::lone_primitive(operands, method, i));
    }
    const auto rounded = [&](std::size_t i) {
      return rounded_together(evaluation_.contributions[i], datapath_);
    };
    for (const auto& [number, doubt] : doubts) {
      const Sum& sum = sums[doubt.pixel];
      // The sensitivity is in doubt, too.
      const double sensitivity = std::max(std::fabs(sum.nearer), std::fabs(sum.farther));
      const double allowed = datapath_.tolerance() + std::max(0.0, sensitivity - 2.0 * sum.li);
      if (sum.li + rounded(doubt.pixel) > allowed && doubt.li * sum.parts >= sum.li) {
        add(number, "its rounding may show at a pixel");
      }
    }
    add_at([&](std::size_t i) { return rounded(i) > datapath_.tolerance(); },
           "too many contributions are rounded at a pixel");
  }

  // Each difference may be as large as the sensitivity: both together are asked, too.
  void add_differing() {
    const auto sensitivity = [&](std::size_t i) {
      return trace_.li_sensitivity.empty() ? 0.0 : static_cast<double>(trace_.li_sensitivity[i]);
    };
    const auto own = [&](std::size_t i) {
      return static_cast<double>(evaluation_.sums[i]) / datapath_.one();
    };
    const auto exact = [&](std::size_t i) {
      return static_cast<double>(exact_.sums[i]) / model::Datapath().one();
    };
    const auto add_apart = [&](const auto& one, const auto& other, double tolerance,
                               std::string_view reason) {
      add_at(
          [&](std::size_t i) { return std::fabs(one(i) - other(i)) > tolerance + sensitivity(i); },
          reason);
    };
    add_apart(own, exact, datapath_.tolerance(),
              "its pixel's sum differs visibly from double precision");
    if (trace_.expected_li.empty()) return;
    const auto expected = [&](std::size_t i) { return static_cast<double>(trace_.expected_li[i]); };
    constexpr std::string_view kApart = "the block and the renderer differ at a pixel";
    add_apart(exact, expected, 0.25 * datapath_.tolerance(), kApart);
    add_apart(own, expected, datapath_.tolerance(), kApart);
  }

  const traces::TraceView& trace_;
  const model::Datapath& datapath_;
  const Evaluation& evaluation_;
  const Evaluation& exact_;
  const std::vector<TraceRounding>& roundings_;
  std::map<std::uint32_t, Flagged> flagged_;
  bool foreseen_ = false;
};

}  // namespace

std::vector<Flagged> flag(const traces::TraceView& trace, const model::Datapath& datapath,
                          const Evaluation& evaluation, const Evaluation& exact,
                          const std::vector<TraceRounding>& roundings) {
  return Flagging(trace, datapath, evaluation, exact, roundings).run();
}

}  // namespace wedgesim::reports::stress
