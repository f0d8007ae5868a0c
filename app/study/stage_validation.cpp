#include "app/study/stage_validation.hpp"

#include "gearset/drivetrain/power_flow.hpp"
#include "gearset/mean_loads.hpp"

namespace orbearing::app {

ValidationTable stage_validation() {
  constexpr double torque = 325e3;           // [N m]  of the rotor, on the carrier
  constexpr double centre_distance = 0.308;  // [m]    of the helical gears, as stated
  constexpr int bearings_per_planet = 2;
  constexpr double recomputed = 175.9;                // [kN]
  constexpr double half_a_digit = 0.05 / recomputed;  // of the number it is compared with
  const gearset::PlanetarySet stage{.sun_teeth = 21,
                                    .planet_teeth = 39,
                                    .ring_teeth = 99,
                                    .planets = 3,
                                    .fixed_member = gearset::Member::ring};
  const gearset::PowerFlow flow =
      gearset::power_flow(gearset::arrangement_of(stage, gearset::Member::carrier, "stage"));
  const double load =
      gearset::planet_tangential_load(torque * flow.sets.front().torque.carrier, stage.planets,
                                      centre_distance) /
      bearings_per_planet;  // [N]  a helix adds axial forces and a tilting moment, none in this plane
  return {.case_name = "nrel_grc_750kW",
          .rows = {judged({.source = "[Oyague2011], recomputed",
                           .kind = EvidenceKind::recomputed,
                           .of = "bearing load",
                           .quantity = "mean_planet_bearing_load_kN",
                           .meaning = "mean load of a planet bearing at 325 kN.m on the rotor",
                           .value = recomputed,
                           .tolerance = half_a_digit},
                          1e-3 * load)}};
}

}  // namespace orbearing::app
