#include "gearset/mesh/iso6336.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gearset/tooth_form.hpp"

namespace orbearing::gearset {

namespace {

constexpr double newton_per_millimetre_micrometre = 1e9;  // [Pa]
constexpr double steel = 206e9;                           // [Pa]  modulus that the regression is for
constexpr double degree = 0.017453292519943295;           // [rad]

// The formula is not symmetric in the two gears; its first is the pinion.
Iso6336Pair pinion_first(Iso6336Pair pair) {
  if (pair.second_teeth == 0) return pair;
  if (std::pair(pair.first_teeth, -pair.first_shift) > std::pair(pair.second_teeth, -pair.second_shift)) {
    std::swap(pair.first_teeth, pair.second_teeth);
    std::swap(pair.first_shift, pair.second_shift);
  }
  return pair;
}

// Teeth of the spur gear whose section is that normal to helical ones, per tooth of those.
double virtual_teeth(const Iso6336Pair& pair) {
  const double base = base_helix_angle(pair.rack.pressure_angle, pair.helix_angle);
  return 1.0 / (std::pow(std::cos(base), 2) * std::cos(pair.helix_angle));
}

// q' of ISO 6336-1, method B [mm um / N].
double flexibility(const Iso6336Pair& pair) {
  const double teeth = virtual_teeth(pair);
  const double z1 = 1.0 / (teeth * pair.first_teeth);
  const double z2 = pair.second_teeth > 0 ? 1.0 / (teeth * pair.second_teeth) : 0.0;
  const double x1 = pair.first_shift;
  const double x2 = pair.second_shift;
  return 0.04723 + 0.15551 * z1 + 0.25791 * z2 - 0.00635 * x1 - 0.11654 * x1 * z1 - 0.00193 * x2 -
         0.24188 * x2 * z2 + 0.00529 * x1 * x1 + 0.00182 * x2 * x2;
}

// C_B, for a basic rack of other dedendum or pressure angle than the standard one.
double rack_factor(const BasicRack& rack) {
  const double dedendum = rack.addendum + rack.clearance;  // [module]
  const double angle = rack.pressure_angle / degree;       // [deg]
  return (1.0 + 0.5 * (1.2 - dedendum)) * (1.0 - 0.02 * (20.0 - angle));
}

}  // namespace

double web_factor(const Web& web) {
  if (!web.thickness) return 1.0;
  const double rim = std::max(web.rim, 1.0);
  return 1.0 + std::log(std::clamp(*web.thickness, 0.2, 1.2)) / (5.0 * std::exp(rim / 5.0));
}

Iso6336Stiffness iso6336_stiffness(const Iso6336Pair& of_pair) {
  const Iso6336Pair pair = pinion_first(of_pair);
  constexpr double measured = 0.8;  // C_M: measured gears are softer than the theory
  const double modulus = pair.material.youngs_modulus / steel;
  Iso6336Stiffness result;
  result.theoretical_single = newton_per_millimetre_micrometre / flexibility(pair);
  const double racks = 0.5 * (rack_factor(pair.rack) + rack_factor(pair.second_rack.value_or(pair.rack)));
  result.single = result.theoretical_single * measured * racks * web_factor(pair.web) * modulus *
                  std::cos(pair.helix_angle);
  result.mesh = result.single * (0.75 * pair.contact_ratio + 0.25);
  const double sum = pair.first_shift + pair.second_shift;
  constexpr double largest_helix = 30.0 * degree;
  result.in_range = pair.first_shift >= pair.second_shift && sum >= -0.5 && sum <= 2.0 &&
                    std::abs(pair.helix_angle) <= largest_helix;
  return result;
}

}  // namespace orbearing::gearset
