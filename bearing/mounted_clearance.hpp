// From the clearance of a bearing on the shelf to that in which it runs: fits, temperatures, speeds.
//
//      planet     b3 ─┐ heated, spinning       G = G_0 + (D_o' - D_o) - (D_i' - D_i) - 2 (D_r' - D_r)
//      outer ring b2 ─┤ pressed in
//      rollers        │                        D_o, D_i diameters of the races, D_r of a roller; ' as it runs
//      inner ring a3 ─┤ pressed on
//      pin        a2 ─┘
//
// Rings, pin and planet are annuli in plane stress, each from radius a to b, elastic [TimoshenkoGoodier1970]:
// with pressure p_a inside and p_b outside (Lamé), spinning about its axis at w, warmer by T than the
// temperature at which sizes are stated,
//
//   (1)  u(r) = [(1-v)(p_a a^2 - p_b b^2) r + (1+v)(p_a - p_b) a^2 b^2/r] / [E (b^2 - a^2)]
//             + (d w^2/E) (1-v)(3+v)/8 [(a^2 + b^2) r - (1+v)/(3+v) r^3 + (1+v)/(1-v) a^2 b^2/r]
//             + e T r
//
// Two of them, pressed together at radius s with the interference I of their diameters, are held by the
// pressure p >= 0 that closes
//
//   (2)  I/2 + u_within(s) - u_around(s) = p (c_within + c_around),      c the displacement at s by a
//   pressure of 1
//
// and part (p = 0) where heat or speed leaves none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bearing/parameters.hpp"

namespace orbearing::bearing {

/// One ring-shaped body: inner ring, outer ring, pin (a solid one has no hole) or planet.
struct Annulus {
  double inner_radius = 0.0;  // [m]  0: solid
  double outer_radius = 0.0;  // [m]
  Material material;
  double expansion = 11.5e-6;  // [1/K]
  double warmth = 0.0;         // [K]      above the temperature at which its sizes hold
  double speed = 0.0;          // [rad/s]  about its own axis, against the stars
  double outside_pull = 0.0;   // [Pa]     on its outer circle, by masses that hang there and spin with it
};

/// Radial displacement [m] at `radius` by Eq. (1), with the pressures [Pa] on both circles.
double displacement(const Annulus& body, double radius, double inside_pressure = 0.0,
                    double outside_pressure = 0.0);

/// Two bodies pressed together.
struct PressedPair {
  Annulus within;
  Annulus around;             // its inner radius is the other's outer one but for the interference
  double interference = 0.0;  // [m]  of the diameters, cold and at rest; negative: a loose fit

  /// Pressure between both [Pa]; 0 where they part. Eq. (2).
  double pressure() const;
};

/// Mounting of a planet bearing to which its stated clearance refers.
enum class ClearanceState {
  operating,  // the clearance stated is that in which the bearing runs
  unmounted   // it is that of the bearing on the shelf
};

constexpr described::Names<ClearanceState, 2> names_of(ClearanceState) {
  return {{{ClearanceState::operating, "operating"}, {ClearanceState::unmounted, "unmounted"}}};
}

/// Which rings a planet bearing has. Rollers without inner ring run on the pin, without outer ring in the
/// bore of the planet: race and seat are then one circle.
enum class Rings { both, outer, none };

constexpr described::Names<Rings, 3> names_of(Rings) {
  return {{{Rings::both, "both"}, {Rings::outer, "outer"}, {Rings::none, "none"}}};
}

/// Temperature at which sizes are stated [degC] (ISO 1), and expansion of bearing steel [1/K].
inline constexpr double kSizesTemperature = 20.0;
inline constexpr double kSteelExpansion = 11.5e-6;

/// Left out: neither tight nor loose, a solid pin, all at the temperature at which sizes hold.
struct Mounting {
  Rings rings = Rings::both;
  ClearanceState state = ClearanceState::operating;
  double unmounted_clearance = 0.0;  // [m]  the one stated, where it is that of the bearing on the shelf
  std::optional<double> inner_interference;  // [m]  bore of the inner ring under the pin, of the diameters
  std::optional<double> outer_interference;  // [m]  outer ring over the planet's bore
  double pin_bore = 0.0;                     // [m]  diameter of the hole in the pin
  double expansion = kSteelExpansion;
  std::optional<double> pin_temperature;         // [degC]
  std::optional<double> inner_ring_temperature;  // [degC]
  std::optional<double> roller_temperature;      // [degC]
  std::optional<double> outer_ring_temperature;  // [degC]
  std::optional<double> planet_temperature;      // [degC]

  bool states_fits() const { return inner_interference || outer_interference; }
  bool states_temperatures() const {
    return pin_temperature || inner_ring_temperature || roller_temperature || outer_ring_temperature ||
           planet_temperature;
  }
};

template <class Visitor>
void describe(Visitor& visit, Mounting& m) {
  using namespace described;
  constexpr Where unmounted{"bearing.clearance_state", "unmounted"};
  const auto interference = [&](std::optional<double>& member, const char* path, const char* meaning) {
    return input(member, path, meaning,
                 {.dimension = dimension::small_length, .range = {-500.0, 500.0}, .where = unmounted});
  };
  const auto temperature = [&](std::optional<double>& member, const char* path, const char* meaning) {
    return input(member, path, meaning,
                 {.dimension = dimension::temperature, .range = {-60.0, 400.0}, .where = unmounted});
  };
  members(
      visit, m,
      input(m.rings, "bearing.rings",
            "rings of a planet bearing: both; outer, with rollers on the pin; or none, with rollers on the "
            "pin and in the planet's bore",
            {.reason = "as most catalogue bearings"}),
      input(m.state, "bearing.clearance_state",
            "state of bearing.radial_clearance: running bearing, or unmounted bearing, from which fits, "
            "temperatures and speeds give the running clearance",
            {.reason = "published clearances are those of running bearings"}),
      apart(m.unmounted_clearance),
      interference(m.inner_interference, "bearing.fit.inner_interference",
                   "interference of pin and inner ring bore before assembly, in diameter; negative: loose"),
      interference(
          m.outer_interference, "bearing.fit.outer_interference",
          "interference of outer ring and planet bore before assembly, in diameter; negative: loose"),
      input(m.pin_bore, "bearing.fit.pin_bore", "diameter of the hole in the pin",
            {.dimension = dimension::length, .range = {0.0, 1e4}, .where = unmounted}),
      input(m.expansion, "bearing.fit.expansion",
            "linear thermal expansion of rings, rollers, pin and planet",
            {.dimension = dimension::per_kelvin, .range = {0.0, 1e-4}, .where = unmounted}),
      temperature(m.pin_temperature, "bearing.temperature.pin", "temperature of the pin"),
      temperature(m.inner_ring_temperature, "bearing.temperature.inner_ring",
                  "temperature of the inner ring"),
      temperature(m.roller_temperature, "bearing.temperature.rollers", "temperature of the rollers"),
      temperature(m.outer_ring_temperature, "bearing.temperature.outer_ring",
                  "temperature of the outer ring"),
      temperature(m.planet_temperature, "bearing.temperature.planet", "temperature of the planet's body"));
}

/// Rotating bodies, and the body around the outer ring.
struct Surroundings {
  double planet_outer_radius = 0.0;  // [m]      of the planet's body: its root circle
  double hanging_mass = 0.0;         // [kg/m]   of the teeth, for each metre of their width
  double hanging_radius = 0.0;       // [m]      at which it hangs
  double planet_speed = 0.0;  // [rad/s]  of planet and outer ring about their own axis, against the stars
  double pin_speed = 0.0;     // [rad/s]  of pin and inner ring: that of the carrier
};

/// The clearance [m, of diameters] step by step, each with all before it.
struct ClearanceChain {
  double unmounted = 0.0;       // on the shelf
  double fitted = 0.0;          // mounted, cold, at rest
  double warm = 0.0;            // at its temperatures, at rest
  double operating = 0.0;       // at speed
  double inner_pressure = 0.0;  // [Pa]  between pin and inner ring as it runs; 0: they part
  double outer_pressure = 0.0;  // [Pa]  between outer ring and planet
};

/// The chain of `bearing`. Where the clearance stated is the operating one, all are equal. Races
/// are taken where the stated clearance has them; ribs of the rings stiffen nothing. Throws
/// std::invalid_argument where pin or planet leave no room for a hole or a rim. Where a ring is missing, the
/// pin's or the planet's own circle is the race: there is no seat, and no pressure in it.
ClearanceChain clearance_chain(const Bearing& bearing, const Mounting& mounting, const Surroundings& around);

}  // namespace orbearing::bearing
