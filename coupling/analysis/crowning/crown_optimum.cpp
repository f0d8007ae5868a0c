#include "coupling/analysis/crowning/crown_optimum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlopt.hpp>
#include <random>
#include <stdexcept>

#include "coupling/analysis/parallel.hpp"
#include "mechanics/cancellation.hpp"

namespace orbearing::analysis::crowning {

namespace {

Crown missed(const Crown& crown, const Member& member) {
  return {std::max(crown.drop + member.offset, 0.0), crown.share};
}

constexpr double kStepEnd = 1e-8;      // relative, of the variables
constexpr double kConstraint = 1e-10;  // of ln L
constexpr int kMostEvaluations = 300;
constexpr int kMostRuns = 12;
constexpr double kLeastGain = 1e-9;  // of ln L

// Variables: drop over the greatest, share, ln of the life that all members reach.
struct Search {
  const CrownProblem& problem;
  const ProfileFamily& family;
  const std::vector<Member>& members;
  const SearchOptions& options;
  int evaluations = 0;

  bool with_share() const { return options.free_share && has_share(family); }
  unsigned size() const { return with_share() ? 3 : 2; }
  Crown crown(const double* x) const {
    return {x[0] * options.greatest_drop, with_share() ? x[1] : default_share(family)};
  }
  CrownLife of_member(const Crown& crown, const Member& member, bool with_slopes) const {
    const Crown made = missed(crown, member);
    const Lean lean = lean_by(problem, member.tilt);
    if (with_slopes) return crown_life(problem, family, made, lean);
    return {.log_hours = std::log(life_hours(problem, profile_of(family, made), lean))};
  }
  double worst_log_life(const Crown& crown) const {
    return std::log(worst_life_hours(problem, family, crown, members));
  }
};

double level(unsigned n, const double* x, double* gradient, void*) {
  if (gradient) {
    std::fill_n(gradient, n, 0.0);
    gradient[n - 1] = 1.0;
  }
  return x[n - 1];
}

// z - ln L <= 0 for every member.
void shortfalls(unsigned count, double* result, unsigned n, const double* x, double* gradient, void* data) {
  Search& search = *static_cast<Search*>(data);
  ++search.evaluations;
  for (unsigned m = 0; m < count; ++m) {
    const CrownLife life = search.of_member(search.crown(x), search.members[m], gradient != nullptr);
    result[m] = x[n - 1] - life.log_hours;
    if (!gradient) continue;
    double* row = gradient + std::size_t{m} * n;
    row[0] = -life.by_drop * search.options.greatest_drop;
    if (n == 3) row[1] = -life.by_share;
    row[n - 1] = 1.0;
  }
}

std::pair<std::vector<double>, std::vector<double>> bounds_of(const Search& search) {
  std::vector<double> low{search.options.least_drop / search.options.greatest_drop}, high{1.0};
  if (search.with_share()) low.push_back(kLeastShare), high.push_back(kGreatestShare);
  return {low, high};
}

nlopt::opt programme(Search& search) {
  const unsigned n = search.size();
  nlopt::opt programme(nlopt::LD_SLSQP, n);
  auto [low, high] = bounds_of(search);
  low.push_back(-HUGE_VAL);
  high.push_back(HUGE_VAL);
  programme.set_lower_bounds(low);
  programme.set_upper_bounds(high);
  programme.set_max_objective(level, nullptr);
  programme.add_inequality_mconstraint(shortfalls, &search,
                                       std::vector<double>(search.members.size(), kConstraint));
  programme.set_xtol_rel(kStepEnd);
  programme.set_maxeval(kMostEvaluations);
  return programme;
}

// The library makes a failure of its own of Cancelled.
nlopt::result optimised(nlopt::opt programme, std::vector<double>& x, double& value) {
  try {
    return programme.optimize(x, value);
  } catch (const std::runtime_error&) {
    throw_if_stopped();
    throw;
  }
}

// One run of the programme; false where it stopped without reason to.
bool improve(Search& search, std::vector<double>& x) {
  double value = 0.0;
  try {
    const nlopt::result result = optimised(programme(search), x, value);
    return result > 0 && result != nlopt::MAXEVAL_REACHED;
  } catch (const nlopt::roundoff_limited&) {
    return true;  // no further step changes anything
  }
}

// At a lamina that just touches, slopes change so fast that the programme's model of the curvature is
// misleading and the search stops early. It restarts without that model until there is no further gain.
SearchEnd search_from(const Crown& start, Search search) {
  SearchEnd end{.start = start};
  std::vector<double> x{start.drop / search.options.greatest_drop};
  if (search.with_share()) x.push_back(start.share);
  double reached = search.worst_log_life(start);
  x.push_back(reached);
  for (int run = 0; run < kMostRuns; ++run) {
    const std::vector<double> before = x;
    end.converged = improve(search, x);
    x.back() = search.worst_log_life(search.crown(x.data()));
    const double gained = x.back() - reached;
    if (gained < 0.0) x = before;
    reached = x.back();
    if (gained < kLeastGain) break;
  }
  end.crown = search.crown(x.data());
  end.life_hours = std::exp(reached);
  end.evaluations = search.evaluations;
  return end;
}

double log_life_alone(unsigned, const double* x, double*, void* data) {
  Search& search = *static_cast<Search*>(data);
  ++search.evaluations;
  return search.worst_log_life(search.crown(x));
}

// Search for one member, without derivatives: equilibria of a planet with a computed tilt start anew each
// time.
SearchEnd search_freely(const Crown& start, Search search) {
  constexpr double first_step = 0.05, relative_end = 1e-6;
  SearchEnd end{.start = start};
  std::vector<double> x{start.drop / search.options.greatest_drop};
  if (search.with_share()) x.push_back(start.share);
  nlopt::opt simplices(nlopt::LN_SBPLX, static_cast<unsigned>(x.size()));
  const auto [low, high] = bounds_of(search);
  simplices.set_lower_bounds(low);
  simplices.set_upper_bounds(high);
  simplices.set_max_objective(log_life_alone, &search);
  simplices.set_initial_step(first_step);
  simplices.set_xtol_abs(relative_end);
  simplices.set_maxeval(kMostEvaluations);
  double reached = 0.0;
  const nlopt::result result = optimised(simplices, x, reached);
  end.converged = result > 0 && result != nlopt::MAXEVAL_REACHED;
  end.crown = search.crown(x.data());
  end.life_hours = std::exp(reached);
  end.evaluations = search.evaluations;
  return end;
}

std::vector<Crown> random_starts(const Search& search) {
  std::mt19937_64 engine(20250607);  // the same starts in every run
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
  };
  std::vector<Crown> starts;
  for (int i = 0; i < search.options.starts; ++i) {
    const double drop = uniform(search.options.least_drop, search.options.greatest_drop);
    const double share = uniform(kLeastShare, kGreatestShare);
    starts.push_back({drop, search.with_share() ? share : default_share(search.family)});
  }
  return starts;
}

}  // namespace

std::vector<Member> members_of(const std::vector<double>& tilts, const Tolerance& tolerance) {
  std::vector<Member> members;
  for (const double tilt : tilts) {
    std::vector<double> ends{tilt};
    if (tolerance.tilt > 0.0) ends = {std::max(tilt - tolerance.tilt, 0.0), tilt + tolerance.tilt};
    for (const double end : ends) {
      if (tolerance.drop == 0.0) members.push_back({end, 0.0});
      if (tolerance.drop > 0.0)
        members.insert(members.end(), {{end, -tolerance.drop}, {end, tolerance.drop}});
    }
  }
  return members;
}

double worst_life_hours(const CrownProblem& problem, const ProfileFamily& family, const Crown& crown,
                        const std::vector<Member>& members) {
  double worst = std::numeric_limits<double>::infinity();
  for (const Member& member : members)
    worst = std::min(
        worst, life_hours(problem, profile_of(family, missed(crown, member)), lean_by(problem, member.tilt)));
  return worst;
}

CrownOptimum best_crown(const CrownProblem& problem, const ProfileFamily& family,
                        const std::vector<Member>& members, const SearchOptions& options) {
  if (problem.seat && members.size() != 1)
    throw std::invalid_argument("best crown: found " + std::to_string(members.size()) +
                                " members together with computed tilts; required: one");
  const Search search{problem, family, members, options};
  const std::vector<Crown> starts = random_starts(search);
  CrownOptimum optimum;
  optimum.ends.resize(starts.size());
  in_parallel(starts.size(), options.jobs, [&](std::size_t i) {
    optimum.ends[i] = problem.seat ? search_freely(starts[i], search) : search_from(starts[i], search);
  });
  const auto best =
      std::max_element(optimum.ends.begin(), optimum.ends.end(), [](const auto& a, const auto& b) {
        return (a.converged ? a.life_hours : 0.0) < (b.converged ? b.life_hours : 0.0);
      });
  if (best == optimum.ends.end() || !best->converged)
    throw std::runtime_error(
        "no start of the search for the best crown came to an end; other tilts or a "
        "smaller greatest drop are required");
  optimum.crown = best->crown;
  optimum.life_hours = best->life_hours;
  for (const SearchEnd& end : optimum.ends)
    optimum.in_best += std::abs(end.crown.drop - optimum.crown.drop) <= kSameDrop * options.greatest_drop &&
                       std::abs(end.life_hours - optimum.life_hours) <= kSameLife * optimum.life_hours;
  return optimum;
}

}  // namespace orbearing::analysis::crowning
