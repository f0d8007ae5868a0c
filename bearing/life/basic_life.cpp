#include "bearing/life/basic_life.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "bearing/units.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::bearing::rating {

namespace {

constexpr double kReliabilityOfRatings = 0.9;

// ln(1/S) over that of the rating life; log1p keeps digits where S is near 1.
double hazard_ratio(double reliability) {
  mechanics::require(reliability > 0.0 && reliability < 1.0, "reliability", reliability,
                     "greater than 0 and less than 1");
  return std::log1p(reliability - 1.0) / std::log(kReliabilityOfRatings);
}

void require_shares(const Eigen::Ref<const Eigen::ArrayXd>& shares, Eigen::Index lives) {
  constexpr double round_off = 1e-9;
  if (shares.size() == lives && lives > 0 && shares.minCoeff() >= 0.0 &&
      std::abs(shares.sum() - 1.0) <= round_off)
    return;
  std::ostringstream text;
  text << "load spectrum: found " << shares.size() << " shares that add up to " << shares.sum() << " for "
       << lives << " lives; required: as many shares as lives, none negative, which add up to 1";
  throw std::invalid_argument(text.str());
}

}  // namespace

double life_exponent(RollingElement element) {
  return element == RollingElement::ball ? 3.0 : 10.0 / 3.0;
}

double basic_rating_life(RollingElement element, double capacity, double equivalent_load) {
  if (equivalent_load <= 0.0) return kInfinity;
  return kMillionRevolutions * std::pow(capacity / equivalent_load, life_exponent(element));
}

double reference_load(RollingElement element, double capacity, double life) {
  return capacity * std::pow(life / kMillionRevolutions, -1.0 / life_exponent(element));
}

double reliability_factor(double reliability) {
  constexpr double safe_share = 0.05;
  constexpr double slope = 1.5;
  return (1.0 - safe_share) * std::pow(hazard_ratio(reliability), 1.0 / slope) + safe_share;
}

double weibull_reliability(double life_ratio, double slope) {
  return std::exp(std::log(kReliabilityOfRatings) * std::pow(life_ratio, slope));
}

double spectrum_life(const Eigen::Ref<const Eigen::ArrayXd>& shares,
                     const Eigen::Ref<const Eigen::ArrayXd>& lives) {
  require_shares(shares, lives.size());
  const double damage = (shares / lives).sum();
  return damage > 0.0 ? 1.0 / damage : kInfinity;
}

double system_life(const Eigen::Ref<const Eigen::ArrayXd>& lives, double slope) {
  const double shortest = lives.size() > 0 ? lives.minCoeff() : kInfinity;
  if (std::isinf(shortest) || shortest <= 0.0) return shortest;
  return shortest * std::pow((lives / shortest).pow(-slope).sum(), -1.0 / slope);
}

}  // namespace orbearing::bearing::rating
