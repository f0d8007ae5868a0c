#include "bearing/mounted_clearance.hpp"

#include <algorithm>

#include "bearing/geometry.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing {

namespace {

using constants::two_pi;

/// Which steps of the chain act.
struct Acting {
  bool warmth = false;
  bool speed = false;
};

/// Shaft and housing of the rings, and displacement of their races.
class MountedRings {
 public:
  MountedRings(const Bearing& bearing, const Mounting& mounting, const Surroundings& around,
               const Acting& acting)
      : races_(geometry_of(bearing)),
        inner_ring_(mounting.rings == Rings::both),
        outer_ring_(mounting.rings != Rings::none) {
    const auto body = [&](double inside, double outside, const std::optional<double>& temperature,
                          double speed) {
      return Annulus{
          .inner_radius = inside,
          .outer_radius = outside,
          .material = bearing.material,
          .expansion = mounting.expansion,
          .warmth = acting.warmth ? temperature.value_or(kSizesTemperature) - kSizesTemperature : 0.0,
          .speed = acting.speed ? speed : 0.0};
    };
    const double bore = inner_ring_ ? 0.5 * bearing.inner.seat_diameter : races_.inner_radius;
    const double outside = outer_ring_ ? 0.5 * bearing.outer.seat_diameter : races_.outer_radius;
    inner_ = {body(0.5 * mounting.pin_bore, bore, mounting.pin_temperature, around.pin_speed),
              body(bore, races_.inner_radius, mounting.inner_ring_temperature, around.pin_speed),
              mounting.inner_interference.value_or(0.0)};
    outer_ = {body(races_.outer_radius, outside, mounting.outer_ring_temperature, around.planet_speed),
              body(outside, around.planet_outer_radius, mounting.planet_temperature, around.planet_speed),
              mounting.outer_interference.value_or(0.0)};
    Annulus& planet = outer_.around;
    planet.outside_pull = around.hanging_mass * planet.speed * planet.speed * around.hanging_radius /
                          (two_pi * planet.outer_radius);
    roller_growth_ =
        mounting.expansion * bearing.element_diameter() *
        (acting.warmth ? mounting.roller_temperature.value_or(kSizesTemperature) - kSizesTemperature : 0.0);
  }

  double inner_pressure() const { return inner_ring_ ? inner_.pressure() : 0.0; }
  double outer_pressure() const { return outer_ring_ ? outer_.pressure() : 0.0; }

  /// By how much the clearance grows [m, of diameters].
  double growth() const {
    const double of_outer = outer_ring_
                                ? displacement(outer_.within, races_.outer_radius, 0.0, outer_pressure())
                                : displacement(outer_.around, races_.outer_radius);
    const double of_inner = inner_ring_
                                ? displacement(inner_.around, races_.inner_radius, inner_pressure(), 0.0)
                                : displacement(inner_.within, races_.inner_radius);
    return 2.0 * (of_outer - of_inner - roller_growth_);
  }

 private:
  BearingGeometry races_;
  bool inner_ring_;
  bool outer_ring_;
  PressedPair inner_;
  PressedPair outer_;
  double roller_growth_ = 0.0;  // [m]  of its diameter
};

}  // namespace

double displacement(const Annulus& body, double radius, double inside_pressure, double outside_pressure) {
  const double nu = body.material.poisson_ratio, modulus = body.material.youngs_modulus;
  const double a2 = body.inner_radius * body.inner_radius, b2 = body.outer_radius * body.outer_radius;
  const double outside = outside_pressure - body.outside_pull;
  const double by_pressure = ((1.0 - nu) * (inside_pressure * a2 - outside * b2) * radius +
                              (1.0 + nu) * (inside_pressure - outside) * a2 * b2 / radius) /
                             (modulus * (b2 - a2));
  const double by_speed = body.material.density * body.speed * body.speed / modulus * (1.0 - nu) *
                          (3.0 + nu) / 8.0 *
                          ((a2 + b2) * radius - (1.0 + nu) / (3.0 + nu) * radius * radius * radius +
                           (1.0 + nu) / (1.0 - nu) * a2 * b2 / radius);
  return by_pressure + by_speed + body.expansion * body.warmth * radius;
}

double PressedPair::pressure() const {
  const double seat = within.outer_radius;
  const double overlap = 0.5 * interference + displacement(within, seat) - displacement(around, seat);
  // Cold bodies at rest: compared with the effects of heat and speed, a pressure of 1 is lost in round-off.
  const auto cold = [](Annulus body) {
    body.warmth = body.speed = body.outside_pull = 0.0;
    return body;
  };
  const double compliance =
      displacement(cold(around), seat, 1.0, 0.0) - displacement(cold(within), seat, 0.0, 1.0);
  return std::max(0.0, overlap / compliance);
}

ClearanceChain clearance_chain(const Bearing& bearing, const Mounting& mounting, const Surroundings& around) {
  if (mounting.state == ClearanceState::operating) {
    const double stated = bearing.radial_clearance;
    return {stated, stated, stated, stated, 0.0, 0.0};
  }
  const double stated = mounting.unmounted_clearance;
  Bearing on_the_shelf = bearing;
  on_the_shelf.radial_clearance = stated;
  const BearingGeometry races = geometry_of(on_the_shelf);
  const double pin = mounting.rings == Rings::both ? bearing.inner.seat_diameter : 2.0 * races.inner_radius;
  const double bore = mounting.rings == Rings::none ? 2.0 * races.outer_radius : bearing.outer.seat_diameter;
  mechanics::require(mounting.pin_bore < pin, "bearing.fit.pin_bore", mounting.pin_bore,
                     "less than the diameter of the pin");
  mechanics::require(around.planet_outer_radius > 0.5 * bore, "radius of the planet's body",
                     around.planet_outer_radius, "more than that of its bore");
  const auto after = [&](const Acting& acting) {
    return stated + MountedRings(on_the_shelf, mounting, around, acting).growth();
  };
  const MountedRings running(on_the_shelf, mounting, around, {.warmth = true, .speed = true});
  return {.unmounted = stated,
          .fitted = after({}),
          .warm = after({.warmth = true}),
          .operating = stated + running.growth(),
          .inner_pressure = running.inner_pressure(),
          .outer_pressure = running.outer_pressure()};
}

}  // namespace orbearing::bearing
