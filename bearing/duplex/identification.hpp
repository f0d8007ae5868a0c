// Constants of a shaft from natural frequencies that were measured on pairs of one kind.
//
// A single case does not separate lever and inertia: the tilt frequencies depend on arm^2/inertia only. So
// the shaft is a solid cylinder of known diameter, whose inertia follows from its mass: mass by radial and
// axial frequencies, lever by those of tilt. Residuals are logarithms of frequency ratios, all of equal
// weight.
#pragma once

#include <functional>
#include <vector>

#include "bearing/duplex/shaft.hpp"

namespace orbearing::bearing::duplex {

/// Measurement of one preloaded pair.
struct Observation {
  std::array<double, 5> frequency{};                     // [Hz]  in the order of mode_kinds
  std::function<Stiffness(const RowLevers&)> stiffness;  // of that pair, by its levers
};

struct Cylinder {
  double diameter = 0.0;  // [m]
  double density = 0.0;   // [kg/m^3]
};

struct Identified {
  Shaft shaft;
  bool converged = false;
  int iterations = 0;
  double root_mean_square = 0.0;  // [-]  of the logarithms of frequency ratios
};

/// Mass and lever, both levers alike, of a cylindrical shaft; a lever is at least `least_lever` [m], since
/// two bearings cannot overlap, and the best of all that fit is taken. Throws std::invalid_argument without
/// observations or for frequencies that are not positive.
Identified identify_cylinder(const std::vector<Observation>& observations, const Cylinder& cylinder,
                             double least_lever, const std::optional<Housing>& housing = {});

/// Mass, both levers and both inertias, from `start` on: for the linear formulas, which have no other
/// knowledge of the shaft.
Identified identify_all(const std::vector<Observation>& observations, const Shaft& start, TiltPlanes planes,
                        const std::optional<Housing>& housing = {});

}  // namespace orbearing::bearing::duplex
