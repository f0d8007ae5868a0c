#include "gearset/mesh/foundation.hpp"

#include <array>
#include <cmath>

namespace orbearing::gearset {

namespace {

ToothLoad load(double base_radius, double tangent_length, double force_angle, double helix_angle) {
  const double contact = std::hypot(base_radius, tangent_length);
  const double axis = base_radius / std::cos(force_angle);
  // Eq. (18): at right angles to the teeth they are thinner and the force is less steep.
  const double position = contact * std::cos(std::atan2(tangent_length, base_radius) - force_angle);
  return {.contact_radius = contact,
          .force_angle = force_angle,
          .axis_radius = axis + std::pow(std::sin(helix_angle), 2) * (position - axis)};
}

}  // namespace

// On the base circle the force is square to the radius through the foot of the flank, which lies half the
// tooth's base thickness from its axis; from there the force turns with the angle of roll.
ToothLoad tooth_load(const ExternalTooth& tooth, double tangent_length) {
  const double roll = tangent_length / tooth.base_radius;
  return load(tooth.base_radius, tangent_length, roll - base_half_angle(tooth), tooth.helix_angle);
}

ToothLoad tooth_load(const RingTooth& tooth, double tangent_length) {
  const double roll = tangent_length / tooth.base_radius;
  return load(tooth.base_radius, tangent_length, roll + base_half_angle(tooth), tooth.helix_angle);
}

namespace {

// X = A/theta^2 + B h^2 + C h/theta + D/theta + E h + F. Table 1 of [Sainsot2004].
double polynomial(const std::array<double, 6>& row, double theta, double h) {
  const auto& [A, B, C, D, E, F] = row;
  return A / (theta * theta) + B * h * h + C * h / theta + D / theta + E * h + F;
}

constexpr std::array<double, 6> moment_row = {-5.574e-5, -1.9986e-3, -2.3015e-4, 4.7702e-3, 0.0271, 6.8045};
constexpr std::array<double, 6> cross_row = {60.111e-5, 28.100e-3, -83.431e-4, -9.9256e-3, 0.1624, 0.9086};
constexpr std::array<double, 6> shear_row = {-50.952e-5, 185.50e-3, 0.0538e-4, 53.300e-3, 0.2895, 0.9236};
constexpr std::array<double, 6> compression_row = {-6.2042e-5, 9.0889e-3, -4.0964e-4,
                                                   7.8297e-3,  -0.1472,   0.6904};

}  // namespace

FoundationBody foundation_body(const ExternalTooth& tooth, double bore_radius) {
  return {tooth.root_radius, half_thickness_angle(tooth, tooth.root_radius), bore_radius, tooth.helix_angle};
}

FoundationBody foundation_body(const RingTooth& tooth, double outside_radius) {
  return {tooth.root_radius, half_thickness_angle(tooth, tooth.root_radius), outside_radius,
          tooth.helix_angle};
}

FoundationCoefficients sainsot_coefficients(double half_angle, double ratio) {
  return {.moment = polynomial(moment_row, half_angle, ratio),
          .cross = polynomial(cross_row, half_angle, ratio),
          .shear = polynomial(shear_row, half_angle, ratio),
          .compression = polynomial(compression_row, half_angle, ratio)};
}

bool in_sainsot_range(const FoundationBody& body) {
  const double ratio = body.root_radius / body.body_radius;
  return ratio >= 1.4 && ratio <= 7.0 && body.half_angle >= 0.01 && body.half_angle <= 0.12;
}

bool sainsot_is_usable(const FoundationBody& body) {
  return body.root_radius <= 20.0 * body.body_radius && body.half_angle >= 0.005;
}

double foundation_compliance(const FoundationCoefficients& coefficients, const FoundationBody& body,
                             const ToothLoad& load, double face_width, const mechanics::Material& material) {
  const double cos_helix = std::cos(body.helix_angle);
  const double thickness =
      2.0 * body.root_radius * body.half_angle * cos_helix;                  // [m] S_f, normal to the tooth
  const double upwards = body.body_radius <= body.root_radius ? 1.0 : -1.0;  // the ring's tooth points inward
  const double lever = upwards * (load.axis_radius - body.root_radius);      // [m] u_f
  const double slenderness = lever / thickness;
  const double across = std::pow(std::cos(load.force_angle) / cos_helix, 2);
  const double along = std::pow(std::sin(load.force_angle), 2);
  const double transverse =
      (coefficients.moment * slenderness + coefficients.cross) * slenderness + coefficients.shear;
  const double length = face_width / cos_helix;  // [m] of the tooth
  return (across * transverse + along * coefficients.shear * coefficients.compression) /
         (length * material.youngs_modulus);
}

}  // namespace orbearing::gearset
