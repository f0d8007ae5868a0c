// Which drop to take: the life from half-space pressures of both races of all bearings is longest, over the
// stated tilts or for a population of planets built within tolerances. How closely it must be met, and what
// it costs to miss it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/study/crowning/crown_grid.hpp"
#include "coupling/study/crowning/tolerance_population.hpp"

namespace orbearing::study::crowning {

// A smooth function of the drop, through its values at few drops.

/// Drops [m] from 0 to `greatest` at which a function is to be known: `intervals` + 1 nodes of Chebyshev,
/// dense at both ends. Every second one of twice as many is one of these.
Eigen::ArrayXd curve_nodes(double greatest, int intervals);

/// The polynomial through values at curve_nodes(), by the barycentric formula [Berrut2004].
class DropCurve {
 public:
  DropCurve(double greatest, Eigen::ArrayXd values);

  /// At a drop [m]; beyond the nodes the value at the end.
  double operator()(double drop) const;

 private:
  Eigen::ArrayXd nodes_;  // [m]
  Eigen::ArrayXd values_;
};

/// Share of the longest life that is left at the ends of a band of drops.
inline constexpr double kKeptLife = 0.95;

/// Drops [m] between which at least kKeptLife of the life at the best is left.
struct DropBand {
  double least = 0.0;
  double most = 0.0;
  bool open = false;  // `most` is the greatest drop studied: greater ones may do as well
};

/// What is left of the longest life at one drop.
struct DropLife {
  double drop = 0.0;        // [m]
  double life_share = 0.0;  // [-]
};

struct HalfSpaceAim {
  std::vector<double> tilts{0.0};  // [rad]  stated ones; one of 0 where tilts are computed
  Tolerance tolerance{};
  Distribution distribution = Distribution::worst;
  double greatest_drop = 0.0;  // [m]
  double miss = 1e-6;          // [m]  at which the cost of missing the drop is stated
  double other_drop = 0.0;     // [m]  of another advice, whose life is wanted too
  int jobs = 0;                // threads; 0: all
};

/// Lives are those of population_of(), [h].
struct HalfSpaceAdvice {
  double drop = 0.0;  // [m]
  double life_hours = 0.0;
  double straight_life_hours = 0.0;  // of straight rollers, whose drop misses nothing
  DropBand band;
  DropLife low, high;                // one miss below and above
  DropLife other;                    // at the other advice
  std::vector<DropLife> curve;       // from no drop to the greatest
  double interpolation_error = 0.0;  // [-]  of a life at the drop, largest over the population's leans
  double quadrature_error = 0.0;     // [-]  of the life at the drop, by twice as many nodes

  bool no_crown_needed() const { return straight_life_hours >= kKeptLife * life_hours; }
};

/// Profiles of `family`, `share` of each half relieved. Lives are computed at nodes over the drop, refined
/// until what lies between is met to 5e-3 at the drop that is found. Throws std::runtime_error where loads do
/// not balance.
HalfSpaceAdvice half_space_advice(const CrownProblem& problem, const RollerPressure& pressure,
                                  const ProfileFamily& family, double share, const HalfSpaceAim& aim);

}  // namespace orbearing::study::crowning
