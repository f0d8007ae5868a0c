// Which drop to take: the life from half-space pressures of both races of all bearings is longest, over the
// stated tilts or for a population of planets built within tolerances. How closely it must be met, and what
// it costs to miss it.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "coupling/analysis/crowning/crown_grid.hpp"
#include "coupling/analysis/crowning/crown_optimum.hpp"

namespace orbearing::analysis::crowning {

// Deviations of manufacturing and mounting, their probability, and the life of planets with these deviations.
//
//   (1)  S(t) = sum w_i S_i(t),  S_i = 0.9^((t/L_i)^e)     parts w_i of a population, each with its L10 L_i
//   (2)  S(L) = 0.9                                         the life that nine tenths of all of them reach

/// Distribution of a deviation within its tolerance.
enum class Distribution {
  worst,    // the ends of the tolerance, of which the one with the shortest life counts
  normal,   // about nominal, the tolerance three standard deviations, cut off there
  uniform,  // all misses within the tolerance alike
};

/// Name as in options: worst, normal, uniform.
std::string name_of(Distribution distribution);

/// Misses of one quantity as parts of its tolerance, and how likely each is; weights add up to 1.
struct Misses {
  Eigen::ArrayXd miss;    // [-]  rising, from -1 to 1
  Eigen::ArrayXd weight;  // [-]
};

/// Gauss's quadrature with the density of the distribution, exact for polynomials up to the degree
/// 2 `nodes` - 1 [Golub1969]; of the worst, both ends.
Misses misses_of(Distribution distribution, int nodes);

/// (2): L10 [h] of a population of rolling bearings on lines of contact whose parts `weights`, which add up
/// to 1, have the lives `hours`. Not the mean of the lives, and not their median: what fails first counts.
double population_life(const Eigen::Ref<const Eigen::ArrayXd>& hours,
                       const Eigen::Ref<const Eigen::ArrayXd>& weights);

/// One way in which a planet may lean.
struct LeanPart {
  Lean lean;
  double weight = 1.0;  // [-]  how likely; without meaning where the worst counts
};

/// All planets that are built to one drawing.
struct Population {
  bool worst = true;  // the shortest life counts; false: that which nine tenths reach
  std::vector<LeanPart> leans;
  Eigen::ArrayXd drop_miss;    // [m]  misses of the drop, the same for each lean
  Eigen::ArrayXd drop_weight;  // [-]
};

/// Gauss nodes of each quantity. Those of leans cost an equilibrium each, those of the drop nothing.
struct PopulationNodes {
  int lean = 3;  // for each direction
  int drop = 16;
};

/// Stated tilts: the ends of the tolerance of each of `tilts` [rad], and the worst counts whatever the
/// distribution. Computed tilts: inclinations of the pin in both directions, each within the tolerance.
Population population_of(const CrownProblem& problem, const std::vector<double>& tilts,
                         const Tolerance& tolerance, Distribution distribution,
                         const PopulationNodes& nodes = {});

/// Life [h] of the population, given those of its parts (leans, drop misses).
double life_of(const Population& population, const Eigen::Ref<const Eigen::ArrayXXd>& hours);

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

/// Life at one drop over the longest life.
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

}  // namespace orbearing::analysis::crowning
