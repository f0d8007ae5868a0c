// Friction in a race contact as a function of load and sliding, and the oil's resistance to rolling.
#pragma once

#include <cmath>
#include <optional>

#include "bearing/contact/film.hpp"
#include "bearing/motion/parameters.hpp"

namespace orbearing::bearing::dynamics {

/// Friction force that rises with the sliding speed `sliding` [m/s] and levels off at `friction` [-] times
/// `load` [N]: regularised Coulomb, rounded over `scale` [m/s]. Takes the sign of the sliding speed. [N]
inline double regularised_friction(double friction, double load, double sliding, double scale) {
  return friction * load * sliding / std::sqrt(sliding * sliding + scale * scale);
}

/// Traction of one race contact.
class TractionCurve {
 public:
  /// `contact` is used by the limiting-shear law only.
  TractionCurve(const RaceContactParameters& parameters, const FilmContact& contact);

  /// Force [N] on the roller along the tangent, at contact load `load` [N], sliding speed `sliding` [m/s] of
  /// race less roller and entrainment speed `entrainment` [m/s] > 0. Never opposes the sliding: force *
  /// sliding >= 0.
  double force(double load, double sliding, double entrainment) const {
    if (law_ == TractionLaw::regularised_coulomb)
      return regularised_friction(friction_, load, sliding, sliding_scale_);
    return limiting_shear(load, sliding, entrainment);
  }

  TractionLaw law() const { return law_; }
  double friction() const { return friction_; }
  double sliding_scale() const { return sliding_scale_; }
  double largest_exponent() const { return largest_exponent_; }
  const FilmContact& contact() const { return contact_; }
  const Film& film_at_unit_speed() const { return film_at_unit_speed_; }

 private:
  double limiting_shear(double load, double sliding, double entrainment) const;

  TractionLaw law_;
  double friction_;
  double sliding_scale_;     // [m/s]
  double largest_exponent_;  // [-]
  FilmContact contact_;
  Film film_at_unit_speed_;  // entrainment 1 m/s
};

/// Resistance of the oil at the inlet of a lubricated line contact to rolling.
///
/// The oil drags each surface back with F_R = 4.318 (alpha E' U)^0.658 W^0.0126 R l / alpha, U = eta u / (E'
/// R), W = Q / (E' R l) [GoksemHargreaves1978] as fitted by [ZhouHoeprich1991]. The pressure's resultant
/// gives the balance of forces, after [Houpert1987].
class RollingResistance {
 public:
  explicit RollingResistance(const FilmContact& contact);

  /// Backward force on each surface [N], with the sign of `rolling` [m/s], at contact load `load` [N].
  /// `entrainment` [m/s] > 0 is |rolling|, rounded at zero. Falls to zero with the load.
  double force(double load, double rolling, double entrainment) const;
  /// Resistance [N] at unit speed and load.
  double factor() const { return factor_; }

 private:
  double factor_ = 0.0;  // [N] at unit speed and load
};

}  // namespace orbearing::bearing::dynamics
