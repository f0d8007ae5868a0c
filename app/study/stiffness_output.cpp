#include "app/study/stiffness_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "app/results/result_row.hpp"

namespace orbearing::app {

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
  constexpr std::array<const char*, 9> heads{"kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy", "speed"};
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
