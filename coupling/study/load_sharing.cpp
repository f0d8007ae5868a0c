#include "coupling/study/load_sharing.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "bearing/equilibrium/lamina_bearing.hpp"
#include "coupling/study/bearing_tangent.hpp"
#include "gearset/dynamics/bearing_force.hpp"
#include "gearset/dynamics/snapshot.hpp"
#include "gearset/dynamics/static_state.hpp"

namespace orbearing::study {

namespace {

using boost::math::double_constants::two_pi;
using Eigen::Vector2d;
using Eigen::VectorXd;
using gearset::dynamics::SetModel;

constexpr int kMostRounds = 100;
constexpr double kSameForce = 1e-9;  // [-]  of the largest force

// The bearings of the planets under the forces [N] that they exert on them.
class PlanetSupport {
 public:
  PlanetSupport(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty)
      : drivetrain_(drivetrain),
        bearing_(of_like_rollers(drivetrain.bearing)),
        duty_(duty),
        options_(quasi_static_options(drivetrain)),
        settled_(static_cast<std::size_t>(drivetrain.set.planets)) {
    if (bearing_.rollers().laminae > 0) cut_.emplace(bearing_, mechanics::InstructionSet::baseline);
  }

  /// Of that planet from the place of its pin [m]; laminae are searched from where they last settled.
  Vector2d displacement(std::size_t planet, const Vector2d& force) {
    const bearing::OperatingPoint point = point_under(drivetrain_, duty_, force);
    return (cut_ ? on_laminae(point, settled_[planet])
                 : balanced(bearing::quasi_static_bearing(bearing_, point, options_))) +
           point.bore_load / drivetrain_.dynamics.support.stiffness;
  }

 private:
  using LaminaStates = std::vector<bearing::laminae::LaminaState>;

  // Mean over the cage angles.
  Vector2d on_laminae(const bearing::OperatingPoint& point, LaminaStates& settled) const {
    const int positions = options_.cage_positions;
    const double step = two_pi / (positions * bearing_.rollers().count);
    const bool known = !settled.empty();
    Vector2d mean = Vector2d::Zero();
    for (int i = 0; i < positions; ++i) {
      const bearing::laminae::LaminaState* near = known             ? &settled[static_cast<std::size_t>(i)]
                                                  : settled.empty() ? nullptr
                                                                    : &settled.back();
      bearing::laminae::LaminaState state =
          lamina_state(*cut_, point, options_, options_.first_roller + i * step, near);
      mean += balanced(state) / positions;
      if (known)
        settled[static_cast<std::size_t>(i)] = std::move(state);
      else
        settled.push_back(std::move(state));
    }
    return mean;
  }
  template <class Result>
  static Vector2d balanced(const Result& result) {
    if (!result.report.converged) throw std::runtime_error("load sharing: " + result.report.message);
    return result.displacement;
  }

  const PlanetaryDrivetrain& drivetrain_;
  bearing::Bearing bearing_;
  BearingDuty duty_;
  bearing::QuasiStaticOptions options_;
  std::optional<bearing::laminae::LaminaBearing> cut_;
  std::vector<LaminaStates> settled_;  // (planets, cage angles)
};

// Fixed point of a map by what its last steps say of its slope: Anderson's mixing of type II.
class Mixing {
 public:
  /// What to try after `tried` became `found`.
  VectorXd next(const VectorXd& tried, const VectorXd& found) {
    const VectorXd change = found - tried;
    if (before_ && change.norm() > before_->change.norm()) forget();  // flanks parted or met
    if (before_) remember(change - before_->change, found - before_->found);
    before_ = Step{found, change};
    if (kept_ == 0) return found;
    const auto changes = changes_.leftCols(kept_), results = results_.leftCols(kept_);
    return found - results * changes.colPivHouseholderQr().solve(change);
  }

 private:
  static constexpr Eigen::Index most = 5;
  struct Step {
    VectorXd found, change;
  };

  void forget() {
    kept_ = 0;
    before_.reset();
  }
  void remember(const VectorXd& change, const VectorXd& result) {
    if (changes_.rows() != change.size()) {
      changes_.resize(change.size(), most);
      results_.resize(change.size(), most);
    }
    const Eigen::Index place = kept_ < most ? kept_++ : oldest_++ % most;
    changes_.col(place) = change;
    results_.col(place) = result;
  }

  std::optional<Step> before_;
  Eigen::MatrixXd changes_, results_;
  Eigen::Index kept_ = 0, oldest_ = 0;
};

void require_gears(const PlanetaryDrivetrain& drivetrain) {
  if (!drivetrain.gear_set)
    throw std::invalid_argument(
        "planets that load unevenly: found gears that cannot move; required: one set with teeth");
}

// The balance does not depend on the springs that lead to it: they are those of the bearings whatever the
// case states for them, so that not even its last digit does.
SetModel on_springs(const PlanetaryDrivetrain& drivetrain, double stiffness) {
  gearset::dynamics::SetParameters set = drivetrain.gear_set();
  set.planet.coupled_bearing = false;
  set.planet.bearing_stiffness = stiffness;
  return gearset::dynamics::set_model(std::move(set),
                                      gearset::dynamics::operation_of(drivetrain.set, drivetrain.drive));
}

// The set at rest under its mean loads.
struct AtRest {
  Eigen::VectorXd state;
  Eigen::Matrix2Xd forces;  // [N]  of the bearings on each planet (2, planets)
};

AtRest at_rest(const SetModel& model) {
  AtRest result{gearset::dynamics::static_state(model), Eigen::Matrix2Xd(2, model.layout.planets)};
  const Eigen::VectorXd q = result.state.head(model.layout.freedoms());
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(q.size());
  for (Eigen::Index i = 0; i < result.forces.cols(); ++i)
    result.forces.col(i) =
        bearing_force(model.parameters.planet, model.bearings[static_cast<std::size_t>(i)], q, still);
  return result;
}

std::vector<double> shares_at(const SetModel& set, const VectorXd& state, const BearingDuty& even) {
  gearset::dynamics::SetSnapshot snapshot;
  Eigen::VectorXd workspace;
  take_snapshot(gearset::dynamics::PlanetarySetEquations(averaged(set)), 0.0, state, workspace, snapshot);
  const Eigen::ArrayXd shares = snapshot.sun_mesh_force / even.gears.normal_force;
  return {shares.begin(), shares.end()};
}

// A spring that gives F at the displacement d has the deflection F / k there: the set rests on such springs
// until they give the forces that the bearings give at their displacements.
struct OnSprings {
  SetModel springs;
  AtRest now;
};

OnSprings balanced(const SetModel& set, PlanetSupport support) {
  SetModel springs = set;
  AtRest now = at_rest(springs);
  Eigen::Matrix2Xd tried = now.forces;
  Mixing mixing;
  double change = 0.0;
  for (int round = 0; round < kMostRounds; ++round) {
    for (Eigen::Index i = 0; i < tried.cols(); ++i) {
      const auto planet = static_cast<std::size_t>(i);
      springs.bearings[planet].pin_error = set.bearings[planet].pin_error +
                                           support.displacement(planet, tried.col(i)) +
                                           tried.col(i) / set.parameters.planet.bearing_stiffness;
    }
    now = at_rest(springs);
    change = (now.forces - tried).colwise().norm().maxCoeff() / now.forces.colwise().norm().maxCoeff();
    if (change <= kSameForce) return {std::move(springs), std::move(now)};
    tried.reshaped() = mixing.next(tried.reshaped(), now.forces.reshaped());
  }
  std::ostringstream text;
  text << "load sharing: after " << kMostRounds << " rounds the planets' loads still change by " << change
       << " of the largest; required: bearings and gears that find a balance";
  throw std::runtime_error(text.str());
}

}  // namespace

bearing::OperatingPoint point_under(const PlanetaryDrivetrain& drivetrain, const BearingDuty& even,
                                    const Vector2d& force) {
  bearing::OperatingPoint point = even.point;
  point.bore_load = -force / drivetrain.bearings_per_planet;
  point.bore_tilt = bore_tilt(drivetrain.misalignment, point.bore_load);
  return point;
}

PlanetBalance planet_balance(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry) {
  const BearingDuty even = bearing_duty(drivetrain, geometry);
  require_gears(drivetrain);
  const double stiffness = planet_bearing_stiffness(drivetrain, geometry);
  const SetModel set = on_springs(drivetrain, stiffness);
  const OnSprings found = balanced(set, {drivetrain, even});
  PlanetBalance result{shares_at(set, found.now.state, even), found.now.forces,
                       Eigen::Matrix2Xd(2, found.now.forces.cols()), stiffness};
  for (Eigen::Index i = 0; i < result.offset.cols(); ++i) {
    const auto planet = static_cast<std::size_t>(i);
    result.offset.col(i) = found.springs.bearings[planet].pin_error - set.bearings[planet].pin_error;
  }
  return result;
}

PlanetBalance balance_on_springs(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                 const Eigen::Matrix2Xd& offset, double stiffness) {
  require_gears(drivetrain);
  SetModel set = on_springs(drivetrain, stiffness);
  for (Eigen::Index i = 0; i < offset.cols(); ++i)
    set.bearings[static_cast<std::size_t>(i)].pin_error += offset.col(i);
  AtRest now = at_rest(set);
  std::vector<double> shares = shares_at(set, now.state, bearing_duty(drivetrain, geometry));
  return {std::move(shares), std::move(now.forces), offset, stiffness};
}

std::vector<double> load_shares(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry) {
  return planet_balance(drivetrain, geometry).shares;
}

std::vector<BearingDuty> planet_duties(const PlanetaryDrivetrain& drivetrain,
                                       const DrivetrainGeometry& geometry) {
  if (!drivetrain.uneven_planets) return {bearing_duty(drivetrain, geometry)};
  return duties_with_shares(drivetrain, geometry, load_shares(drivetrain, geometry));
}

std::vector<BearingDuty> duties_with_shares(const PlanetaryDrivetrain& drivetrain,
                                            const DrivetrainGeometry& geometry,
                                            const std::vector<double>& shares) {
  const BearingDuty even = bearing_duty(drivetrain, geometry);
  std::vector<BearingDuty> duties;
  for (const double share : shares) {
    BearingDuty duty = even;
    duty.planet = static_cast<int>(duties.size());
    duty.gears.normal_force *= std::abs(share);
    duty.gears.tangential_force *= share;
    duty.gears.radial_force *= std::abs(share);  // teeth only push, whichever flank carries
    duty.gears.tooth_force *= std::abs(share);
    duty.gears.axial_force *= share;
    duty.gears.overturning_moment *= share;
    const Vector2d more(duty.gears.radial_force - even.gears.radial_force,
                        duty.gears.tangential_force - even.gears.tangential_force);
    duty.point.bore_load += more / drivetrain.bearings_per_planet;
    duty.point.bore_tilt = bore_tilt(drivetrain.misalignment, duty.point.bore_load);
    duty.point.outer_race = outer_race(drivetrain, geometry, duty.gears);
    duties.push_back(duty);
  }
  return duties;
}

}  // namespace orbearing::study
