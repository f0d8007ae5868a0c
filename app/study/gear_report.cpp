#include "app/study/gear_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <map>
#include <set>

#include "app/study/drivetrain_case.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/gear_output.hpp"
#include "app/study/mesh_output.hpp"
#include "app/study/tooth_drawing.hpp"
#include "coupling/study/parallel.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;
using boost::math::double_constants::two_pi;
using gearset::dynamics::Mode;
using gearset::dynamics::ModeKind;
using gearset::dynamics::SetModel;
constexpr int kHarmonics = 4;            // of the mesh frequency, that meet modes
constexpr std::size_t kFewestRuns = 45;  // a resonance is narrower than a usual step of the sweep
constexpr int kShapesOfKind = 2;
constexpr long kSpectrumPeriods = 32;  // of the series: lines 1/32 of an order apart
constexpr int kSpectrumOrders = 8;
constexpr double kStill = 1e-3;  // of the largest frequency: a mode below is a free rotation

ResolvedCase at_rpm(const ResolvedCase& resolved, double rpm) {
  return resolved.with("input.speed", fmt::format("{:.17g} rpm", rpm));
}

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

// Modes of one kind at one frequency of the set at rest: "T1" is the lowest translational pair. At speed a
// group of several splits.
int group_size(ModeKind kind, int planets) {
  if (kind == ModeKind::rotational) return 1;
  return kind == ModeKind::translational ? 2 : std::max(1, planets - 3);
}

const char* letter(ModeKind kind) {
  if (kind == ModeKind::rotational) return "R";
  return kind == ModeKind::translational ? "T" : "P";
}

std::string mode_name(ModeKind kind, int rank, int planets) {
  return fmt::format("{}{}", letter(kind), rank / group_size(kind, planets) + 1);
}

struct NamedFrequency {
  std::string name;
  ModeKind kind = ModeKind::rotational;
  int rank = 0;            // among the vibrating modes of its kind
  double frequency = 0.0;  // [Hz]
};

std::vector<NamedFrequency> named_frequencies(const std::vector<Mode>& modes, int planets) {
  std::vector<NamedFrequency> list;
  std::map<ModeKind, int> rank;
  for (const Mode& mode : modes) {
    if (mode.frequency <= kStill * modes.back().frequency) continue;
    for (int i = 0; i < mode.multiplicity; ++i) {
      const int place = rank[mode.kind]++;
      list.push_back({mode_name(mode.kind, place, planets), mode.kind, place, mode.frequency});
    }
  }
  return list;
}

// One speed of the report.
struct SpeedPoint {
  double rpm = 0.0;
  std::string status = "ok";
  double mesh_frequency = 0.0;  // [Hz]
  std::vector<NamedFrequency> modes;
  study::GearRunResult run;
};

SpeedPoint computed_point(const ResolvedCase& resolved, double rpm, long series_periods) {
  const SetModel model = gear_model_of(at_rpm(resolved, rpm));
  study::GearRunOptions options = gear_run_options(resolved);
  options.series_periods = std::min(series_periods, options.observed_periods);
  SpeedPoint point{.rpm = rpm, .mesh_frequency = model.operation.mesh_frequency};
  point.modes = named_frequencies(modes_at_speed(model), model.parameters.planets);
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
      },
      [] { return false; });
  return points;
}

Json runs_json(const std::vector<SpeedPoint>& points, const std::vector<double>& swept) {
  Json list = Json::array();
  for (const SpeedPoint& point : points) {
    Json row{{"speed_rpm", point.rpm},
             {"swept", std::find(swept.begin(), swept.end(), point.rpm) != swept.end()},
             {"status", point.status}};
    if (point.run.completed) {
      const Json run = gear_run_json(point.run);
      row["steady"] = point.run.steady;
      const Json& acceleration = run["planet_acceleration_m_per_s2"];
      row["acceleration_m_per_s2"] = {{"x", acceleration["x"]}, {"y", acceleration["y"]}};
      row["load_sharing"] = run["load_sharing"];
      row["parted_share"] = run["share_of_time_with_parted_teeth"];
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
    result["mesh_frequency_Hz"].push_back(points[i].mesh_frequency);
    for (const NamedFrequency& mode : points[i].modes) {
      Json& line = lines[{mode.kind, mode.rank}];
      if (line.is_null()) line = {{"name", mode.name}, {"frequency_Hz", Json(points.size(), nullptr)}};
      line["frequency_Hz"][i] = mode.frequency;
    }
  }
  result["modes"] = Json::array();
  for (auto& [place, line] : lines) result["modes"].push_back(std::move(line));
  return result;
}

// Eq. (14) of gearset/dynamics/README.md; with planets that differ it is a rule no more.
ModeKind excited_kind(int order, int sun_teeth, int planets) {
  const int component = order * sun_teeth % planets;
  if (component == 0) return ModeKind::rotational;
  return component == 1 || component == planets - 1 ? ModeKind::translational : ModeKind::planet;
}

const NamedFrequency* same_mode(const NamedFrequency& mode, const SpeedPoint& point) {
  const auto found = std::find_if(point.modes.begin(), point.modes.end(), [&](const NamedFrequency& other) {
    return other.kind == mode.kind && other.rank == mode.rank;
  });
  return found == point.modes.end() ? nullptr : &*found;
}

// Speeds where a mesh harmonic meets a mode, on straight lines between neighbours.
Json meetings(const std::vector<SpeedPoint>& points, int sun_teeth, int planets) {
  Json list = Json::array();
  for (int order = 1; order <= kHarmonics; ++order)
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      for (const NamedFrequency& mode : points[i].modes) {
        const NamedFrequency* next = same_mode(mode, points[i + 1]);
        if (!next) continue;
        const double before = order * points[i].mesh_frequency - mode.frequency;
        const double after = order * points[i + 1].mesh_frequency - next->frequency;
        if (before > 0.0 || after <= 0.0) continue;
        const double share = before / (before - after);
        list.push_back({{"order", order},
                        {"mode", mode.name},
                        {"speed_rpm", std::lerp(points[i].rpm, points[i + 1].rpm, share)},
                        {"frequency_Hz", std::lerp(mode.frequency, next->frequency, share)},
                        {"excited", excited_kind(order, sun_teeth, planets) == mode.kind}});
      }
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
    const std::string name = mode_name(mode.kind, rank[mode.kind], planets);
    rank[mode.kind] += mode.multiplicity;
    if (drawn[mode.kind]++ >= kShapesOfKind) continue;
    shapes.push_back({{"name", name},
                      {"frequency_Hz", mode.frequency},
                      {"multiplicity", mode.multiplicity},
                      {"kind", modes_json({mode})[0]["kind"]},
                      {"shape", snapshot_of(mode)}});
  }
  return {{"planets", planets},
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
      two_pi * point.mesh_frequency / static_cast<double>(periods) * (series.time - series.time[0]);
  Json result{{"speed_rpm", rpm}, {"status", point.status}, {"mesh_frequency_Hz", point.mesh_frequency}};
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
  return meshes_json(few);
}

}  // namespace

bool has_gear_report(const ResolvedCase& resolved) {
  return resolved.model() == planetary_drivetrain && !resolved.shape().several && resolved.shape().teeth;
}

nlohmann::ordered_json gear_report(const ResolvedCase& resolved, std::vector<double> speeds_rpm) {
  std::sort(speeds_rpm.begin(), speeds_rpm.end());
  const ResolvedCase fixed = resolved.without_sweep();
  const double middle = speeds_rpm[speeds_rpm.size() / 2];
  const ResolvedCase at_middle = at_rpm(fixed, middle);
  const gearset::PlanetarySet set = drivetrain_of(at_middle).set;
  const std::vector<SpeedPoint> points = computed_points(fixed, with_speeds_between(speeds_rpm));
  return {{"tooth_pairs", tooth_pairs_json(gearset::working_geometry(set), planetary_meshes_of(at_middle))},
          {"meshes", one_of_each_kind(mesh_study(at_middle))},
          {"mode_shapes", mode_shapes(gear_model_of(at_middle))},
          {"campbell", campbell(points)},
          {"meetings", meetings(points, set.sun_teeth, set.planets)},
          {"runs", runs_json(points, speeds_rpm)},
          {"spectrum", spectrum(fixed, middle)}};
}

}  // namespace orbearing::app
