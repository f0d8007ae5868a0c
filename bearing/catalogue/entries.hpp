// Bearings as a catalogue prints them: boundary dimensions and basic ratings. Data that a catalogue does not
// print, rollers and balls, are inferred.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace orbearing::bearing::catalogue {

/// Families of bearings of one row.
enum class Family { cylindrical, deep_groove, angular_contact, needle_cage };

/// Whether the rolling elements are rollers; else balls.
constexpr bool has_rollers(Family family) {
  return family == Family::cylindrical || family == Family::needle_cage;
}

/// One line of a catalogue. 0: a number that it does not print.
struct Entry {
  std::vector<std::string> designations;  // "NU 205", "NJ 205" and "NUP 205" share a line
  Family family = Family::cylindrical;
  std::string maker, suffix, source;  // "NSK", "EW" of its NU 205 EW, "[NSKE1102] B84"
  std::string cage;                   // material as cage_material() names it; empty: not printed
  double bore = 0.0;                  // [m]  d; of a bearing with rings
  double outside = 0.0;               // [m]  D; of a bearing with rings
  double width = 0.0;                 // [m]  B; of a needle cage B_c
  double inner_race = 0.0;            // [m]  F, F_w: diameter of the inner race; with rollers only
  double outer_race = 0.0;            // [m]  E, E_w: of the outer race; with rollers only
  double contact_angle = 0.0;         // [rad]  nominal
  double dynamic_rating = 0.0;        // [N]  C_r
  double static_rating = 0.0;         // [N]  C_0r
  double fatigue_load_limit = 0.0;    // [N]  C_u
  double static_factor = 0.0;         // [-]  f_0 of [ISO76]

  bool operator==(const Entry&) const = default;
};

/// "NSK NU 205 EW": the maker's own bearing of that designation.
std::string full_name(const Entry& entry, std::string_view designation);

/// The line of a designation, which is written as in the line; null where none has it.
const Entry* find(const std::vector<Entry>& entries, std::string_view designation);

/// At most `count` of the designations, those of the same family as `unknown` that are nearest to it in size
/// and series first; of any family where none is of the same.
std::vector<std::string> nearest(const std::vector<std::string>& designations, std::string_view unknown,
                                 std::size_t count);

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
// If the catalogue also prints E (outer race): D_r = (E - F)/2 instead of (1).
//
// Needles in a cage, on shaft and housing. The catalogue prints F_w, E_w, the width B_c of the cage and C_0:
//
//   (7)  D_r = (E_w - F_w)/2,  d_m = (E_w + F_w)/2
//   (8)  Z   the longest needles that leave 2 mm of B_c to the cage and of which C_0 gives a whole number:
//            needles are n - 0.2 mm long (n whole), and 0.4 mm of them are their rounded ends
//   (9)  L   from C_0 by [ISO76], with Z, D_r, d_m
//
// Balls. d_m = (d + D)/2, grooves as [ISO281] states f_c for them;
//
//   (5)  D_b(Z) from C_0 by [ISO76] for each Z that finds room
//   (6)  Z   the one whose C by [ISO281] is nearest to the printed one
//
// The two numbers 0.87 and 1.25 are those of five bearings (docs/bearings.md); nothing else is fitted. C
// is not used for rollers, and selects only a whole number for balls; so it checks the inference.

/// Internal geometry, with the uncertainty that the printed numbers leave.
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

/// Throws std::invalid_argument where no rollers or balls of this section make the static rating.
Inside inside_of(const Entry& entry);

}  // namespace orbearing::bearing::catalogue
