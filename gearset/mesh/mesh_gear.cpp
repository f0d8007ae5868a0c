#include "gearset/mesh/mesh_gear.hpp"

#include <stdexcept>

#include "gearset/mesh/elastic_ring.hpp"

namespace orbearing::gearset {

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
