#include "coupling/study/gear_signals.hpp"
#include "mechanics/constants.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace orbearing::study {

using constants::two_pi;

SignalSums::SignalSums(int harmonics)
    : least_(std::numeric_limits<double>::infinity()),
      largest_(-std::numeric_limits<double>::infinity()),
      waves_(Eigen::ArrayXcd::Zero(harmonics)) {}

void SignalSums::add(double value, const Eigen::ArrayXcd& waves) {
  ++samples_;
  sum_ += value;
  square_ += value * value;
  least_ = std::min(least_, value);
  largest_ = std::max(largest_, value);
  waves_ += value * waves;
}

SignalStatistics SignalSums::statistics() const {
  SignalStatistics out;
  if (samples_ == 0) return out;
  const double samples = static_cast<double>(samples_);
  out.mean = sum_ / samples;
  out.rms = std::sqrt(mean_square());
  out.maximum = std::max(std::abs(least_), std::abs(largest_));
  out.least = least_;
  out.largest = largest_;
  for (const std::complex<double>& sum : waves_) {
    const std::complex<double> wave = 2.0 / samples * sum;
    out.cosines.push_back(wave.real());
    out.sines.push_back(-wave.imag());
    out.amplitudes.push_back(std::abs(wave));
  }
  return out;
}

GearSignals::GearSignals(Eigen::Index planets, int harmonics) : waves_(harmonics) {
  const SignalSums empty(harmonics);
  planets_.assign(static_cast<std::size_t>(planets), Planet{empty, empty, empty, empty, empty, empty, 0.0});
}

void GearSignals::add(double periods, const gearset::dynamics::SetSnapshot& now) {
  ++samples_;
  const double angle = two_pi * (periods - std::floor(periods));
  const std::complex<double> first = std::polar(1.0, -angle);
  for (Eigen::Index i = 0; i < waves_.size(); ++i) {
    // Products of real numbers: the library's asks whether they are finite.
    const std::complex<double> before = i == 0 ? 1.0 : waves_[i - 1];
    waves_[i] = {before.real() * first.real() - before.imag() * first.imag(),
                 before.real() * first.imag() + before.imag() * first.real()};
  }
  for (std::size_t i = 0; i < planets_.size(); ++i) {
    const auto n = static_cast<Eigen::Index>(i);
    planets_[i].sun_mesh.add(now.sun_mesh_force[n], waves_);
    planets_[i].ring_mesh.add(now.ring_mesh_force[n], waves_);
    planets_[i].radial.add(now.bearing_force(0, n), waves_);
    planets_[i].tangential.add(now.bearing_force(1, n), waves_);
    planets_[i].radial_acceleration.add(now.acceleration(0, n), waves_);
    planets_[i].tangential_acceleration.add(now.acceleration(1, n), waves_);
    planets_[i].housing_squares += now.in_housing.col(n).square().sum();
  }
}

std::vector<PlanetStatistics> GearSignals::statistics() const {
  std::vector<PlanetStatistics> all;
  double tangential = 0.0;
  for (const Planet& planet : planets_) {
    all.push_back({.sun_mesh_force = planet.sun_mesh.statistics(),
                   .ring_mesh_force = planet.ring_mesh.statistics(),
                   .radial_force = planet.radial.statistics(),
                   .tangential_force = planet.tangential.statistics(),
                   .radial_acceleration = planet.radial_acceleration.statistics(),
                   .tangential_acceleration = planet.tangential_acceleration.statistics(),
                   .housing_acceleration = std::sqrt(0.5 * planet.housing_squares /
                                                     static_cast<double>(std::max(1L, samples_)))});
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
