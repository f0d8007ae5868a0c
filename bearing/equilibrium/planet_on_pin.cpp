#include "bearing/equilibrium/planet_on_pin.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <sstream>

#include "bearing/equilibrium/elastic_waves.hpp"
#include "bearing/plane.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/force_left.hpp"
#include "mechanics/linear_algebra.hpp"

namespace orbearing::bearing::laminae {

namespace {

using Eigen::Index;
using Eigen::Vector2d;

// Coordinates, all lengths: displacement of the planet, its tilt times the lever, then of each bearing's seat
// on the pin its displacement and its slope times the lever, last the waves of an elastic planet.
constexpr Index kTiltAt = 2, kPinAt = 4, kPerSeat = 4;

Index pin_of(std::size_t bearing) {
  return kPinAt + kPerSeat * static_cast<Index>(bearing);
}

Index waves_of(const PlanetOnPin& planet) {
  return pin_of(planet.bearings.size());
}

Vector2d error_of(const PlanetOnPin& planet, std::size_t k) {
  return planet.pin_error.empty() ? Vector2d::Zero() : planet.pin_error[k];
}

Vector2d inclination_of(const PlanetOnPin& planet, std::size_t k) {
  return planet.pin_inclination.empty() ? Vector2d::Zero() : planet.pin_inclination[k];
}

// Part of the planet's load, which acts in the middle of its face, on each bearing [N].
Vector2d load_share(const PlanetOnPin& planet, const OperatingPoint& point) {
  return point.bore_load / static_cast<double>(planet.bearings.size());
}

// The bearings with all coordinates zero, on a pin with a position error; each under its part of the load.
std::vector<RaceEquilibrium> bearings_on(const PlanetOnPin& planet, const OperatingPoint& point,
                                         const QuasiStaticOptions& options, double first_roller) {
  std::vector<RaceEquilibrium> races;
  OperatingPoint unloaded = point;
  unloaded.bore_load.setZero();
  for (std::size_t k = 0; k < planet.bearings.size(); ++k) {
    unloaded.bore_tilt = -inclination_of(planet, k);
    RaceEquilibrium& one =
        races.emplace_back(quasi_static_problem(planet.bearings[k], unloaded, options, first_roller));
    assert(one.cut != nullptr);  // whole contacts hold no tilt
    const Vector2d error = error_of(planet, k);
    if (one.extra_approach.size() == 0) one.extra_approach.setZero(one.angle.size());
    one.extra_approach += one.angle.cos() * error.x() + one.angle.sin() * error.y();
    one.load += load_share(planet, point);
  }
  return races;
}

double lever_of(const PlanetOnPin& planet) {
  double lever = 0.0;
  for (std::size_t k = 0; k < planet.bearings.size(); ++k)
    lever = std::max({lever, std::abs(planet.position[k]), planet.bearings[k].half_length()});
  return lever;
}

// Freedoms of all seats in one plane, displacements before slopes times the lever.
struct PinFreedoms {
  Eigen::MatrixXd shapes;     // [-]    (seats, freedoms)
  Eigen::MatrixXd stiffness;  // [N/m]  (freedoms, freedoms)
  bool are_all() const { return shapes.rows() == shapes.cols(); }
};

// Seats on a rigid sleeve have two freedoms, however many they are: against all others the compliance of the
// pin is zero. The carrier's contribution does not change that.
PinFreedoms pin_freedoms(const Eigen::MatrixXd& pin, const Eigen::MatrixXd& compliance, double lever) {
  constexpr double kRigid = 1e-12;  // [-]  of the softest freedom: round-off of zero
  const Index seats = pin.rows() / 2;
  Eigen::VectorXd unit(2 * seats);  // of slopes: rad by length
  unit << Eigen::VectorXd::Ones(seats), Eigen::VectorXd::Constant(seats, 1.0 / lever);
  const Eigen::VectorXd per_unit = unit.cwiseInverse();
  const mechanics::SymmetricModes modes =
      mechanics::symmetric_modes(per_unit.asDiagonal() * pin * per_unit.asDiagonal());
  const Index rigid = (modes.values.array() <= kRigid * modes.values.maxCoeff()).count();
  if (rigid == 0)
    return {Eigen::MatrixXd::Identity(2 * seats, 2 * seats),
            unit.asDiagonal() * compliance.inverse() * unit.asDiagonal()};
  const Eigen::MatrixXd shapes = modes.vectors.rightCols(2 * seats - rigid);  // values ascend
  const Eigen::MatrixXd soft =
      shapes.transpose() * per_unit.asDiagonal() * compliance * per_unit.asDiagonal() * shapes;
  return {shapes, soft.inverse()};
}

// The coordinates that are free, and how they move all.
struct FreeCoordinates {
  Eigen::MatrixXd all;        // [-]    (coordinates, free ones): orthonormal columns
  Eigen::MatrixXd stiffness;  // [N/m]  (free ones, the same)  of the pin
};

FreeCoordinates free_coordinates(const PlanetOnPin& planet, double lever, Index waves) {
  const Eigen::MatrixXd& along_y =
      planet.tangential_compliance.size() > 0 ? planet.tangential_compliance : planet.pin_compliance;
  const std::array<PinFreedoms, 2> pin{pin_freedoms(planet.pin_compliance, planet.pin_compliance, lever),
                                       pin_freedoms(planet.pin_compliance, along_y, lever)};
  const auto seats = static_cast<Index>(planet.bearings.size());
  // Displacements of all seats precede all slopes in the pin's own matrix.
  const auto coordinate = [&](Index i, Index axis) {
    return kPinAt + kPerSeat * (i % seats) + (i < seats ? 0 : 2) + axis;
  };
  const bool all = pin[0].are_all() && pin[1].are_all();
  const Index size = waves_of(planet) + waves;
  const Index free = kPinAt + pin[0].shapes.cols() + pin[1].shapes.cols() + waves;
  FreeCoordinates found{Eigen::MatrixXd::Zero(size, free), Eigen::MatrixXd::Zero(free, free)};
  found.all.topLeftCorner(kPinAt, kPinAt).setIdentity();
  found.all.bottomRightCorner(waves, waves).setIdentity();
  for (Index axis = 0, begin = kPinAt; axis < 2; ++axis) {
    const PinFreedoms& own = pin[static_cast<std::size_t>(axis)];
    const auto place = [&](Index i) { return all ? coordinate(i, axis) : begin + i; };
    for (Index i = 0; i < own.shapes.cols(); ++i) {
      for (Index row = 0; row < own.shapes.rows(); ++row)
        found.all(coordinate(row, axis), place(i)) = own.shapes(row, i);
      for (Index j = 0; j < own.shapes.cols(); ++j) found.stiffness(place(i), place(j)) = own.stiffness(i, j);
    }
    begin += own.shapes.cols();
  }
  return found;
}

// Displacements of the races of one bearing by the planet, its seats and its waves.
SettlingRow<Eigen::Dynamic> row_on(const PlanetOnPin& planet, std::size_t k, const RaceEquilibrium& races,
                                   double lever, const FreeCoordinates& free,
                                   std::vector<RollerState>& rollers) {
  const Index size = free.all.rows();
  Eigen::MatrixXd outward = Eigen::MatrixXd::Zero(size, races.angle.size()), tilting = outward;
  for (Index j = 0; j < races.angle.size(); ++j) {
    const Vector2d e = direction(races.angle[j]);
    outward.col(j).head<2>() = e;
    outward.col(j).segment<2>(kTiltAt) = e * (planet.position[k] / lever);
    outward.col(j).segment<2>(pin_of(k)) = -e;
    outward.col(j).tail(size - waves_of(planet)) = wave_shapes(races.outer_race, races.angle[j]);
    tilting.col(j).segment<2>(kTiltAt) = e * (planet.bearings[k].half_length() / lever);
    tilting.col(j).segment<2>(pin_of(k) + 2) = -tilting.col(j).segment<2>(kTiltAt);
  }
  SettlingRow<Eigen::Dynamic> row =
      bearing::row_of<Eigen::Dynamic>(races, free.all.transpose() * outward, rollers);
  row.tilting = free.all.transpose() * tilting;
  return row;
}

RingsOnRollers<Eigen::Dynamic> rings_on(const PlanetOnPin& planet, const std::vector<RaceEquilibrium>& races,
                                        const Vector2d& share, const Vector2d& moment, double lever,
                                        const FreeCoordinates& free,
                                        std::vector<std::vector<RollerState>>& rollers) {
  RingsOnRollers<Eigen::Dynamic> rings;
  const ElasticRace& race = races.front().outer_race;
  const Index waves = wave_count(race);
  rings.load.setZero(free.all.cols());
  rings.stiffness = free.stiffness;
  rings.rest.setZero(free.all.cols());
  rings.load.segment<2>(kTiltAt) = moment / lever;
  rings.stiffness.block<2, 2>(kTiltAt, kTiltAt) = planet.tilt_stiffness / (lever * lever);
  // All bearings press on the same waves.
  rings.stiffness.diagonal().tail(waves) = static_cast<double>(races.size()) * wave_stiffness(race);
  rings.rest.tail(waves) = waves_at_rest(race);
  double largest = 0.0;
  for (std::size_t k = 0; k < races.size(); ++k) {
    rings.load.head<2>() += races[k].load;
    const Vector2d through_cage = races[k].load - share;
    rings.load.segment<2>(kTiltAt) += through_cage * (planet.position[k] / lever);
    largest = std::max(largest, races[k].inertial_load.abs().maxCoeff());
    rollers[k].resize(static_cast<std::size_t>(races[k].angle.size()));
    rings.rows.push_back(row_on(planet, k, races[k], lever, free, rollers[k]));
  }
  rings.scale = std::max({rings.load.head<2>().norm(), moment.norm() / lever, largest});
  return rings;
}

// The longest of all bearings, of the steps and of the lengths.
mechanics::SearchLimits limits_of(const std::vector<RaceEquilibrium>& races) {
  mechanics::SearchLimits all;
  for (const RaceEquilibrium& of_bearing : races) {
    const mechanics::SearchLimits one = search_limits(of_bearing);
    all.reach = std::max(all.reach, one.reach);
    all.size = std::max(all.size, one.size);
  }
  return all;
}

// Displacement of each bearing under its part of the load: start of the search.
Eigen::VectorXd start_of(const RaceEquilibrium& first, const Eigen::VectorXd& rest) {
  Eigen::VectorXd at = rest;
  at.head<2>() = first_displacement(first);
  return at;
}

Eigen::VectorXd start_near(const PlanetOnPin& planet, double lever, const PlanetOnPinState& near) {
  Eigen::VectorXd at(waves_of(planet) + near.waves.size());
  at.tail(near.waves.size()) = near.waves;
  at.head<2>() = near.displacement;
  at.segment<2>(kTiltAt) = near.tilt * lever;
  for (std::size_t k = 0; k < planet.bearings.size(); ++k) {
    at.segment<2>(pin_of(k)) = near.displacement + near.tilt * planet.position[k] - error_of(planet, k) -
                               near.bearings[k].displacement;
    at.segment<2>(pin_of(k) + 2) = lever * (near.tilt - near.bearing_tilt[k] - inclination_of(planet, k));
  }
  return at;
}

void put_bearing(const PlanetOnPin& planet, std::size_t k, const RaceEquilibrium& races,
                 const Eigen::VectorXd& at, double lever, std::vector<RollerState> rollers,
                 PlanetOnPinState& state) {
  QuasiStaticState& one = state.bearings.emplace_back();
  one.displacement =
      state.displacement + state.tilt * planet.position[k] - at.segment<2>(pin_of(k)) - error_of(planet, k);
  state.bearing_tilt.push_back(state.tilt - at.segment<2>(pin_of(k) + 2) / lever - inclination_of(planet, k));
  one.waves = state.waves;
  put_rollers(races, std::move(rollers), one);
  state.report.converged = state.report.converged && are_settled(one.rollers);
}

// Displacements by load and moment on the planet, with pin, waves and rollers free.
Eigen::Matrix4d compliance_at(const PlanetOnPin& planet, double lever, const FreeCoordinates& free,
                              const Eigen::MatrixXd& stiffness) {
  const double seats = static_cast<double>(planet.bearings.size());
  Eigen::Matrix4d compliance;
  for (Index i = 0; i < 4; ++i) {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(stiffness.rows());
    load[i] = i < kTiltAt ? 1.0 : 1.0 / lever;
    const Eigen::VectorXd moved = free.all * mechanics::lengths_under<Eigen::Dynamic>(load, stiffness);
    Vector2d shift = moved.head<2>();
    for (std::size_t k = 0; k < planet.bearings.size(); ++k) shift -= moved.segment<2>(pin_of(k)) / seats;
    compliance.col(i) << shift, moved.segment<2>(kTiltAt) / lever;
  }
  return compliance;
}

}  // namespace

Vector2d shift_on_seats(const PlanetOnPin& planet, const PlanetOnPinState& state) {
  Vector2d shift = Vector2d::Zero();
  for (std::size_t k = 0; k < planet.bearings.size(); ++k)
    shift += state.bearings[k].displacement - state.tilt * planet.position[k] + error_of(planet, k);
  return shift / static_cast<double>(planet.bearings.size());
}

PlanetOnPinState planet_on_pin(const PlanetOnPin& planet, const OperatingPoint& point, const Vector2d& moment,
                               const QuasiStaticOptions& options, double first_roller,
                               const PlanetOnPinState* near) {
  mechanics::require(!planet.bearings.empty() && planet.bearings.size() == planet.position.size(),
                     "bearings of a planet", planet.position.size(), "at least one, each with its place");
  const std::vector<RaceEquilibrium> races = bearings_on(planet, point, options, first_roller);
  const double lever = lever_of(planet);
  std::vector<std::vector<RollerState>> rollers(races.size());
  if (near != nullptr)
    for (std::size_t k = 0; k < races.size(); ++k) rollers[k] = near->bearings[k].rollers;
  const FreeCoordinates free = free_coordinates(planet, lever, wave_count(races.front().outer_race));
  const RingsOnRollers<Eigen::Dynamic> rings =
      rings_on(planet, races, load_share(planet, point), moment, lever, free, rollers);
  Eigen::VectorXd found = near != nullptr
                              ? Eigen::VectorXd(free.all.transpose() * start_near(planet, lever, *near))
                              : start_of(races.front(), rings.rest);
  mechanics::Imbalance<Eigen::Dynamic> now;
  PlanetOnPinState state;
  state.report = {mechanics::find_balance<Eigen::Dynamic>(rings, limits_of(races), found, now)};
  state.report.residual = mechanics::force_left(state.report.residual);
  const Eigen::VectorXd at = free.all * found;
  state.displacement = at.head<2>();
  state.tilt = at.segment<2>(kTiltAt) / lever;
  state.waves = at.tail(at.size() - waves_of(planet));
  state.compliance = compliance_at(planet, lever, free, now.stiffness);
  for (std::size_t k = 0; k < races.size(); ++k)
    put_bearing(planet, k, races[k], at, lever, std::move(rollers[k]), state);
  if (!state.report.converged) {
    std::ostringstream text;
    text << "the planet found no static equilibrium on its pin under " << point.bore_load.norm()
         << " N: " << mechanics::force_left_text(state.report.residual)
         << "; check clearances, profiles, the pin and its errors";
    state.report.message = text.str();
  }
  for (QuasiStaticState& one : state.bearings) one.report = state.report;
  return state;
}

PlanetOnPinResult planet_on_pin_over_a_pitch(const PlanetOnPin& planet, const OperatingPoint& point,
                                             const Vector2d& moment, const QuasiStaticOptions& options,
                                             const PlanetOnPinResult* near) {
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
    const PlanetOnPinState* start = near != nullptr ? &near->states[static_cast<std::size_t>(position)]
                                    : position == 0 ? nullptr
                                                    : &last;
    last = planet_on_pin(planet, point, moment, options, result.bearings.front().angle[position], start);
    keep_worst(last.report, result.report);
    result.tilt += last.tilt / positions;
    result.shift += shift_on_seats(planet, last) / positions;
    result.compliance += last.compliance / positions;
    result.states.push_back(last);
    for (std::size_t k = 0; k < planet.bearings.size(); ++k) {
      QuasiStaticResult& one = result.bearings[k];
      result.bearing_tilt[k] += last.bearing_tilt[k] / positions;
      one.total_bore_load -= force_on_bore(last.bearings[k]) / positions;
      put_position(planet.bearings[k], last.bearings[k], position, positions, one);
    }
  }
  for (QuasiStaticResult& one : result.bearings) one.report = result.report;
  return result;
}

}  // namespace orbearing::bearing::laminae
