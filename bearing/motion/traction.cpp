#include "bearing/motion/traction.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

namespace orbearing::bearing::dynamics {

namespace {

using boost::math::double_constants::pi;

constexpr double kTractionSpeedExponent = 0.7;
constexpr double kRollingSpeedExponent = 0.658;
constexpr double kRollingLoadExponent = 0.0126;
constexpr double kRollingLoadScale = 1.0;  // [N]  below it the resistance falls in proportion to the load

// Mean pressure of a Hertzian line contact: load over the area 2 b l, b = sqrt(8 Q R / (pi E' l)),
// chapter 4 of [Johnson1985] with E' twice the composite modulus used there.
double mean_pressure(const FilmContact& contact, double load) {
  const double half_width =
      std::sqrt(8.0 * load * contact.equivalent_radius / (pi * contact.reduced_modulus * contact.length));
  return load / (2.0 * half_width * contact.length);
}

}  // namespace

TractionCurve::TractionCurve(const RaceContactParameters& parameters, const FilmContact& contact)
    : law_(parameters.traction),
      friction_(law_ == TractionLaw::limiting_shear ? parameters.limiting_friction : parameters.friction),
      sliding_scale_(law_ == TractionLaw::limiting_shear ? parameters.least_sliding_scale
                                                         : parameters.sliding_scale),
      largest_exponent_(parameters.largest_barus_exponent),
      contact_(contact),
      film_at_unit_speed_(contact, 1.0) {}

// The film is sheared as a Newtonian oil, eta s / h, until the stress nears its limit, friction times
// pressure; the exponential between both is that of [BairWiner1979]. The viscosity follows Barus up to the
// largest exponent.
double TractionCurve::limiting_shear(double load, double sliding, double entrainment) const {
  if (load <= 0.0) return 0.0;
  const double pressure = mean_pressure(contact_, load);
  const double exponent = std::min(contact_.lubricant.pressure_viscosity * pressure, largest_exponent_);
  const double viscosity = contact_.lubricant.viscosity * std::exp(exponent);
  const double film = film_at_unit_speed_.central(load) * std::pow(entrainment, kTractionSpeedExponent);
  const double scale = friction_ * pressure * film / viscosity + sliding_scale_;
  return std::copysign(friction_ * load * -std::expm1(-std::abs(sliding) / scale), sliding);
}

RollingResistance::RollingResistance(const FilmContact& contact) {
  const double alpha = contact.lubricant.pressure_viscosity;
  if (alpha <= 0.0 || contact.lubricant.viscosity <= 0.0) return;
  const double area = contact.equivalent_radius * contact.length;
  factor_ = 4.318 *
            std::pow(alpha * contact.lubricant.viscosity / contact.equivalent_radius, kRollingSpeedExponent) *
            std::pow(contact.reduced_modulus * area, -kRollingLoadExponent) * area / alpha;
}

double RollingResistance::force(double load, double rolling, double entrainment) const {
  if (load <= 0.0 || factor_ <= 0.0) return 0.0;
  const double powers =
      std::exp(kRollingSpeedExponent * std::log(entrainment) + kRollingLoadExponent * std::log(load));
  return factor_ * powers * (load / (load + kRollingLoadScale)) * (rolling / entrainment);
}

}  // namespace orbearing::bearing::dynamics
