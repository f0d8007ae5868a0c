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

// Rollers and balls inside a bearing of which a catalogue prints boundary dimensions and ratings.
//
// Cylindrical rollers. The catalogue prints d, D, F (inner race) and C_0. With the walls of the rings
// t_i = (F - d)/2 and t_o = 0.87 t_i:
//
//   (1)  D_r = (D - d)/2 - t_i - t_o, to the next half millimetre     rollers are made in such sizes
//   (2)  d_m = F + D_r
//   (3)  Z   = pi d_m/(1.25 D_r), to the next whole number            room for the bars of the cage
//   (4)  L   from C_0 by [ISO76], with Z, D_r, d_m
//
// Balls. d_m = (d + D)/2, grooves as [ISO281] states f_c for them;
//
//   (5)  D_b(Z) from C_0 by [ISO76] for each Z that finds room
//   (6)  Z   the one whose C by [ISO281] is nearest to the printed one
//
// The two numbers 0.87 and 1.25 are those of five bearings (docs/bearings.md); nothing else is fitted. C
// takes no part for rollers, and chooses a whole number alone for balls; so it checks the inference.

/// What is inside, with how far the printed numbers leave it open.
struct Inside {
  int elements = 0;             // [-]  rollers or balls
  double diameter = 0.0;        // [m]
  double length = 0.0;          // [m]  of rollers, effective; 0 for balls
  double pitch_diameter = 0.0;  // [m]
  double dynamic_rating = 0.0;  // [N]  C of [ISO281] by this geometry
  double static_rating = 0.0;   // [N]  C_0 of [ISO76]
  /// Relative change of the length of rollers, or diameter of balls, with one roller or ball more and the
  /// same C_0: the number may err by one.
  double per_element = 0.0;  // [-]
};

/// Throws std::invalid_argument where no ball of any number makes the static rating.
Inside inside_of(const Entry& entry);

}  // namespace orbearing::bearing::catalogue
