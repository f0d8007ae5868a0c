#include "gearset/mesh/mesh_gear.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "gearset/involute.hpp"
#include "tests/unit/mesh/example_gears.hpp"

namespace orbearing::gearset::tooth_beam_test {
namespace {

constexpr double round_off = 1e-10;

//        ____________________ force at an angle to the line across,
//   /|  |                    | its line cuts the axis at `length`
//   /|  |____________________|
//        constant half thickness
TEST(BeamCompliance, OfARectangleIsThatOfACantilever) {
  constexpr double length = 9e-3, half = 2e-3, width = 20e-3, angle = 0.3;
  const mechanics::Material steel;
  const BeamPiece block{0.0, length, [=](double x) { return BeamSlice{x, half, 1.0}; }};
  const BeamCompliance c = beam_compliance({block}, angle, length, width, steel);
  const double area = 2.0 * half * width;
  const double inertia = width * std::pow(2.0 * half, 3) / 12.0;
  const double across = std::pow(std::cos(angle), 2), along = std::pow(std::sin(angle), 2);
  const auto expect = [](double ours, double closed) { EXPECT_NEAR(ours, closed, round_off * closed); };
  expect(c.bending, across * std::pow(length, 3) / (3.0 * steel.youngs_modulus * inertia));
  expect(c.shear, across * 1.2 * length / (steel.shear_modulus() * area));
  expect(c.axial, along * length / (steel.youngs_modulus * area));
}

TEST(BeamCompliance, OfAForceWhoseLineCutsTheAxisBeyondTheEndBendsTheMore) {
  constexpr double length = 9e-3, half = 2e-3, width = 20e-3, beyond = 12e-3;
  const mechanics::Material steel;
  const BeamPiece block{0.0, length, [=](double x) { return BeamSlice{x, half, 1.0}; }};
  const double inertia = width * std::pow(2.0 * half, 3) / 12.0;
  const double closed = (std::pow(beyond, 3) - std::pow(beyond - length, 3)) /
                        (3.0 * steel.youngs_modulus * inertia);  // of the lever squared over the length
  EXPECT_NEAR(beam_compliance({block}, 0.0, beyond, width, steel).bending, closed, round_off * closed);
}

// The same three integrals by the trapezoidal rule over a drawn flank, from the root up to the contact: from
// an outline, a contact point and a direction alone.
template <typename HalfAngle>
BeamCompliance drawn(const HalfAngle& half_angle, double from, double to, const Eigen::Vector2d& force,
                     const Eigen::Vector2d& contact, double width, const mechanics::Material& material) {
  constexpr int steps = 200000;
  BeamCompliance sum;
  Eigen::Vector2d last{0.0, 0.0};
  for (int i = 0; i <= steps; ++i) {
    const double s = double(i) / steps;
    const double radius = from + (to - from) * s * s;  // crowded where the fillet meets the root circle
    const double angle = half_angle(radius);
    const Eigen::Vector2d point(radius * std::sin(angle), radius * std::cos(angle));
    if (i > 0) {
      const double y = 0.5 * (last.x() + point.x()), dx = std::abs(point.y() - last.y());
      const double middle = 0.5 * (last.y() + point.y());
      const double moment = force.x() * (contact.y() - middle) - force.y() * contact.x();
      const double area = 2.0 * y * width, inertia = width * std::pow(2.0 * y, 3) / 12.0;
      sum.bending += moment * moment * dx / (material.youngs_modulus * inertia);
      sum.shear += 1.2 * force.x() * force.x() * dx / (material.shear_modulus() * area);
      sum.axial += force.y() * force.y() * dx / (material.youngs_modulus * area);
    }
    last = point;
  }
  return sum;
}

// The flank's normal at a radius, into the tooth, by differences of the outline.
template <typename HalfAngle>
Eigen::Vector2d drawn_normal(const HalfAngle& half_angle, double radius) {
  const double h = 1e-6 * radius;
  const auto point = [&](double r) {
    return Eigen::Vector2d(r * std::sin(half_angle(r)), r * std::cos(half_angle(r)));
  };
  const Eigen::Vector2d along = (point(radius + h) - point(radius - h)).normalized();
  return {-along.y(), along.x()};
}

constexpr double of_the_drawing = 2e-5;  // trapezoidal rule at a root of infinite slope, 200,000 steps

void expect_near(const BeamCompliance& ours, const BeamCompliance& drawing) {
  EXPECT_NEAR(ours.bending, drawing.bending, of_the_drawing * drawing.bending);
  EXPECT_NEAR(ours.shear, drawing.shear, of_the_drawing * drawing.shear);
  EXPECT_NEAR(ours.axial, drawing.axial, of_the_drawing * drawing.axial);
}

TEST(ToothCompliance, AgreesWithIntegralsOverADrawnTooth) {
  const mechanics::Material steel;
  for (const double shift : {-0.46, 0.0, 0.5}) {  // undercut, standard, thick
    const ExternalTooth tooth = make_external_tooth(22, shift, 3e-3, {});
    const auto half_angle = [&](double radius) { return half_thickness_angle(tooth, radius); };
    const double contact = 0.4 * tooth.form_radius + 0.6 * tooth.tip_radius;
    const double angle = half_angle(contact);
    const BeamCompliance drawing =
        drawn(half_angle, tooth.root_radius, contact, drawn_normal(half_angle, contact),
              {contact * std::sin(angle), contact * std::cos(angle)}, 28e-3, steel);
    const ToothLoad load = tooth_load(tooth, tangent_length(tooth.base_radius, contact));
    SCOPED_TRACE(shift);
    expect_near(tooth_compliance(tooth, load, 28e-3, steel), drawing);
  }
}

TEST(ToothCompliance, OfTheRingAgreesWithIntegralsOverADrawnTooth) {
  const mechanics::Material steel;
  const RingTooth tooth = make_ring_tooth(79, 0.4146, 3e-3, {});
  const auto half_angle = [&](double radius) { return half_thickness_angle(tooth, radius); };
  const double contact = 0.6 * tooth.tip_radius + 0.4 * tooth.root_radius;
  const double angle = half_angle(contact);
  const BeamCompliance drawing =
      drawn(half_angle, tooth.root_radius, contact, drawn_normal(half_angle, contact),
            {contact * std::sin(angle), contact * std::cos(angle)}, 28e-3, steel);
  const ToothLoad load = tooth_load(tooth, tangent_length(tooth.base_radius, contact));
  expect_near(tooth_compliance(tooth, load, 28e-3, steel), drawing);
}

TEST(ToothLoad, LiesOnTheTangentToTheBaseCircle) {
  const ExternalTooth gear = make_external_tooth(22, 0.2, 3e-3, {});
  const RingTooth ring = make_ring_tooth(79, 0.2, 3e-3, {});
  for (const double tangent : {6e-3, 11e-3, 15e-3}) {  // on the involutes of both
    const ToothLoad on_gear = tooth_load(gear, tangent);
    EXPECT_NEAR(on_gear.axis_radius * std::cos(on_gear.force_angle), gear.base_radius, 1e-15);
    // The contact lies on that line: its distance from the axis point, across the force, is none.
    const double angle = half_thickness_angle(gear, on_gear.contact_radius);
    const Eigen::Vector2d to_contact =
        on_gear.contact_radius * Eigen::Vector2d(std::sin(angle), std::cos(angle)) -
        Eigen::Vector2d(0.0, on_gear.axis_radius);
    EXPECT_NEAR(
        to_contact.dot(Eigen::Vector2d(-std::sin(on_gear.force_angle), std::cos(on_gear.force_angle))), 0.0,
        1e-15);
    const ToothLoad on_ring = tooth_load(ring, 4.0 * tangent);
    const double ring_angle = half_thickness_angle(ring, on_ring.contact_radius);
    EXPECT_NEAR(on_ring.contact_radius * std::cos(on_ring.force_angle - ring_angle), ring.base_radius, 1e-14);
  }
}

TEST(Trochoid, SlopeOfTheHalfAngleIsItsDerivative) {
  const ExternalTooth tooth = make_external_tooth(22, -0.4594, 3e-3, {});
  const double h = 1e-5;  // [rad] the error of the central difference is of the order h^2
  for (const double angle : {0.1, 0.5, 1.0, 1.2}) {
    const double difference =
        (trochoid_point(tooth, angle + h).half_angle - trochoid_point(tooth, angle - h).half_angle) /
        (2.0 * h);
    EXPECT_NEAR(trochoid_point(tooth, angle).half_angle_slope, difference, 1e-6 * std::abs(difference));
  }
}

}  // namespace
}  // namespace orbearing::gearset::tooth_beam_test
