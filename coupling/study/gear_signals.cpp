#include "coupling/study/gear_signals.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <complex>
#include <limits>

namespace orbearing::study {

namespace {

using boost::math::double_constants::two_pi;

// Amplitude of the harmonic `order` of one period.
double amplitude(const Eigen::ArrayXd& period, int order) {
  const double samples = static_cast<double>(period.size());
  std::complex<double> sum = 0.0;
  for (Eigen::Index i = 0; i < period.size(); ++i)
    sum += period[i] * std::polar(1.0, -two_pi * order * static_cast<double>(i) / samples);
  return 2.0 * std::abs(sum) / samples;
}

}  // namespace

SignalSums::SignalSums(long samples_per_period)
    : least_(std::numeric_limits<double>::infinity()),
      largest_(-std::numeric_limits<double>::infinity()),
      period_(Eigen::ArrayXd::Zero(samples_per_period)) {}

void SignalSums::add(double value) {
  period_[samples_ % period_.size()] += value;
  ++samples_;
  sum_ += value;
  square_ += value * value;
  least_ = std::min(least_, value);
  largest_ = std::max(largest_, value);
}

SignalStatistics SignalSums::statistics(int harmonics) const {
  SignalStatistics out;
  if (samples_ == 0) return out;
  out.mean = sum_ / static_cast<double>(samples_);
  out.rms = std::sqrt(mean_square());
  out.maximum = std::max(std::abs(least_), std::abs(largest_));
  out.least = least_;
  out.largest = largest_;
  const Eigen::ArrayXd period =
      period_ * (static_cast<double>(period_.size()) / static_cast<double>(samples_));
  for (int order = 1; order <= harmonics; ++order) out.amplitudes.push_back(amplitude(period, order));
  return out;
}

GearSignals::GearSignals(Eigen::Index planets, long samples_per_period) {
  const SignalSums empty(samples_per_period);
  planets_.assign(static_cast<std::size_t>(planets), Planet{empty, empty, empty, empty, empty, empty});
}

void GearSignals::add(const gearset::dynamics::SetSnapshot& now) {
  for (std::size_t i = 0; i < planets_.size(); ++i) {
    const auto n = static_cast<Eigen::Index>(i);
    planets_[i].sun_mesh.add(now.sun_mesh_force[n]);
    planets_[i].ring_mesh.add(now.ring_mesh_force[n]);
    planets_[i].radial.add(now.bearing_force(0, n));
    planets_[i].tangential.add(now.bearing_force(1, n));
    planets_[i].radial_acceleration.add(now.acceleration(0, n));
    planets_[i].tangential_acceleration.add(now.acceleration(1, n));
  }
}

std::vector<PlanetStatistics> GearSignals::statistics(int harmonics) const {
  std::vector<PlanetStatistics> all;
  double tangential = 0.0;
  for (const Planet& planet : planets_) {
    all.push_back({.sun_mesh_force = planet.sun_mesh.statistics(harmonics),
                   .ring_mesh_force = planet.ring_mesh.statistics(harmonics),
                   .radial_force = planet.radial.statistics(harmonics),
                   .tangential_force = planet.tangential.statistics(harmonics),
                   .radial_acceleration = planet.radial_acceleration.statistics(harmonics),
                   .tangential_acceleration = planet.tangential_acceleration.statistics(harmonics)});
    tangential += all.back().tangential_force.mean / static_cast<double>(planets_.size());
  }
  for (PlanetStatistics& planet : all) {
    const SignalStatistics& force = planet.tangential_force;
    planet.load_share = force.mean / tangential;
    planet.most_load_share = std::max(force.least / tangential, force.largest / tangential);
  }
  return all;
}

double GearSignals::rms_acceleration() const {
  double sum = 0.0;
  for (const Planet& planet : planets_)
    sum += planet.radial_acceleration.mean_square() + planet.tangential_acceleration.mean_square();
  return std::sqrt(sum / static_cast<double>(planets_.size()));
}

double GearSignals::rms_mesh_force() const {
  double sum = 0.0;
  for (const Planet& planet : planets_) sum += planet.sun_mesh.mean_square() + planet.ring_mesh.mean_square();
  return std::sqrt(sum / (2.0 * static_cast<double>(planets_.size())));
}

}  // namespace orbearing::study
