// A pair of gears on two fixed shafts, the model gear-pair, and its mesh.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/analysis/meshes.hpp"
#include "gearset/gear_pair.hpp"
#include "mechanics/material.hpp"
#include "mechanics/problem.hpp"

namespace orbearing::analysis {

/// The machine of the model gear-pair.
struct PairOfGears {
  static constexpr std::string_view model = "gear-pair";

  gearset::GearPair pair;
  mechanics::Material material;
};
template <class Visitor>
void describe(Visitor& visit, PairOfGears& m) {
  described::members(visit, m, described::block(m.pair, "pair"), described::part(m.material));
}

/// Inconsistencies of the inputs.
mechanics::Problems problems(const PairOfGears& machine);

/// A gear pair with compliant teeth and without mass, for its meshes.
struct ElasticPair {
  gearset::GearPair pair;
  mechanics::Elasticity material;
};
template <class Visitor>
void describe(Visitor& visit, ElasticPair& m) {
  described::members(visit, m, described::block(m.pair, "pair"), described::part(m.material));
}

MeshStudy meshes_of_pair(const ElasticPair& pair);

/// Results that follow from the inputs.
struct PairQuantities {
  double centre_distance = 0.0;         // [m]
  double working_pressure_angle = 0.0;  // [rad]
  double contact_ratio = 0.0;           // [-]
  double overlap_ratio = 0.0;           // [-]
  std::array<double, 2> mass{};         // [kg]
  double mesh_stiffness = 0.0;          // [N/m]  mean over the mesh period
  std::array<GearCircles, 2> gears{};
  std::vector<std::string> warnings;  // of its mesh
};
void describe(described::Record& record, const PairQuantities& of);

PairQuantities quantities_of(const PairOfGears& machine);

}  // namespace orbearing::analysis
