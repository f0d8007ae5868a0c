#include "coupling/analysis/load_sharing.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "bearing/equilibrium/aligned_pitch.hpp"
#include "bearing/equilibrium/elastic_waves.hpp"
#include "coupling/analysis/planet_stiffness.hpp"
#include "coupling/analysis/tilting_planet.hpp"
#include "gearset/dynamics/bearing_force.hpp"
#include "gearset/dynamics/snapshot.hpp"
#include "gearset/dynamics/static_state.hpp"
#include "mechanics/linear_algebra.hpp"

namespace orbearing::analysis {

namespace {

using bearing::vectorised::PitchResults;
using Eigen::Matrix2d;
using Eigen::Matrix2Xd;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using gearset::dynamics::SetModel;
using gearset::dynamics::StaticSet;

constexpr int kMostRounds = 100;
constexpr int kNewtonRounds = 8;
constexpr int kTangentRounds = 30;
constexpr int kLinearRounds = 3;
constexpr double kSameForce = 1e-9;          // [-]  of the largest force
constexpr double kSameTangentForce = 1e-10;  // [-]  the same on tangents

// Deflection of the bearings of a planet and of their pin under a force that they exert on it.
struct Give {
  Vector2d displacement;  // [m]    of the planet from the position of its pin
  Matrix2d compliance;    // [m/N]  -d(displacement)/d(force)
};

gearset::MeanLoads gears_with_share(gearset::MeanLoads gears, double share) {
  gears.normal_force *= std::abs(share);
  gears.tangential_force *= share;
  gears.radial_force *= std::abs(share);  // teeth only push, whichever flank carries
  gears.tooth_force *= std::abs(share);
  gears.axial_force *= share;
  gears.overturning_moment *= share;
  return gears;
}

// An elastic planet also deflects between its teeth. The deflection of both meshes beyond the stiffness that
// the gears have is equivalent to a displacement of the whole planet along the force of its meshes: its
// rotation is free.
class TeethOnRim {
 public:
  TeethOnRim(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
             const gearset::MeanLoads& even)
      : rim_(geometry.rim), even_(even), along_(even.radial_force, even.tangential_force) {
    if (!rim_) return;
    along_ /= even.normal_force;
    for (const double share : {1.0, -1.0}) {
      const bearing::ElasticRace race = outer_race(drivetrain, geometry, gears_with_share(even, share));
      (share > 0.0 ? driving_ : back_) = bearing::waves_at_rest(race);
    }
    waves_ = bearing::wave_stiffness({rim_->race, {}, {}});
  }

  /// To what one of the `bearings` gives under its part of the load: `waves` [m] of the race, where the
  /// planet carries `share` of the mean load.
  void add(double share, const VectorXd& waves, double bearings, Give& give) const {
    if (!rim_) return;
    const VectorXd& by_teeth = share < 0.0 ? back_ : driving_;
    const Vector2d along(along_.x(), share < 0.0 ? -along_.y() : along_.y());
    const VectorXd pressed = waves_.cwiseProduct(waves - std::abs(share) * by_teeth);  // [N]  by the rollers
    const double meshes = rim_->meshes.sum();                                          // [m/N]
    const double deflection =
        std::abs(share) * even_.normal_force * meshes + by_teeth.dot(pressed) / even_.normal_force;
    const Vector2d by_deflection = along / along.squaredNorm();
    give.displacement += deflection * by_deflection;
    give.compliance.col(1) += bearings * meshes / along.y() * by_deflection;
  }

 private:
  std::shared_ptr<const gearset::rim::RimInfluence> rim_;  // none: rigid
  gearset::MeanLoads even_;
  Vector2d along_;                   // [-]    force on the planet by 1 N of both meshes
  VectorXd driving_, back_, waves_;  // [m]    by the teeth at the mean load; [N/m]
};

// The bearings of the planets under the forces [N] that they exert on them.
class PlanetSupport {
 public:
  PlanetSupport(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                const BearingDuty& duty)
      : drivetrain_(drivetrain),
        geometry_(geometry),
        duty_(duty),
        options_(quasi_static_options(drivetrain)),
        teeth_(drivetrain, geometry, duty.gears),
        search_(of_like_rollers(drivetrain.bearing), options_),
        pitches_(static_cast<std::size_t>(drivetrain.set.planets)),
        seated_(pitches_.size()) {
    if (drivetrain.seats.tilt == TiltState::computed)
      on_pin_ = planet_on(unlike_planet_seat(drivetrain, duty), of_like_rollers(drivetrain.bearing));
  }

  /// Each search starts from the last equilibrium of this planet, else from the first one found.
  Give give(std::size_t planet, const Vector2d& force) {
    bearing::OperatingPoint point = point_under(drivetrain_, duty_, force);
    const double share = -force.y() / duty_.gears.tangential_force;
    if (geometry_.rim)
      point.outer_race = outer_race(drivetrain_, geometry_, gears_with_share(duty_.gears, share));
    const Give rolling = on_pin_ ? give_on_pin(planet, point, share) : give_of_bearing(planet, point, share);
    const double support = drivetrain_.dynamics.support.stiffness;
    return {point.bore_load / support + rolling.displacement,
            (Matrix2d::Identity() / support + rolling.compliance) / drivetrain_.bearings_per_planet};
  }

  /// Last equilibria of the bearing of each planet; none where cage angles were searched one by one.
  std::vector<std::shared_ptr<const PitchResults>> pitches() {
    std::vector<std::shared_ptr<const PitchResults>> all;
    for (PitchResults& one : pitches_) {
      if (one.rollers.empty()) return {};
      all.push_back(std::make_shared<const PitchResults>(std::move(one)));
    }
    return all;
  }

 private:
  static Matrix2d compliance_of(const Matrix2d& stiffness) {
    Matrix2d compliance;
    for (int i = 0; i < 2; ++i)
      compliance.col(i) = mechanics::lengths_under<2>(Vector2d(Matrix2d::Identity().col(i)), stiffness);
    return compliance;
  }

  template <class States>
  static VectorXd mean_waves(const States& states) {
    VectorXd waves = VectorXd::Zero(states.front().waves.size());
    for (const auto& state : states) waves += state.waves / static_cast<double>(states.size());
    return waves;
  }

  Give give_of_bearing(std::size_t planet, const bearing::OperatingPoint& point, double share) {
    const PitchResults& near = pitches_[planet].reports.empty() ? pitches_.front() : pitches_[planet];
    search_.solve(point, found_, near.reports.empty() ? nullptr : &near);
    const auto positions = static_cast<double>(found_.reports.size());
    Matrix2d compliance = Matrix2d::Zero();
    for (std::size_t i = 0; i < found_.reports.size(); ++i) {
      if (!found_.reports[i].converged)
        throw std::runtime_error("load sharing: " + found_.reports[i].message);
      compliance += compliance_of(found_.stiffness[i]) / positions;
    }
    Give give{found_.displacement.rowwise().mean().matrix(), compliance};
    if (geometry_.rim) teeth_.add(share, mean_waves(found_.states), drivetrain_.bearings_per_planet, give);
    std::swap(pitches_[planet], found_);
    return give;
  }

  // The displacement of the pin is in the support's stiffness.
  Give give_on_pin(std::size_t planet, const bearing::OperatingPoint& point, double share) {
    std::optional<bearing::laminae::PlanetOnPinResult>& near =
        seated_[planet] ? seated_[planet] : seated_.front();
    const Eigen::Vector2d couple = Eigen::Vector2d(duty_.gears.overturning_moment, 0.0) + duty_.couple;
    bearing::laminae::PlanetOnPinResult found =
        tilting_planet(*on_pin_, point, share * couple, options_, near ? &*near : nullptr);
    const double bearings = drivetrain_.bearings_per_planet;
    Give give{found.shift, bearings * found.compliance.topLeftCorner<2, 2>()};
    give.compliance.col(1) +=
        bearings / duty_.gears.tangential_force * found.compliance.block<2, 2>(0, 2) * couple;
    if (geometry_.rim) teeth_.add(share, mean_waves(found.states), bearings, give);
    seated_[planet] = std::move(found);
    return give;
  }

  const PlanetaryDrivetrain& drivetrain_;
  const DrivetrainGeometry& geometry_;
  BearingDuty duty_;
  bearing::QuasiStaticOptions options_;
  TeethOnRim teeth_;
  bearing::vectorised::PitchSearch search_;
  std::optional<bearing::laminae::PlanetOnPin> on_pin_;  // where its tilt is computed
  std::vector<PitchResults> pitches_;                    // (planets)  their last equilibria
  std::vector<std::optional<bearing::laminae::PlanetOnPinResult>> seated_;  // (planets)  the same
  PitchResults found_;
};

// Fixed point of a map, with its slope from the last steps: Anderson's mixing of type II.
class Mixing {
 public:
  /// The next argument after the map of `tried` was `found`.
  VectorXd next(const VectorXd& tried, const VectorXd& found) {
    const VectorXd change = found - tried;
    if (before_ && change.norm() > before_->change.norm()) forget();  // flanks parted or met
    if (before_) remember(change - before_->change, found - before_->found);
    before_ = Step{found, change};
    if (kept_ == 0) return found;
    const auto changes = changes_.leftCols(kept_), results = results_.leftCols(kept_);
    return found - results * mechanics::least_squares(changes, change);
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
    const Eigen::Index position = kept_ < most ? kept_++ : oldest_++ % most;
    changes_.col(position) = change;
    results_.col(position) = result;
  }

  std::optional<Step> before_;
  MatrixXd changes_, results_;
  Eigen::Index kept_ = 0, oldest_ = 0;
};

void require_gears(const PlanetaryDrivetrain& drivetrain) {
  if (!drivetrain.gear_set)
    throw std::invalid_argument(
        "planets that load unevenly: found gears that cannot move; required: one set with teeth");
}

// The torques of the three members are in equilibrium: springs against their rotation carry nothing, and are
// left out, so that not even the last digit depends on them.
void hold_against_rotation(gearset::dynamics::SetParameters& set, gearset::Member fixed) {
  const auto hold = [&](gearset::dynamics::Support& support, gearset::Member member) {
    support.torsional_stiffness = 0.0;
    support.held_in_rotation = member == fixed;
  };
  hold(set.sun.support, gearset::Member::sun);
  hold(set.ring.support, gearset::Member::ring);
  hold(set.carrier.support, gearset::Member::carrier);
}

// The equilibrium does not depend on the springs that lead to it: they are those of the bearings whatever the
// case states for them, so that not even its last digit does.
SetModel on_springs(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                    double stiffness) {
  gearset::dynamics::SetParameters set = drivetrain.gear_set();
  set.planet.coupled_bearing = false;
  set.planet.bearing_stiffness = stiffness;
  hold_against_rotation(set, drivetrain.set.fixed_member);
  return gearset::dynamics::set_model(std::move(set), set_operation(drivetrain, geometry.gears));
}

// The set at rest under its mean loads on springs whose pins are displaced.
struct AtRest {
  Eigen::VectorXd state;
  Matrix2Xd forces;  // [N]  of the bearings on each planet (2, planets)
};

AtRest at_rest(StaticSet& set, const Matrix2Xd& offset) {
  VectorXd state = set.at(offset);
  Matrix2Xd forces = set.bearing_forces(state, offset);
  return {std::move(state), std::move(forces)};
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
  Matrix2Xd offset;  // [m]  of the pins
  AtRest now;
};

double largest_change(const Matrix2Xd& before, const Matrix2Xd& now) {
  return (now - before).colwise().norm().maxCoeff() / now.colwise().norm().maxCoeff();
}

// Forces at equilibrium of the gears on bearings that deflect along their tangents at the forces `tried`:
// only a start for the next round, and the same search without a bearing in it. On flanks that stay in
// contact it is linear, and one step of Newton's method ends it; where they change, mixing follows. Forces
// after kTangentRounds where it does not end.
Matrix2Xd balanced_on_tangents(StaticSet& set, double stiffness, const std::vector<Give>& gives,
                               const Matrix2Xd& tried, const Matrix2Xd& first) {
  Matrix2Xd at = tried, found = first, offset(2, tried.cols());
  MatrixXd offset_by_force = MatrixXd::Zero(tried.size(), tried.size());
  for (Eigen::Index i = 0; i < tried.cols(); ++i)
    offset_by_force.block<2, 2>(2 * i, 2 * i) =
        Matrix2d::Identity() / stiffness - gives[static_cast<std::size_t>(i)].compliance;
  Mixing mixing;
  for (int round = 0; round < kTangentRounds && largest_change(at, found) > kSameTangentForce; ++round) {
    if (round < kLinearRounds) {
      const MatrixXd follows =
          MatrixXd::Identity(tried.size(), tried.size()) - set.forces_by_offset() * offset_by_force;
      at.reshaped() += mechanics::solution(follows, (found - at).reshaped());
    } else {
      at.reshaped() = mixing.next(at.reshaped(), found.reshaped());
    }
    for (Eigen::Index i = 0; i < at.cols(); ++i) {
      const Give& give = gives[static_cast<std::size_t>(i)];
      offset.col(i) =
          give.displacement - give.compliance * (at.col(i) - tried.col(i)) + at.col(i) / stiffness;
    }
    found = at_rest(set, offset).forces;
  }
  return found;
}

// Newton's method in the bearings' tangents; where that does not end, rollers that come and go, by mixing.
OnSprings balanced(const SetModel& model, double stiffness, PlanetSupport& support) {
  StaticSet set(model);
  Matrix2Xd offset = Matrix2Xd::Zero(2, static_cast<Eigen::Index>(model.bearings.size()));
  AtRest now = at_rest(set, offset);
  Matrix2Xd tried = now.forces;
  std::vector<Give> gives(static_cast<std::size_t>(tried.cols()));
  Mixing mixing;
  double change = 0.0;
  for (int round = 0; round < kMostRounds; ++round) {
    for (Eigen::Index i = 0; i < tried.cols(); ++i) {
      Give& give = gives[static_cast<std::size_t>(i)];
      give = support.give(static_cast<std::size_t>(i), tried.col(i));
      offset.col(i) = give.displacement + tried.col(i) / stiffness;
    }
    now = at_rest(set, offset);
    change = largest_change(tried, now.forces);
    if (change <= kSameForce) return {std::move(offset), std::move(now)};
    if (round < kNewtonRounds)
      tried = balanced_on_tangents(set, stiffness, gives, tried, now.forces);
    else
      tried.reshaped() = mixing.next(tried.reshaped(), now.forces.reshaped());
  }
  std::ostringstream text;
  text << "load sharing: after " << kMostRounds << " rounds the planets' loads still change by " << change
       << " of the largest; required: bearings and gears that find a static equilibrium";
  throw std::runtime_error(text.str());
}

// Duties of one bearing of each planet that carries such a share of the mean load.
std::vector<BearingDuty> duties_with_shares(const PlanetaryDrivetrain& drivetrain,
                                            const DrivetrainGeometry& geometry,
                                            const std::vector<double>& shares) {
  const BearingDuty even = bearing_duty(drivetrain, geometry);
  std::vector<BearingDuty> duties;
  for (const double share : shares) {
    BearingDuty duty = even;
    duty.planet = static_cast<int>(duties.size());
    duty.gears = gears_with_share(even.gears, share);
    const Vector2d more(duty.gears.radial_force - even.gears.radial_force,
                        duty.gears.tangential_force - even.gears.tangential_force);
    duty.point.bore_load += more / drivetrain.bearings_per_planet;
    duty.point.bore_tilt = bore_tilt(drivetrain.misalignment, duty.point.bore_load);
    duty.point.outer_race = outer_race(drivetrain, geometry, duty.gears);
    duties.push_back(duty);
  }
  return duties;
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
  const SetModel set = on_springs(drivetrain, geometry, stiffness);
  PlanetSupport support(drivetrain, geometry, even);
  OnSprings found = balanced(set, stiffness, support);
  return {shares_at(set, found.now.state, even), std::move(found.now.forces), std::move(found.offset),
          stiffness, support.pitches()};
}

std::vector<BearingDuty> planet_duties(const PlanetaryDrivetrain& drivetrain,
                                       const DrivetrainGeometry& geometry) {
  if (!drivetrain.uneven_planets) return {bearing_duty(drivetrain, geometry)};
  const PlanetBalance balance = planet_balance(drivetrain, geometry);
  std::vector<BearingDuty> duties = duties_with_shares(drivetrain, geometry, balance.shares);
  for (std::size_t i = 0; i < balance.pitches.size(); ++i) duties[i].near = balance.pitches[i];
  return duties;
}

}  // namespace orbearing::analysis
