#include <fmt/format.h>

#include "reports/claims/claims.h"
#include "reports/table.h"

namespace wedgesim::reports {
namespace {

Table table_of(std::span<const ClaimResult> claims) {
  Table table;
  for (const char* title : {"claim", "Paper, section", "the paper", "measured", "verdict"}) {
    table.add_column(title, Table::Align::left);
  }
  for (const ClaimResult& result : claims) {
    const Claim& claim = *result.claim;
    table.add_row({claim.id, claim.paper + ", " + claim.section, band_text(claim),
                   value_text(claim, result.literal()), std::string(spelling(result.verdict))});
  }
  return table;
}

Table measured_table(const ClaimResult& result) {
  const Claim& claim = *result.claim;
  Table table;
  table.add_column("measured as", Table::Align::left);
  std::vector<std::string> kinds{"linear", "coverage"};
  if (claim.of_methods) kinds = {""};
  for (const std::string& kind : kinds) {
    table.add_column("value", Table::Align::right, kind.empty() ? kind : kind + " wedges");
    table.add_column("in the band", Table::Align::right);
    table.add_column("values", Table::Align::right);
  }
  for (std::size_t i = 0; i < result.measured.size(); ++i) {
    std::vector<std::string> cells{claim.measured[i].definition};
    for (const std::string& kind : kinds) {
      const auto found = result.measured[i].find(kind);
      const Measured measured = found == result.measured[i].end() ? Measured{} : found->second;
      cells.push_back(value_text(claim, measured));
      cells.push_back(measured.count == 0 ? "-" : fmt::format("{:.0f} %", 100 * measured.within));
      cells.push_back(std::to_string(measured.count));
    }
    table.add_row(std::move(cells));
  }
  return table;
}

}  // namespace

std::string band_text(const Claim& claim) {
  return claim.low == claim.high
             ? fmt::format("{:g} {}", claim.low, claim.unit)
             : fmt::format("{:g} to {:g} {}", claim.low, claim.high, claim.unit);
}

std::string value_text(const Claim& claim, const Measured& measured) {
  if (measured.count == 0) return "-";
  const int digits = claim.unit == "times" ? 2 : claim.unit == "pixels" ? 0 : 1;
  const Spread& spread = measured.spread;
  const double value = claim.most ? measured.most : spread.median;
  return fmt::format("{:.{}f} ({:.{}f} to {:.{}f})", value, digits, spread.low, digits, spread.high,
                     digits);
}

Document claims_table(std::span<const ClaimResult> claims) {
  Document document;
  document.heading("Claims of the papers");
  document.paragraph(
      "Measured: the median, or the largest where the paper says up to, and in parentheses the 5th "
      "to 95th percentile, over frames and tiles, on the paper's kind of wedges where that "
      "matters.");
  document.table(table_of(claims));
  return document;
}

Document claims_page(std::span<const ClaimResult> claims, const Results& results) {
  const bool of_methods = !claims.empty() && claims.front().claim->of_methods;
  Document document = claims_table(claims);
  document.paragraph(
      fmt::format("Over {} frames. Made by `wedgesim {} --claims FILE` from "
                  "`reports/claims.toml`: do not edit.",
                  results.frames.size(), of_methods ? "accuracy" : "study claims"));
  for (const ClaimResult& result : claims) {
    const Claim& claim = *result.claim;
    document.heading(claim.id);
    std::string text =
        fmt::format("{} (Paper {}, section {}). Band: {}. Verdict: {}{}.", claim.says, claim.paper,
                    claim.section, band_text(claim), spelling(result.verdict),
                    result.because.empty() ? "" : "; " + result.because);
    if (!claim.scenes.empty()) text += fmt::format(" Scenes: {}.", fmt::join(claim.scenes, ", "));
    document.paragraph(text);
    const bool holds = result.verdict == Verdict::reproduced;
    if (!holds && !claim.likely.empty()) document.paragraph("Likely why: " + claim.likely);
    if (!result.measured.empty()) document.table(measured_table(result));
  }
  return document;
}

}  // namespace wedgesim::reports
