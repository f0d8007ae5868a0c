// Whether rolling elements, races, cage and seats of a bearing fit each other.
#pragma once

#include <optional>
#include <string>

#include "bearing/mounted_clearance.hpp"
#include "bearing/parameters.hpp"
#include "mechanics/problem.hpp"

namespace orbearing::bearing {

/// Sizes of a bearing with rollers or balls; what is 0 or absent is not stated, and fits.
struct BearingDesign {
  CylindricalRollers rollers;  // none where balls are stated
  int balls = 0;
  double ball_diameter = 0.0;                             // [m]
  double inner_osculation = 0.0, outer_osculation = 0.0;  // [-]
  double contact_angle = 0.0;                             // [rad]  nominal
  double pitch_diameter = 0.0;                            // [m]
  double radial_clearance = 0.0;                          // [m]
  double bore = 0.0;                                      // [m]
  double outside_diameter = 0.0;                          // [m]
  double width = 0.0;                                     // [m]
  Cage cage;
  Rings rings = Rings::both;
  double pin_bore = 0.0;                   // [m]
  bool caged = true;                       // else what is stated of a cage has no effect
  std::optional<double> pocket_clearance;  // [m]
  std::optional<double> guide_land;        // [m]  diameter; 0: rollers or balls guide the cage
};
template <class Visitor>
void describe(Visitor& visit, BearingDesign& m) {
  using namespace described;
  const auto length = [](auto& member, const char* key) {
    return internal(member, key, "", {.dimension = dimension::length});
  };
  members(visit, m, part(m.rollers), internal(m.balls, "bearing.balls"),
          length(m.ball_diameter, "bearing.ball_diameter"),
          internal(m.inner_osculation, "bearing.inner_osculation"),
          internal(m.outer_osculation, "bearing.outer_osculation"),
          internal(m.contact_angle, "bearing.contact_angle", "", {.dimension = dimension::angle}),
          length(m.pitch_diameter, "bearing.pitch_diameter"),
          length(m.radial_clearance, "bearing.radial_clearance"), length(m.bore, "bearing.bore"),
          length(m.outside_diameter, "bearing.outside_diameter"), length(m.width, "bearing.width"),
          part(m.cage), internal(m.rings, "bearing.rings"), length(m.pin_bore, "bearing.fit.pin_bore"),
          apart(m.caged), length(m.pocket_clearance, "bearing.cage.pocket_clearance"),
          length(m.guide_land, "bearing.cage.guide_land_diameter"));
}
mechanics::Problems problems(const BearingDesign& design);

/// Balls that do not fit around the pitch circle, or that touch their grooves nowhere.
mechanics::Problems ball_problems(const BearingDesign& design);

/// Whether `low` is less than `high` [m], or equals it but for round-off.
bool are_in_order(double low, double high, bool may_equal = false);

/// Lengths of which one must be less than the other, or may equal it; the problem is that of `key`.
/// @param requirement of `low`, such as "a roller within the rings"
/// @param low, high [m]
void require_order(const std::string& key, const char* requirement, double low, double high,
                   mechanics::Problems& found, bool may_equal = false);

}  // namespace orbearing::bearing
