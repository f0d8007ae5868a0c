#include "bearing/default_design.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing {

namespace {

// Metals rebound with 1 - a v, a = 0.08 to 0.32 s/m [HuntCrossley1975]; in the middle 3/2 a is 0.3 s/m.
constexpr double metal_damping = 0.3;  // [s/m]
constexpr double polymer_damping = 1.0;

constexpr std::array<CageMaterial, 4> default_materials{{
    {"glass-filled polyamide", 1310.0, 6e9, polymer_damping},  // moist and warm; dry and cold 8e9
    {"aluminium", 2700.0, 70e9, metal_damping},
    {"steel", 7850.0, 206e9, metal_damping},
    {"brass", 8500.0, 105e9, metal_damping},
}};

constexpr double cage_poisson_ratio = 0.35;  // [-]  between polymers and metals; affects the shear only

double gap_between_rollers(double roller_diameter, double pitch_diameter, int rollers) {
  return pitch_diameter * std::sin(constants::pi / rollers) - roller_diameter;
}

double shear_modulus(double youngs_modulus, double poisson_ratio) {
  return 0.5 * youngs_modulus / (1.0 + poisson_ratio);
}

}  // namespace

const CageMaterial& default_cage_material(double density) {
  const auto distance = [density](const CageMaterial& material) {
    return std::abs(material.density - density);
  };
  return *std::min_element(
      default_materials.begin(), default_materials.end(),
      [&](const CageMaterial& a, const CageMaterial& b) { return distance(a) < distance(b); });
}

const CageMaterial& cage_material(std::string_view name) {
  const auto found = std::find_if(default_materials.begin(), default_materials.end(),
                                  [name](const CageMaterial& one) { return one.name.ends_with(name); });
  mechanics::require(!name.empty() && found != default_materials.end(), "material of a cage", name,
                     "polyamide, aluminium, steel or brass");
  return *found;
}

double default_pocket_clearance(double roller_diameter, double pitch_diameter, int rollers) {
  const double gap = gap_between_rollers(roller_diameter, pitch_diameter, rollers);
  return std::max(0.0, std::min(roller_diameter / 50.0, 0.5 * gap));
}

CageSize default_cage_size(double pitch_diameter, double element_diameter, double element_length,
                           double bearing_width, double share_of_width) {
  constexpr double inward = 0.4, outward = 0.5;
  double width = share_of_width * bearing_width;
  if (width <= element_length) width = 0.5 * (element_length + bearing_width);  // longer than is usual
  return {pitch_diameter - inward * element_diameter, pitch_diameter + outward * element_diameter, width};
}

double default_land_play(double element_diameter) {
  return 0.06 * element_diameter;
}

double cage_bar_thickness(double roller_diameter, double pocket_clearance, double pitch_diameter,
                          int rollers) {
  return gap_between_rollers(roller_diameter, pitch_diameter, rollers) - pocket_clearance;
}

double cage_bar_stiffness(const CageBar& bar) {
  constexpr double warping = 1.2;  // kappa of a rectangle
  const double area = bar.height * bar.thickness;
  const double second_moment = area * bar.thickness * bar.thickness / 12.0;
  const double bending = std::pow(bar.length, 3) / (720.0 * bar.youngs_modulus * second_moment);
  const double shear =
      warping * bar.length / (12.0 * shear_modulus(bar.youngs_modulus, cage_poisson_ratio) * area);
  return 1.0 / (bending + shear);
}

double default_touch_down_stiffness(double youngs_modulus, double width) {
  return 0.2 * youngs_modulus * width;
}

double pin_stiffness(const PlanetPin& pin) {
  const double b = pin.loaded_length, a = 0.5 * (pin.span - b), c = 0.125 * (2.0 * pin.span - b);
  const double area = 0.25 * constants::pi * pin.diameter * pin.diameter;
  const double second_moment = area * pin.diameter * pin.diameter / 16.0;
  const double nu = pin.poisson_ratio;
  const double warping = (7.0 + 6.0 * nu) / (6.0 * (1.0 + nu));  // kappa of a circle
  double bending = 0.0;                                          // [m^3]  times E I
  double shear = 0.0;                                            // [m]    times G A/kappa
  switch (pin.ends) {
    case PinEnds::both:
      bending = 2.0 * (a * a * a / 12.0 + 0.5 * c * c * b - c * b * b / 24.0 + b * b * b / 640.0);
      shear = 0.5 * a + b / 12.0;
      break;
    case PinEnds::one:
      bending = a * a * a / 3.0 + 0.5 * a * a * b + 0.25 * a * b * b + b * b * b / 20.0;
      shear = a + b / 3.0;
      break;
    case PinEnds::flexpin:
      bending = std::pow(pin.span, 3) / 12.0;
      shear = pin.span;
      break;
  }
  return 1.0 / (bending / (pin.youngs_modulus * second_moment) +
                warping / (shear_modulus(pin.youngs_modulus, nu) * area) * shear);
}

}  // namespace orbearing::bearing
