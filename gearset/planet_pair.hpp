// Planets in pairs: the first meshes with the sun, the second with the first and with the ring.
//
//                 ring
//            .-----------.            second planet at the angle phi from the first round the carrier, ahead
//          .'   second    '.          of it or behind it in the sense of the carrier's rotation; the three
//         /    (  +  )---.  \         distances a_1 (sun, first), a_12 and a_2 (ring, second) without
//        |      `-.-'     \  |        backlash make the triangle of the axes
//        |  sun ( + )( +  ) |
#pragma once

#include "gearset/mean_loads.hpp"
#include "gearset/parameters.hpp"
#include "gearset/stepped_planet.hpp"
#include "gearset/warning.hpp"
#include "gearset/working_geometry.hpp"

namespace orbearing::gearset {

/// Position of the second planet of a pair, in the sense in which the carrier rotates.
enum class PairSide { ahead, behind };

constexpr described::Names<PairSide, 2> names_of(PairSide) {
  return {{{PairSide::ahead, "ahead"}, {PairSide::behind, "behind"}}};
}

/// The second planet in a case. Without teeth there is none, and PlanetarySet::planets are single.
struct SecondPlanet {
  int teeth = 0;
  double first_shift = 0.0;  // [module]  profile shift of the first planet, which nothing else fixes
  double shift = 0.0;        // [module]  of the second
  PairSide side = PairSide::ahead;

  bool present() const { return teeth > 0; }
};

template <class Visitor>
void describe(Visitor& visit, SecondPlanet& m) {
  using namespace described;
  const Where beside{"gearset.second_planet.teeth"};
  members(
      visit, m,
      input(m.teeth, "gearset.second_planet.teeth",
            "teeth of a second planet between each planet and the ring: gearset.teeth.planet meshes with the "
            "sun and with it, and gearset.planets are pairs; single planets if absent",
            {.range = {5, 2000}, .may_be_absent = true}),
      input(m.first_shift, "gearset.second_planet.first_profile_shift",
            "profile shift of the first planet of a pair, in modules; 0 if absent",
            {.range = {-2.0, 2.0}, .where = beside}),
      input(m.shift, "gearset.second_planet.profile_shift",
            "profile shift of the second planet of a pair, in modules; 0 if absent",
            {.range = {-2.0, 2.0}, .where = beside}),
      input(m.side, "gearset.second_planet.side",
            "position of the second planet of a pair: ahead of the first or behind it in the sense of the "
            "carrier's rotation; ahead if absent",
            {.where = beside}));
}

/// A planet of a pair.
struct PlanetOfPair {
  SecondPlanet pair;
  bool second = false;  // else the first
};

/// Sizes of a pair without backlash.
struct PlanetPairGeometry {
  ExternalTooth sun, first, second;
  RingTooth ring;
  double first_distance = 0.0;   // [m]    sun axis to the first planet's: a_1
  double second_distance = 0.0;  // [m]    to the second planet's: a_2
  double between = 0.0;          // [m]    axis of the first planet to that of the second: a_12
  double angle = 0.0;            // [rad]  of both round the carrier: phi, from 0 to pi
  MeshGeometry sun_mesh, planet_mesh, ring_mesh;
};

/// Eqs. (44) and (45) of gearset/README.md.
/// @throws std::domain_error where a mesh has no distance without backlash, or the three make no triangle
PlanetPairGeometry planet_pair_geometry(const PlanetarySet& set, const SecondPlanet& pair);

/// The geometry from one planet: its own tooth, the distance of its axis from the sun's; sun_mesh is that of
/// the first planet with the sun, or of the second with the first.
WorkingGeometry geometry_of_planet(const PlanetarySet& set, const PlanetOfPair& planet);

/// For speeds and torques: with a stationary carrier, the ring turns in the same sense as the sun, as if its
/// teeth were negative. Eq. (46).
WillisTeeth willis_teeth_of_pairs(const PlanetarySet& set);

/// Loads of one planet in its own frame: x outward through its axis, y in the sense of the carrier's
/// rotation. Eqs. (47) and (48).
/// @throws std::invalid_argument if power or speed is not positive
MeanLoads mean_loads_of_planet(const PlanetarySet& set, const PlanetOfPair& planet,
                               const MemberRatios& ratios, const Drive& drive);

/// Faults of the teeth of pairs that can still run, as tooth_warnings() has them for single planets.
/// @throws std::domain_error as planet_pair_geometry()
Warnings pair_tooth_warnings(const PlanetarySet& set, const SecondPlanet& pair);

/// Reasons why pairs cannot be built or assembled.
Warnings pair_problems(const PlanetarySet& set, const SecondPlanet& pair);

}  // namespace orbearing::gearset
