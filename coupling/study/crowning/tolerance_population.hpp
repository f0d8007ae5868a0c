// What workshop and mounting miss, how likely that is, and how long planets live that are built so.
//
//   (1)  S(t) = sum w_i S_i(t),  S_i = 0.9^((t/L_i)^e)     parts w_i of a population, each with its L10 L_i
//   (2)  S(L) = 0.9                                         the life that nine tenths of all of them reach
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "coupling/study/crowning/crown_optimum.hpp"

namespace orbearing::study::crowning {

/// How likely a miss within its tolerance is.
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

/// Gauss nodes of each quantity. Those of leans cost a balance each, those of the drop nothing.
struct PopulationNodes {
  int lean = 3;  // for each direction
  int drop = 16;
};

/// Where tilts are stated, of each of `tilts` [rad] the ends of its tolerance, and the worst counts whatever
/// the distribution; where they are computed, inclinations of the pin in both directions, each within the
/// tolerance by itself.
Population population_of(const CrownProblem& problem, const std::vector<double>& tilts,
                         const Tolerance& tolerance, Distribution distribution,
                         const PopulationNodes& nodes = {});

/// Life [h] of the population, given those of its parts (leans, drop misses).
double life_of(const Population& population, const Eigen::Ref<const Eigen::ArrayXXd>& hours);

}  // namespace orbearing::study::crowning
