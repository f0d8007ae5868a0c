// The crown under which the shortest life is longest: over tilts, over a spectrum, over what the workshop and
// the mounting may miss.
//
//   greatest z  with  z <= ln L(drop + e, share; tilt)  for all members (e, tilt)
//
// so that the worst of several lives has smooth constraints instead of a kink. Solved by sequential
// quadratic programming [Kraft1988] [NLopt] with the derivatives of crown_life(). Where tilts are computed
// there is one member, whose life is sought without derivatives by simplices in subspaces [Rowan1990].
#pragma once

#include <vector>

#include "coupling/analysis/crowning/crown_problem.hpp"

namespace orbearing::analysis::crowning {

/// A case that the crown must live through.
struct Member {
  double tilt = 0.0;    // [rad]  as lean_by() takes it
  double offset = 0.0;  // [m]  by which the drop may miss its nominal value
};

/// Band of tolerance about the drop and every tilt, both plus and minus.
struct Tolerance {
  double drop = 0.0;  // [m]
  double tilt = 0.0;  // [rad]
};

/// The tilts studied with the ends of their bands. Life falls monotonously away from the best drop, so that
/// the ends of the drop's band are the worst; a band of tilt that holds zero has its least there.
std::vector<Member> members_of(const std::vector<double>& tilts, const Tolerance& tolerance);

/// Shortest life over the members, with each member's derivatives.
double worst_life_hours(const CrownProblem& problem, const ProfileFamily& family, const Crown& crown,
                        const std::vector<Member>& members);

struct SearchOptions {
  double greatest_drop = 0.0;  // [m]
  double least_drop = 0.0;     // [m]
  int starts = 10;             // random ones, the same in every run
  bool free_share = true;      // of kinds that have one
  int jobs = 0;                // threads; 0: all
};

/// Result of one start.
struct SearchEnd {
  Crown start;
  Crown crown;
  double life_hours = 0.0;  // [h]  shortest over the members
  int evaluations = 0;
  bool converged = false;
};

struct CrownOptimum {
  Crown crown;
  double life_hours = 0.0;      // [h]  shortest over the members
  std::vector<SearchEnd> ends;  // of all starts
  int in_best = 0;              // starts that ended in it
};

/// Two ends are one where they are as close as this. Laminae that begin to touch excitation the life by about
/// 1e-6 with a period of hundredths of a micrometre, each excitation with an optimum of its own.
inline constexpr double kSameDrop = 5e-3;  // of the greatest drop
inline constexpr double kSameLife = 1e-4;  // relative

/// Throws std::runtime_error where no start ends, std::invalid_argument for several members where tilts are
/// computed.
CrownOptimum best_crown(const CrownProblem& problem, const ProfileFamily& family,
                        const std::vector<Member>& members, const SearchOptions& options);

}  // namespace orbearing::analysis::crowning
