#include "bearing/equilibrium/planet_on_pin.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "bearing/equilibrium/lamina_stiffness.hpp"
#include "bearing/plane.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::bearing::laminae {

namespace {

using Eigen::Index;
using Eigen::Vector2d;
using SeatPlaces = Eigen::VectorXd;

// Coordinates, all lengths: displacement of the planet, its tilt times the lever, then of each bearing's seat
// on the pin its displacement and its slope times the lever.
constexpr Index kTiltAt = 2, kPinAt = 4, kPerSeat = 4;

struct PinnedPlanet {
  const PlanetOnPin& planet;
  std::vector<RaceEquilibrium> races;  // (bearings)
  Vector2d load, moment;
  double lever = 0.0;                            // [m]
  std::array<Eigen::MatrixXd, 2> pin_stiffness;  // of displacements and slopes, along x and y
  std::vector<LaminaState>& states;

  Index size() const { return kPinAt + kPerSeat * static_cast<Index>(planet.bearings.size()); }
  static Index pin_of(std::size_t bearing) { return kPinAt + kPerSeat * static_cast<Index>(bearing); }
  Vector2d error(std::size_t k) const {
    return planet.pin_error.empty() ? Vector2d::Zero() : planet.pin_error[k];
  }
  Vector2d inclination(std::size_t k) const {
    return planet.pin_inclination.empty() ? Vector2d::Zero() : planet.pin_inclination[k];
  }
  Vector2d displacement(std::size_t k, const SeatPlaces& at) const {
    return at.head<2>() + at.segment<2>(kTiltAt) * (planet.place[k] / lever) - at.segment<2>(pin_of(k)) -
           error(k);
  }
  Vector2d tilt(std::size_t k, const SeatPlaces& at) const {
    return (at.segment<2>(kTiltAt) - at.segment<2>(pin_of(k) + 2)) / lever - inclination(k);
  }
  double scale() const {
    double largest = std::max(load.norm(), moment.norm() / lever);
    for (const RaceEquilibrium& one : races) largest = std::max(largest, one.inertial_load.abs().maxCoeff());
    return largest;
  }

  mechanics::Imbalance<Eigen::Dynamic> operator()(const SeatPlaces& at) const {
    mechanics::Imbalance<Eigen::Dynamic> sum;
    sum.force.setZero(size());
    sum.stiffness.setZero(size(), size());
    sum.scale = scale();
    sum.force.head<2>() = load;
    sum.force.segment<2>(kTiltAt) = (moment - planet.tilt_stiffness * at.segment<2>(kTiltAt) / lever) / lever;
    sum.stiffness.block<2, 2>(kTiltAt, kTiltAt) += planet.tilt_stiffness / (lever * lever);
    for (std::size_t k = 0; k < races.size(); ++k) {
      sum.force.head<2>() += races[k].load;  // what reaches the ring through the cage
      sum.force.segment<2>(kTiltAt) += races[k].load * (planet.place[k] / lever);
    }
    add_pin(at, sum);
    for (std::size_t k = 0; k < races.size(); ++k) add_bearing(k, at, sum);
    return sum;
  }

  // Coordinates by approach (outward) and end displacement of roller `j` of a bearing.
  Eigen::Matrix<double, Eigen::Dynamic, 2> moves(std::size_t k, Index j) const {
    const Vector2d e = direction(races[k].angle[j]);
    Eigen::Matrix<double, Eigen::Dynamic, 2> all = Eigen::MatrixXd::Zero(size(), 2);
    all.col(0).head<2>() = e;
    all.col(0).segment<2>(kTiltAt) = e * (planet.place[k] / lever);
    all.col(0).segment<2>(pin_of(k)) = -e;
    all.col(1).segment<2>(kTiltAt) = e * (planet.bearings[k].half_length() / lever);
    all.col(1).segment<2>(pin_of(k) + 2) = -all.col(1).segment<2>(kTiltAt);
    return all;
  }

  // Displacements of all seats stand before all slopes in the pin's own matrix.
  void add_pin(const SeatPlaces& at, mechanics::Imbalance<Eigen::Dynamic>& sum) const {
    const auto count = static_cast<Index>(races.size());
    const auto coordinate = [&](Index i, Index axis) {
      return kPinAt + kPerSeat * (i % count) + (i < count ? 0 : 2) + axis;
    };
    const auto unit = [&](Index i) { return i < count ? 1.0 : 1.0 / lever; };  // of slopes: rad by length
    for (Index i = 0; i < 2 * count; ++i)
      for (Index j = 0; j < 2 * count; ++j)
        for (Index axis = 0; axis < 2; ++axis) {
          const double stiffness = unit(i) * unit(j) * pin_stiffness[static_cast<std::size_t>(axis)](i, j);
          sum.stiffness(coordinate(i, axis), coordinate(j, axis)) += stiffness;
          sum.force[coordinate(i, axis)] -= stiffness * at[coordinate(j, axis)];
        }
  }

  void add_bearing(std::size_t k, const SeatPlaces& at, mechanics::Imbalance<Eigen::Dynamic>& sum) const {
    const LaminaBearing& bearing = planet.bearings[k];
    const RaceEquilibrium& race = races[k];
    LaminaState& state = states[k];
    const SettlingRollers rollers(bearing, race, state.rollers);
    state.displacement = displacement(k, at);
    const Vector2d relative = tilt(k, at);
    for (Index j = 0; j < race.angle.size(); ++j) {
      const double end_displacement = bearing.half_length() * relative.dot(direction(race.angle[j]));
      const RollerState& one = rollers.settle(j, race.approach(j, state.displacement), end_displacement);
      const Eigen::Matrix<double, Eigen::Dynamic, 2> by = moves(k, j);
      sum.force += by * Vector2d(one.outer.load, one.outer.end_load);
      sum.stiffness += by * roller_stiffness(one) * by.transpose();
    }
  }
};

PinnedPlanet pinned(const PlanetOnPin& planet, const OperatingPoint& point, const Vector2d& moment,
                    const QuasiStaticOptions& options, double first_roller,
                    std::vector<LaminaState>& states) {
  const Eigen::MatrixXd& along_y =
      planet.tangential_compliance.size() > 0 ? planet.tangential_compliance : planet.pin_compliance;
  PinnedPlanet problem{
      planet, {}, point.bore_load, moment, 0.0, {planet.pin_compliance.inverse(), along_y.inverse()}, states};
  OperatingPoint unloaded = point;
  unloaded.bore_load.setZero();
  for (std::size_t k = 0; k < planet.bearings.size(); ++k) {
    const LaminaBearing& bearing = planet.bearings[k];
    problem.races.push_back(
        quasi_static_problem(bearing.bearing(), bearing.geometry(), unloaded, options, first_roller));
    problem.lever = std::max({problem.lever, std::abs(planet.place[k]), bearing.half_length()});
    states[k].angle = problem.races[k].angle;
    states[k].rollers.resize(static_cast<std::size_t>(states[k].angle.size()));
  }
  return problem;
}

// Where the load would displace the stiffest share of it: each bearing under its part.
SeatPlaces start_of(const PinnedPlanet& problem) {
  SeatPlaces at = SeatPlaces::Zero(problem.size());
  RaceEquilibrium one = problem.races.front();
  one.load = problem.load / static_cast<double>(problem.races.size());
  at.head<2>() = first_displacement(one);
  return at;
}

SeatPlaces start_near(const PinnedPlanet& problem, const PlanetOnPinState& near) {
  SeatPlaces at(problem.size());
  at.head<2>() = near.displacement;
  at.segment<2>(kTiltAt) = near.tilt * problem.lever;
  for (std::size_t k = 0; k < problem.races.size(); ++k) {
    const Index pin = PinnedPlanet::pin_of(k);
    at.segment<2>(pin) = near.displacement + near.tilt * problem.planet.place[k] - problem.error(k) -
                         near.bearings[k].displacement;
    at.segment<2>(pin + 2) = problem.lever * (near.tilt - near.bearing_tilt[k] - problem.inclination(k));
  }
  return at;
}

mechanics::SearchLimits limits_of(const PinnedPlanet& problem) {
  mechanics::SearchLimits limits;
  for (std::size_t k = 0; k < problem.races.size(); ++k) {
    RaceEquilibrium one = problem.races[k];
    one.load += problem.load;
    const mechanics::SearchLimits own = search_limits(one);
    const LaminaBearing& bearing = problem.planet.bearings[k];
    const double more =
        2.0 * largest_drop(bearing) + problem.error(k).norm() + problem.lever * problem.inclination(k).norm();
    limits.reach = std::max(limits.reach, own.reach + more);
    limits.size = std::max(limits.size, own.size + own.reach + more);
  }
  return limits;
}

}  // namespace

PlanetOnPinState planet_on_pin(const PlanetOnPin& planet, const OperatingPoint& point, const Vector2d& moment,
                               const QuasiStaticOptions& options, double first_roller,
                               const PlanetOnPinState* near) {
  mechanics::require(!planet.bearings.empty() && planet.bearings.size() == planet.place.size(),
                     "bearings of a planet", planet.place.size(), "at least one, each with its place");
  mechanics::require(point.outer_race.is_rigid(), "outer race", "elastic",
                     "a rigid one where the tilt is computed");
  PlanetOnPinState state;
  state.bearings.resize(planet.bearings.size());
  if (near != nullptr)
    for (std::size_t k = 0; k < state.bearings.size(); ++k)
      state.bearings[k].rollers = near->bearings[k].rollers;
  const PinnedPlanet problem = pinned(planet, point, moment, options, first_roller, state.bearings);
  SeatPlaces at = near != nullptr ? start_near(problem, *near) : start_of(problem);
  mechanics::Imbalance<Eigen::Dynamic> now;
  const mechanics::SearchReport search = mechanics::find_balance<Eigen::Dynamic>(
      [&](const SeatPlaces& place) { return problem(place); }, limits_of(problem), at, now);
  state.displacement = at.head<2>();
  state.tilt = at.segment<2>(kTiltAt) / problem.lever;
  state.report = {search};
  for (std::size_t k = 0; k < state.bearings.size(); ++k) {
    state.bearing_tilt.push_back(problem.tilt(k, at));
    LaminaState& one = state.bearings[k];
    one.moment = moment_on_bore(planet.bearings[k], one);
    state.report.converged = state.report.converged && are_settled(one.rollers);
  }
  if (!state.report.converged) {
    std::ostringstream text;
    text << "the planet found no balance on its pin under " << problem.load.norm()
         << " N: " << search.residual << " N remain; check clearances, profiles, the pin and its errors";
    state.report.message = text.str();
  }
  for (LaminaState& one : state.bearings) one.report = state.report;
  return state;
}

PlanetOnPinResult planet_on_pin_over_a_pitch(const PlanetOnPin& planet, const OperatingPoint& point,
                                             const Vector2d& moment, const QuasiStaticOptions& options) {
  PlanetOnPinResult result;
  for (const LaminaBearing& bearing : planet.bearings) {
    require_equal_pitches(bearing.bearing());
    result.bearings.push_back(empty_result(bearing, point, options));
    result.bearings.back().total_bore_load.setZero();
  }
  result.bearing_tilt.assign(planet.bearings.size(), Vector2d::Zero());
  result.report.converged = true;
  const int positions = options.cage_positions;
  PlanetOnPinState last;
  for (int position = 0; position < positions; ++position) {
    last = planet_on_pin(planet, point, moment, options, result.bearings.front().angle[position],
                         position == 0 ? nullptr : &last);
    keep_worst(last.report, result.report);
    result.tilt += last.tilt / positions;
    result.states.push_back(last);
    for (std::size_t k = 0; k < planet.bearings.size(); ++k) {
      LaminaResult& one = result.bearings[k];
      result.bearing_tilt[k] += last.bearing_tilt[k] / positions;
      one.total_bore_load -= force_on_bore(last.bearings[k]) / positions;
      put_position(planet.bearings[k], last.bearings[k], position, positions, one);
    }
  }
  for (LaminaResult& one : result.bearings) one.report = result.report;
  return result;
}

}  // namespace orbearing::bearing::laminae
