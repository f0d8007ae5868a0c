#include "coupling/study/life_slopes.hpp"

#include <Eigen/LU>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "bearing/life/lamina_life.hpp"
#include "bearing/life/lundberg_palmgren.hpp"
#include "coupling/study/bearing_tangent.hpp"
#include "coupling/study/tilting_planet.hpp"
#include "mechanics/explicit_slope.hpp"

namespace orbearing::study {

namespace {

using bearing::Race;
using bearing::laminae::BalanceNumbers;
using bearing::laminae::BalanceSetting;
using bearing::laminae::BalanceSlopes;
using bearing::laminae::LaminaSlopes;
using LoadsOfBearings = std::vector<std::vector<LaminaSlopes>>;  // (cage angles, bearings)

constexpr double kByMean = 9.0 / 8.0;  // power of the damage over the mean of fourth powers
constexpr double kWeibullSlope = 9.0 / 8.0;
constexpr double kByCapacity = 4.5;  // power of the damage over the capacity
constexpr double kShareStep = 1e-3;  // [-]  of loads and shares: the longest of steps that are extrapolated
constexpr Eigen::Index kOfLife = 3;  // ln of both capacities and of the speed

Eigen::Vector<double, kOfLife> life_numbers(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty) {
  const bearing::Bearing& b = drivetrain.bearing;
  return {std::log(bearing::contact_capacity(b, Race::inner, drivetrain.reduction_factor)),
          std::log(bearing::contact_capacity(b, Race::outer, drivetrain.reduction_factor)),
          std::log(std::abs(bearing::turning_speed(b, duty.point)))};
}

// Damage of one race, and its slopes by the loads of all laminae put into `race` of `slopes`.
class RaceRating {
 public:
  RaceRating(const LoadsOfBearings& loads, Eigen::ArrayXXd LaminaSlopes::*race, const Eigen::ArrayXd& weight,
             bearing::RaceMotion motion)
      : race_(race), weight_(weight), standing_(motion == bearing::RaceMotion::standing) {
    bearings_ = static_cast<double>(loads.front().size());
    for (const std::vector<LaminaSlopes>& position : loads) {
      Eigen::ArrayXXd& means = means_.emplace_back();
      means = Eigen::ArrayXXd::Zero(weight.size(), (position.front().*race).cols());
      for (const LaminaSlopes& one : position) means += (one.*race).square().square() / bearings_;
      places_ += static_cast<double>(means.cols());
    }
    if (!standing_) share_all();
  }

  double damage() const {
    double sum = 0.0;
    for (const Eigen::ArrayXXd& means : means_)
      sum += (means.pow(kByMean).colwise() * weight_).sum() / places_;
    return sum;
  }

  void put_slopes(const LoadsOfBearings& loads, double factor, LoadsOfBearings& slopes) const {
    for (std::size_t position = 0; position < loads.size(); ++position) {
      const Eigen::ArrayXXd by_mean = (means_[position].pow(kByMean - 1.0).colwise() * weight_) *
                                      (factor * kByMean * 4.0 / (places_ * bearings_));
      for (std::size_t b = 0; b < loads[position].size(); ++b)
        slopes[position][b].*race_ = by_mean * (loads[position][b].*race_).cube();
    }
  }

 private:
  // A turning race meets all places alike.
  void share_all() {
    Eigen::ArrayXd mean = Eigen::ArrayXd::Zero(weight_.size());
    for (const Eigen::ArrayXXd& means : means_) mean += means.rowwise().sum() / places_;
    for (Eigen::ArrayXXd& means : means_) means.colwise() = mean;
  }

  Eigen::ArrayXXd LaminaSlopes::*race_;
  Eigen::ArrayXd weight_;
  bool standing_;
  double bearings_ = 0.0, places_ = 0.0;
  std::vector<Eigen::ArrayXXd> means_;  // [N^4]  (cage angles) of (laminae, rollers)
};

Eigen::Index count_of(BalanceNumbers& numbers) {
  Eigen::Index count = 0;
  each_number(numbers, [&](const double*, Eigen::Index size) { count += size; });
  return count;
}

bearing::OperatingPoint whole_planet(const BearingDuty& duty, std::size_t bearings) {
  bearing::OperatingPoint point = duty.point;
  point.bore_load *= static_cast<double>(bearings);
  return point;
}

Eigen::Vector2d overturning(const BearingDuty& duty) {
  return {duty.gears.overturning_moment, 0.0};
}

bearing::laminae::PlanetOnPin planet_of(const PlanetaryDrivetrain& drivetrain) {
  return planet_on(planet_seat(drivetrain), drivetrain.bearing, mechanics::InstructionSet::baseline);
}

void require(const bearing::SolverReport& report) {
  if (!report.converged) throw std::runtime_error(report.message);
}

// Numbers of a balance one after the other.
void append_to(Eigen::VectorXd& flat, BalanceNumbers numbers) {
  Eigen::Index at = flat.size();
  flat.conservativeResize(at + count_of(numbers));
  each_number(numbers, [&](const double* first, Eigen::Index count) {
    flat.segment(at, count) = Eigen::Map<const Eigen::VectorXd>(first, count);
    at += count;
  });
}

// The change of them that stands in `change` from `at` on, which goes on.
BalanceNumbers taken_from(const Eigen::Ref<const Eigen::VectorXd>& change, BalanceNumbers like,
                          Eigen::Index& at) {
  each_number(like, [&](double* first, Eigen::Index count) {
    Eigen::Map<Eigen::VectorXd>(first, count) = change.segment(at, count);
    at += count;
  });
  return like;
}

Eigen::VectorXd flattened(const PlanetBalance& balance) {
  Eigen::VectorXd flat(balance.forces.size() + static_cast<Eigen::Index>(balance.shares.size()));
  flat << balance.forces.reshaped(),
      Eigen::Map<const Eigen::VectorXd>(balance.shares.data(),
                                        static_cast<Eigen::Index>(balance.shares.size()));
  return flat;
}

}  // namespace

LifeSlopes::LifeSlopes(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry) {
  bearing::require_equal_pitches(drivetrain.bearing);
  if (drivetrain.uneven_planets) sharing_ = Sharing{.here = planet_balance(drivetrain, geometry)};
  const std::vector<BearingDuty> duties =
      sharing_ ? duties_with_shares(drivetrain, geometry, sharing_->here.shares)
               : std::vector<BearingDuty>{bearing_duty(drivetrain, geometry)};
  for (const BearingDuty& duty : duties)
    lives_.push_back(drivetrain.seats.tilt == TiltState::computed
                         ? balance_planet(drivetrain, duty)
                         : balance_rings(drivetrain, geometry, drivetrain.bearing, duty.point));
  rate(drivetrain);
  log_life_ -= life_numbers(drivetrain, duties.front())[2];
  if (sharing_) put_sharing(drivetrain, geometry);
}

LifeSlopes::Balances LifeSlopes::balance_rings(const PlanetaryDrivetrain& drivetrain,
                                               const DrivetrainGeometry& geometry, const bearing::Bearing& b,
                                               const bearing::OperatingPoint& point) {
  const bearing::QuasiStaticOptions options = quasi_static_options(drivetrain);
  Balances all;
  std::optional<bearing::laminae::LaminaBearing> cut;
  if (b.rollers().laminae > 0) cut.emplace(b, mechanics::InstructionSet::baseline);
  bearing::laminae::LaminaState near;
  const double pitch = boost::math::double_constants::two_pi / b.rollers().count;
  for (int i = 0; i < options.cage_positions; ++i) {
    Position position{.first_roller = options.first_roller + pitch * i / options.cage_positions};
    std::vector<bearing::laminae::RollerPlace> rollers;
    Eigen::VectorXd waves;
    Eigen::Vector2d displacement;
    if (cut) {
      near = bearing::laminae::lamina_state(*cut, point, options, position.first_roller,
                                            i == 0 ? nullptr : &near);
      require(near.report);
      displacement = near.displacement;
      waves = near.waves;
      rollers = bearing::laminae::roller_places(near);
    } else {
      const bearing::RaceEquilibrium problem =
          bearing::quasi_static_problem(b, geometry.bearing, point, options, position.first_roller);
      const bearing::QuasiStaticState state = bearing::solve(problem);
      require(state.report);
      displacement = state.displacement;
      waves = state.waves;
      rollers = bearing::laminae::roller_places(problem, state);
    }
    position.place.resize(2 + waves.size());
    position.place << displacement, waves;
    all.balances.emplace_back(setting_at(drivetrain, geometry, b, point, position),
                              std::vector<std::vector<bearing::laminae::RollerPlace>>{std::move(rollers)});
    all.positions.push_back(std::move(position));
  }
  return all;
}

LifeSlopes::Balances LifeSlopes::balance_planet(const PlanetaryDrivetrain& drivetrain,
                                                const BearingDuty& duty) {
  Balances all;
  const bearing::QuasiStaticOptions options = quasi_static_options(drivetrain);
  const bearing::laminae::PlanetOnPin planet = planet_of(drivetrain);
  const bearing::OperatingPoint point = whole_planet(duty, planet.bearings.size());
  const bearing::laminae::PlanetOnPinResult result =
      bearing::laminae::planet_on_pin_over_a_pitch(planet, point, overturning(duty), options);
  require(result.report);
  for (std::size_t i = 0; i < result.states.size(); ++i) {
    const bearing::laminae::PlanetOnPinState& state = result.states[i];
    Position position{.first_roller = result.bearings.front().angle[static_cast<Eigen::Index>(i)]};
    position.place = bearing::laminae::planet_place(planet, point, overturning(duty), options,
                                                    position.first_roller, state);
    std::vector<std::vector<bearing::laminae::RollerPlace>> rollers;
    for (const bearing::laminae::LaminaState& one : state.bearings)
      rollers.push_back(bearing::laminae::roller_places(one));
    all.balances.emplace_back(bearing::laminae::planet_setting(planet, point, overturning(duty), options,
                                                               position.first_roller, position.place),
                              rollers);
    all.positions.push_back(std::move(position));
  }
  return all;
}

void LifeSlopes::rate(const PlanetaryDrivetrain& drivetrain) {
  const bearing::life::LaminaRating rating = bearing::life::lamina_rating(
      drivetrain.bearing, bearing::life::LifeMeasure::lundberg_palmgren, drivetrain.reduction_factor);
  LoadsOfBearings loads;
  loads.resize(lives_.front().balances.size());
  for (const Balances& planet : lives_)
    for (std::size_t i = 0; i < loads.size(); ++i)
      for (LaminaSlopes& one : planet.balances[i].loads()) loads[i].push_back(std::move(one));
  const RaceRating inner(loads, &LaminaSlopes::inner, rating.inner_weight, rating.motions.inner);
  const RaceRating outer(loads, &LaminaSlopes::outer, rating.outer_weight, rating.motions.outer);
  const double damage = inner.damage() + outer.damage();
  if (!(damage > 0.0))
    throw std::runtime_error("sensitivities: found a bearing without load; its life is without end");
  inner_share_ = inner.damage() / damage;
  outer_share_ = outer.damage() / damage;
  by_load_ = loads;
  inner.put_slopes(loads, -1.0 / (kWeibullSlope * damage), by_load_);
  outer.put_slopes(loads, -1.0 / (kWeibullSlope * damage), by_load_);
  log_life_ = std::log(bearing::hours(bearing::life::life_of_damage(damage), 1.0));
}

// Central differences of explicit maps are exact but for round-off: the set on springs is linear where no
// flank parts, and the point of a bearing follows its load by closed forms.
void LifeSlopes::put_sharing(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry) {
  const BearingDuty even = bearing_duty(drivetrain, geometry);
  const bearing::Bearing like = of_like_rollers(drivetrain.bearing);
  const PlanetBalance& here = sharing_->here;
  const Eigen::Index planets = here.forces.cols();
  sharing_->displacement_by_force =
      Eigen::MatrixXd::Identity(2 * planets, 2 * planets) *
      (1.0 / here.stiffness - 1.0 / (drivetrain.bearings_per_planet * drivetrain.dynamics.support.stiffness));
  sharing_->forces_by_offset.resize(2 * planets, 2 * planets);
  sharing_->shares_by_offset.resize(planets, 2 * planets);
  constexpr double kOffset = 1e-7;  // [m]
  for (Eigen::Index i = 0; i < 2 * planets; ++i) {
    const auto at = [&](double more) {
      Eigen::Matrix2Xd offset = here.offset;
      offset.reshaped()[i] += more;
      return flattened(balance_on_springs(drivetrain, geometry, offset, here.stiffness));
    };
    const Eigen::VectorXd slope = (at(kOffset) - at(-kOffset)) / (2.0 * kOffset);
    sharing_->forces_by_offset.col(i) = slope.head(2 * planets);
    sharing_->shares_by_offset.col(i) = slope.tail(planets);
  }
  for (Eigen::Index planet = 0; planet < planets; ++planet) {
    const Eigen::Vector2d force = here.forces.col(planet);
    sharing_->supports.push_back(
        balance_rings(drivetrain, geometry, like, point_under(drivetrain, even, force)));
    const Balances& support = sharing_->supports.back();
    const double part = 1.0 / static_cast<double>(support.positions.size());
    for (std::size_t i = 0; i < support.positions.size(); ++i)
      for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const auto at = [&](double more) {
          const Eigen::Vector2d other = force + more * Eigen::Vector2d::Unit(axis);
          Eigen::VectorXd flat;
          append_to(flat, setting_at(drivetrain, geometry, like, point_under(drivetrain, even, other),
                                     support.positions[i])
                              .numbers);
          return flat;
        };
        const Eigen::VectorXd slope = mechanics::central_slope(at, at(0.0), kShareStep * force.norm()).slope;
        Eigen::Index from = 0;
        sharing_->displacement_by_force.block<2, 1>(2 * planet, 2 * planet + axis) +=
            part *
            support.balances[i].rings_along(taken_from(slope, support.balances[i].numbers(), from)).head<2>();
      }
  }
  sharing_->life_by_share.resize(planets);
  const Eigen::VectorXd numbers = numbers_with(drivetrain, geometry, here.shares);
  for (Eigen::Index planet = 0; planet < planets; ++planet) {
    const auto at = [&](double more) {
      std::vector<double> shares = here.shares;
      shares[static_cast<std::size_t>(planet)] += more;
      return numbers_with(drivetrain, geometry, shares);
    };
    Eigen::Index from = 0;
    sharing_->life_by_share[planet] =
        slope_with_shares(mechanics::central_slope(at, numbers, kShareStep).slope, from);
  }
}

BalanceSetting LifeSlopes::setting_at(const PlanetaryDrivetrain& drivetrain,
                                      const DrivetrainGeometry& geometry, const bearing::Bearing& bearing,
                                      const bearing::OperatingPoint& point, const Position& position) {
  return bearing::laminae::ring_setting(
      bearing,
      bearing::quasi_static_problem(bearing, geometry.bearing, point, quasi_static_options(drivetrain),
                                    position.first_roller),
      point, position.place);
}

Eigen::VectorXd LifeSlopes::numbers(const PlanetaryDrivetrain& drivetrain,
                                    const DrivetrainGeometry& geometry) const {
  if (!sharing_) return numbers_with(drivetrain, geometry, {1.0});
  const Eigen::VectorXd of_life = numbers_with(drivetrain, geometry, sharing_->here.shares),
                        of_sharing = sharing_numbers(drivetrain, geometry);
  Eigen::VectorXd all(of_life.size() + of_sharing.size());
  all << of_life, of_sharing;
  return all;
}

// With the shares as they are here.
Eigen::VectorXd LifeSlopes::numbers_with(const PlanetaryDrivetrain& drivetrain,
                                         const DrivetrainGeometry& geometry,
                                         const std::vector<double>& shares) const {
  const std::vector<BearingDuty> duties = sharing_
                                              ? duties_with_shares(drivetrain, geometry, shares)
                                              : std::vector<BearingDuty>{bearing_duty(drivetrain, geometry)};
  Eigen::VectorXd flat = life_numbers(drivetrain, duties.front());
  for (std::size_t k = 0; k < duties.size(); ++k) {
    const BearingDuty& duty = duties[k];
    if (drivetrain.seats.tilt == TiltState::computed) {
      const bearing::laminae::PlanetOnPin planet = planet_of(drivetrain);
      for (const Position& position : lives_[k].positions)
        append_to(flat, bearing::laminae::planet_setting(planet, whole_planet(duty, planet.bearings.size()),
                                                         overturning(duty), quasi_static_options(drivetrain),
                                                         position.first_roller, position.place)
                            .numbers);
    } else {
      for (const Position& position : lives_[k].positions)
        append_to(flat, setting_at(drivetrain, geometry, drivetrain.bearing, duty.point, position).numbers);
    }
  }
  return flat;
}

// With forces and offsets as they are here: the balances of the bearings, how far the pins' supports give
// way, forces and shares of the set on its springs.
Eigen::VectorXd LifeSlopes::sharing_numbers(const PlanetaryDrivetrain& drivetrain,
                                            const DrivetrainGeometry& geometry) const {
  const PlanetBalance& here = sharing_->here;
  const BearingDuty even = bearing_duty(drivetrain, geometry);
  const bearing::Bearing like = of_like_rollers(drivetrain.bearing);
  Eigen::VectorXd flat;
  for (std::size_t planet = 0; planet < sharing_->supports.size(); ++planet) {
    const bearing::OperatingPoint point =
        point_under(drivetrain, even, here.forces.col(static_cast<Eigen::Index>(planet)));
    for (const Position& position : sharing_->supports[planet].positions)
      append_to(flat, setting_at(drivetrain, geometry, like, point, position).numbers);
  }
  const Eigen::VectorXd pins = -here.forces.reshaped() /
                               (drivetrain.bearings_per_planet * drivetrain.dynamics.support.stiffness),
                        set =
                            flattened(balance_on_springs(drivetrain, geometry, here.offset, here.stiffness));
  const Eigen::Index at = flat.size();
  flat.conservativeResize(at + pins.size() + set.size());
  flat.tail(pins.size() + set.size()) << pins, set;
  return flat;
}

double LifeSlopes::slope_with_shares(Eigen::Ref<const Eigen::VectorXd> change, Eigen::Index& at) const {
  double sum = kByCapacity / kWeibullSlope * (inner_share_ * change[at] + outer_share_ * change[at + 1]) -
               change[at + 2];
  at += kOfLife;
  std::size_t first = 0;
  for (const Balances& planet : lives_) {
    std::size_t bearings = 0;
    for (std::size_t i = 0; i < planet.balances.size(); ++i) {
      const BalanceSlopes& balance = planet.balances[i];
      const std::vector<LaminaSlopes> loads = balance.along(taken_from(change, balance.numbers(), at));
      bearings = loads.size();
      for (std::size_t b = 0; b < bearings; ++b)
        sum += (by_load_[i][first + b].inner * loads[b].inner).sum() +
               (by_load_[i][first + b].outer * loads[b].outer).sum();
    }
    first += bearings;
  }
  return sum;
}

// Eq. (23).
Eigen::VectorXd LifeSlopes::shares_along(Eigen::Ref<const Eigen::VectorXd> change, Eigen::Index& at) const {
  const Eigen::Index planets = sharing_->here.forces.cols();
  Eigen::VectorXd displacement = Eigen::VectorXd::Zero(2 * planets);
  for (Eigen::Index planet = 0; planet < planets; ++planet) {
    const Balances& support = sharing_->supports[static_cast<std::size_t>(planet)];
    for (const BalanceSlopes& balance : support.balances)
      displacement.segment<2>(2 * planet) +=
          balance.rings_along(taken_from(change, balance.numbers(), at)).head<2>() /
          static_cast<double>(support.balances.size());
  }
  displacement += change.segment(at, 2 * planets);
  const Eigen::VectorXd forces = change.segment(at + 2 * planets, 2 * planets),
                        shares = change.segment(at + 4 * planets, planets);
  at += 5 * planets;
  const Eigen::MatrixXd follows = Eigen::MatrixXd::Identity(2 * planets, 2 * planets) -
                                  sharing_->displacement_by_force * sharing_->forces_by_offset;
  const Eigen::VectorXd offset =
      follows.partialPivLu().solve(displacement + sharing_->displacement_by_force * forces);
  return shares + sharing_->shares_by_offset * offset;
}

double LifeSlopes::slope(const Eigen::VectorXd& change) const {
  Eigen::Index at = 0;
  const double by_numbers = slope_with_shares(change, at);
  return sharing_ ? by_numbers + sharing_->life_by_share.dot(shares_along(change, at)) : by_numbers;
}

}  // namespace orbearing::study
