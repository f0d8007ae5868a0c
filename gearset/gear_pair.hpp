// A pair of external gears on two fixed shafts.
#pragma once

#include <array>

#include "gearset/contact_path.hpp"
#include "gearset/parameters.hpp"
#include "gearset/tooth_form.hpp"
#include "gearset/warning.hpp"

namespace orbearing::gearset {

/// What the user states about a pair; the first gear drives.
struct GearPair {
  std::array<int, 2> teeth = {0, 0};
  std::array<double, 2> shift = {0.0, 0.0};  // [module]
  double module = 0.0;                       // [m]
  double face_width = 0.0;                   // [m]
  double bore = 0.0;                         // [m]  diameter, of both gears
  BasicRack rack;
};

/// The pair as assembled without backlash.
struct PairGeometry {
  std::array<ExternalTooth, 2> gears;
  double centre_distance = 0.0;         // [m]
  double working_pressure_angle = 0.0;  // [rad]
  ContactPath path;                     // from the tangent point on the second gear's base circle
  double contact_ratio = 0.0;           // [-]
};

/// Centre distance from the shifts by Eq. (2) of gearset/README.md.
/// @throws std::domain_error if the shifts leave no working pressure angle, or a tooth cannot be formed
PairGeometry pair_geometry(const GearPair& pair);

/// Reasons why the pair cannot be built; empty if it can. Places are "pair.teeth" and so on.
Warnings pair_problems(const GearPair& pair);

/// Faults of a pair that runs all the same.
Warnings pair_warnings(const PairGeometry& geometry);

}  // namespace orbearing::gearset
