#include "coupling/analysis/duplex_modes.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "mechanics/no_result.hpp"

namespace orbearing::analysis {

namespace {

namespace duplex = bearing::duplex;
using described::Record;
namespace dimension = described::dimension;

constexpr auto kPhysical = duplex::TiltPlanes::physical;

PairColumn column_of(const duplex::Shaft& shaft, const duplex::Stiffness& stiffness,
                     const std::optional<duplex::Housing>& housing, duplex::TiltPlanes planes) {
  return {shaft, stiffness, duplex::modes_of(stiffness, shaft, housing, planes)};
}

bearing::equilibrium::RingState balanced_at(const duplex::Pair& pair,
                                            const bearing::equilibrium::RowMotion& motion) {
  return motion.moves_balls() ? duplex::balance_pair_at_speed(pair, motion) : duplex::balance_pair(pair).ring;
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

bool is_lost(const PairAtSpeed& at) {
  return !at.modes;
}

}  // namespace

PairPoint point_of(const PreloadedPair& pair) {
  const duplex::Shaft shaft = pair.spindle.shaft();
  PairPoint point{.linear = pair.is_linear(), .approach = pair.approach()};
  point.state = balanced_at({pair.bearing, pair.arrangement, shaft.levers, point.approach},
                            pair.motion_at(pair.operation.shaft_speed));
  if (!point.state.report.converged) throw mechanics::NoResult(point.state.report.message);
  point.nonlinear = column_of(shaft, point.state.stiffness, pair.free_housing(), kPhysical);
  if (pair.has_linear_formulas()) {
    const duplex::Shaft other = pair.linear_shaft();
    point.published = column_of(
        other, duplex::linear_stiffness(duplex::pressed_row(pair.bearing, point.approach), other.levers),
        pair.free_housing(), duplex::TiltPlanes::literature_variant);
  }
  warn(pair.arrangement, point);
  return point;
}

std::vector<PairAtSpeed> over_speeds(const PreloadedPair& pair) {
  std::vector<PairAtSpeed> found;
  if (pair.operation.speeds.empty()) return found;
  const duplex::Shaft shaft = pair.spindle.shaft();
  const duplex::Pair rows{pair.bearing, pair.arrangement, shaft.levers, pair.approach()};
  for (const double speed : pair.operation.speeds) {
    PairAtSpeed at{.speed = speed, .modes = {}, .state = balanced_at(rows, pair.motion_at(speed))};
    if (at.state.report.converged)
      at.modes = duplex::modes_of(at.state.stiffness, shaft, pair.free_housing(), kPhysical);
    found.push_back(std::move(at));
  }
  return found;
}

bool DuplexModes::failed() const {
  return std::ranges::any_of(over_speed, is_lost);
}

DuplexModes duplex_modes(const PreloadedPair& pair) {
  DuplexModes result{.point = point_of(pair), .over_speed = over_speeds(pair)};
  result.warnings = result.point.warnings;
  return result;
}

namespace {

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

std::array<double, 5> frequencies_of(const std::optional<duplex::PairModes>& modes) {
  std::array<double, 5> found{};
  for (std::size_t i = 0; i < found.size(); ++i)
    found[i] = modes ? (*modes)[i].frequency : described::kAbsent;
  return found;
}

}  // namespace

void describe(Record& record, const PairPoint& point) {
  describe_modes(record, point.linear, point.chosen());
  if (point.published)
    record.child("other", "by the other stiffness", point, [](Record& other, const PairPoint& of) {
      describe_modes(other, !of.linear, of.linear ? of.nonlinear : *of.published);
    });
}

void describe(Record& row, const PairAtSpeed& at) {
  row.value("speed_rpm", dimension::angular_speed, "of the shaft", at.speed);
  row.value("status", "ok, or the reason why there is no static equilibrium",
            at.modes ? "ok" : at.state.report.message);
  row.array("", dimension::cycles, "order of natural_frequency; none: no static equilibrium",
            {{"mode", frequency_names()}}, frequencies_of(at.modes))
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

void describe(Record& record, const DuplexModes& result) {
  describe(record, result.point);
  if (!result.over_speed.empty())
    record.table("over_speed", "speed", "the pair at operation.speeds", result.over_speed);
}

}  // namespace orbearing::analysis
