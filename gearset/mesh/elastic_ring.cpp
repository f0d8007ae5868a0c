#include "gearset/mesh/elastic_ring.hpp"
#include "mechanics/constants.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace orbearing::gearset {

namespace {

using constants::pi;

// Harmonics per radian of the tooth's root; with the smoothing below the error of the series is then below
// a thousandth of each coefficient.
constexpr double harmonics_per_angle = 100.0;

// Displacements u_r = U cos(n phi), u_phi = V sin(n phi) at one radius, and their slopes over the radius.
// Lengths in units of the loaded radius.
struct Amplitudes {
  double radial = 0.0;
  double tangential = 0.0;
  double radial_slope = 0.0;
  double tangential_slope = 0.0;
};

struct Ring {
  double held = 0.0;   // [loaded radius]
  double kappa = 0.0;  // [-]  3 - 4 nu: plane strain
};

// a r^power and c r^power, as a share of their values at `reference`.
Amplitudes power_law(double radius, double power, double a, double c, double reference) {
  const double r = std::pow(radius / reference, power);
  return {a * r, c * r, power * a * r / radius, power * c * r / radius};
}

// The four displacement fields of order n without body forces, from Kolosov's formulas with powers of z, and
// with log z where two of the powers coincide.
std::array<Amplitudes, 4> fields(const Ring& ring, int order, double radius) {
  const double inner = std::min(1.0, ring.held);
  const double outer = std::max(1.0, ring.held);
  const double kappa = ring.kappa;
  if (order == 0)
    return {power_law(radius, 1, 1, 0, outer), power_law(radius, -1, 1, 0, inner),
            power_law(radius, 1, 0, 1, outer), power_law(radius, -1, 0, 1, inner)};
  const double n = order;
  const double log = std::log(radius);
  const Amplitudes from_log{2 * kappa * log - 1, -2 * kappa * log - 1, 2 * kappa / radius,
                            -2 * kappa / radius};
  return {power_law(radius, n - 1, -1, 1, outer), power_law(radius, -n - 1, 1, 1, inner),
          power_law(radius, n + 1, kappa - n - 1, kappa + n + 1, outer),
          order == 1 ? from_log : power_law(radius, 1 - n, kappa + n - 1, n - kappa - 1, inner)};
}

// Radial and shear stress in units of the shear modulus.
Eigen::Vector2d stresses(const Ring& ring, int order, double radius, const Amplitudes& u) {
  const double lame = (3.0 - ring.kappa) / (ring.kappa - 1.0);  // [shear modulus]
  const double hoop = (u.radial + order * u.tangential) / radius;
  return {lame * (u.radial_slope + hoop) + 2.0 * u.radial_slope,
          u.tangential_slope - (order * u.radial + u.tangential) / radius};
}

// Displacement amplitudes (rows) at the loaded edge per unit of pressing traction (columns), radial and
// tangential, in units of loaded radius / shear modulus.
Eigen::Matrix2d edge_compliance(const Ring& ring, int order) {
  const std::array<Amplitudes, 4> held = fields(ring, order, ring.held);
  const std::array<Amplitudes, 4> loaded = fields(ring, order, 1.0);
  const double outward = ring.held < 1.0 ? 1.0 : -1.0;  // normal of the loaded edge, away from the material
  Eigen::Matrix4d conditions;
  Eigen::Matrix<double, 2, 4> edge;
  for (int j = 0; j < 4; ++j) {
    const auto i = static_cast<std::size_t>(j);
    conditions.col(j) << held[i].radial, held[i].tangential, outward * stresses(ring, order, 1.0, loaded[i]);
    edge.col(j) << loaded[i].radial, loaded[i].tangential;
    const double scale = conditions.col(j).cwiseAbs().maxCoeff();
    conditions.col(j) /= scale;
    edge.col(j) /= scale;
  }
  Eigen::Matrix<double, 4, 2> tractions = Eigen::Matrix<double, 4, 2>::Zero();
  tractions.bottomRows<2>().setIdentity();
  return edge * conditions.partialPivLu().solve(tractions);
}

// Fourier coefficients over an arc of half angle theta: of 1 (cosine), and of phi (sine).
struct ArcTerms {
  double constant = 0.0;
  double linear = 0.0;
};

ArcTerms arc_terms(int order, double theta) {
  if (order == 0) return {theta / pi, 0.0};
  const double n = order;
  return {2.0 * std::sin(n * theta) / (n * pi),
          2.0 * (std::sin(n * theta) / (n * n) - theta * std::cos(n * theta) / n) / pi};
}

// Deflections at the middle of the tooth root by a unit force across, a unit moment and a unit force along
// the tooth.
struct Flexibility {
  double across_by_force = 0.0;
  double across_by_moment = 0.0;
  double turn_by_force = 0.0;
  double turn_by_moment = 0.0;
  double along_by_force = 0.0;
};

// A force across is a shear stress, u_r = U sin(n phi), u_phi = -V cos(n phi); a moment (positive
// anticlockwise) is a radial stress that falls with phi; the middle turns by u_phi - d u_r / d phi.
void add_harmonic(const Ring& ring, int order, double theta, double weight, Flexibility& sum) {
  const Eigen::Matrix2d edge = edge_compliance(ring, order);
  const ArcTerms arc = arc_terms(order, theta);
  const double uniform = weight * arc.constant / (2.0 * theta);
  const double falling = -weight * arc.linear * 1.5 / (theta * theta * theta);
  const auto turn = [order](const Eigen::Vector2d& u) { return -u(1) - order * u(0); };
  sum.across_by_force += edge(1, 1) * uniform;
  sum.turn_by_force += turn(edge.col(1)) * -uniform;
  sum.across_by_moment += -edge(1, 0) * falling;
  sum.turn_by_moment += turn(edge.col(0)) * falling;
  sum.along_by_force += edge(0, 0) * uniform;
}

Flexibility flexibility(const Ring& ring, double theta) {
  const int harmonics = static_cast<int>(std::ceil(harmonics_per_angle / theta));
  Flexibility sum;
  add_harmonic(ring, 0, theta, 1.0, sum);
  for (int n = 1; n < harmonics; ++n) {
    const double x = pi * n / harmonics;
    add_harmonic(ring, n, theta, std::sin(x) / x, sum);  // Lanczos: no excitation from the cut series
  }
  return sum;
}

}  // namespace

FoundationCoefficients elastic_ring_coefficients(const FoundationBody& body, double poisson_ratio) {
  const Ring ring{body.body_radius / body.root_radius, 3.0 - 4.0 * poisson_ratio};
  if (!(ring.held > 0.0) || ring.held == 1.0)
    throw std::domain_error("no body is left under the teeth of a gear");
  const Flexibility f = flexibility(ring, body.half_angle);
  const double per_modulus = 2.0 * (1.0 + poisson_ratio);  // from units of the shear modulus to Young's
  const double thickness = 2.0 * body.half_angle;          // [root radius]
  const double upwards = ring.held < 1.0 ? 1.0 : -1.0;
  FoundationCoefficients coefficients;
  coefficients.moment = per_modulus * f.turn_by_moment * thickness * thickness;
  coefficients.cross = per_modulus * upwards * (f.turn_by_force + f.across_by_moment) * thickness;
  coefficients.shear = per_modulus * f.across_by_force;
  coefficients.compression = f.along_by_force / f.across_by_force;
  return coefficients;
}

}  // namespace orbearing::gearset
