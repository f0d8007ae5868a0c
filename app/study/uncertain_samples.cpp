#include "app/study/uncertain_samples.hpp"

#include <Eigen/Cholesky>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <cmath>
#include <random>
#include <utility>

namespace orbearing::app {

namespace {

const boost::math::normal standard_normal;

// In [0, 1), equal on every machine, unlike the standard library's distributions.
double uniform_draw(std::mt19937_64& generator) {
  return std::ldexp(static_cast<double>(generator() >> 11), -53);
}

double normal_quantile(const UncertainInput& one, double share) {
  const auto share_below = [&](double end, double otherwise) {
    return std::isnan(end) ? otherwise : cdf(standard_normal, (end - one.mean) / one.standard_deviation);
  };
  const double low = share_below(one.from, 0.0), high = share_below(one.to, 1.0);
  return one.mean + one.standard_deviation * quantile(standard_normal, low + share * (high - low));
}

// The value below which the share (0, 1) lies.
double input_quantile(const UncertainInput& one, double share) {
  if (one.distribution == "uniform") return one.from + share * (one.to - one.from);
  if (one.distribution == "triangular")
    return quantile(boost::math::triangular(one.from, one.peak, one.to), share);
  return normal_quantile(one, share);
}

// Normal scores of independent numbers, one in the middle of each of as many equal shares as there are
// samples.
Eigen::MatrixXd hypercube(Eigen::Index inputs, Eigen::Index samples, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  Eigen::MatrixXd scores(inputs, samples);
  for (Eigen::Index i = 0; i < inputs; ++i) {
    for (Eigen::Index j = 0; j < samples; ++j)
      scores(i, j) = quantile(standard_normal, (static_cast<double>(j) + 0.5) / static_cast<double>(samples));
    for (Eigen::Index j = samples - 1; j > 0; --j) {
      const auto other = static_cast<Eigen::Index>(uniform_draw(generator) * static_cast<double>(j + 1));
      std::swap(scores(i, j), scores(i, other));
    }
  }
  return scores;
}

}  // namespace

std::vector<std::vector<double>> uncertain_samples(const UncertainInputs& uncertain, int samples,
                                                   std::uint64_t seed) {
  const auto inputs = static_cast<Eigen::Index>(uncertain.inputs.size());
  if (inputs == 0) return {};
  Eigen::MatrixXd correlations(inputs, inputs);
  for (Eigen::Index i = 0; i < inputs; ++i)
    for (Eigen::Index j = 0; j < inputs; ++j)
      correlations(i, j) = uncertain.correlations[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  const Eigen::MatrixXd scores = correlations.llt().matrixL() * hypercube(inputs, samples, seed);
  std::vector<std::vector<double>> drawn(static_cast<std::size_t>(samples));
  for (Eigen::Index j = 0; j < samples; ++j)
    for (Eigen::Index i = 0; i < inputs; ++i)
      drawn[static_cast<std::size_t>(j)].push_back(
          input_quantile(uncertain.inputs[static_cast<std::size_t>(i)], cdf(standard_normal, scores(i, j))));
  return drawn;
}

}  // namespace orbearing::app
