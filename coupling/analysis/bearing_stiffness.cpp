#include "coupling/analysis/bearing_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bearing/equilibrium/lamina_stiffness.hpp"
#include "bearing/equilibrium/row_group.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::analysis {

namespace {

namespace equilibrium = bearing::equilibrium;
using described::Record;
namespace dimension = described::dimension;

constexpr const char* kOfRing = "x, y, z [m], tilt about x, tilt about y [rad]";

equilibrium::RingLoad scaled(equilibrium::RingLoad load, double factor) {
  load.radial *= factor;
  load.axial *= factor;
  load.moment *= factor;
  load.moment_across *= factor;
  return load;
}

StiffnessPoint single_point(const bearing::Bearing& bearing, const equilibrium::RowMotion& motion,
                            const equilibrium::RingLoad& load) {
  const equilibrium::RingState state = equilibrium::balance_bearing(bearing, motion, load);
  StiffnessPoint point{.speed = bearing.has_rollers() ? 0.0 : motion.speeds.inner,
                       .load = {{"radial_N", load.radial},
                                {"axial_N", load.axial},
                                {"moment_N_m", state.moment},
                                {"moment_across_N_m", state.lateral_moment}}};
  if (!state.report.converged) {
    point.status = state.report.message;
    return point;
  }
  point.stiffness = equilibrium::stiffness_by_axes(state);
  point.displacement = equilibrium::displacement_by_axes(state);
  point.largest_pressure = state.largest_pressure;
  return point;
}

// At each factor over each speed of the inner ring; a factor is a series.
StiffnessStudy over_loads_and_speeds(const bearing::Bearing& bearing, equilibrium::RowMotion motion,
                                     const equilibrium::RingLoad& load, const std::vector<double>& factors,
                                     const std::vector<double>& speeds) {
  StiffnessStudy study{
      .series = 0,
      .frame =
          "inner ring against the outer one; x along the radial load, z along the axis; load.moment_across "
          "acts about x, load.moment about -y",
      .damping =
          "a static equilibrium has none; the film depends on speed and load only, not on the rate of "
          "approach"};
  for (const double factor : factors) {
    for (const double speed : speeds) {
      motion.speeds.inner = speed;
      study.points.push_back(single_point(bearing, motion, scaled(load, factor)));
      study.points.back().series = study.series;
    }
    ++study.series;
  }
  return study;
}

std::vector<double> list_or(const std::vector<double>& list, double otherwise) {
  return list.empty() ? std::vector<double>{otherwise} : list;
}

}  // namespace

StiffnessStudy stiffness_of_rollers(const RollerSupport& in) {
  bearing::Bearing bearing = in.bearing;
  bearing::put_profile(in.profile, bearing);
  return over_loads_and_speeds(bearing, {}, in.load, list_or(in.load_factors, 1.0), {0.0});
}

StiffnessStudy stiffness_of_balls(const BallSupport& in) {
  return over_loads_and_speeds(in.bearing, row_motion(in.rotation, in.balls, in.oil.lubricant), in.load,
                               list_or(in.load_factors, 1.0), list_or(in.speeds, in.rotation.shaft_speed));
}

void warn_of_failed_points(StiffnessStudy& study) {
  constexpr int digits = 6;
  for (const StiffnessPoint& point : study.points)
    if (!point.stiffness)
      study.warnings.push_back(
          mechanics::significant(mechanics::in_unit(point.speed, 30.0 / constants::pi), digits) +
          " rpm: " + point.status);
}

std::optional<std::string> effect_of_straight_rollers(RollerSupport in, const StiffnessPoint& first) {
  if (!first.stiffness) return std::nullopt;
  in.bearing.rollers().profile = {};
  in.profile = {};
  if (!in.load_factors.empty()) in.load_factors = {in.load_factors.front()};
  const StiffnessPoint straight = stiffness_of_rollers(in).points.front();
  if (!straight.stiffness) return std::nullopt;
  const auto change = [&](int axis) {
    const double percent = 100.0 * ((*straight.stiffness)(axis, axis) / (*first.stiffness)(axis, axis) - 1.0);
    return (std::signbit(percent) ? "" : "+") + mechanics::with_decimals(percent, 0) + " %";
  };
  return "Straight rollers change the stiffness along the load by " + change(0) + " and across it by " +
         change(1);
}

StiffnessStudy stiffness_of_pair(PreloadedPair pair) {
  StiffnessStudy study{.frame = "shaft against both outer rings, about its mass centre; z along the axis",
                       .damping = "a static equilibrium has none"};
  for (const double speed : list_or(pair.operation.speeds, pair.operation.shaft_speed)) {
    pair.operation.shaft_speed = speed;
    const PairPoint found = point_of(pair);
    StiffnessPoint point{.speed = speed, .load = {{"preload_N", pair.preload}}};
    point.stiffness =
        equilibrium::turned_to_axes() * found.chosen().stiffness * equilibrium::turned_to_axes().transpose();
    point.displacement = equilibrium::displacement_by_axes(found.state);
    point.largest_pressure = found.state.largest_pressure;
    study.points.push_back(point);
    study.warnings = found.warnings;
  }
  return study;
}

namespace {

// Whole contacts hold no tilt of their own: as straight laminae, whose loads are the same, they do.
bearing::Bearing with_laminae(const PlanetaryDrivetrain& drivetrain) {
  bearing::Bearing bearing = drivetrain.bearing;
  if (bearing.rollers().laminae > 0) return bearing;
  bearing.rollers().laminae = default_laminae;
  bearing.rollers().profile = {};
  return bearing;
}

StiffnessPoint planet_point(const NamedSet& set) {
  namespace laminae = bearing::laminae;
  const BearingDuty duty = bearing_duty(set.drivetrain, set.geometry);
  const bearing::QuasiStaticOptions options = quasi_static_options(set.drivetrain);
  const laminae::LaminaBearing bearing(with_laminae(set.drivetrain));
  bearing::OperatingPoint at = duty.point;
  if (set.drivetrain.bearing.rollers().laminae == 0) at.bore_tilt.setZero();  // as its sweep has it
  const bearing::QuasiStaticResult result = quasi_static_bearing(bearing, at, options);
  StiffnessPoint point{.speed = set.drivetrain.drive.speed,
                       .load = {{"x_N", result.total_bore_load[0]}, {"y_N", result.total_bore_load[1]}},
                       .set = set.name};
  if (!result.report.converged) {
    point.status = result.report.message;
    return point;
  }
  point.stiffness = laminae::about_axes(laminae::mean_stiffness(bearing, result, at.outer_race));
  point.displacement << result.displacement, 0.0, -at.bore_tilt[1], at.bore_tilt[0];
  return point;
}

}  // namespace

StiffnessPoint stiffness_of_planet_bearing(const NamedSet& set) {
  try {
    return planet_point(set);
  } catch (const std::domain_error& error) {
    return {.speed = set.drivetrain.drive.speed, .set = set.name, .status = error.what()};
  }
}

StiffnessStudy stiffness_of_planet_bearings(std::vector<StiffnessPoint> points, bool whole_contacts) {
  StiffnessStudy study{
      .points = std::move(points),
      .frame =
          "bore of one planet bearing against its pin, in the carrier's frame; x outward from the sun, y "
          "along the carrier's rotation, z along the axis",
      .damping = "rollers and cage at their kinematic speeds: a static equilibrium has none"};
  std::vector<std::string> names;
  for (StiffnessPoint& point : study.points) {
    const auto found = std::ranges::find(names, point.set);
    point.series = static_cast<std::size_t>(found - names.begin());
    if (found == names.end()) names.push_back(point.set);
  }
  study.series = names.size();
  if (whole_contacts)
    study.warnings.push_back("bearing.laminae: not given; the stiffness against tilt is that of " +
                             std::to_string(default_laminae) + " straight laminae");
  return study;
}

void describe(Record& row, const StiffnessPoint& point) {
  row.value("speed_rpm", dimension::angular_speed, "of the inner ring; of a drivetrain, of its input",
            point.speed);
  row.child("load", "on the ring that moves", point, [](Record& loads, const StiffnessPoint& of) {
    for (const auto& [name, value] : of.load)
      loads.value(name, name.ends_with("_m") ? dimension::torque : dimension::force, "", value);
  });
  if (!point.set.empty()) row.value("set", "whose planet bearing", point.set);
  if (point.stiffness) {
    row.array("stiffness", {},
              "rows and columns x, y, z, tilt about x, tilt about y: N/m, N/rad, N m/m, N m/rad",
              {"row", "column"}, *point.stiffness);
    row.array("displacement", {}, kOfRing, {"row"}, point.displacement);
  } else {
    row.nothing("stiffness", "no static equilibrium");
    row.nothing("displacement", "no static equilibrium");
  }
  if (point.largest_pressure)
    row.value("pressure_max_MPa", dimension::pressure, "after Hertz", point.largest_pressure);
  row.nothing("damping", "none");
  row.value("status", "ok, or the reason why there is no static equilibrium", point.status);
  row.value("series", "points that belong to one table over speed", point.series);
}

void describe(Record& record, const StiffnessStudy& study) {
  record.table("points", "point", study.frame, study.points).variable = "";
  record.value("order", "of rows and columns", described::Texts{"x", "y", "z", "tilt_x", "tilt_y"});
  record.child("units", "of the stiffness", study, [](Record& units, const StiffnessStudy&) {
    units.value("force_by_place", "", "N/m");
    units.value("force_by_tilt", "", "N/rad");
    units.value("moment_by_place", "", "N m/m");
    units.value("moment_by_tilt", "", "N m/rad");
    units.value("displacement", "", "m, rad");
  });
  record.value("frame", "relative motion", study.frame);
  record.child("damping", "of the ring", study, [](Record& damping, const StiffnessStudy& of) {
    damping.nothing("value", "none");
    damping.value("reason", "why there is none", of.damping);
  });
}

}  // namespace orbearing::analysis
