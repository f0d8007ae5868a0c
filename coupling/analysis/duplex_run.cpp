#include "coupling/analysis/duplex_run.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/life/basic_life.hpp"

namespace orbearing::analysis {

namespace {

namespace duplex = bearing::duplex;
namespace rating = bearing::rating;
using bearing::equilibrium::RingState;
using described::each;
using described::Record;
namespace dimension = described::dimension;

// On the outer races, where the shaft rotates.
const Eigen::ArrayXd& outer_load(const RingState& state) {
  return state.outer_load.size() > 0 ? state.outer_load : state.contact_load;
}

// The shaft rotates; both rows have the ratings of one bearing.
PairLives lives_of(const DuplexPair& machine, const RingState& state) {
  bearing::Bearing bearing = machine.preloaded.bearing;
  bearing.motions = {bearing::RaceMotion::rotating, bearing::RaceMotion::stationary};
  const rating::BearingRating rated = rating::bearing_rating(bearing, machine.capacities.ratings());
  const Eigen::Index balls = bearing.element_count();
  const auto of_row = [&](Eigen::Index first) {
    return rating::rating_lives(rated, {}, {state.contact_load.segment(first, balls), {}},
                                {outer_load(state).segment(first, balls), {}});
  };
  const std::array rows{of_row(0), of_row(balls)};
  const Eigen::Array2d lives(rows[0].reference.bearing, rows[1].reference.bearing);
  const rating::RatingLives& shorter = rows[lives[0] <= lives[1] ? 0 : 1];
  return {
      {shorter, shorter.reference.bearing, machine.preloaded.operation.shaft_speed, state.largest_pressure},
      rating::system_life(lives, rating::weibull_slope(rating::RollingElement::ball))};
}

ShaftResponse response_of(const DuplexPair& machine, const PairPoint& point) {
  constexpr int steps = 2500;
  constexpr double beyond = 1.25;  // of the highest natural frequency
  const PairColumn& column = point.chosen();
  const duplex::TiltPlanes planes =
      point.linear ? duplex::TiltPlanes::literature_variant : duplex::TiltPlanes::physical;
  double highest = 0.0;
  for (const duplex::PairMode& mode : column.modes) highest = std::max(highest, mode.frequency);
  ShaftResponse response{.step = std::max(beyond * highest, 1.0) / steps};
  for (int k = 1; k <= steps; ++k) {
    const auto values = duplex::accelerance(column.stiffness, column.shaft, machine.preloaded.free_housing(),
                                            planes, machine.response, k * response.step);
    for (std::size_t i = 0; i < values.size(); ++i) response.accelerance[i].push_back(values[i]);
  }
  return response;
}

}  // namespace

DuplexRun duplex_run(const DuplexPair& machine) {
  DuplexRun result{.modes = duplex_modes(machine.preloaded)};
  result.lives = lives_of(machine, result.modes.point.state);
  result.response = response_of(machine, result.modes.point);
  result.warnings = result.modes.warnings;
  return result;
}

DuplexQuantities quantities_of(const DuplexPair& machine) {
  const PairPoint point = point_of(machine.preloaded);
  return {.approach = point.approach,
          .contact_angle = point.state.contact_angle[0],
          .contact_load = point.state.contact_load.maxCoeff(),
          .shaft = point.chosen().shaft};
}

namespace {

void describe_balance(Record& record, const PairPoint& point) {
  const RingState& state = point.state;
  const bool moving = state.outer_load.size() > 0;
  record.value("approach_um", dimension::small_length, "of each row under preload", point.approach);
  record.value("contact_angle_deg", dimension::angle, "of the first ball", state.contact_angle[0]).variable =
      "first_contact_angle";
  record.value("contact_load_max_N", dimension::force, "largest of all balls", state.contact_load.maxCoeff());
  if (moving) {
    record.value("outer_contact_angle_deg", dimension::angle, "of the first ball", state.outer_angle[0])
        .variable = "first_outer_contact_angle";
    record.value("outer_contact_load_max_N", dimension::force, "the same on the outer races",
                 state.outer_load.maxCoeff());
  }
  record.value("pressure_max_MPa", dimension::pressure, "after Hertz", state.largest_pressure);
  record.child("shaft", "as used", point.chosen().shaft);
  record
      .array("stiffness_matrix", {}, "of the shaft about its mass centre [N/m], [N/rad], [N m/m], [N m/rad]",
             {"freedom", "freedom_beside"}, point.chosen().stiffness)
      .variable = "stiffness";
}

void describe_balls(Record& record, const RingState& state) {
  const auto of_balls = [&](const char* name, const described::Dimension& of, const char* meaning,
                            const char* variable, const Eigen::ArrayXd& values) {
    record.array(name, of, meaning, {"ball"}, values).variable = variable;
  };
  of_balls("contact_loads_N", dimension::force, "of the first row's balls, then of the second's",
           "contact_load", state.contact_load);
  of_balls("contact_angles_deg", dimension::angle, "the same", "contact_angle", state.contact_angle);
  record.value("inner_load_max_N", dimension::force, "largest load of a ball on the inner race",
               state.contact_load.maxCoeff());
  record.value("outer_load_max_N", dimension::force, "largest load of a ball on the outer race",
               outer_load(state).maxCoeff());
  if (state.outer_load.size() == 0) return;
  of_balls("outer_contact_loads_N", dimension::force,
           "on the outer races; contact_load is that on the inner ones", "outer_contact_load",
           state.outer_load);
  of_balls("outer_contact_angles_deg", dimension::angle, "the same", "outer_contact_angle",
           state.outer_angle);
}

}  // namespace

void describe(Record& record, const PairLives& lives) {
  describe(record, lives.row);
  record.value("system_L10r_Mrev", dimension::revolutions, "reference rating life of both rows", lives.pair);
  record.value("system_L10rh", dimension::hours, "reference rating life of both rows",
               lives.row.speed != 0.0 ? bearing::hours(lives.pair, lives.row.speed) : described::kAbsent);
}

void describe(Record& record, const ShaftResponse& response) {
  record.value("step_Hz", dimension::cycles, "between lines", response.step).variable = "response_step";
  std::vector<double> largest, frequency;
  for (const auto& line : response.accelerance) {
    const auto sizes = each(line, [](const std::complex<double>& value) { return std::abs(value); });
    largest.push_back(*std::max_element(sizes.begin(), sizes.end()));
  }
  record.array("accelerance_max_per_kg", dimension::inverse_mass, "largest along x, y and z", {"direction"},
               largest);
  for (std::size_t k = 1; k <= response.accelerance[0].size(); ++k)
    frequency.push_back(static_cast<double>(k) * response.step);
  record.series("frequency", dimension::cycles, "of the frequency response", {"line"}, frequency);
  for (std::size_t i = 0; i < response.accelerance.size(); ++i) {
    const std::string axis(1, "xyz"[i]);
    const auto add = [&](const char* part, double (*value)(const std::complex<double>&)) {
      record.series("accelerance_" + axis + part, dimension::inverse_mass,
                    "acceleration over force along " + axis, {"line"}, each(response.accelerance[i], value));
    };
    add("_real", [](const std::complex<double>& value) { return value.real(); });
    add("_imaginary", [](const std::complex<double>& value) { return value.imag(); });
  }
}

void describe(Record& record, const DuplexRun& result) {
  const PairPoint& point = result.modes.point;
  describe(record, point);
  describe(record, result.lives);
  if (!result.modes.over_speed.empty())
    record.table("over_speed", "speed", "the pair at operation.speeds", result.modes.over_speed).file =
        "modes_over_speed.csv";
  describe_balance(record, point);
  record.child("response", "of the shaft to a force", result.response).variable = "";
  describe_balls(record, point.state);
}

void describe(Record& record, const DuplexQuantities& of) {
  using namespace described;
  record.value("approach_um", dimension::small_length, "of each row along the shaft under preload",
               of.approach);
  record.value("contact_angle_deg", dimension::angle, "under preload", of.contact_angle);
  record.value("contact_load_N", dimension::force, "largest of all balls", of.contact_load);
  record.value("mass_kg", dimension::mass, "of the shaft, as used", of.shaft.mass);
  record.value("inertia_x_kg_m2", dimension::inertia, "of the shaft about x, as used", of.shaft.inertia_x);
  record.value("inertia_y_kg_m2", dimension::inertia, "of the shaft about y, as used", of.shaft.inertia_y);
}

}  // namespace orbearing::analysis
