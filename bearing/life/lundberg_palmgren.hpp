// Fatigue of rolling contacts by Lundberg and Palmgren, stated once for points and lines
// [LundbergPalmgren1947] [LundbergPalmgren1952]; capacities and lives of line contacts, Eqs. (35)-(41) of
// [Gai2025].
//
//   (1)  Q_e = power mean of the loads over the positions on a race, exponent p if it rotates relative to
//        the load, p e if it is stationary
//   (2)  D = (Q_e/Q_c)^(p e);  damages of laminae, races and bearings add up
//   (3)  L = D^(-1/e) million revolutions
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "bearing/life/basic_life.hpp"
#include "bearing/parameters.hpp"
#include "bearing/units.hpp"

namespace orbearing::bearing {

/// Lives of both races and of the bearing, in revolutions of the turning race relative to the load.
struct BearingLife {
  double inner = 0.0;    // [rev]
  double outer = 0.0;    // [rev]
  double bearing = 0.0;  // [rev]
};

namespace life {

struct FatigueLaw {
  double load_exponent;  // [-]  p
  double weibull_slope;  // [-]  e

  constexpr double damage_exponent() const { return load_exponent * weibull_slope; }
  constexpr double mean_exponent(RaceMotion motion) const {
    return motion == RaceMotion::rotating ? load_exponent : damage_exponent();
  }

  /// (1) [N]. `loads` [N] are taken at positions evenly spaced on the race, unloaded ones included.
  double equivalent_load(const Eigen::Ref<const Eigen::ArrayXd>& loads, RaceMotion motion) const {
    const double largest = loads.size() > 0 ? loads.maxCoeff() : 0.0;
    if (largest <= 0.0) return 0.0;
    // By the largest load, so that no power over- or underflows.
    const double exponent = mean_exponent(motion);
    return largest * std::pow((loads / largest).max(0.0).pow(exponent).mean(), 1.0 / exponent);
  }
  /// (2) [-]
  double damage(double equivalent_load, double capacity) const {
    return std::pow(equivalent_load / capacity, damage_exponent());
  }
  /// (3) [rev]; infinite without damage.
  double life(double damage) const {
    return damage > 0.0 ? kMillionRevolutions * std::pow(damage, -1.0 / weibull_slope) : kInfinity;
  }
  BearingLife lives(double inner_damage, double outer_damage) const {
    return {life(inner_damage), life(outer_damage), life(inner_damage + outer_damage)};
  }
};

inline constexpr FatigueLaw point_contacts{3.0, rating::weibull_slope(rating::RollingElement::ball)};
inline constexpr FatigueLaw line_contacts{4.0, rating::weibull_slope(rating::RollingElement::roller)};

}  // namespace life

/// Basic dynamic capacity of one roller-race contact [N], Eq. (36) of [Gai2025]. `reduction_factor` is the
/// product lambda nu of ISO/TR 1281-1 (0.83 for cylindrical rollers) [-].
double contact_capacity(const Bearing& bearing, Race race, double reduction_factor);

/// Life of the bearing [rev] from its races, Eq. (41) of [Gai2025] with the minus signs it lost in print.
double combined_life(double inner, double outer);

/// Life of `n` equal bearings, of which none may fail: Weibull's product law with slope 9/8. Any unit.
double system_life(double one_bearing, int n);

/// Hours from revolutions and the speed of the turning race relative to the load [rad/s]; infinite at rest.
double hours(double revolutions, double speed);

}  // namespace orbearing::bearing
