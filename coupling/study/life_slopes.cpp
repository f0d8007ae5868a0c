#include "coupling/study/life_slopes.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "bearing/life/lamina_life.hpp"
#include "bearing/life/lundberg_palmgren.hpp"
#include "coupling/study/tilting_planet.hpp"

namespace orbearing::study {

namespace {

using bearing::Race;
using bearing::laminae::BalanceNumbers;
using bearing::laminae::BalanceSetting;
using bearing::laminae::LaminaSlopes;
using LoadsOfBearings = std::vector<std::vector<LaminaSlopes>>;  // (cage angles, bearings)

constexpr double kByMean = 9.0 / 8.0;  // power of the damage over the mean of fourth powers
constexpr double kWeibullSlope = 9.0 / 8.0;
constexpr double kByCapacity = 4.5;  // power of the damage over the capacity
constexpr Eigen::Index kOfLife = 3;  // ln of both capacities and of the speed

Eigen::Vector<double, kOfLife> life_numbers(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty) {
  const bearing::Bearing& b = drivetrain.bearing;
  return {std::log(bearing::contact_capacity(b, Race::inner, drivetrain.lambda)),
          std::log(bearing::contact_capacity(b, Race::outer, drivetrain.lambda)),
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

}  // namespace

LifeSlopes::LifeSlopes(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry) {
  if (drivetrain.uneven_planets)
    throw std::invalid_argument("slopes of a life: found planets that load unevenly; required: all alike");
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  bearing::require_equal_pitches(drivetrain.bearing);
  if (drivetrain.seats.tilt == TiltState::computed)
    balance_planet(drivetrain, duty);
  else
    balance_rings(drivetrain, geometry, duty);
  rate(drivetrain);
  log_life_ -= life_numbers(drivetrain, duty)[2];
}

void LifeSlopes::balance_rings(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                               const BearingDuty& duty) {
  const bearing::QuasiStaticOptions options = quasi_static_options(drivetrain);
  const bearing::Bearing& b = drivetrain.bearing;
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
      near = bearing::laminae::lamina_state(*cut, duty.point, options, position.first_roller,
                                            i == 0 ? nullptr : &near);
      require(near.report);
      displacement = near.displacement;
      waves = near.waves;
      rollers = bearing::laminae::roller_places(near);
    } else {
      const bearing::RaceEquilibrium problem =
          bearing::quasi_static_problem(b, geometry.bearing, duty.point, options, position.first_roller);
      const bearing::QuasiStaticState state = bearing::solve(problem);
      require(state.report);
      displacement = state.displacement;
      waves = state.waves;
      rollers = bearing::laminae::roller_places(problem, state);
    }
    position.place.resize(2 + waves.size());
    position.place << displacement, waves;
    balances_.emplace_back(setting_at(drivetrain, geometry, duty, position),
                           std::vector<std::vector<bearing::laminae::RollerPlace>>{std::move(rollers)});
    positions_.push_back(std::move(position));
  }
}

void LifeSlopes::balance_planet(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty) {
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
    balances_.emplace_back(bearing::laminae::planet_setting(planet, point, overturning(duty), options,
                                                            position.first_roller, position.place),
                           rollers);
    positions_.push_back(std::move(position));
  }
}

void LifeSlopes::rate(const PlanetaryDrivetrain& drivetrain) {
  const bearing::life::LaminaRating rating = bearing::life::lamina_rating(
      drivetrain.bearing, bearing::life::LifeMeasure::lundberg_palmgren, drivetrain.lambda);
  LoadsOfBearings loads;
  for (const bearing::laminae::BalanceSlopes& balance : balances_) loads.push_back(balance.loads());
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

BalanceSetting LifeSlopes::setting_at(const PlanetaryDrivetrain& drivetrain,
                                      const DrivetrainGeometry& geometry, const BearingDuty& duty,
                                      const Position& position) const {
  return bearing::laminae::ring_setting(
      drivetrain.bearing,
      bearing::quasi_static_problem(drivetrain.bearing, geometry.bearing, duty.point,
                                    quasi_static_options(drivetrain), position.first_roller),
      duty.point, position.place);
}

Eigen::VectorXd LifeSlopes::numbers(const PlanetaryDrivetrain& drivetrain,
                                    const DrivetrainGeometry& geometry) const {
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  std::vector<BalanceNumbers> all;
  if (drivetrain.seats.tilt == TiltState::computed) {
    const bearing::laminae::PlanetOnPin planet = planet_of(drivetrain);
    for (const Position& position : positions_)
      all.push_back(bearing::laminae::planet_setting(planet, whole_planet(duty, planet.bearings.size()),
                                                     overturning(duty), quasi_static_options(drivetrain),
                                                     position.first_roller, position.place)
                        .numbers);
  } else {
    for (const Position& position : positions_)
      all.push_back(setting_at(drivetrain, geometry, duty, position).numbers);
  }
  Eigen::Index size = kOfLife;
  for (BalanceNumbers& one : all) size += count_of(one);
  Eigen::VectorXd flat(size);
  flat.head<kOfLife>() = life_numbers(drivetrain, duty);
  Eigen::Index at = kOfLife;
  for (BalanceNumbers& one : all)
    each_number(one, [&](const double* first, Eigen::Index count) {
      flat.segment(at, count) = Eigen::Map<const Eigen::VectorXd>(first, count);
      at += count;
    });
  return flat;
}

double LifeSlopes::slope(const Eigen::VectorXd& change) const {
  double sum =
      kByCapacity / kWeibullSlope * (inner_share_ * change[0] + outer_share_ * change[1]) - change[2];
  Eigen::Index at = kOfLife;
  for (std::size_t i = 0; i < balances_.size(); ++i) {
    BalanceNumbers along = balances_[i].numbers();
    each_number(along, [&](double* first, Eigen::Index count) {
      Eigen::Map<Eigen::VectorXd>(first, count) = change.segment(at, count);
      at += count;
    });
    const std::vector<LaminaSlopes> loads = balances_[i].along(along);
    for (std::size_t b = 0; b < loads.size(); ++b)
      sum += (by_load_[i][b].inner * loads[b].inner).sum() + (by_load_[i][b].outer * loads[b].outer).sum();
  }
  return sum;
}

}  // namespace orbearing::study
