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

#include "app/case/input_keys.hpp"
#include "app/case/machine_of.hpp"
#include "app/case/machines.hpp"
#include "app/errors.hpp"
#include "app/results/record_writers.hpp"
#include "app/study/planetary_case.hpp"

namespace orbearing::app {

namespace {

StiffnessStudy roller_stiffness(const ResolvedCase& in) {
  const auto rollers = machine_of<analysis::RollerSupport>(in);
  StiffnessStudy study = stiffness_of_rollers(rollers);
  if (!in.has(keys().laminae))
    study.warnings.push_back(
        fmt::format("bearing.laminae: not given; {} are used, and stiffness depends on their number",
                    analysis::default_laminae));
  const std::string& profile = keys().profile_kind;
  if (!in.has(profile) || in.origin(profile) != "default") return study;
  if (const auto effect = effect_of_straight_rollers(rollers, study.points.front()))
    study.warnings.push_back(
        fmt::format("{}: not given; {} is used. {}", profile, in.choice(profile), *effect));
  return study;
}

StiffnessStudy planet_stiffness(const ResolvedCase& in) {
  std::vector<StiffnessPoint> points;
  for (std::size_t i = 0; i < sweep_size(in); ++i)
    for (const analysis::NamedSet& set : bearing_sets(in.with(sweep_point(in, i)).without_sweep()))
      points.push_back(analysis::stiffness_of_planet_bearing(set));
  const std::vector<analysis::NamedSet> stated = stated_sets(in);
  const bool whole = !in.shape().several && stated.front().drivetrain.bearing.has_rollers() &&
                     stated.front().drivetrain.bearing.rollers().laminae == 0;
  return analysis::stiffness_of_planet_bearings(std::move(points), whole);
}

}  // namespace

StiffnessStudy stiffness_study(const ResolvedCase& in) {
  StiffnessStudy study;
  if (in.model() == roller_bearing) {
    study = roller_stiffness(in);
  } else if (in.model() == ball_bearing) {
    study = stiffness_of_balls(machine_of<analysis::BallSupport>(in));
  } else if (in.model() == planetary_drivetrain && (in.shape().several || in.shape().bearing)) {
    study = planet_stiffness(in);
  } else if (in.model() == duplex_pair) {
    study = result_for(in, [&] { return stiffness_of_pair(machine_of<analysis::PreloadedPair>(in)); });
  } else {
    throw BadInput(in.origin("model") + ": model: found " + in.choice("model") +
                   " without a bearing in static equilibrium; required: ball-bearing without a block "
                   "simulation, roller-bearing, duplex-pair, or planetary-drivetrain with bearings");
  }
  analysis::warn_of_failed_points(study);
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
