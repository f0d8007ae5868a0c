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
  double helix_angle = 0.0;  // [rad]  at the reference circle; positive: the first gear is right-handed
  Web web;                   // of the softer gear
};

template <class Visitor>
void describe(Visitor& visit, GearPair& m) {
  using namespace described;
  const auto length = [](double& member, std::string path, std::string meaning, double most) {
    return field(member, std::move(path), Physics::pair, std::move(meaning),
                 {.models = gear_pair,
                  .required_by = gear_pair,
                  .dimension = dimension::length,
                  .range = positive(most)});
  };
  members(visit, m,
          field(m.teeth, "pair.teeth", Physics::pair, "teeth of both gears, the driving one first",
                {.models = gear_pair, .required_by = gear_pair, .range = {5, 2000}}),
          length(m.module, "pair.module", "normal module", 100.0),
          length(m.face_width, "pair.face_width", "width of the teeth", 1e4),
          length(m.bore, "pair.bore", "bore of both gears, held by a rigid shaft", 1e5),
          part(m.rack, [&] { describe_rack(visit, m.rack, "pair.", Physics::pair, gear_pair); }),
          field(m.shift, "pair.profile_shift", Physics::pair, "profile shifts of both gears, in modules",
                {.models = gear_pair, .range = {-2.0, 2.0}, .reason = "standard gears"}),
          helix_row(m.helix_angle, "pair.", Physics::pair, gear_pair, "first gear"),
          part(m.web, [&] { describe_web(visit, m.web, "pair.", Physics::pair, gear_pair); }));
}

/// The pair as assembled without backlash.
struct PairGeometry {
  std::array<ExternalTooth, 2> gears;
  double centre_distance = 0.0;         // [m]
  double working_pressure_angle = 0.0;  // [rad]
  ContactPath path;                     // from the tangent point on the second gear's base circle
  double contact_ratio = 0.0;           // [-]    transverse
  double base_helix_angle = 0.0;        // [rad]  positive: the first gear is right-handed
  double overlap_ratio = 0.0;           // [-]
};

/// Centre distance from the shifts by Eq. (2) of gearset/README.md.
/// @throws std::domain_error if the shifts leave no working pressure angle, or a tooth cannot be formed
PairGeometry pair_geometry(const GearPair& pair);

/// Reasons why the pair cannot be built; empty if it can. Places are "pair.teeth" and so on.
Warnings pair_problems(const GearPair& pair);

/// Faults of a pair that runs all the same.
Warnings pair_warnings(const PairGeometry& geometry);

}  // namespace orbearing::gearset
