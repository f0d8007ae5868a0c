// The pin of a planet as a beam with shear: its deflection and inclination at its bearings.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "mechanics/material.hpp"

namespace orbearing::bearing {

/// Support of a pin by the carrier.
enum class PinEnds {
  both,     // it rests in the middles of both walls
  one,      // clamped in the wall at its negative end
  flexpin,  // the same, and the bearings sit on a rigid sleeve that its other end carries
};

constexpr described::Names<PinEnds, 3> names_of(PinEnds) {
  return {{{PinEnds::both, "both"}, {PinEnds::one, "one"}, {PinEnds::flexpin, "flexpin"}}};
}

struct PinBeam {
  double diameter = 0.0;  // [m]
  double bore = 0.0;      // [m]  0: solid
  double span =
      0.0;  // [m]  between the supports; of a pin clamped at one end, from there to the middle of the face
            //      and as far again: there a flexpin carries its sleeve
  PinEnds ends = PinEnds::both;
  mechanics::Material material;
};

/// Displacement [m] and slope [rad] at each of `positions` [m], from the middle of the face, by unit force
/// [N] and moment [N m] at each, in one plane: rows and columns are displacement (force) at all positions,
/// then slope (moment) at all. By the energy of bending and shear; symmetric. Eqs. (1) and (2) of
/// bearing/pin_beam.cpp.
/// @throws std::invalid_argument where a position lies beyond the supports; of a flexpin, on a rigid sleeve,
/// positions may lie anywhere
Eigen::MatrixXd pin_compliance(const PinBeam& pin, const std::vector<double>& positions);

}  // namespace orbearing::bearing
