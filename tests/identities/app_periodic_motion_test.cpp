// Test whether the steady motion of a planet bearing is periodic over a roller passage, the time in which the
// cage rotates by one pocket and after which every roller could be where its neighbour was. Under the mean
// forces of the gears nothing else changes with time. docs/periodic_motion.md has the figures.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <ostream>
#include <stdexcept>
#include <vector>

#include "app/case/case_file.hpp"
#include "app/study/planetary_case.hpp"
#include "bearing/motion/initial_state.hpp"
#include "bearing/motion/vector_bearing.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "coupling/integration/rosenbrock2.hpp"
#include "coupling/system/bearing_steps.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::system {
namespace {

using constants::two_pi;
using Eigen::Index;
using Eigen::VectorXd;
using StepLengths = std::vector<double>;  // [s]

struct PassageDuty {
  double speed = 0.0;           // [1/min]  of the input
  double clearance = 0.0;       // [um]
  double error = 1.0;           // [-]  share of the case's allowed error of a step
  double pocket_damping = 1.0;  // [s/m]  that of the case
  bool oil_in_pockets = false;

  friend void PrintTo(const PassageDuty& d, std::ostream* out) {
    *out << d.speed << " rpm, " << d.clearance << " um, error x " << d.error << ", pockets "
         << d.pocket_damping << " s/m";
  }
};

// The shipped reducer with film and squeeze under the mean forces of its gears, passage by passage.
class Passages {
 public:
  explicit Passages(const PassageDuty& duty) : Passages(drivetrain_of(duty), duty.error) {}

  const bearing::motion::StateLayout& layout() const { return bearing_.model().layout; }
  const VectorXd& state() const { return x_; }
  /// Change of each variable that corresponds to one length.
  const VectorXd& scale() const { return scale_; }

  /// To the next passage, after which rollers are renamed; `see` sees every step. Returns its steps.
  StepLengths next(const std::function<void(const VectorXd&)>& see = {}) {
    std::vector<double> x = bearing_.padded(x_);
    const auto cage_angle = static_cast<std::size_t>(bearing_.layout().cage() + 2);
    const double end = begin_ + pitch();
    integration::Rosenbrock2 stepper = new_stepper();
    StepLengths steps;
    VectorXd flat = x_;
    for (double time = 0.0;;) {
      const double before = time, turned = sense() * x[cage_angle];
      while (stepper.try_step(bearing_, x, time, step_) != integration::kAccepted)
        if (!(step_ > 1e-13)) throw std::runtime_error("the steps of a passage vanish");
      const double length = time - before;
      if (sense() * x[cage_angle] < end) {
        steps.push_back(length);
        if (!see) continue;
        bearing_.flatten(x.data(), flat);
        see(flat);
        continue;
      }
      // The last step ends where the cage has turned by a pocket: secants from its beginning.
      const std::vector<double> from = stepper.replaced_state();
      double part = length * (end - turned) / (sense() * x[cage_angle] - turned);
      for (int i = 0; i < 4; ++i) {
        x = from;
        single_step(stepper, x, part);
        if (i < 3) part *= (end - turned) / (sense() * x[cage_angle] - turned);
      }
      steps.push_back(part);
      bearing_.flatten(x.data(), flat);
      x_ = renamed(flat);
      return steps;
    }
  }

  /// From `start` by the same `steps`, then renamed: neighbouring motions take the same steps.
  VectorXd along(const VectorXd& start, const StepLengths& steps) {
    std::vector<double> x = bearing_.padded(start);
    integration::Rosenbrock2 stepper = new_stepper();
    for (double step : steps) single_step(stepper, x, step);
    VectorXd flat = start;
    bearing_.flatten(x.data(), flat);
    return renamed(flat);
  }

  VectorXd rate(const VectorXd& at) {
    std::vector<double> x = bearing_.padded(at), dx(x.size());
    bearing_.derivative(0.0, x.data(), dx.data());
    VectorXd flat = at;
    bearing_.flatten(dx.data(), flat);
    return flat;
  }

  /// Each roller named as the one in whose place it has come, the cage a pocket back.
  VectorXd renamed(const VectorXd& x) const {
    VectorXd y = with_names_moved(x);
    const Index z = layout().rollers, last = sense() > 0.0 ? 0 : z - 1;
    y[z + last] -= sense() * two_pi;
    y[layout().cage() + 2] -= sense() * pitch();
    return y;
  }
  /// The same for rates, which do not depend on the position.
  VectorXd with_names_moved(const VectorXd& x) const {
    const Index z = layout().rollers, one = sense() > 0.0 ? z - 1 : 1;
    VectorXd y = x;
    for (Index group = 0; group < layout().groups(); ++group)
      for (Index i = 0; i < z; ++i) y[group * z + i] = x[group * z + (i + one) % z];
    return y;
  }

 private:
  static analysis::PlanetaryDrivetrain drivetrain_of(const PassageDuty& duty) {
    analysis::PlanetaryDrivetrain drivetrain = app::drivetrain_of(
        app::read_case(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml",
                       {"film.enabled=true", "contact.squeeze=true", "gearset.mesh_variation=false"}));
    drivetrain.drive.speed = duty.speed * two_pi / 60.0;
    drivetrain.bearing.radial_clearance = 1e-6 * duty.clearance;
    drivetrain.dynamics.cage.pocket_damping = duty.pocket_damping;
    if (duty.oil_in_pockets) drivetrain.dynamics.cage.pocket_film = bearing::motion::PocketFilm::hydrodynamic;
    return drivetrain;
  }
  Passages(const analysis::PlanetaryDrivetrain& drivetrain, double error)
      : Passages(drivetrain, analysis::derive(drivetrain), error) {}
  Passages(const analysis::PlanetaryDrivetrain& drivetrain, const analysis::DrivetrainGeometry& geometry,
           double error)
      : Passages(drivetrain.bearing, analysis::bearing_duty(drivetrain, geometry).point,
                 analysis::bearing_dynamics(drivetrain, geometry),
                 error * drivetrain.steady_state.allowed_length_error) {}
  Passages(const bearing::Bearing& bearing, const bearing::OperatingPoint& point,
           const bearing::motion::DynamicsParameters& dynamics, double length_error)
      : bearing_(bearing::motion::bearing_model(bearing, point, dynamics)),
        allowed_(allowed_errors(bearing_.model(), length_error)),
        scale_(allowed_ / length_error),
        x_(bearing::motion::initial_state(bearing, bearing_.model(), dynamics, 0.0).x),
        begin_(sense() * x_[layout().cage() + 2]) {}

  double sense() const { return bearing_.model().kinematic_cage_speed > 0.0 ? 1.0 : -1.0; }
  double pitch() const { return two_pi / static_cast<double>(layout().rollers); }
  integration::Rosenbrock2 new_stepper() const {
    return integration::Rosenbrock2(linearly_implicit_errors(bearing_, allowed_),
                                    longest_step(bearing_.model()));
  }
  void single_step(integration::Rosenbrock2& stepper, std::vector<double>& x, double length) {
    stepper.begin(bearing_, x, 0.0);
    stepper.attempt(bearing_, x, 0.0, length);
    stepper.accept(x);
  }

  bearing::vectorised::VectorBearing bearing_;
  VectorXd allowed_, scale_;
  VectorXd x_;
  double begin_ = 0.0;  // [rad]  cage angle at which passages begin, in the sense in which it turns
  double step_ = 1e-7;  // [s]
};

constexpr int kSettling = 90, kSeen = 45;  // passages: six cage revolutions and three

// Root mean square of what the cage's place differs by from one passage to the next, over its standard
// deviation within a passage [-].
double deviation_of_cage(Passages& motion) {
  const Index cage = motion.layout().cage();
  double differs = 0.0, within = 0.0;
  for (int k = 0; k < kSeen; ++k) {
    const Eigen::Vector2d before = motion.state().segment<2>(cage);
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double squares = 0.0, number = 0.0;
    motion.next([&](const VectorXd& x) {
      const Eigen::Vector2d off = x.segment<2>(cage) - before;
      sum += off;
      squares += off.squaredNorm();
      number += 1.0;
    });
    within += squares / number - (sum / number).squaredNorm();
    differs += (motion.state().segment<2>(cage) - before).squaredNorm();
  }
  return std::sqrt(differs / within);
}

// Passages in which a difference turns into the direction that grows most, and over which the mean is taken.
struct PassagesOfGrowth {
  int aligning = 15, seen = 30;
};
// Of a periodic motion: other differences decay by a few percent in a passage, and swing as they do so.
constexpr PassagesOfGrowth kOfPeriodic{60, 60};

// Geometric mean by which the distance of a neighbouring motion grows in a passage [-]: the modulus of the
// largest Floquet multiplier where the motion is periodic.
double growth_of_distance(Passages& motion, const PassagesOfGrowth& passages = {}) {
  constexpr double kDistance = 1e-13;  // [m]  far above round-off, far below what changes a contact
  VectorXd direction = VectorXd::LinSpaced(motion.state().size(), -1.0, 2.0).normalized();
  double logarithms = 0.0;
  for (int k = 0; k < passages.aligning + passages.seen; ++k) {
    const VectorXd start = motion.state();
    const StepLengths steps = motion.next();
    const VectorXd moved = motion.along(start + kDistance * direction.cwiseProduct(motion.scale()), steps);
    direction = (moved - motion.along(start, steps)).cwiseQuotient(motion.scale()) / kDistance;
    if (k >= passages.aligning) logarithms += std::log(direction.norm());
    direction.normalize();
  }
  return std::exp(logarithms / passages.seen);
}

Passages settled_passages(const PassageDuty& duty) {
  Passages motion(duty);
  for (int k = 0; k < kSettling; ++k) motion.next();
  return motion;
}

// A passage may be taken as a period at all, since the equations do not distinguish one roller from the next.
TEST(PeriodicMotion, RenamedRollersMoveAlike) {
  constexpr double kRoundOff = 1e-9;  // of the largest rate of a kind
  Passages motion = settled_passages({.speed = 6000.0});
  const VectorXd expected = motion.with_names_moved(motion.rate(motion.state()));
  const VectorXd found = motion.rate(motion.renamed(motion.state()));
  const Index z = motion.layout().rollers;
  for (Index group = 0; group < motion.layout().groups(); ++group) {
    const VectorXd of_group = expected.segment(group * z, z);
    EXPECT_LT((found.segment(group * z, z) - of_group).cwiseAbs().maxCoeff(),
              kRoundOff * of_group.cwiseAbs().maxCoeff())
        << "group " << group;
  }
  const VectorXd of_rings = expected.tail(expected.size() - motion.layout().cage());
  EXPECT_LT((found.tail(of_rings.size()) - of_rings).cwiseAbs().maxCoeff(),
            kRoundOff * of_rings.cwiseAbs().maxCoeff());
}

// The cage returns to a different position, by as much as it moves within a passage; and neighbouring motions
// diverge by orders of magnitude in a passage, so that a periodic motion, if there is one, is unstable and
// steady means are not taken of it.
TEST(PeriodicMotion, SqueezeAloneDoesNotMakeIt) {
  for (const PassageDuty& duty : {PassageDuty{.speed = 6000.0}, {.speed = 12000.0, .clearance = 37.0}}) {
    SCOPED_TRACE(testing::PrintToString(duty));
    Passages motion = settled_passages(duty);
    EXPECT_GT(deviation_of_cage(motion), 0.5);
    EXPECT_GT(growth_of_distance(motion), 30.0);
  }
}

// At 3000 rpm without clearance the motion looks periodic, but the distance of neighbouring motions grows as
// fast, and with shorter steps as well.
TEST(PeriodicMotion, NearlyPeriodicMotionRepels) {
  for (double error : {1.0, 0.01}) {
    const PassageDuty duty{.speed = 3000.0, .error = error};
    SCOPED_TRACE(testing::PrintToString(duty));
    Passages motion = settled_passages(duty);
    const double deviation = deviation_of_cage(motion);
    EXPECT_GT(deviation, 0.01);
    EXPECT_LT(deviation, 0.3);
    EXPECT_GT(growth_of_distance(motion), 1e4);
  }
}

// The instability is caused by the pockets, which are dry and nearly elastic. With a hundred times their
// damping the motion at 12000 rpm is periodic, and neighbouring motions do not diverge: the only difference
// that does not decay is a shift in time, whose multiplier is 1.
TEST(PeriodicMotion, IsWhatDampedPocketsMake) {
  Passages motion = settled_passages({.speed = 12000.0, .error = 0.1, .pocket_damping = 100.0});
  EXPECT_LT(deviation_of_cage(motion), 0.02);
  EXPECT_NEAR(growth_of_distance(motion, kOfPeriodic), 1.0, 0.02);
}

// A squeeze film in the pockets makes it periodic too, and stable.
TEST(PeriodicMotion, IsWhatOilInPocketsMakes) {
  Passages motion = settled_passages({.speed = 3000.0, .error = 0.1, .oil_in_pockets = true});
  EXPECT_LT(deviation_of_cage(motion), 1e-4);
  EXPECT_NEAR(growth_of_distance(motion, kOfPeriodic), 1.0, 0.02);
}

}  // namespace
}  // namespace orbearing::system
