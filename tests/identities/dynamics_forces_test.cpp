// Forces follow from stored energy, bodies exert equal and opposite forces on each other, and nothing
// dissipative gives power.
#include <gtest/gtest.h>

#include "bearing/motion/snapshot.hpp"
#include "bearing/motion/vector_bearing.hpp"
#include "tests/many_scratches.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::dynamics_forces_test {
namespace {

constexpr int kStates = 40;
constexpr double kSpeed = 0.05;  // share of the kinematic speeds by which a state is shaken

enum class Refinement {
  none,
  forms,
  scratches,
  unequal_rollers,
  mixed_lubrication,
  pocket_film,
  run_up,
  full_complement,
  rim,
  squeeze,
  weight,
};

struct Variant {
  const char* name;
  bool film;
  bool inner_guidance;
  TractionLaw traction;
  Refinement refinement = Refinement::none;
};

class DynamicsIdentity : public testing::TestWithParam<Variant> {
 protected:
  DynamicsIdentity() {
    parameters.race.film_in_approach = GetParam().film;
    parameters.race.traction = GetParam().traction;
    if (GetParam().inner_guidance) {
      bearing.cage.guidance = Race::inner;
      parameters.cage.guide_diameter = 33.1e-3;
    }
    parameters.excitation = {.angular_frequency = 3e4,
                             .harmonics = {{.order = 1, .cosine = {0.0, 10.0}, .sine = {20.0, 49.0}}}};
    refine();
  }

  void refine() {
    switch (GetParam().refinement) {
      case Refinement::none:
        break;
      case Refinement::forms:
        bearing.inner.form = {{2, 4e-6, 0.3, false}, {11, 5e-7, 0.1, true}};
        bearing.outer.form = {{3, 3e-6, -0.7, false}, {2, 2e-6, 1.0, true}};
        point.inner_speed = -300.0;
        break;
      case Refinement::scratches:
        point.inner_speed = -300.0;
        break;
      case Refinement::unequal_rollers:
        bearing.rollers().diameter_deviation = {4e-6, -3e-6, 0.0, 8e-6};
        break;
      case Refinement::mixed_lubrication:
        parameters.race.lubrication = Lubrication::mixed;
        break;
      case Refinement::pocket_film:
        parameters.cage.pocket_film = PocketFilm::hydrodynamic;
        break;
      case Refinement::run_up:
        parameters.driving.ramp = 150.0;
        bearing.outer.form = {{5, 1e-6, 0.4, true}};
        break;
      case Refinement::rim:
        point.outer_race = test::bending_race();
        parameters.driving.ramp = 150.0;
        break;
      case Refinement::squeeze:  // squeeze film
        parameters.race.squeeze = true;
        break;
      case Refinement::weight:  // so heavy that it shows beside the contacts
        parameters.gravity = {.across = 5e3, .angle = 0.7};
        break;
      case Refinement::full_complement:  // rollers that touch one another
        bearing = test::full_complement_bearing();
        bearing.rollers().diameter_deviation = {1e-6, -2e-6, 0.0, 1e-6};
        break;
    }
  }

  BearingModel model_now() const {
    BearingModel model = bearing_model(bearing, point, parameters);
    if (GetParam().refinement == Refinement::scratches)
      defect::put_scratches(test::scratched_everywhere(), model);
    return model;
  }

  Bearing bearing = test::reducer_bearing();
  DynamicsParameters parameters = test::reducer_parameters();
  OperatingPoint point = test::reducer_point(6000.0);
  test::Random random;
};

// At rest, without friction, what accelerates each body is the slope of all stored energy, the centrifugal
// potential included.
TEST_P(DynamicsIdentity, ForcesAreTheSlopeOfTheEnergy) {
  point.outer_speed = point.inner_speed = 0.0;
  parameters.driving = {};  // Euler's terms have no potential
  parameters.gravity = {};  // nor has gravity in a frame that turns
  const BearingModel model = model_now();
  vectorised::VectorBearing equations(model);
  const StateLayout& layout = model.layout;
  const Eigen::Index z = layout.rollers;
  const auto mass_of = [&](Eigen::Index i, const Eigen::VectorXd& x) {
    if (i < z) return model.roller.mass;
    if (i < 2 * z) return model.roller.mass * x[i - z] * x[i - z];
    if (i < layout.bore()) return i == layout.cage() + 2 ? model.cage.inertia : model.cage.mass;
    if (i >= layout.wave()) return model.rim[static_cast<std::size_t>(i - layout.wave())].mass;
    return i < layout.pin() ? model.bore_mass : model.pin_mass;
  };
  const auto check = [&](const Eigen::VectorXd& x, Eigen::Index position, Eigen::Index velocity,
                         double external) {
    Eigen::VectorXd dx(x.size());
    equations.derivative(0.0, x, dx);
    const bool angle = (position >= z && position < 2 * z) || (layout.caged && position == layout.cage() + 2);
    const double step = angle ? 1e-9 : 2e-11;  // [rad] or [m]: 1e-5 of the approaches
    Eigen::VectorXd left = x, right = x;
    left[position] -= step;
    right[position] += step;
    const double slope =
        (stored_energy(model, right).total() - stored_energy(model, left).total()) / (2.0 * step);
    const double inertial_force = mass_of(position, x) * dx[velocity];
    // Round-off of the energy (of order 10 J through the centrifugal potential) over twice the step.
    const double round_off = 20.0 * 2.2e-16 * 100.0 / (2.0 * step);
    EXPECT_NEAR(inertial_force, external - slope, round_off + 1e-4 * std::abs(slope))
        << "variable " << position;
  };
  for (int k = 0; k < kStates / 8; ++k) {
    const Eigen::VectorXd shaken = test::shaken_state(model, bearing, parameters, 2e-5, 0.0, random);
    Eigen::VectorXd x = shaken;
    x.segment(2 * z, 3 * z).setZero();
    if (layout.caged) x.segment(layout.cage() + 3, 3).setZero();
    for (Eigen::Index i = 0; i < 2 * z; ++i) check(x, i, i + 2 * z, 0.0);
    for (Eigen::Index i = 0; layout.caged && i < 3; ++i)
      check(x, layout.cage() + i, layout.cage() + 3 + i, 0.0);
    for (Eigen::Index i = 0; i < 2; ++i) {
      check(x, layout.bore() + i, layout.bore() + 2 + i, bore_load(model, 0.0)[i]);
      check(x, layout.pin() + i, layout.pin() + 2 + i, 0.0);
    }
    for (Eigen::Index i = 0; i < layout.waves; ++i) check(x, layout.wave() + i, layout.wave_speed() + i, 0.0);
  }
}

// Along the motion, all that is stored changes by what enters less what is lost, in any state whatever.
TEST_P(DynamicsIdentity, PowerBalancesInEveryState) {
  if (parameters.driving.ramp == 0.0) point.carrier.acceleration = 300.0;
  const BearingModel model = model_now();
  vectorised::VectorBearing equations(model);
  for (int k = 0; k < kStates; ++k) {
    const Eigen::VectorXd x = test::shaken_state(model, bearing, parameters, 5e-6, kSpeed, random);
    Eigen::VectorXd dx(x.size());
    const double time = 1e-3 * random();
    equations.derivative(time, x, dx);
    const double step = 1e-9;  // [s]
    const double change = (stored_energy(model, x + step * dx, time + step).total() -
                           stored_energy(model, x - step * dx, time - step).total()) /
                          (2.0 * step);
    const Snapshot now = snapshot(model, x, time);
    const double entering = power_input(model, time, x, dx).total();
    const double turned_over = std::abs(entering) + now.loss.total() + std::abs(change);
    // Round-off of about 10 J over 2 ns, and contacts that open or close within the step.
    EXPECT_NEAR(change, entering - now.loss.total(), 1.0 + 1e-5 * turned_over);
  }
}

TEST_P(DynamicsIdentity, LossesAreNeverNegative) {
  const BearingModel model = model_now();
  for (int k = 0; k < kStates; ++k) {
    const Eigen::VectorXd x = test::shaken_state(model, bearing, parameters, 3e-5, 3.0 * kSpeed, random);
    const PowerLoss loss = snapshot(model, x).loss;
    for (double one : {loss.race_damping, loss.inner_traction, loss.outer_traction, loss.rolling, loss.drag,
                       loss.pockets, loss.neighbours, loss.guidance, loss.support})
      EXPECT_GE(one, 0.0);
    EXPECT_GT(loss.total(), 0.0);
  }
}

// Forces inside the bearing cancel, and so do their moments about the origin: Newton and Euler require this
// apart from external loads. The pin's moment is that of the power that keeps it rotating.
TEST_P(DynamicsIdentity, InnerForcesAndMomentsCancel) {
  point.inner_speed = -300.0;
  const BearingModel model = model_now();
  vectorised::VectorBearing equations(model);
  const CarrierFrame frame = frame_at(model, 0.0);
  const Vector2 gravity = gravity_at(model, 0.0);
  for (int k = 0; k < kStates; ++k) {
    const Eigen::VectorXd x = test::shaken_state(model, bearing, parameters, 3e-5, kSpeed, random);
    Eigen::VectorXd dx(x.size());
    equations.derivative(0.0, x, dx);
    const ConstStateViews at = state_views(model.layout, x.data()),
                          rate = state_views(model.layout, dx.data());
    Vector2 force = Vector2::Zero();
    double moment = 0.0, scale = 0.0;
    const auto add = [&](const Vector2& on_body, double rotating, const Vector2& position) {
      force += on_body;
      moment += rotating + cross(position, on_body);
      scale += on_body.norm();
    };
    for (Eigen::Index j = 0; j < model.layout.rollers; ++j) {
      const double r = at.radius[j], theta = at.angle[j], orbital = at.orbital_speed[j];
      const double radial = rate.radial_speed[j] - radial_inertial_acceleration(frame, r, theta, orbital);
      const double along = r * rate.orbital_speed[j] + 2.0 * at.radial_speed[j] * orbital -
                           tangential_inertial_acceleration(frame, r, theta, at.radial_speed[j]);
      const Vector2 out = direction(theta);
      add(model.roller.mass * (radial * out - gravity) +
              (model.roller.mass * along - model.orbit_drag.force(r * orbital)) * across(out),
          model.roller.inertia * (rate.spin[j] + frame.euler) - model.spin_drag.force(at.spin[j]), r * out);
    }
    const auto beyond = [&](const auto& acceleration, const CarrierFrame& in, const auto& position,
                            const auto& velocity) -> Vector2 {
      return acceleration - inertial_acceleration(in, position, velocity);
    };
    if (model.layout.caged)
      add(model.cage.mass * (beyond(rate.cage_velocity, frame, at.cage_position, at.cage_velocity) - gravity),
          model.cage.inertia * (rate.cage_speed + frame.euler) - model.cage_drag.force(at.cage_speed),
          at.cage_position);
    CarrierFrame centred = frame;
    centred.orbit_radius = 0.0;
    const double on_bore = equations.reaction().moment;
    add(model.bore_mass * beyond(rate.bore_velocity, centred, at.bore_position, at.bore_velocity) -
            bore_load(model, 0.0),
        on_bore, at.bore_position);
    const double holding = power_input(model, 0.0, x, dx).rotations;
    add(model.pin_mass * (beyond(rate.pin_velocity, frame, at.pin_position, at.pin_velocity) - gravity) -
            model.support.force(at.pin_position, at.pin_velocity),
        -(holding + on_bore * model.point.outer_speed) / model.point.inner_speed, at.pin_position);
    const double round_off = 1e-11 * scale;  // accelerations are those of the carrier, too
    EXPECT_NEAR(force.norm(), 0.0, round_off);
    EXPECT_NEAR(moment, 0.0, round_off * model.geometry.outer_radius);
  }
}

// Rollers have no names: turning the cage by one pocket and renaming the rollers changes nothing.
TEST_P(DynamicsIdentity, RollersCanBeRenamed) {
  if (!bearing.rollers().diameter_deviation.empty() || GetParam().refinement == Refinement::scratches)
    GTEST_SKIP() << "these rollers have names";
  const BearingModel model = model_now();
  vectorised::VectorBearing equations(model);
  const Eigen::Index z = model.layout.rollers;
  const Eigen::VectorXd x = test::shaken_state(model, bearing, parameters, 1e-5, kSpeed, random);
  Eigen::VectorXd renamed = x, dx(x.size()), renamed_dx(x.size());
  for (Eigen::Index block = 0; block < 5; ++block)
    for (Eigen::Index j = 0; j < z; ++j) renamed[block * z + j] = x[block * z + (j + 1) % z];
  if (model.layout.caged) renamed[model.layout.cage() + 2] += 2.0 * M_PI / static_cast<double>(z);
  equations.derivative(0.0, x, dx);
  equations.derivative(0.0, renamed, renamed_dx);
  const double round_off =
      1e-10;  // relative: pocket depths are differences of lengths a thousand times as large
  for (Eigen::Index block = 0; block < 5; ++block) {
    const double scale = dx.segment(block * z, z).cwiseAbs().maxCoeff();
    for (Eigen::Index j = 0; j < z; ++j)
      EXPECT_NEAR(renamed_dx[block * z + j], dx[block * z + (j + 1) % z], round_off * scale);
  }
  const Eigen::Index rings = x.size() - 5 * z;
  EXPECT_NEAR((renamed_dx.tail(rings) - dx.tail(rings)).norm(), 0.0, round_off * dx.tail(rings).norm());
}

// Neighbours without contact exert no forces, like bars that are never reached.
TEST(FullComplement, WithRoomLeftMovesAsInACageOutOfReach) {
  Bearing roomy = test::reducer_bearing();  // 15 rollers where 21 go in
  DynamicsParameters far = test::reducer_parameters();
  far.cage.pocket_clearance = 4e-3;
  const BearingModel caged = bearing_model(roomy, test::reducer_point(6000.0), far);
  roomy.cage = {};
  const BearingModel full = bearing_model(roomy, test::reducer_point(6000.0), far);
  test::Random random;
  const Eigen::Index z = full.layout.rollers;
  for (int k = 0; k < 10; ++k) {
    const Eigen::VectorXd x = test::shaken_state(full, roomy, far, 5e-6, kSpeed, random);
    Eigen::VectorXd in_cage = Eigen::VectorXd::Zero(caged.layout.size()), dx(x.size()),
                    dx_caged(in_cage.size());
    in_cage.head(5 * z) = x.head(5 * z);
    in_cage[caged.layout.cage() + 2] = 0.3;  // where the first roller begins
    in_cage.tail(8) = x.tail(8);
    vectorised::VectorBearing(full).derivative(0.0, x, dx);
    vectorised::VectorBearing(caged).derivative(0.0, in_cage, dx_caged);
    const double round_off = 1e-12;
    EXPECT_LT((dx.head(5 * z) - dx_caged.head(5 * z)).norm(), round_off * dx.head(5 * z).norm());
    EXPECT_LT((dx.tail(4) - dx_caged.tail(4)).norm(), round_off * dx.tail(4).norm()) << "the pin";
    EXPECT_EQ(snapshot(full, x).loss.neighbours, 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Variants, DynamicsIdentity,
    testing::Values(
        Variant{"dry", false, false, TractionLaw::regularised_coulomb},
        Variant{"film", true, false, TractionLaw::regularised_coulomb},
        Variant{"limiting_shear", false, false, TractionLaw::limiting_shear},
        Variant{"inner_guidance", true, true, TractionLaw::limiting_shear},
        Variant{"forms", true, false, TractionLaw::regularised_coulomb, Refinement::forms},
        Variant{"scratches", true, false, TractionLaw::regularised_coulomb, Refinement::scratches},
        Variant{"unequal_rollers", true, false, TractionLaw::regularised_coulomb,
                Refinement::unequal_rollers},
        Variant{"mixed_lubrication", false, false, TractionLaw::limiting_shear,
                Refinement::mixed_lubrication},
        Variant{"pocket_film", false, false, TractionLaw::regularised_coulomb, Refinement::pocket_film},
        // Waves of an elastic rim are slopes of its energy, and teeth whose forces decrease in a run-up do
        // work on it.
        Variant{"rim", true, false, TractionLaw::regularised_coulomb, Refinement::rim},
        Variant{"squeeze", false, false, TractionLaw::regularised_coulomb, Refinement::squeeze},
        Variant{"squeeze_film", true, false, TractionLaw::limiting_shear, Refinement::squeeze},
        Variant{"weight", false, false, TractionLaw::regularised_coulomb, Refinement::weight},
        Variant{"run_up", false, false, TractionLaw::regularised_coulomb, Refinement::run_up},
        Variant{"full_complement", true, false, TractionLaw::regularised_coulomb,
                Refinement::full_complement}),
    [](const testing::TestParamInfo<Variant>& variant) { return variant.param.name; });

}  // namespace
}  // namespace orbearing::bearing::motion::dynamics_forces_test
