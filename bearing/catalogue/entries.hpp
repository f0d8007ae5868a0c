// Bearings as a catalogue prints them: boundary dimensions and basic ratings. What a catalogue does not
// print, rollers and balls, is inferred (inference.hpp).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace orbearing::bearing::catalogue {

/// Families of bearings of one row.
enum class Family { cylindrical, deep_groove, angular_contact };

/// One line of a catalogue. All numbers were read in [NSKE1102].
struct Entry {
  std::string_view
      number;  // "205" of NU 205, NJ 205 and NUP 205, else the whole designation: "6205", "7205 A"
  Family family = Family::cylindrical;
  double bore = 0.0;            // [m]  d
  double outside = 0.0;         // [m]  D
  double width = 0.0;           // [m]  B
  double dynamic_rating = 0.0;  // [N]  C_r
  double static_rating = 0.0;   // [N]  C_0r
  double inner_race = 0.0;      // [m]  F_w, diameter of the inner race; cylindrical rollers only
  double contact_angle = 0.0;   // [rad]  nominal
  double static_factor = 0.0;   // [-]  f_0 of [ISO76]; 0: not printed
};

/// All lines, cylindrical rollers first, each family by bore.
const std::vector<Entry>& entries();

/// Every designation that `find` knows, as it is written: "NU 205", "NJ 205", "6205", "7205 A".
const std::vector<std::string>& designations();

/// The line of "NU 205"; null for one that is not in the table. Written as in `designations`.
const Entry* find(std::string_view designation);

}  // namespace orbearing::bearing::catalogue
