#include "app/study/duplex_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "app/errors.hpp"
#include "app/units.hpp"
#include "bearing/duplex/linear_pair.hpp"

namespace orbearing::app {

namespace {

namespace duplex = bearing::duplex;

constexpr auto kPhysical = duplex::TiltPlanes::physical;
constexpr auto kPrinted = duplex::TiltPlanes::literature_variant;

PairColumn column_of(const duplex::Shaft& shaft, const duplex::Stiffness& stiffness,
                     const std::optional<duplex::Housing>& housing, duplex::TiltPlanes planes) {
  return {shaft, stiffness, duplex::modes_of(stiffness, shaft, housing, planes)};
}

void warn(duplex::Arrangement arrangement, PairPoint& point) {
  if (point.linear && arrangement == duplex::Arrangement::face_to_face)
    point.warnings.push_back(
        "stiffness: linear is the source's calculation as printed: both rows approach with one axial sign, "
        "where "
        "rows that face each other have opposite ones");
  if (point.state.outer_load.size() > 0)
    point.warnings.push_back(
        "operation.shaft_speed: felt by the balls; the shaft's own gyroscopic moment, which would part its "
        "tilts into "
        "two whirls, is left out");
  if (!(point.state.contact_load.minCoeff() > 0.0))
    point.warnings.push_back("preload: some balls are not pressed; the stiffness is that of the others");
}

// By the nonlinear equilibrium, whatever levers come.
duplex::Observation observed(const ResolvedCase& in, const MeasuredPair& measured) {
  const duplex::Arrangement arrangement = arrangement_of_pair(in);
  const bearing::Bearing bearing = duplex_bearing_of(in, measured.contact_angle);
  const duplex::PairState state =
      duplex::balance_pair({.bearing = bearing,
                            .arrangement = arrangement,
                            .levers = {},
                            .approach = duplex::approach_under(bearing, measured.preload)});
  return {measured.frequency, [rows = state.rows, arrangement](const duplex::RowLevers& levers) {
            return duplex::pair_stiffness(rows, arrangement, levers);
          }};
}

duplex::Observation observed_linear(const ResolvedCase& in, const MeasuredPair& measured) {
  const bearing::Bearing bearing = duplex_bearing_of(in, measured.contact_angle);
  const duplex::PressedRow row =
      duplex::pressed_row(bearing, duplex::approach_under(bearing, measured.preload));
  return {measured.frequency,
          [row](const duplex::RowLevers& levers) { return duplex::linear_stiffness(row, levers); }};
}

std::array<double, 5> frequencies(const duplex::Observation& pair, const duplex::Shaft& shaft,
                                  const std::optional<duplex::Housing>& housing, duplex::TiltPlanes planes) {
  const duplex::PairModes modes = duplex::modes_of(pair.stiffness(shaft.levers), shaft, housing, planes);
  std::array<double, 5> found{};
  for (std::size_t i = 0; i < found.size(); ++i) found[i] = modes[i].frequency;
  return found;
}

// Of the pairs identified from, or of all others.
FrequencyErrors errors_of(const std::vector<PredictedPair>& pairs, bool identified_from,
                          std::array<double, 5> PredictedPair::*model) {
  FrequencyErrors errors;
  int count = 0;
  for (const PredictedPair& pair : pairs) {
    if (pair.identified_from != identified_from) continue;
    for (std::size_t i = 0; i < 5; ++i, ++count) {
      const double error = std::abs((pair.*model)[i] / pair.measured.frequency[i] - 1.0);
      errors.mean += error;
      errors.worst = std::max(errors.worst, error);
    }
  }
  errors.mean /= count;  // NaN where there are none
  if (count == 0) errors.worst = std::numeric_limits<double>::quiet_NaN();
  return errors;
}

std::vector<PredictedPair> pairs_of(const ResolvedCase& in) {
  constexpr double same = 1e-9;  // [rad]
  std::vector<PredictedPair> pairs;
  for (const MeasuredPair& measured : measured_pairs_of(in)) {
    PredictedPair pair{.measured = measured};
    pair.identified_from =
        std::abs(measured.contact_angle - in.quantity("identification.contact_angle")) < same;
    pair.linear.fill(std::numeric_limits<double>::quiet_NaN());
    pairs.push_back(pair);
  }
  return pairs;
}

// Predictions of one model: its constants from the chosen pairs, then all pairs with them.
template <class ObservedBy, class Identify>
duplex::Identified predict(const ResolvedCase& in, std::vector<PredictedPair>& pairs,
                           std::array<double, 5> PredictedPair::*model, duplex::TiltPlanes planes,
                           const ObservedBy& observed_by, const Identify& identify) {
  std::vector<duplex::Observation> all, chosen;
  for (const PredictedPair& pair : pairs) {
    all.push_back(observed_by(in, pair.measured));
    if (pair.identified_from) chosen.push_back(all.back());
  }
  const duplex::Identified found = identify(chosen);
  const std::optional<duplex::Housing> housing = housing_of(in);
  for (std::size_t k = 0; k < pairs.size(); ++k)
    pairs[k].*model = frequencies(all[k], found.shaft, housing, planes);
  return found;
}

Identification identification_of(const ResolvedCase& in) {
  Identification found;
  found.pairs = pairs_of(in);
  const std::optional<duplex::Housing> housing = housing_of(in);
  const double least_lever = 0.5 * in.quantity("identification.least_distance");
  found.nonlinear =
      predict(in, found.pairs, &PredictedPair::nonlinear, kPhysical, observed,
              [&](const std::vector<duplex::Observation>& chosen) {
                return duplex::identify_cylinder(chosen, *cylinder_of(in), least_lever, housing);
              });
  if (arrangement_of_pair(in) != duplex::Arrangement::back_to_back)
    found.linear = predict(in, found.pairs, &PredictedPair::linear, kPrinted, observed_linear,
                           [&](const std::vector<duplex::Observation>& chosen) {
                             return duplex::identify_all(chosen, linear_shaft_of(in), kPrinted, housing);
                           });
  found.nonlinear_fit = errors_of(found.pairs, true, &PredictedPair::nonlinear);
  found.nonlinear_prediction = errors_of(found.pairs, false, &PredictedPair::nonlinear);
  found.linear_fit = errors_of(found.pairs, true, &PredictedPair::linear);
  found.linear_prediction = errors_of(found.pairs, false, &PredictedPair::linear);
  return found;
}

// A fit at its bound, or one that does not end, says little of the shaft.
void warn(const Identification& found, std::vector<std::string>& warnings) {
  constexpr double vague = 0.2;  // of frequencies
  if (!found.nonlinear.converged)
    warnings.push_back(
        "identification: the search for mass and lever did not end; its last values are given");
  if (found.nonlinear_fit.worst > vague)
    warnings.push_back(fmt::format("identification: the frequencies it is from are missed by up to {:.0f} %",
                                   100.0 * found.nonlinear_fit.worst));
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
                                            point.linear ? kPrinted : kPhysical, at, k * response.step);
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
  point.approach = pair_approach_of(in, bearing, in.quantity("preload"));
  const duplex::Arrangement arrangement = arrangement_of_pair(in);
  const bearing::equilibrium::RowMotion motion = pair_motion_of(in);
  point.state = balanced_at({bearing, arrangement, shaft.levers, point.approach}, motion);
  if (!point.state.report.converged)
    throw ComputationFailed(in.text("name") + ": " + point.state.report.message);
  point.nonlinear = column_of(shaft, point.state.stiffness, housing_of(in), kPhysical);
  if (arrangement != duplex::Arrangement::back_to_back && motion.speeds.at_rest()) {
    const duplex::Shaft other = linear_shaft_of(in);
    point.printed =
        column_of(other, duplex::linear_stiffness(duplex::pressed_row(bearing, point.approach), other.levers),
                  housing_of(in), kPrinted);
  }
  warn(arrangement, point);
  return point;
}

}  // namespace

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
                          pair_approach_of(in, bearing, in.quantity("preload"))};
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
  study.warnings = study.point.warnings;
  if (in.has("measured.preload")) study.identification = identification_of(in);
  if (study.identification) warn(*study.identification, study.warnings);
  study.response = response_of(in, study.point);
  return study;
}

double duplex_property(const DuplexStudy& study, const std::string& quantity) {
  for (const duplex::PairMode& mode : study.point.asked().modes)
    if (quantity == std::string(duplex::name_of(mode.kind)) + "_Hz") return mode.frequency;
  if (quantity == "contact_angle_deg") return kDegree * study.point.state.contact_angle[0];
  if (study.identification) {
    if (quantity == "predicted_mean_percent") return 100.0 * study.identification->nonlinear_prediction.mean;
    if (quantity == "predicted_worst_percent")
      return 100.0 * study.identification->nonlinear_prediction.worst;
    if (quantity == "linear_mean_percent") return 100.0 * study.identification->linear_prediction.mean;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<Derived> duplex_quantities(const ResolvedCase& in) {
  const PairPoint point = pair_point(in);
  const duplex::Shaft& shaft = point.asked().shaft;
  return {{"pair.approach", kMicro * point.approach, "um", "of each row along the shaft under preload"},
          {"pair.contact_angle", kDegree * point.state.contact_angle[0], "deg", "under preload"},
          {"pair.contact_load", point.state.contact_load.maxCoeff(), "N", "largest of all balls"},
          {"pair.mass", shaft.mass, "kg", "of the shaft, as used"},
          {"pair.inertia_x", shaft.inertia_x, "kg.m2", "of the shaft about x, as used"},
          {"pair.inertia_y", shaft.inertia_y, "kg.m2", "of the shaft about y, as used"}};
}

}  // namespace orbearing::app
