#include "coupling/analysis/gear_model.hpp"

#include <cmath>
#include <complex>
#include <stdexcept>

#include "gearset/dynamics/bodies.hpp"
#include "gearset/mesh/loaded/tooth_pairs.hpp"
#include "gearset/planet_angles.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::analysis {

namespace {

using constants::two_pi;
using gearset::Member;
using gearset::PeriodicCurve;
using gearset::dynamics::Body;
using gearset::dynamics::CentralMember;
using gearset::dynamics::SetParameters;

double damping(double ratio, double stiffness, double mass) {
  return 2.0 * ratio * std::sqrt(stiffness * mass);
}

Body body_of(const GearMemberChoice& choice, const Body& derived) {
  return {choice.mass.value_or(derived.mass), choice.inertia.value_or(derived.inertia), derived.radius};
}

CentralMember central(const GearMemberChoice& choice, const Body& derived, double damping_ratio, bool fixed) {
  const Body body = body_of(choice, derived);
  CentralMember member{body.mass, body.inertia, body.radius, {}};
  member.support = {.stiffness = choice.support_stiffness,
                    .damping = damping(damping_ratio, choice.support_stiffness, body.mass),
                    .torsional_stiffness = choice.torsional_stiffness,
                    .torsional_damping = damping(damping_ratio, choice.torsional_stiffness, body.inertia),
                    .held_in_rotation = fixed && choice.torsional_stiffness == 0.0};
  return member;
}

gearset::dynamics::Mesh mesh_of(const GearDynamicsChoice& choice, double angle, PeriodicCurve stiffness,
                                const std::vector<double>& error, double central_inertia,
                                double planet_inertia) {
  const double mass = 1.0 / (1.0 / central_inertia + 1.0 / planet_inertia);
  const double c = damping(choice.mesh_damping_ratio, stiffness.mean(), mass);
  return {.pressure_angle = angle,
          .stiffness = std::move(stiffness),
          .error = curve_through(error),
          .damping = c,
          .backlash = choice.backlash};
}

Eigen::Matrix2Xd pin_errors(const GearDynamicsChoice& choice, int planets) {
  if (choice.pin_error_radial.empty() && choice.pin_error_tangential.empty()) return {};
  Eigen::Matrix2Xd errors = Eigen::Matrix2Xd::Zero(2, planets);
  const auto put = [&](const std::vector<double>& list, Eigen::Index row) {
    for (std::size_t n = 0; n < list.size(); ++n) errors(row, static_cast<Eigen::Index>(n)) = list[n];
  };
  put(choice.pin_error_radial, 0);
  put(choice.pin_error_tangential, 1);
  return errors;
}

struct SetBodiesAndMeshes {
  gearset::dynamics::SetBodies bodies;
  double sun_angle = 0.0;   // [rad]
  double ring_angle = 0.0;  // [rad]
  PeriodicCurve sun_stiffness;
  PeriodicCurve ring_stiffness;
  double bearing_stiffness = 0.0;  // [N/m]
};

SetParameters assemble(const GearDynamicsChoice& choice, int planets, std::optional<Member> fixed,
                       SetBodiesAndMeshes parts) {
  const auto member = [&](Member which, const GearMemberChoice& own, const Body& derived) {
    return central(own, derived, choice.support_damping_ratio, fixed == which);
  };
  SetParameters set{.planets = planets,
                    .sun = member(Member::sun, choice.sun, parts.bodies.sun),
                    .ring = member(Member::ring, choice.ring, parts.bodies.ring),
                    .carrier = member(Member::carrier, choice.carrier, parts.bodies.carrier)};
  const Body planet = body_of(choice.planet, parts.bodies.planet);
  const double stiffness = choice.bearing_stiffness.value_or(parts.bearing_stiffness);
  set.planet = {.mass = planet.mass,
                .inertia = planet.inertia,
                .radius = planet.radius,
                .bearing_stiffness = stiffness,
                .bearing_damping = damping(choice.bearing_damping_ratio, stiffness, planet.mass)};
  const auto curve = [](const std::optional<double>& constant, PeriodicCurve& derived) {
    return constant ? PeriodicCurve::constant(*constant) : std::move(derived);
  };
  set.sun_mesh = mesh_of(choice, parts.sun_angle, curve(choice.sun_mesh_stiffness, parts.sun_stiffness),
                         choice.sun_error, set.sun.inertia, set.planet.inertia);
  set.ring_mesh = mesh_of(choice, parts.ring_angle, curve(choice.ring_mesh_stiffness, parts.ring_stiffness),
                          choice.ring_error, set.ring.inertia, set.planet.inertia);
  set.pin_error = pin_errors(choice, planets);
  set.frame = choice.frame;
  set.separation = choice.separation;
  return set;
}

}  // namespace

SetParameters lumped_set(const GearDynamicsChoice& choice, int planets, double pressure_angle,
                         const std::vector<double>& positions) {
  const Body unit{.radius = 1.0};  // inertias are stated over radius^2, and no torque is applied
  SetParameters set = assemble(
      choice, planets, std::nullopt,
      {.bodies = {unit, unit, unit, unit}, .sun_angle = pressure_angle, .ring_angle = pressure_angle});
  set.planet_angles = positions;
  set.sun_phase.assign(static_cast<std::size_t>(planets), 0.0);
  set.ring_phase = set.sun_phase;
  return set;
}

SetParameters geometric_set(const GearDynamicsChoice& choice, const gearset::PlanetarySet& set,
                            const gearset::WorkingGeometry& geometry, const gearset::PlanetaryMeshes& meshes,
                            double planet_rings, double bearing_stiffness) {
  const gearset::dynamics::BodyOutlines outlines{
      .sun_bore = 2.0 * choice.bodies.sun_bore * geometry.sun.root_radius,
      .ring_outside = 2.0 * choice.bodies.ring_outside * geometry.ring.root_radius,
      .planet_bore = set.planet_bore,
      .carrier_plates = choice.carrier_plate_ratio * set.face_width,
      .extra_planet_mass = planet_rings};
  SetParameters out = assemble(choice, set.planets, set.fixed_member,
                               {.bodies = gearset::dynamics::set_bodies(set, geometry, outlines),
                                .sun_angle = geometry.sun_mesh.working_pressure_angle,
                                .ring_angle = geometry.ring_mesh.working_pressure_angle,
                                .sun_stiffness = meshes.sun.curve,
                                .ring_stiffness = meshes.ring.curve,
                                .bearing_stiffness = bearing_stiffness});
  if (set.flanks.contact == gearset::ToothContact::loaded) {
    gearset::SetTeeth teeth = gearset::set_teeth(set, meshes);
    const auto share = [](gearset::ToothPairs& pairs) {
      return std::make_shared<const gearset::LoadedTeeth>(std::move(pairs.teeth));
    };
    if (!choice.sun_mesh_stiffness) out.sun_mesh.loaded = share(teeth.sun);
    if (!choice.ring_mesh_stiffness) out.ring_mesh.loaded = share(teeth.ring);
  }
  if (is_unequally_spaced(set)) out.planet_angles = angles_of_planets(set);
  // A mesh that lags behind is earlier in its period.
  for (const double lag : meshes.sun_lag) out.sun_phase.push_back(-lag);
  for (const double lag : meshes.ring_lag) out.ring_phase.push_back(-lag);
  return out;
}

PeriodicCurve curve_through(const std::vector<double>& samples) {
  if (samples.empty()) return {};
  const int n = static_cast<int>(samples.size());
  const auto coefficient = [&](int order) {
    std::complex<double> sum = 0.0;
    for (int i = 0; i < n; ++i)
      sum += samples[static_cast<std::size_t>(i)] * std::polar(1.0 / n, -two_pi * order * i / n);
    return sum;
  };
  std::vector<std::complex<double>> coefficients;
  for (int order = 0; 2 * order <= n; ++order) coefficients.push_back(coefficient(order));
  const auto value = [&](double fraction) {
    double sum = coefficients[0].real();
    for (int order = 1; 2 * order <= n; ++order) {
      const double share = 2 * order == n ? 1.0 : 2.0;
      sum +=
          share *
          (coefficients[static_cast<std::size_t>(order)] * std::polar(1.0, two_pi * order * fraction)).real();
    }
    return sum;
  };
  return PeriodicCurve(value, {}, std::max(64, 16 * n));
}

}  // namespace orbearing::analysis
