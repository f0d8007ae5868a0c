#include "app/study/duplex_study.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/case/static_case.hpp"
#include "app/errors.hpp"
#include "app/units.hpp"
#include "bearing/duplex/pair.hpp"
#include "bearing/life/basic_life.hpp"

namespace orbearing::app {

namespace {

namespace duplex = bearing::duplex;

constexpr auto kPhysical = duplex::TiltPlanes::physical;
constexpr auto kPublished = duplex::TiltPlanes::literature_variant;

PairColumn column_of(const duplex::Shaft& shaft, const duplex::Stiffness& stiffness,
                     const std::optional<duplex::Housing>& housing, duplex::TiltPlanes planes) {
  return {shaft, stiffness, duplex::modes_of(stiffness, shaft, housing, planes)};
}

void warn(duplex::Arrangement arrangement, PairPoint& point) {
  if (point.linear && arrangement == duplex::Arrangement::face_to_face)
    point.warnings.push_back(
        "stiffness: linear is the source's calculation as published: both rows approach with the same axial "
        "sign. Rows that face each other have opposite signs");
  if (point.state.outer_load.size() > 0)
    point.warnings.push_back(
        "operation.shaft_speed: affects the balls; the shaft's own gyroscopic moment, which would split its "
        "tilt modes into two whirls, is left out");
  if (!(point.state.contact_load.minCoeff() > 0.0))
    point.warnings.push_back("preload: some balls are not loaded; the stiffness is that of the others");
}

std::array<double, 5> frequencies_of(const duplex::PairModes& modes) {
  std::array<double, 5> found{};
  std::transform(modes.begin(), modes.end(), found.begin(), std::mem_fn(&duplex::PairMode::frequency));
  return found;
}

Response response_of(const ResolvedCase& in, const PairPoint& point) {
  constexpr int steps = 2500;
  constexpr double beyond = 1.25;  // of the highest natural frequency
  const PairColumn& column = point.asked();
  double highest = 0.0;
  for (const duplex::PairMode& mode : column.modes) highest = std::max(highest, mode.frequency);
  Response response{.step = std::max(beyond * highest, 1.0) / steps};
  const duplex::ResponsePoint at{in.quantity("response.position"), in.number("response.loss_factor")};
  for (int k = 1; k <= steps; ++k) {
    const auto values = duplex::accelerance(column.stiffness, column.shaft, housing_of(in),
                                            point.linear ? kPublished : kPhysical, at, k * response.step);
    for (std::size_t i = 0; i < values.size(); ++i) response.accelerance[i].push_back(values[i]);
  }
  return response;
}

bearing::equilibrium::RingState balanced_at(const duplex::Pair& pair,
                                            const bearing::equilibrium::RowMotion& motion) {
  return motion.moves_balls() ? duplex::balance_pair_at_speed(pair, motion) : duplex::balance_pair(pair).ring;
}

PairPoint balanced(const ResolvedCase& in) {
  const bearing::Bearing bearing = duplex_bearing_of(in);
  const duplex::Shaft shaft = duplex_shaft_of(in);
  PairPoint point{.linear = is_linear_pair(in)};
  point.approach = pair_approach_of(in, bearing);
  const duplex::Arrangement arrangement = arrangement_of_pair(in);
  const bearing::equilibrium::RowMotion motion = pair_motion_of(in);
  point.state = balanced_at({bearing, arrangement, shaft.levers, point.approach}, motion);
  if (!point.state.report.converged)
    throw ComputationFailed(in.text("name") + ": " + point.state.report.message);
  point.nonlinear = column_of(shaft, point.state.stiffness, housing_of(in), kPhysical);
  if (arrangement != duplex::Arrangement::back_to_back && motion.speeds.at_rest()) {
    const duplex::Shaft other = linear_shaft_of(in);
    point.published =
        column_of(other, duplex::linear_stiffness(duplex::pressed_row(bearing, point.approach), other.levers),
                  housing_of(in), kPublished);
  }
  warn(arrangement, point);
  return point;
}

// The shaft rotates; both rows have the ratings of one bearing.
PairLives lives_of(const ResolvedCase& in, const bearing::equilibrium::RingState& state) {
  namespace rating = bearing::rating;
  bearing::Bearing bearing = duplex_bearing_of(in);
  bearing.motions = {bearing::RaceMotion::rotating, bearing::RaceMotion::stationary};
  const rating::BearingRating rated = rating::bearing_rating(bearing, stated_ratings_of(in));
  const Eigen::ArrayXd& outer = state.outer_load.size() > 0 ? state.outer_load : state.contact_load;
  const Eigen::Index balls = bearing.element_count();
  const auto of_row = [&](Eigen::Index first) {
    return rating::rating_lives(rated, {}, {state.contact_load.segment(first, balls), {}},
                                {outer.segment(first, balls), {}});
  };
  const std::array rows{of_row(0), of_row(balls)};
  const Eigen::Array2d lives(rows[0].reference.bearing, rows[1].reference.bearing);
  const rating::RatingLives& shorter = rows[lives[0] <= lives[1] ? 0 : 1];
  return {{shorter, shorter.reference.bearing, in.quantity("operation.shaft_speed"), state.largest_pressure},
          rating::system_life(lives, rating::weibull_slope(rating::RollingElement::ball))};
}

using described::each;
using described::Record;
namespace dimension = described::dimension;

void describe_modes(Record& record, bool linear, const PairColumn& column) {
  record.value("stiffness", "nonlinear equilibrium, or the linear formulas of the source",
               linear ? "linear" : "nonlinear");
  record.table("modes", "mode", "natural modes of the shaft", column.modes).variable = "";
}

std::vector<std::string> frequency_names() {
  std::vector<std::string> names;
  for (const duplex::ModeKind kind : duplex::mode_kinds)
    names.push_back(std::string(duplex::name_of(kind)) + "_Hz");
  return names;
}

void describe_balance(Record& record, const PairPoint& point) {
  const bearing::equilibrium::RingState& state = point.state;
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
  record.child("shaft", "as used", point.asked().shaft);
  record
      .array("stiffness_matrix", {}, "of the shaft about its mass centre [N/m], [N/rad], [N m/m], [N m/rad]",
             {"freedom", "freedom_beside"}, point.asked().stiffness)
      .variable = "stiffness";
}

void describe_balls(Record& record, const bearing::equilibrium::RingState& state) {
  const bool moving = state.outer_load.size() > 0;
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
               (moving ? state.outer_load : state.contact_load).maxCoeff());
  if (!moving) return;
  of_balls("outer_contact_loads_N", dimension::force,
           "on the outer races; contact_load is that on the inner ones", "outer_contact_load",
           state.outer_load);
  of_balls("outer_contact_angles_deg", dimension::angle, "the same", "outer_contact_angle",
           state.outer_angle);
}

}  // namespace

void describe(Record& record, const PairPoint& point) {
  describe_modes(record, point.linear, point.asked());
  if (point.published)
    record.child("other", "by the other stiffness", point, [](Record& other, const PairPoint& of) {
      describe_modes(other, !of.linear, of.linear ? of.nonlinear : *of.published);
    });
}

void describe(Record& row, const PairAtSpeed& at) {
  row.value("speed_rpm", dimension::angular_speed, "of the shaft", at.speed);
  row.value("status", "ok, or the reason why there is no static equilibrium",
            at.modes ? "ok" : at.state.report.message);
  constexpr double absent = described::kAbsent;
  row.array("", dimension::cycles, "order of natural_frequency; none: no static equilibrium",
            {{"mode", frequency_names()}},
            at.modes ? frequencies_of(*at.modes) : std::array{absent, absent, absent, absent, absent})
      .variable = "natural_frequency";
  const bearing::equilibrium::RingState& state = at.state;
  Eigen::Index ball = 0;
  if (at.modes) state.contact_load.maxCoeff(&ball);
  const auto of_ball = [&](const Eigen::ArrayXd& inner, const Eigen::ArrayXd& outer) {
    return !at.modes ? described::kAbsent : outer.size() > 0 ? outer[ball] : inner[ball];
  };
  const auto& [load, angle] = std::pair(state.contact_load, state.contact_angle);
  row.value("inner_angle_deg", dimension::angle, "of the most loaded ball", of_ball(angle, {}));
  row.value("outer_angle_deg", dimension::angle, "the same", of_ball(angle, state.outer_angle));
  row.value("inner_load_max_N", dimension::force, "largest of all balls", of_ball(load, {}));
  row.value("outer_load_max_N", dimension::force, "of the same ball", of_ball(load, state.outer_load));
}

void describe(Record& record, const Response& response) {
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

void describe(Record& record, const PairLives& lives) {
  describe(record, lives.row);
  record.value("system_L10r_Mrev", dimension::revolutions, "reference rating life of both rows", lives.pair);
  record.value("system_L10rh", dimension::hours, "reference rating life of both rows",
               lives.row.speed != 0.0 ? bearing::hours(lives.pair, lives.row.speed) : described::kAbsent);
}

void describe(Record& record, const DuplexStudy& study) {
  describe(record, study.point);
  describe(record, study.lives);
  if (!study.over_speed.empty())
    record.table("over_speed", "speed", "the pair at operation.speeds", study.over_speed).file =
        "modes_over_speed.csv";
  describe_balance(record, study.point);
  record.child("response", "of the shaft to a force", study.response).variable = "";
  describe_balls(record, study.point.state);
}

bool is_duplex(const ResolvedCase& resolved) {
  return resolved.model() == duplex_pair;
}

PairPoint pair_point(const ResolvedCase& in) {
  try {
    return balanced(in);
  } catch (const std::runtime_error& failure) {
    throw ComputationFailed(in.text("name") + ": " + failure.what());
  }
}

std::vector<PairAtSpeed> pair_over_speed(const ResolvedCase& in) {
  std::vector<PairAtSpeed> found;
  if (!in.has("operation.speeds")) return found;
  const bearing::Bearing bearing = duplex_bearing_of(in);
  const duplex::Shaft shaft = duplex_shaft_of(in);
  const duplex::Pair pair{bearing, arrangement_of_pair(in), shaft.levers,
                          pair_approach_of(in, bearing)};
  bearing::equilibrium::RowMotion motion = pair_motion_of(in);
  for (const double speed : in.list("operation.speeds")) {
    motion.speeds.inner = speed;
    PairAtSpeed at{.speed = speed, .modes = {}, .state = balanced_at(pair, motion)};
    if (at.state.report.converged)
      at.modes = duplex::modes_of(at.state.stiffness, shaft, housing_of(in), kPhysical);
    found.push_back(std::move(at));
  }
  return found;
}

DuplexStudy duplex_study(const ResolvedCase& in) {
  DuplexStudy study{.point = pair_point(in), .over_speed = pair_over_speed(in)};
  study.lives = lives_of(in, study.point.state);
  study.warnings = study.point.warnings;
  study.response = response_of(in, study.point);
  return study;
}

std::vector<Derived> duplex_quantities(const ResolvedCase& in) {
  const PairPoint point = pair_point(in);
  const duplex::Shaft& shaft = point.asked().shaft;
  return {{"pair.approach", per_micro * point.approach, "um", "of each row along the shaft under preload"},
          {"pair.contact_angle", kDegree * point.state.contact_angle[0], "deg", "under preload"},
          {"pair.contact_load", point.state.contact_load.maxCoeff(), "N", "largest of all balls"},
          {"pair.mass", shaft.mass, "kg", "of the shaft, as used"},
          {"pair.inertia_x", shaft.inertia_x, "kg.m2", "of the shaft about x, as used"},
          {"pair.inertia_y", shaft.inertia_y, "kg.m2", "of the shaft about y, as used"}};
}

}  // namespace orbearing::app
