#include "coupling/study/crowning/tolerance_population.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>

#include "bearing/life/basic_life.hpp"

namespace orbearing::study::crowning {

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

}  // namespace orbearing::study::crowning
