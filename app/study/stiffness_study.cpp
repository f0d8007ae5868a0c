#include "app/study/stiffness_study.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "app/case/machine_of.hpp"
#include "app/case/machines.hpp"
#include "app/errors.hpp"
#include "app/results/record_writers.hpp"
#include "app/study/planetary_case.hpp"
#include "bearing/equilibrium/lamina_stiffness.hpp"

namespace orbearing::app {

namespace {

namespace equilibrium = bearing::equilibrium;
namespace laminae = bearing::laminae;
using analysis::default_laminae;

std::vector<double> list_or(const ResolvedCase& in, const char* path, double otherwise) {
  return in.has(path) ? in.list(path) : std::vector<double>{otherwise};
}

// Effect of a profile that the case does not state, on the first point.
std::optional<std::string> warning_of_profile(const ResolvedCase& in, analysis::RollerSupport rollers,
                                              const StiffnessPoint& point) {
  const char* path = "bearing.profile.kind";
  if (!in.has(path) || in.origin(path) != "default" || !point.stiffness) return std::nullopt;
  rollers.bearing.rollers().profile = {};
  if (!rollers.load_factors.empty()) rollers.load_factors.resize(1);
  const StiffnessPoint straight = stiffness_of_rollers(rollers).points.front();
  if (!straight.stiffness) return std::nullopt;
  const auto change = [&](int axis) {
    return 100.0 * ((*straight.stiffness)(axis, axis) / (*point.stiffness)(axis, axis) - 1.0);
  };
  return fmt::format(
      "{}: not given; {} is used. Straight rollers change the stiffness along the load by {:+.0f} % and "
      "across it by {:+.0f} %",
      path, in.choice(path), change(0), change(1));
}

StiffnessStudy roller_stiffness(const ResolvedCase& in) {
  const auto rollers = machine_of<analysis::RollerSupport>(in);
  StiffnessStudy study = stiffness_of_rollers(rollers);
  if (!in.has("bearing.laminae"))
    study.warnings.push_back(fmt::format(
        "bearing.laminae: not given; {} are used, and stiffness depends on their number", default_laminae));
  if (const auto warning = warning_of_profile(in, rollers, study.points.front()))
    study.warnings.push_back(*warning);
  return study;
}

// The shaft of a duplex pair under its preload.
StiffnessStudy pair_stiffness(const ResolvedCase& in) {
  auto pair = machine_of<analysis::PreloadedPair>(in);
  const double own = pair.operation.shaft_speed;
  StiffnessStudy study{.frame = "shaft against both outer rings, about its mass centre; z along the axis",
                       .damping = "a static equilibrium has none"};
  for (const double speed : list_or(in, "operation.speeds", own)) {
    pair.operation.shaft_speed = speed;
    const analysis::PairPoint found = result_for(in, [&] { return analysis::point_of(pair); });
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
      .damping = "rollers and cage at their kinematic speeds: a static equilibrium has none"};
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
  if (in.model() == roller_bearing) {
    study = roller_stiffness(in);
  } else if (in.model() == ball_bearing) {
    study = stiffness_of_balls(machine_of<analysis::BallSupport>(in));
  } else if (in.model() == planetary_drivetrain && (in.shape().several || in.shape().bearing)) {
    study = planet_stiffness_of(in);
  } else if (in.model() == duplex_pair) {
    study = pair_stiffness(in);
  } else {
    throw BadInput(in.origin("model") + ": model: found " + in.choice("model") +
                   " without a bearing in static equilibrium; required: ball-bearing without a block "
                   "simulation, roller-bearing, duplex-pair, or planetary-drivetrain with bearings");
  }
  for (const StiffnessPoint& point : study.points)
    if (!point.stiffness)
      study.warnings.push_back(fmt::format("{:.6g} rpm: {}", speed_in_rpm(point.speed), point.status));
  return study;
}

namespace {

constexpr std::array<const char*, 5> ring_axes{"x", "y", "z", "tilt_x", "tilt_y"};

// Units of a row of the stiffness by a column of it.
const char* unit_of(std::size_t row, std::size_t column) {
  if (row < 3) return column < 3 ? "N/m" : "N/rad";
  return column < 3 ? "N m/m" : "N m/rad";
}

double entry(const StiffnessPoint& point, std::size_t row, std::size_t column) {
  if (!point.stiffness) return std::numeric_limits<double>::quiet_NaN();
  return (*point.stiffness)(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
}

double displaced(const StiffnessPoint& point, std::size_t axis) {
  if (!point.stiffness) return std::numeric_limits<double>::quiet_NaN();
  return point.displacement[static_cast<Eigen::Index>(axis)];
}

// A worksheet of the oldest format that readers still support: a stream of records, no container around it.
class Worksheet {
 public:
  Worksheet() { record(0x0409, {0x0000, 0x0010, 0x0000}); }  // BOF: a sheet

  void number(std::size_t row, std::size_t column, double value) {
    std::string data = cell(row, column);
    for (auto bits = std::bit_cast<std::uint64_t>(value), i = std::uint64_t{0}; i < 8; ++i, bits >>= 8)
      data.push_back(static_cast<char>(bits & 0xff));
    put(0x0203, data);
  }
  void label(std::size_t row, std::size_t column, const std::string& text) {
    put(0x0204, cell(row, column) + little(text.size()) + text);
  }
  std::string finished() {
    put(0x000a, {});
    return bytes_;
  }

 private:
  static std::string little(std::size_t value) {
    return {static_cast<char>(value & 0xff), static_cast<char>((value >> 8) & 0xff)};
  }
  static std::string cell(std::size_t row, std::size_t column) {
    return little(row) + little(column) + little(0);  // no format
  }
  void put(std::size_t kind, const std::string& data) { bytes_ += little(kind) + little(data.size()) + data; }
  void record(std::size_t kind, std::initializer_list<std::size_t> words) {
    std::string data;
    for (const std::size_t word : words) data += little(word);
    put(kind, data);
  }

  std::string bytes_;
};

}  // namespace

std::string stiffness_csv(const StiffnessStudy& study) {
  std::string text = "set,speed_rpm";
  for (const auto& [name, value] : study.points.front().load) text += "," + name;
  for (std::size_t axis = 0; axis < ring_axes.size(); ++axis)
    text += fmt::format(",{}_{}", ring_axes[axis], axis < 3 ? "m" : "rad");
  for (std::size_t row = 0; row < ring_axes.size(); ++row)
    for (std::size_t column = 0; column < ring_axes.size(); ++column)
      text += fmt::format(",k_{}_{} [{}]", ring_axes[row], ring_axes[column], unit_of(row, column));
  text += ",status\n";
  const auto field = [](double value) {
    return std::isfinite(value) ? fmt::format(",{}", value) : std::string(",");
  };
  for (const StiffnessPoint& point : study.points) {
    text += point.set + field(speed_in_rpm(point.speed));
    for (std::size_t i = 0; i < study.points.front().load.size(); ++i)
      text += i < point.load.size() ? field(point.load[i].second) : std::string(",");
    for (std::size_t axis = 0; axis < ring_axes.size(); ++axis) text += field(displaced(point, axis));
    for (std::size_t row = 0; row < ring_axes.size(); ++row)
      for (std::size_t column = 0; column < ring_axes.size(); ++column)
        text += field(entry(point, row, column));
    text += ",\"" + point.status + "\"\n";
  }
  return text;
}

std::string ross_table(const StiffnessStudy& study, std::size_t series) {
  std::vector<const StiffnessPoint*> points;
  for (const StiffnessPoint& point : study.points)
    if (point.series == series && point.stiffness) points.push_back(&point);
  std::sort(points.begin(), points.end(),
            [](const StiffnessPoint* a, const StiffnessPoint* b) { return a->speed < b->speed; });
  Worksheet sheet;
  // The last names no column of ROSS, which skips it.
  constexpr std::array<const char*, 10> heads{
      "kxx",   "kxy",
      "kyx",   "kyy",
      "cxx",   "cxy",
      "cyx",   "cyy",
      "speed", "x is along the load (of a planet: outward), y across; weight in ROSS is along y"};
  for (std::size_t i = 0; i < heads.size(); ++i) sheet.label(0, i, heads[i]);
  std::size_t row = 0;
  const auto put_row = [&](const StiffnessPoint& before, const StiffnessPoint& after, double share) {
    ++row;
    for (std::size_t i = 0; i < 4; ++i)
      sheet.number(row, i, std::lerp(entry(before, i / 2, i % 2), entry(after, i / 2, i % 2), share));
    for (std::size_t i = 4; i < 8; ++i) sheet.number(row, i, 0.0);  // no damping
    sheet.number(row, 8, std::lerp(before.speed, after.speed, share));
  };
  if (points.empty()) return sheet.finished();
  constexpr double range = 1000.0;  // [rad/s]  over which a single point is constant
  StiffnessPoint again = *points.front();
  again.speed += range;
  if (points.size() == 1) points.push_back(&again);
  constexpr std::size_t least_intervals = 4;  // ROSS 3 warns of fewer than five speeds
  const std::size_t intervals = points.size() - 1;
  const std::size_t parts = (least_intervals + intervals - 1) / intervals;
  for (std::size_t i = 0; i < intervals; ++i)
    for (std::size_t part = 0; part < parts; ++part)
      put_row(*points[i], *points[i + 1], static_cast<double>(part) / static_cast<double>(parts));
  put_row(*points.back(), *points.back(), 0.0);
  return sheet.finished();
}

}  // namespace orbearing::app
