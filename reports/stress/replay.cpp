#include "reports/stress/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/table.h"

namespace wedgesim::reports::stress {
namespace {

constexpr std::size_t kWorst = 3;          // pixels of each arithmetic
constexpr std::size_t kMostFlagged = 100;  // lines

const Errors& errors_of(const Measurement& measurement, Arithmetic arithmetic) {
  return measurement.errors[static_cast<std::size_t>(arithmetic)];
}

Table errors_table(const Measurement& measurement) {
  using Align = Table::Align;
  Table table;
  table.add_column("", Align::left);
  for (const char* title : {"error", "excess", "RMS", "RMS inside", "jump"}) {
    table.add_column(title, Align::right);
  }
  for (const char* title : {"off", "beyond", "unflagged", "unforeseen", "specks", "leaks"}) {
    table.add_column(title, Align::right, *title == 'o' ? "pixels" : "");
  }
  for (const char* title :
       {"contributions", "not finite", "saturated", "overflowed", "signs", "wrong signs"}) {
    table.add_column(title, Align::right, *title == 'c' ? "counts" : "");
  }
  table.add_column("", Align::left);
  for (const Arithmetic a : kArithmetics) {
    const Errors& e = errors_of(measurement, a);
    std::vector<std::string> row{std::string(name_of(a))};
    for (const double x : {e.max_error, e.max_excess, e.rms, e.rms_penumbra}) {
      row.push_back(fmt::format("{:.2e}", x));
    }
    row.push_back(e.jump ? fmt::format("{:.2e}", e.jump->excess) : "-");
    for (const std::uint64_t n :
         {e.off, e.beyond, e.unflagged, e.unforeseen, e.specks, e.leaks, e.visits, e.not_finite,
          e.saturated, e.overflowed, e.signs, e.wrong_signs}) {
      row.push_back(std::to_string(n));
    }
    row.emplace_back(e.holds ? "holds" : "does not hold");
    table.add_row(std::move(row));
  }
  return table;
}

std::string pixels_text(const Measurement& measurement) {
  using Align = Table::Align;
  std::vector<std::size_t> pixels;
  for (const Arithmetic a : kArithmetics) {
    for (const std::size_t pixel : worst_pixels(measurement, a, kWorst)) {
      if (std::ranges::find(pixels, pixel) == pixels.end()) pixels.push_back(pixel);
    }
  }
  if (pixels.empty()) return "no pixel is off by more than its sensitivity\n";
  Table table;
  for (const char* title : {"x", "y", "judge", "sensitivity"}) {
    table.add_column(title, Align::right, *title == 'x' ? "worst pixels" : "");
  }
  for (const Arithmetic a : kArithmetics) {
    table.add_column(std::string(name_of(a)), Align::right, a == kArithmetics[0] ? "LI" : "");
  }
  for (const std::size_t pixel : pixels) {
    const auto width = static_cast<std::size_t>(measurement.width);
    std::vector<std::string> row{std::to_string(pixel % width), std::to_string(pixel / width),
                                 fmt::format("{:.9f}", measurement.judge[pixel]),
                                 fmt::format("{:.2e}", measurement.sensitivities[pixel])};
    for (const Arithmetic a : kArithmetics) {
      const bool beyond = !(excess_at(measurement, a, pixel) <= tolerance_of(a));
      row.push_back(
          fmt::format("{:.9f}{}", errors_of(measurement, a).li[pixel], beyond ? "*" : " "));
    }
    table.add_row(std::move(row));
  }
  return table.text() + "* beyond the bar: off by more than the tolerance and the sensitivity\n";
}

// Where what is not a pixel's error breaks the bar.
std::string places_text(const Measurement& measurement) {
  const auto place = [&](std::size_t pixel) {
    const auto width = static_cast<std::size_t>(measurement.width);
    return fmt::format("{},{}", pixel % width, pixel / width);
  };
  std::string text;
  for (const Arithmetic a : kArithmetics) {
    const Errors& e = errors_of(measurement, a);
    if (e.first_leak) {
      text += fmt::format("{}: the sum leaks at pixel {}\n", name_of(a), place(*e.first_leak));
    }
    if (e.jump && e.jump->excess > largest_jump_of(a)) {
      text += fmt::format("{}: a step across a plane of wedge {} is off at pixel {}\n", name_of(a),
                          e.jump->wedge, place(e.jump->pixel));
    }
  }
  return text;
}

std::string flagged_text(const Measurement& measurement) {
  std::string text;
  for (const Arithmetic a : kArithmetics) {
    const auto& flagged = measurement.flagged[static_cast<std::size_t>(a)];
    for (std::size_t i = 0; i < flagged.size(); ++i) {
      if (i == kMostFlagged) {
        text += fmt::format("{}: {} more wedges flagged\n", name_of(a), flagged.size() - i);
        break;
      }
      const bool is_wedge = flagged[i].wedge < measurement.wedges;
      text += fmt::format("{}: {} {} {}: {}\n", name_of(a), is_wedge ? "wedge" : "umbra polygon",
                          flagged[i].wedge - (is_wedge ? 0 : measurement.wedges),
                          flagged[i].foreseen ? "foreseen" : "flagged", flagged[i].reason);
    }
  }
  return text;
}

}  // namespace

double excess_at(const Measurement& measurement, Arithmetic arithmetic, std::size_t pixel) {
  const double error =
      std::fabs(errors_of(measurement, arithmetic).li[pixel] - measurement.judge[pixel]);
  if (std::isnan(measurement.judge[pixel])) return 0.0;  // sky
  if (!std::isfinite(error)) return std::numeric_limits<double>::infinity();
  return error - measurement.sensitivities[pixel];
}

std::vector<std::size_t> worst_pixels(const Measurement& measurement, Arithmetic arithmetic,
                                      std::size_t most) {
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < measurement.judge.size(); ++i) {
    if (excess_at(measurement, arithmetic, i) > 0.0) pixels.push_back(i);
  }
  std::ranges::stable_sort(pixels, std::ranges::greater(),
                           [&](std::size_t i) { return excess_at(measurement, arithmetic, i); });
  pixels.resize(std::min(pixels.size(), most));
  return pixels;
}

std::optional<Arithmetic> first_beyond(const Measurement& measurement) {
  for (const Arithmetic a : kArithmetics) {
    if (errors_of(measurement, a).beyond > 0) return a;
  }
  return {};
}

std::string replay_text(const CaseName& name, const Measurement& measurement) {
  const std::string unit = name.family->unit.empty() ? "" : fmt::format(" {}", name.family->unit);
  std::string text = fmt::format("{}, seed {}, difficulty {}{}: {}\n", name.family->name, name.seed,
                                 difficulty_text(name.difficulty), unit, name.family->parameter);
  if (measurement.refused) return text + fmt::format("refused: {}\n", *measurement.refused);
  text +=
      fmt::format("{}x{} pixels, {} of them judged; {} wedges, {} degenerate; condition {:.1e}\n\n",
                  measurement.width, measurement.height, measurement.judged, measurement.wedges,
                  measurement.degenerate_wedges, measurement.condition);
  text += errors_table(measurement).text() + "\n" + pixels_text(measurement);
  text += places_text(measurement) + flagged_text(measurement);
  if (!measurement.configurations_agree) {
    text += "modes, cullings and tile sizes do not agree\n";
  }
  return text;
}

bool replay_holds(const CaseName& name, const Measurement& measurement) {
  if (measurement.refused) return name.family->may_refuse;
  return measurement.configurations_agree && std::ranges::all_of(kArithmetics, [&](Arithmetic a) {
           return errors_of(measurement, a).unforeseen == 0;
         });
}

}  // namespace wedgesim::reports::stress
