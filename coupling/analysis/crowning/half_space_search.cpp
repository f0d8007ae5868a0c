#include "coupling/analysis/crowning/half_space_search.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>

#include "bearing/life/basic_life.hpp"
#include "coupling/analysis/parallel.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::analysis::crowning {

namespace {

constexpr double kDeviations = 3.0;  // standard deviations in a tolerance
constexpr double kSurvival = 0.9;    // of L10
constexpr int kRootBits = 50;        // to which a population's life is found

double density(Distribution distribution, double miss) {
  return distribution == Distribution::normal ? std::exp(-0.5 * std::pow(kDeviations * miss, 2)) : 1.0;
}

// The density by 30 points of Gauss and Legendre, which hold polynomials up to the degree 59.
Misses fine_misses(Distribution distribution) {
  using Fine = boost::math::quadrature::gauss<double, 30>;
  Misses fine{Eigen::ArrayXd(30), Eigen::ArrayXd(30)};
  for (std::size_t i = 0; i < Fine::abscissa().size(); ++i)
    for (const int side : {0, 1}) {
      const auto position = static_cast<Eigen::Index>(2 * i) + side;
      fine.miss[position] = (side == 0 ? -1.0 : 1.0) * Fine::abscissa()[i];
      fine.weight[position] = Fine::weights()[i] * density(distribution, fine.miss[position]);
    }
  fine.weight /= fine.weight.sum();
  return fine;
}

// Squares of the off-diagonal of Jacobi's matrix, of a density that is even: ratios of the norms of its
// orthogonal polynomials.
Eigen::ArrayXd off_diagonal(const Misses& fine, int nodes) {
  Eigen::ArrayXd beta(nodes - 1);
  Eigen::ArrayXd before = Eigen::ArrayXd::Zero(fine.miss.size()), now = before + 1.0;
  double norm = 1.0;
  for (int k = 0; k + 1 < nodes; ++k) {
    const Eigen::ArrayXd next = fine.miss * now - (k > 0 ? beta[k - 1] : 0.0) * before;
    const double next_norm = (fine.weight * next.square()).sum();
    beta[k] = next_norm / norm;
    before = now;
    now = next;
    norm = next_norm;
  }
  return beta.sqrt();
}

Misses scaled(Misses misses, double tolerance) {
  if (tolerance == 0.0) return {Eigen::ArrayXd::Zero(1), Eigen::ArrayXd::Ones(1)};
  misses.miss *= tolerance;
  return misses;
}

}  // namespace

std::string name_of(Distribution distribution) {
  if (distribution == Distribution::worst) return "worst";
  return distribution == Distribution::normal ? "normal" : "uniform";
}

Misses misses_of(Distribution distribution, int nodes) {
  if (distribution == Distribution::worst) return {Eigen::Array2d(-1.0, 1.0), Eigen::Array2d(0.5, 0.5)};
  if (nodes == 1) return {Eigen::ArrayXd::Zero(1), Eigen::ArrayXd::Ones(1)};
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(Eigen::VectorXd::Zero(nodes),
                                off_diagonal(fine_misses(distribution), nodes).matrix());
  return {solver.eigenvalues().array(), solver.eigenvectors().row(0).transpose().array().square()};
}

double population_life(const Eigen::Ref<const Eigen::ArrayXd>& hours,
                       const Eigen::Ref<const Eigen::ArrayXd>& weights) {
  using bearing::rating::weibull_reliability;
  constexpr double slope = bearing::rating::weibull_slope(bearing::rating::RollingElement::roller);
  const double shortest = hours.minCoeff<Eigen::PropagateNaN>(), longest = hours.maxCoeff();
  if (!(shortest < longest)) return shortest;  // not a number among them: that
  const auto excess = [&](double log_life) {
    double surviving = 0.0;
    for (Eigen::Index i = 0; i < hours.size(); ++i)
      surviving += weights[i] * weibull_reliability(std::exp(log_life) / hours[i], slope);
    return surviving - kSurvival;
  };
  double high = std::log(shortest);
  do high += 1.0;
  while (excess(high) > 0.0 && high < std::log(longest));
  if (excess(high) > 0.0) return longest;
  std::uintmax_t steps = 200;
  const auto [from, to] = boost::math::tools::toms748_solve(
      excess, high - 1.0, high, boost::math::tools::eps_tolerance<double>(kRootBits), steps);
  return std::exp(0.5 * (from + to));
}

Population population_of(const CrownProblem& problem, const std::vector<double>& tilts,
                         const Tolerance& tolerance, Distribution distribution,
                         const PopulationNodes& nodes) {
  Population population{.worst = !problem.seat || distribution == Distribution::worst};
  const Distribution taken = population.worst ? Distribution::worst : distribution;
  const Misses drops = scaled(misses_of(taken, nodes.drop), tolerance.drop);
  population.drop_miss = drops.miss;
  population.drop_weight = drops.weight;
  if (!problem.seat) {
    for (const Member& member : members_of(tilts, {0.0, tolerance.tilt}))
      population.leans.push_back({lean_by(problem, member.tilt)});
    return population;
  }
  const Misses inclined = scaled(misses_of(taken, nodes.lean), tolerance.tilt);
  for (Eigen::Index i = 0; i < inclined.miss.size(); ++i)
    for (Eigen::Index j = 0; j < inclined.miss.size(); ++j)
      population.leans.push_back(
          {Lean(inclined.miss[i], inclined.miss[j]), inclined.weight[i] * inclined.weight[j]});
  return population;
}

double life_of(const Population& population, const Eigen::Ref<const Eigen::ArrayXXd>& hours) {
  if (population.worst) return hours.minCoeff<Eigen::PropagateNaN>();
  Eigen::ArrayXd all(hours.size()), weights(hours.size());
  for (Eigen::Index i = 0; i < hours.rows(); ++i)
    for (Eigen::Index j = 0; j < hours.cols(); ++j) {
      all[i * hours.cols() + j] = hours(i, j);
      weights[i * hours.cols() + j] =
          population.leans[static_cast<std::size_t>(i)].weight * population.drop_weight[j];
    }
  return population_life(all, weights);
}

Eigen::ArrayXd curve_nodes(double greatest, int intervals) {
  Eigen::ArrayXd nodes(intervals + 1);
  for (int k = 0; k <= intervals; ++k) {
    const double sine = std::sin(0.5 * constants::pi * k / intervals);
    nodes[k] = greatest * sine * sine;
  }
  return nodes;
}

DropCurve::DropCurve(double greatest, Eigen::ArrayXd values)
    : nodes_(curve_nodes(greatest, static_cast<int>(values.size()) - 1)), values_(std::move(values)) {}

double DropCurve::operator()(double drop) const {
  const Eigen::Index last = nodes_.size() - 1;
  const double at = std::clamp(drop, nodes_[0], nodes_[last]);
  double above = 0.0, below = 0.0;
  for (Eigen::Index k = 0; k <= last; ++k) {
    if (at == nodes_[k]) return values_[k];
    const double weight = (k % 2 == 0 ? 1.0 : -1.0) * (k == 0 || k == last ? 0.5 : 1.0) / (at - nodes_[k]);
    above += weight * values_[k];
    below += weight;
  }
  return above / below;
}

namespace {

constexpr int kFirstIntervals = 16, kMostIntervals = 64;
constexpr double kSmooth = 5e-3;      // of a life: what a curve may miss
constexpr double kQuadrature = 1e-2;  // of a life: beyond it a population is taken with twice as many nodes
constexpr int kScan = 800;            // drops among which the best and the ends of its band are looked for
constexpr int kDrawn = 160;           // drops at which the curve is a result
constexpr int kBits = 24;             // to which they are then found

struct Lives {
  const CrownProblem& problem;
  const RollerPressure& pressure;
  const ProfileFamily& family;
  double share;
  int jobs;

  double log_life(double drop, const Lean& lean) const {
    return std::log(pressure_life_hours(problem, pressure, profile_of(family, {drop, share}), lean));
  }
  // (leans, drops)
  Eigen::ArrayXXd log_lives(const std::vector<LeanPart>& leans, const Eigen::ArrayXd& drops) const {
    const auto count = static_cast<Eigen::Index>(leans.size());
    Eigen::ArrayXXd found(count, drops.size());
    in_parallel(static_cast<std::size_t>(found.size()), jobs, [&](std::size_t i) {
      const auto position = static_cast<Eigen::Index>(i);
      found(position % count, position / count) =
          log_life(drops[position / count], leans[static_cast<std::size_t>(position % count)].lean);
    });
    return found;
  }
};

// ln of the life over the drop, a curve for each lean.
class Curves {
 public:
  Curves(const Lives& lives, const Population& population, double greatest)
      : lives_(lives), population_(population), greatest_(greatest) {
    values_ = lives.log_lives(population.leans, curve_nodes(greatest, kFirstIntervals));
    draw();
  }

  // Halves the intervals; what is known stays.
  void refine() {
    const int intervals = 2 * this->intervals();
    const Eigen::ArrayXd nodes = curve_nodes(greatest_, intervals);
    Eigen::ArrayXXd finer(values_.rows(), intervals + 1);
    finer(Eigen::all, Eigen::seq(0, intervals, 2)) = values_;
    finer(Eigen::all, Eigen::seq(1, intervals, 2)) =
        lives_.log_lives(population_.leans, nodes(Eigen::seq(1, intervals, 2)));
    values_ = finer;
    draw();
  }
  int intervals() const { return static_cast<int>(values_.cols()) - 1; }

  double life(double drop) const { return life(drop, population_); }
  // Life of a population with the same leans.
  double life(double drop, const Population& population) const {
    return life_of(population, missed(population.drop_miss, drop));
  }
  double straight_life() const {
    Population straight = population_;
    straight.drop_miss = Eigen::ArrayXd::Zero(1);
    straight.drop_weight = Eigen::ArrayXd::Ones(1);
    return life(0.0, straight);
  }
  // Largest over the leans, in parts of a life.
  double error(double drop) const {
    const Eigen::ArrayXXd exact = lives_.log_lives(population_.leans, Eigen::ArrayXd::Constant(1, drop));
    double largest = 0.0;
    for (std::size_t i = 0; i < curves_.size(); ++i)
      largest =
          std::max(largest, std::abs(std::expm1(curves_[i](drop) - exact(static_cast<Eigen::Index>(i), 0))));
    return largest;
  }

 private:
  void draw() {
    curves_.clear();
    for (Eigen::Index i = 0; i < values_.rows(); ++i)
      curves_.emplace_back(greatest_, values_.row(i).transpose());
  }
  // A drop cannot miss below none.
  Eigen::ArrayXXd missed(const Eigen::ArrayXd& misses, double drop) const {
    Eigen::ArrayXXd hours(values_.rows(), misses.size());
    for (Eigen::Index i = 0; i < hours.rows(); ++i)
      for (Eigen::Index j = 0; j < misses.size(); ++j)
        hours(i, j) = std::exp(curves_[static_cast<std::size_t>(i)](std::max(drop + misses[j], 0.0)));
    return hours;
  }

  const Lives& lives_;
  const Population& population_;
  double greatest_;  // [m]
  Eigen::ArrayXXd values_;
  std::vector<DropCurve> curves_;
};

// The longest of a scan, then between its neighbours.
double best_drop(const Curves& curves, double greatest) {
  int best = 0;
  double longest = 0.0;
  for (int i = 0; i <= kScan; ++i)
    if (const double life = curves.life(greatest * i / kScan); life > longest) {
      longest = life;
      best = i;
    }
  const double step = greatest / kScan;  // as unit: the search's end is absolute
  const auto [steps, lost] = boost::math::tools::brent_find_minima(
      [&](double at) { return -curves.life(step * at); }, std::max(0.0, best - 1.0),
      std::min(1.0 * kScan, best + 1.0), kBits);
  return step * (-lost > longest ? steps : best);
}

// From `best` towards `end` the last drop that still leaves enough.
template <class Enough>
double end_of_band(double best, double end, const Enough& enough) {
  double good = best;
  for (int i = 1; i <= kScan; ++i) {
    double bad = best + (end - best) * i / kScan;
    if (enough(bad)) {
      good = bad;
      continue;
    }
    for (int bit = 0; bit < kBits; ++bit) {
      const double middle = 0.5 * (good + bad);
      (enough(middle) ? good : bad) = middle;
    }
    return good;
  }
  return end;
}

DropBand band_around(const Curves& curves, double best, double greatest) {
  const double required = kKeptLife * curves.life(best);
  const auto enough = [&](double drop) { return curves.life(drop) >= required; };
  DropBand band{end_of_band(best, 0.0, enough), end_of_band(best, greatest, enough), false};
  band.open = band.most >= greatest;
  return band;
}

double relative(double one, double other) {
  return std::abs(one / other - 1.0);
}

// Error of the quadrature: over leans by lives without deviation of the drop, over the drop by the curves.
double quadrature_error(const Lives& lives, const Curves& curves, const HalfSpaceAim& aim,
                        const PopulationNodes& nodes, double drop) {
  const auto of = [&](const Tolerance& tolerance, const PopulationNodes& taken) {
    return population_of(lives.problem, aim.tilts, tolerance, aim.distribution, taken);
  };
  const PopulationNodes more_leans{2 * nodes.lean, nodes.drop}, more_drops{nodes.lean, 2 * nodes.drop};
  const Population finer = of(aim.tolerance, more_drops);
  if (finer.worst) return 0.0;
  const auto leaning = [&](const PopulationNodes& taken) {
    const Population population = of({0.0, aim.tolerance.tilt}, taken);
    return life_of(population, lives.log_lives(population.leans, Eigen::ArrayXd::Constant(1, drop)).exp());
  };
  const double of_leans = aim.tolerance.tilt > 0.0 ? relative(leaning(nodes), leaning(more_leans)) : 0.0;
  return of_leans + relative(curves.life(drop), curves.life(drop, finer));
}

HalfSpaceAdvice advice_with(const Lives& lives, const HalfSpaceAim& aim, const PopulationNodes& nodes) {
  const Population population =
      population_of(lives.problem, aim.tilts, aim.tolerance, aim.distribution, nodes);
  Curves curves(lives, population, aim.greatest_drop + aim.tolerance.drop);
  HalfSpaceAdvice advice;
  for (;;) {
    advice.drop = best_drop(curves, aim.greatest_drop);
    advice.interpolation_error = curves.error(advice.drop);
    if (advice.interpolation_error <= kSmooth || curves.intervals() >= kMostIntervals) break;
    curves.refine();
  }
  advice.life_hours = curves.life(advice.drop);
  advice.straight_life_hours = curves.straight_life();
  advice.band = band_around(curves, advice.drop, aim.greatest_drop);
  const auto left_at = [&](double drop) -> DropLife { return {drop, curves.life(drop) / advice.life_hours}; };
  advice.low = left_at(std::max(advice.drop - aim.miss, 0.0));
  advice.high = left_at(std::min(advice.drop + aim.miss, aim.greatest_drop));
  advice.other = left_at(aim.other_drop);
  for (int i = 0; i <= kDrawn; ++i) advice.curve.push_back(left_at(aim.greatest_drop * i / kDrawn));
  advice.quadrature_error = quadrature_error(lives, curves, aim, nodes, advice.drop);
  return advice;
}

}  // namespace

HalfSpaceAdvice half_space_advice(const CrownProblem& problem, const RollerPressure& pressure,
                                  const ProfileFamily& family, double share, const HalfSpaceAim& aim) {
  const Lives lives{problem, pressure, family, share, aim.jobs};
  PopulationNodes nodes;
  HalfSpaceAdvice advice = advice_with(lives, aim, nodes);
  if (advice.quadrature_error <= kQuadrature) return advice;
  nodes.lean *= 2;
  nodes.drop *= 2;
  return advice_with(lives, aim, nodes);
}

}  // namespace orbearing::analysis::crowning
