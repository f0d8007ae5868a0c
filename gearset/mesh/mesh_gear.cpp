#include "gearset/mesh/mesh_gear.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <stdexcept>

#include "gearset/involute.hpp"
#include "gearset/mesh/elastic_ring.hpp"

namespace orbearing::gearset {

namespace {

constexpr double shear_factor = 1.2;  // [-] of a rectangular section

template <typename Integrand>
double integral(const std::vector<BeamPiece>& pieces, const Integrand& integrand) {
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 21>;
  constexpr unsigned max_depth = 6;
  constexpr double tolerance = 1e-9;  // relative; pointed tips need the subdivision, other teeth do not
  double sum = 0.0;
  for (const BeamPiece& piece : pieces) {
    if (!(piece.end > piece.begin)) continue;
    const auto along = [&](double parameter) {
      const BeamSlice slice = piece.slice(parameter);
      return integrand(slice) * slice.measure;
    };
    sum += Quadrature::integrate(along, piece.begin, piece.end, max_depth, tolerance);
  }
  return sum;
}

double cube(double x) {
  return x * x * x;
}

// Place and thickness by polar position; the measure by differences would lose digits, so its derivatives.
BeamSlice polar_slice(double radius, double half_angle, double radius_slope, double half_angle_slope) {
  const double sine = std::sin(half_angle);
  const double cosine = std::cos(half_angle);
  return {.position = radius * cosine,
          .half_thickness = radius * sine,
          .measure = std::abs(radius_slope * cosine - radius * sine * half_angle_slope)};
}

// By the rack's normal angle, since the thickness has an infinite slope over the position at the root circle.
BeamPiece trochoid_piece(const ExternalTooth& tooth) {
  const auto slice = [&tooth](double normal_angle) {
    const TrochoidPoint point = trochoid_point(tooth, normal_angle);
    return polar_slice(point.radius, point.half_angle, point.radius_slope, point.half_angle_slope);
  };
  return {0.0, trochoid_normal_angle(tooth, tooth.form_radius), slice};
}

// By the tangent length t: dR/dt = t/R, and the involute's polar angle turns by (t/r_b)^2/R^2 r_b per t.
template <typename Tooth>
BeamSlice involute_slice(const Tooth& tooth, double tangent, double sense) {
  const double radius = std::hypot(tooth.base_radius, tangent);
  const double turn = tangent * tangent / (tooth.base_radius * radius * radius);  // [rad/m]
  return polar_slice(radius, half_thickness_angle(tooth, radius), tangent / radius, sense * turn);
}

// Eq. (14): a force of 1 N in the transverse section is 1/cos(helix) N across a tooth that is thinner and
// longer by cos(helix) where it is cut at right angles.
BeamCompliance along_helix(const BeamCompliance& transverse, double helix_angle) {
  const double square = std::pow(std::cos(helix_angle), 2);
  return {.bending = transverse.bending / (square * square),
          .shear = transverse.shear / square,
          .axial = transverse.axial};
}

}  // namespace

BeamCompliance beam_compliance(const std::vector<BeamPiece>& pieces, double force_angle, double axis_position,
                               double width, const mechanics::Material& material) {
  const double across = std::pow(std::cos(force_angle), 2);
  const double along = std::pow(std::sin(force_angle), 2);
  const double bent = integral(pieces, [&](const BeamSlice& slice) {
    const double lever = axis_position - slice.position;
    return lever * lever / (2.0 / 3.0 * width * cube(slice.half_thickness));
  });
  const double sheared =
      integral(pieces, [&](const BeamSlice& slice) { return 1.0 / (2.0 * width * slice.half_thickness); });
  return {.bending = across * bent / material.youngs_modulus,
          .shear = shear_factor * across * sheared / material.shear_modulus(),
          .axial = along * sheared / material.youngs_modulus};
}

BeamCompliance tooth_compliance(const ExternalTooth& tooth, const ToothLoad& load, double face_width,
                                const mechanics::Material& material) {
  const auto slice = [&tooth](double tangent) { return involute_slice(tooth, tangent, -1.0); };
  const BeamPiece flank{tangent_length(tooth.base_radius, tooth.form_radius),
                        tangent_length(tooth.base_radius, load.contact_radius), slice};
  return along_helix(beam_compliance({trochoid_piece(tooth), flank}, load.force_angle, load.axis_radius,
                                     face_width, material),
                     tooth.helix_angle);
}

BeamCompliance tooth_compliance(const RingTooth& tooth, const ToothLoad& load, double face_width,
                                const mechanics::Material& material) {
  const auto slice = [&tooth](double tangent) { return involute_slice(tooth, tangent, 1.0); };
  const BeamPiece flank{tangent_length(tooth.base_radius, load.contact_radius),
                        tangent_length(tooth.base_radius, tooth.root_radius), slice};
  return along_helix(beam_compliance({flank}, load.force_angle, load.axis_radius, face_width, material),
                     tooth.helix_angle);
}

namespace {

constexpr double round_off = 1e-9;  // of a bore that equals the root diameter on paper

}  // namespace

MeshGear make_mesh_gear(const ExternalTooth& tooth, double bore_radius, double face_width,
                        const mechanics::Material& material, Foundation law) {
  const FoundationBody body = foundation_body(tooth, bore_radius);
  if (!(bore_radius > 0.0 && bore_radius <= tooth.root_radius * (1.0 + round_off)))
    throw std::domain_error("the bore of a gear must be greater than zero and not exceed its root circle");
  const FoundationCoefficients foundation =
      sainsot_is_usable(body) && law == Foundation::polynomials
          ? sainsot_coefficients(body.half_angle, body.root_radius / bore_radius)
          : elastic_ring_coefficients(body, material.poisson_ratio);
  return {tooth, body, foundation, law == Foundation::elastic_ring, face_width, material};
}

MeshGear make_mesh_gear(const RingTooth& tooth, double outside_radius, double face_width,
                        const mechanics::Material& material) {
  const FoundationBody body = foundation_body(tooth, outside_radius);
  if (!(outside_radius > tooth.root_radius))
    throw std::domain_error("the outside of a ring gear must be greater than its root circle");
  return {tooth, body, elastic_ring_coefficients(body, material.poisson_ratio), true, face_width, material};
}

GearCompliance gear_compliance(const MeshGear& gear, double tangent_length) {
  return std::visit(
      [&](const auto& tooth) -> GearCompliance {
        const ToothLoad load = tooth_load(tooth, tangent_length);
        return {tooth_compliance(tooth, load, gear.face_width, gear.material),
                foundation_compliance(gear.foundation, gear.body, load, gear.face_width, gear.material)};
      },
      gear.tooth);
}

double base_radius(const MeshGear& gear) {
  return std::visit([](const auto& tooth) { return tooth.base_radius; }, gear.tooth);
}

}  // namespace orbearing::gearset
