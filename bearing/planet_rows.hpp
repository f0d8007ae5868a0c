// Bearings of a planet that are not single rows of cylindrical rollers: kind and arrangement of their rows.
//
//     back-to-back (O)                       face-to-face (X)
//        \  first   second  /                    first      second
//     ----\--o---------o---/----  outer ring   ---o-/------\-o---
//          \              /                        /        \       contact lines, from the outer race
//     -----------------------> z  pin axis     --------------------> z
#pragma once

#include <optional>

#include "mechanics/described.hpp"

namespace orbearing::bearing {

/// Kind of the bearings in a planet.
enum class PlanetBearingType { cylindrical_roller, tapered_roller, spherical_roller, deep_groove_ball };

constexpr described::Names<PlanetBearingType, 4> names_of(PlanetBearingType) {
  return {{{PlanetBearingType::cylindrical_roller, "cylindrical-roller"},
           {PlanetBearingType::tapered_roller, "tapered-roller"},
           {PlanetBearingType::spherical_roller, "spherical-roller"},
           {PlanetBearingType::deep_groove_ball, "deep-groove-ball"}}};
}

/// Arrangement of the two tapered roller bearings of a planet.
enum class RowArrangement {
  back_to_back,  // O: contact lines meet the axis outside of the pair
  face_to_face,  // X: between both rows
};

constexpr described::Names<RowArrangement, 2> names_of(RowArrangement) {
  return {{{RowArrangement::back_to_back, "back-to-back"}, {RowArrangement::face_to_face, "face-to-face"}}};
}

/// Rows of planet bearings in a case, in addition to Bearing, whose rollers are those of one row.
struct PlanetRows {
  PlanetBearingType type = PlanetBearingType::cylindrical_roller;
  double contact_angle = 0.0;  // [rad]  between the normal of the outer race and the radial plane
  RowArrangement arrangement = RowArrangement::back_to_back;
  std::optional<double> distance;  // [m]  between the middles of both rows; none: evenly across the face
  std::optional<double> preload;   // [N]  axial force of each row on the other, without other loads
  std::optional<double> approach;  // [m]  axial displacement by which both rows are pressed together
  int balls = 0;                   // [-]  of a ball bearing, whose grooves are those of Ring
  double ball_diameter = 0.0;      // [m]

  bool is_cylindrical() const { return type == PlanetBearingType::cylindrical_roller; }
  bool is_tapered() const { return type == PlanetBearingType::tapered_roller; }
  bool has_balls() const { return type == PlanetBearingType::deep_groove_ball; }
  /// Rows of one bearing.
  int rows() const { return type == PlanetBearingType::spherical_roller ? 2 : 1; }
};

template <class Visitor>
void describe(Visitor& visit, PlanetRows& m) {
  using namespace described;
  constexpr Where tapered{"bearing.type", "tapered-roller"}, ball{"bearing.type", "deep-groove-ball"};
  members(
      visit, m, apart(m.type),
      input(m.contact_angle, "bearing.rows.contact_angle",
            "contact angle of tapered or spherical rollers: between the normal of the outer race and the "
            "radial plane",
            {.dimension = dimension::angle,
             .range = positive(60.0),
             .where = {"bearing.type", "tapered-roller|spherical-roller"}}),
      input(m.arrangement, "bearing.rows.arrangement",
            "how the two tapered roller bearings of a planet stand to each other: back-to-back (O) or "
            "face-to-face (X)",
            {.where = tapered}),
      input(m.distance, "bearing.rows.distance",
            "distance between the middles of the rollers of both tapered rows; left out: half of the face "
            "width",
            {.dimension = dimension::length, .range = positive(1e4), .where = tapered}),
      input(m.preload, "bearing.rows.preload",
            "axial preload force of a pair of tapered rows without other loads",
            {.dimension = dimension::force, .range = {0.0, 1e9}, .where = tapered}),
      input(m.approach, "bearing.rows.approach",
            "axial displacement by which both tapered rows are pressed together, instead of preload; "
            "negative: axial play of the pair",
            {.dimension = dimension::small_length, .range = {-2000.0, 2000.0}, .where = tapered}),
      input(m.balls, "bearing.balls", "number of balls", {.range = {3, 500}, .where = ball}),
      input(m.ball_diameter, "bearing.ball_diameter", "diameter of a ball",
            {.dimension = dimension::length, .range = positive(1e4), .where = ball}));
}

}  // namespace orbearing::bearing
