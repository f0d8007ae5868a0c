#include "app/study/stiffness_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/results/json_number.hpp"
#include "app/results/result_row.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

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

Json point_json(const StiffnessPoint& point) {
  Json object{{"speed_rpm", speed_in_rpm(point.speed)}, {"load", Json::object()}};
  for (const auto& [name, value] : point.load) object["load"][name] = value;
  if (!point.set.empty()) object["set"] = point.set;
  Json displacement = Json::array();
  for (const double value : point.displacement) displacement.push_back(value);
  object["stiffness"] = point.stiffness ? stiffness_json(*point.stiffness) : Json(nullptr);
  object["displacement"] = point.stiffness ? displacement : Json(nullptr);
  if (point.largest_pressure) object["pressure_max_MPa"] = 1e-6 * *point.largest_pressure;
  object["damping"] = nullptr;
  object["status"] = point.status;
  return object;
}

// A worksheet of the oldest kind that readers still know: a stream of records, no container around it.
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

Json stiffness_json(const bearing::equilibrium::RingStiffness& stiffness) {
  Json rows = Json::array();
  for (const auto& row : stiffness.rowwise()) rows.push_back(std::vector<double>(row.begin(), row.end()));
  return rows;
}

Json stiffness_json(const StiffnessStudy& study) {
  Json points = Json::array();
  for (const StiffnessPoint& point : study.points) points.push_back(point_json(point));
  return {{"points", points},
          {"order", ring_axes},
          {"units",
           {{"force_by_place", "N/m"},
            {"force_by_tilt", "N/rad"},
            {"moment_by_place", "N m/m"},
            {"moment_by_tilt", "N m/rad"},
            {"displacement", "m, rad"}}},
          {"frame", study.frame},
          {"damping", {{"value", nullptr}, {"reason", study.damping}}}};
}

std::string stiffness_text(const StiffnessStudy& study) {
  std::string text = study.frame + "\n";
  for (const StiffnessPoint& point : study.points) {
    text += fmt::format("\n{:.6g} rpm", speed_in_rpm(point.speed));
    if (!point.set.empty()) text += ", " + point.set;
    for (const auto& [name, value] : point.load) text += fmt::format(", {} {:.6g}", name, value);
    if (!point.stiffness) {
      text += ": " + point.status + "\n";
      continue;
    }
    text += fmt::format("\n{:>8}", "");
    for (const char* axis : ring_axes) text += fmt::format(" {:>13}", axis);
    for (std::size_t row = 0; row < ring_axes.size(); ++row) {
      text += fmt::format("\n{:>8}", ring_axes[row]);
      for (std::size_t column = 0; column < ring_axes.size(); ++column)
        text += fmt::format(" {:>13.5g}", entry(point, row, column));
    }
    text += "\n";
  }
  return text + "\n[N/m], [N/rad], [N m/m], [N m/rad]; no damping: " + study.damping + "\n";
}

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

PointContent stiffness_content(const StiffnessStudy& study) {
  PointContent content;
  content.dimensions = {
      {"point", study.points.size()}, {"row", ring_axes.size()}, {"column", ring_axes.size()}};
  std::vector<double> stiffness, displacement;
  for (const StiffnessPoint& point : study.points)
    for (std::size_t row = 0; row < ring_axes.size(); ++row) {
      displacement.push_back(displaced(point, row));
      for (std::size_t column = 0; column < ring_axes.size(); ++column)
        stiffness.push_back(entry(point, row, column));
    }
  content.add_each("speed", {"point"}, "rad s-1", "of the inner ring; of a drivetrain, of its input",
                   study.points, &StiffnessPoint::speed);
  content.add_each("series", {"point"}, "1", "points that belong to one table over speed", study.points,
                   &StiffnessPoint::series);
  content.add(
      "stiffness", {"point", "row", "column"}, "1",
      "rows and columns x, y, z, tilt about x, tilt about y: N/m, N/rad, N m/m, N m/rad; " + study.frame,
      stiffness);
  content.add("displacement", {"point", "row"}, "1", "x, y, z [m], tilt about x, tilt about y [rad]",
              displacement);
  for (std::size_t i = 0; i < study.points.front().load.size(); ++i) {
    const std::string& name = study.points.front().load[i].first;  // "radial_N", "moment_N_m"
    content.add_each("load_" + name.substr(0, name.find("_N")), {"point"}, name.ends_with("_m") ? "N m" : "N",
                     "on the ring that moves", study.points, [&](const StiffnessPoint& point) {
                       return i < point.load.size() ? point.load[i].second
                                                    : std::numeric_limits<double>::quiet_NaN();
                     });
  }
  return content;
}

std::string ross_table(const StiffnessStudy& study, std::size_t series) {
  std::vector<const StiffnessPoint*> points;
  for (const StiffnessPoint& point : study.points)
    if (point.series == series && point.stiffness) points.push_back(&point);
  std::sort(points.begin(), points.end(),
            [](const StiffnessPoint* a, const StiffnessPoint* b) { return a->speed < b->speed; });
  Worksheet sheet;
  constexpr std::array<const char*, 9> heads{"kxx", "kxy", "kyx", "kyy",      "cxx",
                                             "cxy", "cyx", "cyy", "speed"};
  for (std::size_t i = 0; i < heads.size(); ++i) sheet.label(0, i, heads[i]);
  const auto put_row = [&](std::size_t row, const StiffnessPoint& point, double speed) {
    const std::array<double, 9> values{entry(point, 0, 0),
                                       entry(point, 0, 1),
                                       entry(point, 1, 0),
                                       entry(point, 1, 1),
                                       0.0,
                                       0.0,
                                       0.0,
                                       0.0,
                                       speed};
    for (std::size_t i = 0; i < values.size(); ++i) sheet.number(row, i, values[i]);
  };
  for (std::size_t row = 0; row < points.size(); ++row) put_row(row + 1, *points[row], points[row]->speed);
  constexpr double another = 1000.0;  // [rad/s]  ROSS draws its curve through two speeds at least
  if (points.size() == 1) put_row(2, *points.front(), points.front()->speed + another);
  return sheet.finished();
}

}  // namespace orbearing::app
