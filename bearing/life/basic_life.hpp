// Basic rating life, reliability and sums of lives: closed forms that need no distribution of load.
#pragma once

#include <Eigen/Core>

namespace orbearing::bearing::rating {

/// Which kind of contact sets exponents and slopes.
enum class RollingElement { ball, roller };

/// Exponent of life over load: 3 for balls, 10/3 for rollers. [ISO281]
double life_exponent(RollingElement element);

/// Slope e of Weibull's distribution of lives: 10/9 for balls, 9/8 for rollers. [LundbergPalmgren1947]
/// [LundbergPalmgren1952]
constexpr double weibull_slope(RollingElement element) {
  return element == RollingElement::ball ? 10.0 / 9.0 : 9.0 / 8.0;
}

/// Largest contact pressure [Pa] under the static capacity, which leaves an indentation of 1e-4 of the
/// element's diameter: 4200 MPa for balls, 4000 MPa for rollers. [ISO76]
constexpr double static_pressure(RollingElement element) {
  return element == RollingElement::ball ? 4200e6 : 4000e6;
}

/// L10 [rev] = 1e6 (C/P)^p of [ISO281], for load rating `capacity` [N] and equivalent load [N]; infinite at
/// no load.
double basic_rating_life(RollingElement element, double capacity, double equivalent_load);

/// Equivalent load [N] that gives a bearing of `capacity` [N] the life `life` [rev]: the inverse of
/// `basic_rating_life`; [ISO16281] so defines the reference load of a distribution of loads.
double reference_load(RollingElement element, double capacity, double life);

/// Life modification factor a_1 [-] for reliability S in (0, 1): 0.95 (ln(1/S)/ln(1/0.9))^(2/3) + 0.05, from
/// which [ISO281] prints its table (90 to 99.95 %). Three parameters: near certainty 5 % of L10 is safe.
double reliability_factor(double reliability);

/// Share of bearings that reach a life over L10 of `life_ratio` [-], by Weibull's distribution of two
/// parameters with slope e.
double weibull_reliability(double life_ratio, double slope);

/// Life under a load spectrum by the rule of Palmgren and Miner: 1/sum(shares/lives), any unit. `shares` [-]
/// add up to 1 and are shares of revolutions where lives are in revolutions, of time where they are in hours.
/// Throws std::invalid_argument where the two do not fit or the shares do not add up.
double spectrum_life(const Eigen::Ref<const Eigen::ArrayXd>& shares,
                     const Eigen::Ref<const Eigen::ArrayXd>& lives);

/// Life of a system, of which no bearing may fail: (sum lives^-e)^(-1/e), any unit of time.
double system_life(const Eigen::Ref<const Eigen::ArrayXd>& lives, double slope);

}  // namespace orbearing::bearing::rating
