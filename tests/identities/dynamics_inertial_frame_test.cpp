// Equations of motion against a model of the same bearing that shares no line with them: inertial frame,
// Cartesian coordinates, absolute speeds, no fictitious forces (tests/reference/inertial_bearing.hpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bearing/motion/snapshot.hpp"
#include "bearing/motion/vector_bearing.hpp"
#include "tests/reference/inertial_bearing.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::dynamics_inertial_frame_test {
namespace {

using reference::Plane;

constexpr Plane kTurn{0.0, 1.0};

struct Seen {
  const char* name;
  double sun_rpm;
  double clearance;  // [m]
  bool film;
  double carrier_acceleration;  // [rad/s^2]
  double shaken;                // [-]  share of speeds
  bool rim = false;             // bends
  bool caged = true;
  bool squeeze = false;
  double gravity = 0.0;  // [m/s^2]
};

void PrintTo(const Seen& seen, std::ostream* out) {
  *out << seen.name;
}

// Stated once more, as a user would read them off the case; masses are those of the geometry test.
reference::BearingNumbers numbers_of(const Bearing& bearing, const DynamicsParameters& given,
                                     const BearingGeometry& geometry) {
  const double support_damping =
      2.0 * given.support.damping_ratio *
      std::sqrt(given.support.stiffness * (given.bore_mass + geometry.inner_ring_mass));
  const double pitch = 0.5 * bearing.pitch_diameter, half_play = 0.25 * bearing.radial_clearance;
  return {.roller_radius = 0.5 * bearing.rollers().diameter,
          .roller_length = bearing.rollers().length,
          .pin_radius = pitch - 0.5 * bearing.rollers().diameter - half_play,
          .bore_radius = pitch + 0.5 * bearing.rollers().diameter + half_play,
          .roller_mass = geometry.element_mass,
          .roller_inertia = geometry.element_inertia,
          .cage_mass = geometry.cage_mass,
          .cage_inertia = geometry.cage_inertia,
          .bore_mass = given.bore_mass,
          .pin_mass = geometry.inner_ring_mass,
          .young = bearing.material.youngs_modulus,
          .poisson = bearing.material.poisson_ratio,
          .oil = {given.lubricant.viscosity, given.lubricant.pressure_viscosity},
          .film = given.race.film_in_approach,
          .damping = given.race.damping,
          .friction = given.race.friction,
          .sliding_scale = given.race.sliding_scale,
          .entrainment_scale = given.race.entrainment_scale,
          .pocket_clearance = given.cage.pocket_clearance,
          .pocket_stiffness = given.cage.pocket_stiffness,
          .pocket_damping = given.cage.pocket_damping,
          .pocket_friction = given.cage.pocket_friction,
          .land_clearance = 0.5 * (given.cage.guide_diameter - bearing.cage.outer_diameter),
          .cage_guide_radius = 0.5 * bearing.cage.outer_diameter,
          .land_width = 0.5 * (bearing.cage.width - bearing.rollers().length),
          .lands = given.cage.lands,
          .held_eccentricity = given.cage.largest_eccentricity,
          .land_stiffness = given.cage.touch_down_stiffness,
          .land_damping = given.cage.touch_down_damping,
          .land_friction = given.cage.touch_down_friction,
          .support_stiffness = given.support.stiffness,
          .support_damping = support_damping,
          .mixture_density = given.drag.oil_share * given.drag.oil_density,
          .cylinder_drag = given.drag.drag_coefficient,
          .churning = given.drag.churning_coefficient,
          .cage_mean_radius = 0.25 * (bearing.cage.inner_diameter + bearing.cage.outer_diameter),
          .cage_width = bearing.cage.width,
          .caged = bearing.cage.width > 0.0,
          .neighbour_friction = given.neighbours.friction,
          .squeeze = given.race.squeeze,
          .roughness = given.race.roughness,
          .gravity = given.gravity.across};
}

Plane plane(const Eigen::Ref<const Eigen::Vector2d>& v) {
  return {v.x(), v.y()};
}

// From the carrier's coordinates into inertial ones and back; the carrier has turned by any angle.
class Outside {
 public:
  explicit Outside(const reference::Carrier& carrier)
      : carrier_(carrier), axes_(std::polar(1.0, carrier.angle)) {}

  reference::Body body(Plane position, Plane velocity, double angle, double speed) const {
    const Plane from_sun = carrier_.orbit_radius + position;
    return {axes_ * from_sun, axes_ * (velocity + kTurn * carrier_.speed * from_sun), carrier_.angle + angle,
            carrier_.speed + speed};
  }
  /// Rate of the velocity in the carrier's coordinates, by differentiating body() once more.
  Plane inside(Plane acceleration, Plane position, Plane velocity) const {
    const Plane from_sun = carrier_.orbit_radius + position;
    return acceleration / axes_ - 2.0 * kTurn * carrier_.speed * velocity -
           kTurn * carrier_.acceleration * from_sun + carrier_.speed * carrier_.speed * from_sun;
  }

 private:
  reference::Carrier carrier_;
  Plane axes_;
};

// Waves of the state in pairs, as amplitudes; that of order 0 is alone.
std::vector<Plane> amplitudes(const Eigen::Ref<const Eigen::VectorXd>& waves) {
  std::vector<Plane> all;
  for (Eigen::Index i = 0; i < waves.size(); i += i == 0 ? 1 : 2)
    all.push_back(i == 0 ? Plane(waves[0]) : Plane(waves[i], waves[i + 1]));
  return all;
}

std::vector<reference::RimWave> rim_of(const ElasticRace& race, double damping_ratio) {
  std::vector<reference::RimWave> rim;
  for (int n = 0; n < race.compliance.size(); ++n) {
    if (n == 1) continue;
    const double stiffness = 1.0 / race.compliance[n];
    rim.push_back({n, stiffness, race.mass[n], 2.0 * damping_ratio * std::sqrt(stiffness * race.mass[n]),
                   Plane(race.cosine[n], race.sine[n])});
  }
  return rim;
}

// Rates of all speeds by the reference, in the layout of the program's state.
struct ReferenceRates {
  Eigen::VectorXd of_state;
  double holding_power = 0.0;  // [W]  of what keeps bore and pin at their speeds in the carrier
};

ReferenceRates reference_rates(const reference::BearingNumbers& numbers, const OperatingPoint& point,
                               const StateLayout& layout, const Eigen::VectorXd& x, double carrier_angle) {
  const reference::Carrier carrier{carrier_angle, point.carrier.speed, point.carrier.acceleration,
                                   point.carrier.orbit_radius};
  const Outside outside(carrier);
  const ConstStateViews state = state_views(layout, x.data());
  const auto position = [&](Eigen::Index j) { return std::polar(state.radius[j], state.angle[j]); };
  const auto speed = [&](Eigen::Index j) {
    return std::polar(1.0, state.angle[j]) *
           Plane(state.radial_speed[j], state.radius[j] * state.orbital_speed[j]);
  };
  reference::Bodies bodies;
  for (Eigen::Index j = 0; j < layout.rollers; ++j)
    bodies.rollers.push_back(outside.body(position(j), speed(j), 0.0, state.spin[j]));
  if (layout.caged)
    bodies.cage = outside.body(plane(state.cage_position), plane(state.cage_velocity), state.cage_angle,
                               state.cage_speed);
  bodies.bore = outside.body(plane(state.bore_position), plane(state.bore_velocity), 0.0, point.outer_speed);
  bodies.pin = outside.body(plane(state.pin_position), plane(state.pin_velocity), 0.0, point.inner_speed);
  bodies.bent = amplitudes(state.wave);
  bodies.bending = amplitudes(state.wave_speed);
  // The load that is stated balances the planet's inertial load at the pin's axis, which no inertial frame
  // has.
  const double orbit = point.carrier.orbit_radius;
  const Plane inertial =
      numbers.bore_mass * orbit * Plane(carrier.speed * carrier.speed, -carrier.acceleration);
  const Plane force = (plane(point.bore_load) - inertial) * std::polar(1.0, carrier_angle);
  const reference::Accelerations found = reference::accelerations(numbers, carrier, bodies, force);

  Eigen::VectorXd rates = Eigen::VectorXd::Zero(x.size());
  MutableStateViews rate = mutable_state_views(layout, rates.data());
  for (Eigen::Index j = 0; j < layout.rollers; ++j) {
    const auto& roller = found.rollers[static_cast<std::size_t>(j)];
    const Plane polar =
        outside.inside(roller.linear, position(j), speed(j)) / std::polar(1.0, state.angle[j]);
    rate.radial_speed[j] = polar.real() + state.radius[j] * state.orbital_speed[j] * state.orbital_speed[j];
    rate.orbital_speed[j] =
        (polar.imag() - 2.0 * state.radial_speed[j] * state.orbital_speed[j]) / state.radius[j];
    rate.spin[j] = roller.angular - carrier.acceleration;
  }
  const auto put = [&](const reference::BodyAcceleration& body, const auto& at, const auto& velocity,
                       auto&& into) {
    const Plane a = outside.inside(body.linear, plane(at), plane(velocity));
    into = Eigen::Vector2d(a.real(), a.imag());
  };
  if (layout.caged) {
    put(found.cage, state.cage_position, state.cage_velocity, rate.cage_velocity);
    rate.cage_speed = found.cage.angular - carrier.acceleration;
  }
  put(found.bore, state.bore_position, state.bore_velocity, rate.bore_velocity);
  put(found.pin, state.pin_position, state.pin_velocity, rate.pin_velocity);
  for (std::size_t i = 0; i < found.rim.size(); ++i) {
    const auto first = static_cast<Eigen::Index>(i == 0 ? 0 : 2 * i - 1);
    rate.wave_speed[first] = found.rim[i].real();
    if (i > 0) rate.wave_speed[first + 1] = found.rim[i].imag();
  }
  return {rates, -found.bore_moment * point.outer_speed - found.pin_moment * point.inner_speed};
}

// A pin that rotates, too: the equations assume no stationary race.
OperatingPoint rotating_pin(OperatingPoint point) {
  point.inner_speed = 40.0;  // [rad/s]
  return point;
}

class InertialFrame : public testing::TestWithParam<Seen> {
 protected:
  InertialFrame() {
    if (!GetParam().caged) bearing = test::full_complement_bearing();
    bearing.radial_clearance = GetParam().clearance;
    parameters.race.film_in_approach = GetParam().film;
    parameters.race.squeeze = GetParam().squeeze;
    point.carrier.acceleration = GetParam().carrier_acceleration;
    parameters.gravity.across = GetParam().gravity;
    if (GetParam().rim) point.outer_race = test::bending_race();
  }
  Bearing bearing = test::reducer_bearing();
  DynamicsParameters parameters = test::reducer_parameters();
  OperatingPoint point = rotating_pin(test::reducer_point(GetParam().sun_rpm));
  test::Random random;
};

// Round-off: forces of 1e3 N on rollers of 1 g from lengths of 0.1 m known to 1e-17 m on contacts of 1e8 N/m.
TEST_P(InertialFrame, SeesTheSameMotion) {
  constexpr int kStates = 60;
  constexpr double kAllowed = 1e-8;  // [-]  of the largest rate of the same kind
  const BearingModel model = bearing_model(bearing, point, parameters);
  vectorised::VectorBearing equations(model);
  reference::BearingNumbers numbers = numbers_of(bearing, parameters, model.geometry);
  numbers.rim = rim_of(point.outer_race, parameters.rim.damping_ratio);
  // Two hundredths of the speed at which rollers pass the pin at pure rolling, where that is less.
  const double gamma = bearing.rollers().diameter / bearing.pitch_diameter;
  const double rolling =
      numbers.pin_radius * 0.5 * (1.0 + gamma) * std::abs(point.outer_speed - point.inner_speed);
  for (double* scale : {&numbers.sliding_scale, &numbers.entrainment_scale})
    *scale = std::min(*scale, 0.02 * rolling);
  const StateLayout& layout = model.layout;
  double open = 0.0, closed = 0.0;
  for (int k = 0; k < kStates; ++k) {
    const double length = k % 3 == 0 ? 5e-5 : 3e-6;  // [m]  cage and land in contact, or near equilibrium
    const Eigen::VectorXd x =
        test::shaken_state(model, bearing, parameters, length, GetParam().shaken, random);
    Eigen::VectorXd dx(x.size());
    const double carrier_angle = 3.0 * random(), time = carrier_angle / point.carrier.speed;
    equations.derivative(time, x, dx);
    const ReferenceRates reference = reference_rates(numbers, point, layout, x, carrier_angle);
    const Eigen::VectorXd& rates = reference.of_state;
    const auto compare = [&](Eigen::Index begin, Eigen::Index count, const char* what) {
      const double scale = dx.segment(begin, count).cwiseAbs().maxCoeff();
      ASSERT_GT(scale, 0.0);
      EXPECT_LT((dx - rates).segment(begin, count).cwiseAbs().maxCoeff(), kAllowed * scale)
          << what << ", state " << k;
    };
    const Eigen::Index z = layout.rollers;
    compare(2 * z, z, "radial speeds");
    compare(3 * z, z, "orbital speeds");
    compare(4 * z, z, "spins");
    if (layout.caged) {
      compare(layout.cage() + 3, 2, "cage");
      compare(layout.cage() + 5, 1, "speed of the cage");
    }
    compare(layout.bore() + 2, 2, "bore");
    compare(layout.pin() + 2, 2, "pin");
    if (GetParam().rim) compare(layout.wave_speed(), layout.waves, "waves of the rim");
    const double holding_power = power_input(model, 0.0, x, dx).rotations;
    EXPECT_NEAR(holding_power, reference.holding_power, kAllowed * std::abs(holding_power)) << "state " << k;
    const Snapshot now = snapshot(model, x, 0.0);
    for (const double load : now.outer.load) (load > 0.0 ? closed : open) += 1.0;
    for (const double load : now.neighbour_load) (load > 0.0 ? closed : open) += 1.0;
    EXPECT_TRUE(layout.caged || now.neighbour_load.maxCoeff() > 0.0) << "no two rollers touched";
  }
  EXPECT_GT(open, 0.05 * (open + closed)) << "no contact was open";
  EXPECT_GT(closed, 0.05 * (open + closed)) << "no contact was closed";
}

INSTANTIATE_TEST_SUITE_P(
    Variants, InertialFrame,
    testing::Values(Seen{"slow", 1000.0, 0.0, false, 0.0, 0.02}, Seen{"dry", 6000.0, 0.0, false, 0.0, 0.02},
                    Seen{"film", 6000.0, 0.0, true, 0.0, 0.02},
                    Seen{"clearance", 6000.0, 37e-6, false, 0.0, 0.02},
                    Seen{"film_clearance", 12000.0, 37e-6, true, 0.0, 0.02},
                    // A bore that bends.
                    Seen{"rim", 6000.0, 0.0, false, 0.0, 0.02, true},
                    Seen{"rim_film", 12000.0, 37e-6, true, 300.0, 0.02, true},
                    Seen{"run_up", 6000.0, 0.0, false, 300.0, 0.02},
                    // Rollers that touch one another.
                    Seen{"full_complement", 6000.0, 20e-6, true, 300.0, 0.02, false, false},
                    // Squeeze film.
                    Seen{"squeeze_dry", 6000.0, 0.0, false, 0.0, 0.02, false, true, true},
                    Seen{"squeeze_film", 1000.0, 0.0, true, 0.0, 0.02, false, true, true},
                    Seen{"squeeze_clearance", 12000.0, 37e-6, true, 300.0, 0.02, true, true, true},
                    // So heavy that weight shows to the last of the digits that are compared.
                    Seen{"weight", 1000.0, 20e-6, false, 0.0, 0.02, false, true, false, 500.0},
                    Seen{"weight_run_up", 6000.0, 37e-6, true, 300.0, 0.02, true, true, false, 500.0},
                    Seen{"weight_full_complement", 6000.0, 20e-6, true, 0.0, 0.02, false, false, false,
                         500.0}),
    [](const testing::TestParamInfo<Seen>& seen) { return seen.param.name; });

}  // namespace
}  // namespace orbearing::bearing::motion::dynamics_inertial_frame_test
