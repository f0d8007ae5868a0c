// Sorts shapes of one frequency by their symmetry under an exchange of planets.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gearset/dynamics/model.hpp"

namespace orbearing::gearset::dynamics {

/// Kinds of [LinParker1999], by the motion's symmetry under an exchange of planets:
/// rotational      central members turn, all planets do the same;
/// translational  central members shift, the planets' motion goes with cosine and sine of their angle;
/// planet         central members rest, the planets' motion is any other.
/// Planets at unequal steps keep the kinds where equal forces on all of them balance on the sun
/// [LinParker2000]; elsewhere rotational and translational modes mix.
enum class ModeKind { rotational, translational, planet };

/// Part of a space of shapes that is of one kind.
struct KindShapes {
  ModeKind kind = ModeKind::rotational;
  Eigen::MatrixXcd shapes;  // (freedoms, number)  orthonormal
};

/// Shares of a motion's kinetic energy, by kind; their sum is 1. A harmonic of a steady vibration is of a
/// single kind if the planets follow each other at equal phase steps.
struct KindShares {
  double rotational = 0.0;     // [-]
  double translational = 0.0;  // [-]
  double planet = 0.0;         // [-]
};

/// @param shape (freedoms) in the coordinates sqrt(mass) x position; not zero
KindShares kind_shares(const SetModel& model, const Eigen::VectorXcd& shape);

/// Splits the space that the columns of `shapes` span, which share one frequency, into parts of one kind. A
/// shape of mixed kind gets the kind of its largest part. Eq. (13) of gearset/dynamics/README.md.
/// @param shapes (freedoms, number) in the coordinates sqrt(mass) x position
std::vector<KindShapes> by_kind(const SetModel& model, const Eigen::MatrixXcd& shapes);

/// Whether a force of the meshes that goes `teeth` times round the sun while the carrier goes round once
/// against it excites modes of that kind: harmonic l of the mesh frequency has l z_s. Eq. (14),
/// [ParkerLin2004].
/// @param angles [rad] of the planets
bool excites(const std::vector<double>& angles, int teeth, ModeKind kind);

}  // namespace orbearing::gearset::dynamics
