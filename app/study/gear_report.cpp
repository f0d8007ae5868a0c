#include "app/study/report_data.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>

#include "app/case/bearing_type.hpp"
#include "app/case/drivetrain_reader.hpp"
#include "app/results/record_writers.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/mesh_study.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/resonance_lines.hpp"
#include "app/units.hpp"
#include "coupling/analysis/parallel.hpp"
#include "gearset/mesh/planetary_meshes.hpp"
#include "gearset/working_geometry.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;
using Eigen::Vector2d;
constexpr double kMillimetre = 1000.0;  // per m
constexpr int kFlankPoints = 40;

Json flank(const gearset::ExternalTooth& tooth) {
  Json drawn;
  for (const Vector2d& point : gearset::flank_points(tooth, kFlankPoints)) {
    drawn["radius_mm"].push_back(kMillimetre * point.norm());
    drawn["half_angle_deg"].push_back(kDegree * std::atan2(point.x(), point.y()));
  }
  return drawn;
}

Json flank(const gearset::RingTooth& tooth) {
  Json drawn;
  for (int i = 0; i < kFlankPoints; ++i) {
    const double radius = std::lerp(tooth.root_radius, tooth.tip_radius, double(i) / (kFlankPoints - 1));
    drawn["radius_mm"].push_back(kMillimetre * radius);
    drawn["half_angle_deg"].push_back(kDegree * half_thickness_angle(tooth, radius));
  }
  return drawn;
}

// A tooth by its flank from root to tip and by the involute that it follows.
template <typename Tooth>
Json gear_json(const char* name, const Tooth& tooth) {
  Json drawn{{"name", name},
             {"teeth", tooth.teeth},
             {"base_radius_mm", kMillimetre * tooth.base_radius},
             {"base_half_angle_deg", kDegree * base_half_angle(tooth)},
             {"module_mm", kMillimetre * tooth.module}};
  drawn.update(flank(tooth));
  return drawn;
}

// Gears that mesh; on the line of action the pitch point as the page draws them, and where the teeth touch
// there.
Json pair_json(const char* name, double pressure_angle, double contact, const Json& gears) {
  return {{"mesh", name},
          {"working_pressure_angle_deg", kDegree * pressure_angle},
          {"contact_from_pitch_point_mm", kMillimetre * contact},
          {"gears", gears}};
}

// Sun and planet, planet and ring, each touching at its pitch point (at the nearest place of contact where
// the teeth do not reach it).
Json tooth_pairs_json(const gearset::WorkingGeometry& geometry, const gearset::PlanetaryMeshes& meshes) {
  const double base = geometry.planet.base_radius;
  const double sun_angle = geometry.sun_mesh.working_pressure_angle,
               ring_angle = geometry.ring_mesh.working_pressure_angle;
  const Json planet = gear_json("planet", geometry.planet);
  return {pair_json("sun and planet", sun_angle,
                    base * std::tan(sun_angle) - gearset::pitch_point(meshes.sun_gears),
                    {gear_json("sun", geometry.sun), planet}),
          pair_json("planet and ring", ring_angle,
                    gearset::pitch_point(meshes.ring_gears) - base * std::tan(ring_angle),
                    {planet, gear_json("ring", geometry.ring)})};
}

using gearset::dynamics::Mode;
using gearset::dynamics::ModeKind;
using gearset::dynamics::SetModel;
constexpr std::size_t kFewestRuns = 45;  // a resonance is narrower than a typical step of the sweep
constexpr int kShapesOfKind = 2;
constexpr long kSpectrumPeriods = 32;  // of the series: lines 1/32 of an order apart
constexpr double kStill = 1e-3;        // of the largest frequency: a mode below is a free rotation

// The speeds of the sweep with as many in equal steps between as make kFewestRuns.
std::vector<double> with_speeds_between(const std::vector<double>& speeds) {
  if (speeds.size() < 2) return speeds;
  const std::size_t parts = std::max<std::size_t>(1, (kFewestRuns + speeds.size() - 3) / (speeds.size() - 1));
  std::vector<double> all;
  for (std::size_t i = 0; i + 1 < speeds.size(); ++i)
    for (std::size_t part = 0; part < parts; ++part)
      all.push_back(std::lerp(speeds[i], speeds[i + 1], double(part) / double(parts)));
  all.push_back(speeds.back());
  return all;
}

// One speed of the report.
struct SpeedPoint {
  double rpm = 0.0;  // [rpm]
  diagnosis::ModesAtSpeed modes;
  std::string status = "ok";
  analysis::GearRunResult run;
};

SpeedPoint computed_point(const ResolvedCase& resolved, double rpm, long series_periods) {
  const SetModel model = gear_model_of(resolved.with({input_speed(rpm)}));
  analysis::GearRunOptions options = gear_run_options(resolved);
  options.series_periods = std::min(series_periods, options.observed_periods);
  SpeedPoint point{.rpm = rpm, .modes = diagnosis::named_modes_at(rpm * kRadiansPerSecond, model)};
  point.run = run_gears(model, options);
  if (!point.run.message.empty()) point.status = point.run.message;
  return point;
}

std::vector<SpeedPoint> computed_points(const ResolvedCase& resolved, const std::vector<double>& rpm) {
  std::vector<SpeedPoint> points(rpm.size());
  analysis::in_parallel(rpm.size(), 0, [&](std::size_t i) {
    try {
      points[i] = computed_point(resolved, rpm[i], analysis::GearRunOptions{}.series_periods);
    } catch (const std::exception& error) {
      points[i] = {.rpm = rpm[i], .status = error.what()};
    }
  });
  return points;
}

// Modes in the carrier's frame, and what the run of the gears alone gives.
Json speed_json(const SpeedPoint& point) {
  Json row{{"speed_rpm", point.rpm},
           {"status", point.status},
           {"mesh_frequency_Hz", point.modes.mesh_frequency},
           {"modes", Json::array()}};
  for (const diagnosis::NamedFrequency& mode : point.modes.modes)
    row["modes"].push_back(
        {{"name", mode.name}, {"kind", mode.kind}, {"rank", mode.rank}, {"frequency_Hz", mode.frequency}});
  if (!point.run.completed) return row;
  row["run"] = json_of(record_of(point.run));
  return row;
}

Json meetings_json(const ResolvedCase& resolved, const std::vector<SpeedPoint>& points,
                   const gearset::PlanetarySet& set) {
  std::vector<diagnosis::ModesAtSpeed> modes;
  for (const SpeedPoint& point : points) modes.push_back(point.modes);
  Json list = Json::array();
  const auto modes_at = [&](double speed) { return modes_at_rpm(resolved, speed * kRpm); };
  for (const diagnosis::Meeting& meeting : diagnosis::meetings(modes, set, modes_at))
    list.push_back({{"order", meeting.order},
                    {"mode", meeting.mode.name},
                    {"speed_rpm", meeting.speed * kRpm},
                    {"frequency_Hz", meeting.mode.frequency},
                    {"excited", meeting.excited}});
  return list;
}

// The real part of a shape whose largest component is made real: the positions of the members at one instant.
std::vector<double> snapshot_of(const Mode& mode) {
  const analysis::ModeShape shape = analysis::shape_of(mode);
  const Eigen::VectorXd flat = shape.position.reshaped<Eigen::RowMajor>();
  return {flat.begin(), flat.end()};
}

Json mode_shapes(const SetModel& model) {
  const int planets = model.parameters.planets;
  Json shapes = Json::array();
  std::map<ModeKind, int> drawn, rank;
  const std::vector<Mode> modes = modes_at_rest(model);
  for (const Mode& mode : modes) {
    if (mode.frequency <= kStill * modes.back().frequency) continue;
    const std::string name = diagnosis::mode_name(mode.kind, rank[mode.kind], planets);
    rank[mode.kind] += mode.multiplicity;
    if (drawn[mode.kind]++ >= kShapesOfKind) continue;
    shapes.push_back({{"name", name},
                      {"frequency_Hz", mode.frequency},
                      {"multiplicity", mode.multiplicity},
                      {"kind", analysis::kind_name(mode.kind)},
                      {"shape", snapshot_of(mode)}});
  }
  return {{"places_rad", model.planet_angles},
          {"centre_distance_mm", 1e3 * model.parameters.carrier.radius},
          {"sun_radius_mm", 1e3 * model.parameters.sun.radius},
          {"ring_radius_mm", 1e3 * model.parameters.ring.radius},
          {"planet_radius_mm", 1e3 * model.parameters.planet.radius},
          {"modes", shapes}};
}

// The tangential load on the first planet over so many periods of the mesh.
Json load_series(const ResolvedCase& resolved, double rpm) {
  const SpeedPoint point = computed_point(resolved, rpm, kSpectrumPeriods);
  Json result{
      {"speed_rpm", rpm}, {"status", point.status}, {"mesh_frequency_Hz", point.modes.mesh_frequency}};
  if (!point.run.completed) return result;
  result["periods"] = std::min(kSpectrumPeriods, gear_run_options(resolved).observed_periods);
  const analysis::GearSeries& series = point.run.series;
  result["time_s"] = std::vector<double>(series.time.begin(), series.time.end());
  for (const double load : series.tangential_force.row(0)) result["load_N"].push_back(load);
  return result;
}

}  // namespace

bool has_gear_report(const ResolvedCase& resolved) {
  return resolved.model() == planetary_drivetrain && resolved.shape().teeth &&
         gears_can_move(stated_drivetrain(resolved));
}

nlohmann::ordered_json gear_report(const ResolvedCase& resolved, std::vector<double> speeds_rpm) {
  std::sort(speeds_rpm.begin(), speeds_rpm.end());
  const ResolvedCase fixed = resolved.without_sweep();
  const double middle = speeds_rpm[speeds_rpm.size() / 2];
  const ResolvedCase at_middle = fixed.with({input_speed(middle)});
  const gearset::PlanetarySet set = drivetrain_of(at_middle).set;
  const std::vector<SpeedPoint> points = computed_points(fixed, with_speeds_between(speeds_rpm));
  Json speeds = Json::array();
  for (const SpeedPoint& point : points) speeds.push_back(speed_json(point));
  return {{"tooth_pairs", tooth_pairs_json(gearset::working_geometry(set), planetary_meshes_of(at_middle))},
          {"meshes", json_of(record_of(mesh_study(at_middle))).at("meshes")},
          {"mode_shapes", mode_shapes(gear_model_of(at_middle))},
          {"meetings", meetings_json(fixed, points, set)},
          {"swept_rpm", speeds_rpm},
          {"speeds", speeds},
          {"load_series", load_series(fixed, middle)}};
}

}  // namespace orbearing::app
