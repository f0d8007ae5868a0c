#include "app/study/stiffness_study.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "app/case/static_case.hpp"
#include "app/errors.hpp"
#include "app/results/result_row.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/static_study.hpp"
#include "bearing/equilibrium/lamina_stiffness.hpp"
#include "bearing/equilibrium/static_bearing.hpp"

namespace orbearing::app {

namespace {

namespace equilibrium = bearing::equilibrium;
namespace laminae = bearing::laminae;

std::vector<double> list_or(const ResolvedCase& in, const char* path, double otherwise) {
  return in.has(path) ? in.list(path) : std::vector<double>{otherwise};
}

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

StiffnessStudy single_stiffness(const ResolvedCase& in) {
  const bearing::Bearing bearing = bearing_of(in);
  equilibrium::RowMotion motion = row_motion_of(in);
  StiffnessStudy study{
      .series = 0,
      .frame =
          "inner ring against the outer one; x along the radial load, z along the axis; load.moment_across "
          "acts about x, load.moment about -y",
      .damping =
          "a balance has none; the film follows from speed and load alone, it has no rate of approach"};
  const std::vector<double> speeds = list_or(in, "operation.speeds", motion.speeds.inner);
  for (const double factor : list_or(in, "operation.load_factors", 1.0)) {
    for (const double speed : speeds) {
      motion.speeds.inner = speed;
      study.points.push_back(single_point(bearing, motion, scaled(ring_load_of(in), factor)));
      study.points.back().series = study.series;
    }
    ++study.series;
  }
  if (in.model() == roller_bearing && !in.has("bearing.laminae"))
    study.warnings.push_back(fmt::format(
        "bearing.laminae: not given; {} are taken, and stiffness depends on their number", default_laminae));
  return study;
}

// Whole contacts hold no tilt of their own: as straight laminae, whose loads are the same, they do.
bearing::Bearing with_laminae(const study::PlanetaryDrivetrain& drivetrain) {
  bearing::Bearing bearing = drivetrain.bearing;
  if (bearing.rollers().laminae > 0) return bearing;
  bearing.rollers().laminae = default_laminae;
  bearing.rollers().profile = {};
  return bearing;
}

StiffnessPoint planet_point(const study::NamedSet& set, double speed) {
  const study::BearingDuty duty = study::bearing_duty(set.drivetrain, set.geometry);
  const bearing::QuasiStaticOptions options = study::quasi_static_options(set.drivetrain);
  const laminae::LaminaBearing bearing(with_laminae(set.drivetrain));
  bearing::OperatingPoint at = duty.point;
  if (set.drivetrain.bearing.rollers().laminae == 0) at.bore_tilt.setZero();  // as its sweep has it
  const bearing::QuasiStaticResult result = quasi_static_bearing(bearing, at, options);
  StiffnessPoint point{.speed = speed,
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

StiffnessStudy planet_stiffness_of(const ResolvedCase& in) {
  StiffnessStudy study{
      .frame =
          "bore of one planet bearing against its pin, in the carrier's frame; x outward from the sun, y "
          "along the carrier's rotation, z along the axis",
      .damping = "rollers and cage at their kinematic speeds: a balance has none"};
  for (std::size_t i = 0; i < sweep_size(in); ++i) {
    const ResolvedCase at = in.with(sweep_point(in, i)).without_sweep();
    for (const study::NamedSet& set : bearing_sets(at)) {
      try {
        study.points.push_back(planet_point(set, at.quantity("input.speed")));
      } catch (const std::domain_error& error) {
        study.points.push_back(
            {.speed = at.quantity("input.speed"), .set = set.name, .status = error.what()});
      }
    }
  }
  // One table for each set.
  std::vector<std::string> names;
  for (StiffnessPoint& point : study.points) {
    const auto found = std::find(names.begin(), names.end(), point.set);
    point.series = static_cast<std::size_t>(found - names.begin());
    if (found == names.end()) names.push_back(point.set);
  }
  study.series = names.size();
  if (in.has("bearing.rollers") && !in.has("bearing.laminae"))
    study.warnings.push_back(
        fmt::format("bearing.laminae: not given; the stiffness against tilt is that of {} straight laminae",
                    default_laminae));
  return study;
}

}  // namespace

StiffnessStudy stiffness_study(const ResolvedCase& in) {
  StiffnessStudy study;
  if (is_static_bearing(in)) {
    study = single_stiffness(in);
  } else if (in.model() == planetary_drivetrain && (in.shape().several || in.shape().bearing)) {
    study = planet_stiffness_of(in);
  } else {
    throw BadInput(in.origin("model") + ": model: found " + in.choice("model") +
                   " without a bearing in balance; required: ball-bearing without a block simulation, "
                   "roller-bearing, or planetary-drivetrain with bearings");
  }
  for (const StiffnessPoint& point : study.points)
    if (!point.stiffness)
      study.warnings.push_back(fmt::format("{:.6g} rpm: {}", speed_in_rpm(point.speed), point.status));
  return study;
}

namespace {

using described::Record;
namespace dimension = described::dimension;

constexpr const char* kOfRing = "x, y, z [m], tilt about x, tilt about y [rad]";

}  // namespace

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
    row.nothing("stiffness", "no balance");
    row.nothing("displacement", "no balance");
  }
  if (point.largest_pressure)
    row.value("pressure_max_MPa", dimension::pressure, "after Hertz", point.largest_pressure);
  row.nothing("damping", "none");
  row.value("status", "ok, or why there is no balance", point.status);
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
  record.value("frame", "what moves against what", study.frame);
  record.child("damping", "of the ring", study, [](Record& damping, const StiffnessStudy& of) {
    damping.nothing("value", "none");
    damping.value("reason", "why there is none", of.damping);
  });
}

}  // namespace orbearing::app
