#pragma once

#include <array>
#include <filesystem>
#include <string_view>

#include "model/datapath/li_word.h"
#include "model/datapath/rounder.h"

namespace wedgesim {
class TomlTable;
}

namespace wedgesim::model::datapath {

/// The widths of the fixed datapath that may be chosen.
struct Formats {
  int form_bits = 58;         // of the values of planes and other linear forms
  int significand_bits = 18;  // of every operator on them
  LiWord li;
  int stencil_bits = 8;

  Rounder round() const { return Rounder(significand_bits); }
};

/// One width: file reader, command line and documents share the table below.
struct Width {
  std::string_view key;  // in a formats file
  int& (*of)(Formats& formats);
  int low, high;
  std::string_view what;
  std::string_view why;  // the default
};

// clang-format off
inline constexpr std::array kWidths{
    Width{"form_bits", [](Formats& f) -> int& { return f.form_bits; }, 24, 62,
          "bits of the value of a plane or another linear form, sign included",
          "signs and ratios near contact; 53 hold the pixel bars on the scenes"},
    Width{"significand_bits", [](Formats& f) -> int& { return f.significand_bits; }, Rounder::kMinBits, Rounder::kMaxBits,
          "significant bits of every operator of intensity and coverage",
          "12 hold the pixel bars on the scenes"},
    Width{"li_integer_bits", [](Formats& f) -> int& { return f.li.integer_bits; }, 2, 24,
          "bits of an LI word before its point, sign included",
          "16 full lights"},
    Width{"li_fraction_bits", [](Formats& f) -> int& { return f.li.fraction_bits; }, 4, 24,
          "bits of an LI word after its point",
          "48 contributions a pixel stay within an RMS of 0.25/255"},
    Width{"stencil_bits", [](Formats& f) -> int& { return f.stencil_bits; }, 4, 16,
          "bits of a stencil word, sign included",
          "what graphics hardware has"},
};
// clang-format on

/// Sets the formats that a table holds, and rejects other keys.
/// \param complete  every key must be there
/// \throws InputError naming file, line and key
void read_formats(const TomlTable& table, bool complete, Formats& formats);

/// The default formats with the keys of kWidths that a TOML file sets.
/// \throws InputError naming file, line and key
Formats read_formats(const std::filesystem::path& file);

}  // namespace wedgesim::model::datapath
