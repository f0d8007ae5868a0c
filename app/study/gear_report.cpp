#include "app/study/report_data.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "app/results/record_writers.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/gear_output.hpp"
#include "app/study/mesh_study.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/resonance.hpp"
#include "app/units.hpp"
#include "coupling/study/parallel.hpp"
#include "gearset/mesh/planetary_meshes.hpp"
#include "gearset/working_geometry.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;
using Eigen::Vector2d;
constexpr double kMillimetre = 1000.0;  // per m
constexpr int kFlankPoints = 40;

// Where a gear's axis stands and which way its teeth point along the line of centres.
struct Axis {
  double centre = 0.0;  // [m]
  double sense = 1.0;
};

// Angle and radius of a point, seen from a gear's axis.
double angle_of(const Axis& axis, const Vector2d& point) {
  return std::atan2(point.x(), axis.sense * (point.y() - axis.centre));
}
double radius_of(const Axis& axis, const Vector2d& point) {
  return std::hypot(point.x(), point.y() - axis.centre);
}

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

// `side`: -1 for the tooth left of the contact, +1 for the one on its right.
template <typename Tooth>
Json gear_json(const char* name, const Tooth& tooth, const Axis& axis, const Vector2d& contact, double side) {
  const double half = half_thickness_angle(tooth, radius_of(axis, contact));
  Json drawn{{"name", name},
             {"teeth", tooth.teeth},
             {"centre_y_mm", kMillimetre * axis.centre},
             {"sense", axis.sense},
             {"axis_deg", kDegree * (angle_of(axis, contact) + side * half)},
             {"base_radius_mm", kMillimetre * tooth.base_radius},
             {"module_mm", kMillimetre * tooth.module}};
  drawn.update(flank(tooth));
  return drawn;
}

Json pair_json(const char* name, double pressure_angle, const Vector2d& contact, const Json& gears) {
  return {{"mesh", name},
          {"working_pressure_angle_deg", kDegree * pressure_angle},
          {"contact_x_mm", kMillimetre * contact.x()},
          {"contact_y_mm", kMillimetre * contact.y()},
          {"gears", gears}};
}

// The force of the tooth on the left: to the right and, as teeth grow thinner outward, outward.
Vector2d force_direction(double pressure_angle) {
  return {std::cos(pressure_angle), std::sin(pressure_angle)};
}

// Sun and planet, ring and planet, each touching at its pitch point (at the nearest place of contact where
// the teeth do not reach it). Lengths in mm from the pitch point, y along the line of centres towards the
// second axis (sun mesh) or away from both (ring mesh); the tooth on the left pushes to the right.
//
//     centre_y, sense   a point at radius R, angle phi from the line of centres is (R sin phi, centre_y +
//     sense R cos phi) axis_deg          phi of the axis of symmetry of the touching tooth radius_mm,
//     half_angle_deg   its flank from root to tip
Json tooth_pairs_json(const gearset::WorkingGeometry& geometry, const gearset::PlanetaryMeshes& meshes) {
  const double base = geometry.planet.base_radius, distance = geometry.centre_distance;
  const double sun_angle = geometry.sun_mesh.working_pressure_angle,
               ring_angle = geometry.ring_mesh.working_pressure_angle;
  const Axis sun{-geometry.sun.base_radius / std::cos(sun_angle), 1.0};
  const Axis above{sun.centre + distance, -1.0};
  const Vector2d in_sun =
      (base * std::tan(sun_angle) - gearset::pitch_point(meshes.sun_gears)) * force_direction(sun_angle);
  const Axis below{-base / std::cos(ring_angle), 1.0};
  const Axis ring{below.centre - distance, 1.0};
  const Vector2d in_ring =
      (gearset::pitch_point(meshes.ring_gears) - base * std::tan(ring_angle)) * force_direction(ring_angle);
  return Json::array({pair_json("sun and planet", sun_angle, in_sun,
                                Json::array({gear_json("sun", geometry.sun, sun, in_sun, -1.0),
                                             gear_json("planet", geometry.planet, above, in_sun, 1.0)})),
                      pair_json("planet and ring", ring_angle, in_ring,
                                Json::array({gear_json("planet", geometry.planet, below, in_ring, -1.0),
                                             gear_json("ring", geometry.ring, ring, in_ring, 1.0)}))});
}

using Json = nlohmann::ordered_json;
using constants::two_pi;
using gearset::dynamics::Mode;
using gearset::dynamics::ModeKind;
using gearset::dynamics::SetModel;
constexpr std::size_t kFewestRuns = 45;  // a resonance is narrower than a usual step of the sweep
constexpr int kShapesOfKind = 2;
constexpr long kSpectrumPeriods = 32;  // of the series: lines 1/32 of an order apart
constexpr int kSpectrumOrders = 8;
constexpr double kStill = 1e-3;  // of the largest frequency: a mode below is a free rotation

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
  study::GearRunResult run;
};

SpeedPoint computed_point(const ResolvedCase& resolved, double rpm, long series_periods) {
  const SetModel model = gear_model_of(resolved.with({input_speed(rpm)}));
  study::GearRunOptions options = gear_run_options(resolved);
  options.series_periods = std::min(series_periods, options.observed_periods);
  SpeedPoint point{.rpm = rpm,
                   .modes = {rpm * kRadiansPerSecond, model.operation.mesh_frequency,
                             diagnosis::named_frequencies(modes_at_speed(model), model.parameters.planets)}};
  point.run = run_gears(model, options);
  if (!point.run.message.empty()) point.status = point.run.message;
  return point;
}

std::vector<SpeedPoint> computed_points(const ResolvedCase& resolved, const std::vector<double>& rpm) {
  std::vector<SpeedPoint> points(rpm.size());
  std::vector<std::size_t> indices(rpm.size());
  for (std::size_t i = 0; i < rpm.size(); ++i) {
    indices[i] = i;
    points[i].rpm = rpm[i];
  }
  study::compute_points(
      indices, 0,
      [&](std::size_t i) {
        points[i] = computed_point(resolved, rpm[i], study::GearRunOptions{}.series_periods);
        return study::PointResult{};
      },
      [&](const std::vector<study::ComputedPoint>& done) {
        for (const study::ComputedPoint& one : done)
          if (!one.result.status.empty() && one.result.status != study::PointResult{}.status)
            points[one.index].status = one.result.status;
      });
  return points;
}

Json runs_json(const std::vector<SpeedPoint>& points, const std::vector<double>& swept) {
  Json list = Json::array();
  for (const SpeedPoint& point : points) {
    Json row{{"speed_rpm", point.rpm},
             {"swept", std::find(swept.begin(), swept.end(), point.rpm) != swept.end()},
             {"status", point.status}};
    if (point.run.completed) {
      Record record;
      describe_gear_run(record, point.run);
      const Json run = json_of(record);
      row["steady"] = point.run.steady;
      const Json& acceleration = run["planet_acceleration_m_per_s2"];
      row["acceleration_m_per_s2"] = {{"x", acceleration["x"]}, {"y", acceleration["y"]}};
      row["load_sharing"] = run["load_sharing"];
      row["separated_fraction"] = run["separated_fraction"];
    }
    list.push_back(std::move(row));
  }
  return list;
}

// Frequencies of each single mode over speed, gathered by kind and rank.
Json campbell(const std::vector<SpeedPoint>& points) {
  Json result{{"speed_rpm", Json::array()}, {"mesh_frequency_Hz", Json::array()}};
  std::map<std::pair<ModeKind, int>, Json> lines;
  for (std::size_t i = 0; i < points.size(); ++i) {
    result["speed_rpm"].push_back(points[i].rpm);
    result["mesh_frequency_Hz"].push_back(points[i].modes.mesh_frequency);
    for (const diagnosis::NamedFrequency& mode : points[i].modes.modes) {
      Json& line = lines[{mode.kind, mode.rank}];
      if (line.is_null()) line = {{"name", mode.name}, {"frequency_Hz", Json(points.size(), nullptr)}};
      line["frequency_Hz"][i] = mode.frequency;
    }
  }
  result["modes"] = Json::array();
  for (auto& [position, line] : lines) result["modes"].push_back(std::move(line));
  return result;
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

// The real part of a shape whose largest component is made real: how the members stand at one instant.
std::vector<double> snapshot_of(const Mode& mode) {
  const Eigen::VectorXcd shape = mode.shapes.col(0);
  Eigen::Index largest = 0;
  shape.cwiseAbs().maxCoeff(&largest);
  const Eigen::VectorXd real = (shape / shape[largest]).real();
  return {real.begin(), real.end()};
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
                      {"kind", kind_name(mode.kind)},
                      {"shape", snapshot_of(mode)}});
  }
  return {{"places_rad", model.planet_angles},
          {"centre_distance_mm", 1e3 * model.parameters.carrier.radius},
          {"sun_radius_mm", 1e3 * model.parameters.sun.radius},
          {"ring_radius_mm", 1e3 * model.parameters.ring.radius},
          {"planet_radius_mm", 1e3 * model.parameters.planet.radius},
          {"modes", shapes}};
}

// Amplitudes of the tangential load on the first planet over orders of the mesh frequency.
Json spectrum(const ResolvedCase& resolved, double rpm) {
  const SpeedPoint point = computed_point(resolved, rpm, kSpectrumPeriods);
  if (!point.run.completed) return {{"speed_rpm", rpm}, {"status", point.status}};
  const study::GearSeries& series = point.run.series;
  const double mean = series.tangential_force.row(0).mean();
  const Eigen::ArrayXd load = series.tangential_force.row(0).transpose() - mean;
  const auto samples = static_cast<double>(load.size());
  const long periods = std::min(kSpectrumPeriods, gear_run_options(resolved).observed_periods);
  const Eigen::ArrayXd angle =
      two_pi * point.modes.mesh_frequency / static_cast<double>(periods) * (series.time - series.time[0]);
  Json result{
      {"speed_rpm", rpm}, {"status", point.status}, {"mesh_frequency_Hz", point.modes.mesh_frequency}};
  result["mean_N"] = mean;
  for (long line = 1; line <= kSpectrumOrders * periods; ++line) {
    const Eigen::ArrayXd turned = static_cast<double>(line) * angle;
    result["order"].push_back(double(line) / double(periods));
    result["amplitude_N"].push_back(2.0 / samples *
                                    std::hypot((load * turned.cos()).sum(), (load * turned.sin()).sum()));
  }
  return result;
}

// Meshes of a kind differ in their phase only.
Json one_of_each_kind(const MeshStudy& study) {
  MeshStudy few;
  std::set<std::string> seen;
  for (const NamedMesh& mesh : study.meshes)
    if (seen.insert(mesh.first).second) few.meshes.push_back(mesh);
  Record record;
  describe(record, few);
  return json_of(record).at("meshes");
}

}  // namespace

bool has_gear_report(const ResolvedCase& resolved) {
  return resolved.model() == planetary_drivetrain && !resolved.shape().several && resolved.shape().teeth;
}

nlohmann::ordered_json gear_report(const ResolvedCase& resolved, std::vector<double> speeds_rpm) {
  std::sort(speeds_rpm.begin(), speeds_rpm.end());
  const ResolvedCase fixed = resolved.without_sweep();
  const double middle = speeds_rpm[speeds_rpm.size() / 2];
  const ResolvedCase at_middle = fixed.with({input_speed(middle)});
  const gearset::PlanetarySet set = drivetrain_of(at_middle).set;
  const std::vector<SpeedPoint> points = computed_points(fixed, with_speeds_between(speeds_rpm));
  return {{"tooth_pairs", tooth_pairs_json(gearset::working_geometry(set), planetary_meshes_of(at_middle))},
          {"meshes", one_of_each_kind(mesh_study(at_middle))},
          {"mode_shapes", mode_shapes(gear_model_of(at_middle))},
          {"campbell", campbell(points)},
          {"meetings", meetings_json(fixed, points, set)},
          {"runs", runs_json(points, speeds_rpm)},
          {"spectrum", spectrum(fixed, middle)}};
}

}  // namespace orbearing::app
