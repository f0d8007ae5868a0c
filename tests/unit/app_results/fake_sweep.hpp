// A sweep whose points cost next to nothing and whose numbers have no round digits.
#pragma once

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "app/results/durable_file.hpp"
#include "app/results/sweep_run.hpp"
#include "orbearing/files.hpp"

namespace orbearing::app::fake_sweep {

namespace fs = std::filesystem;

inline constexpr std::size_t failing_point = 7;

/// A folder of its own for one test, removed with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "orbearing_test_XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

inline double input_speed_of(std::size_t point) {
  return 100.0 + 0.7 * static_cast<double>(point);
}  // [rad/s]

/// Point 7 fails; the others' numbers fill every digit of a double.
inline analysis::PointResult fake_result(std::size_t point) {
  if (point == failing_point) throw std::runtime_error("no balance, \"as\" found\nin line 2");
  const double x = std::sqrt(2.0 + static_cast<double>(point));
  analysis::PointResult result;
  result.input_speed = input_speed_of(point);
  result.carrier_speed = result.input_speed / 3.1;
  result.planet_load = 1e4 / x;
  result.inner = {300.0 * x, 100.0 * x, 1e9 / x, std::numeric_limits<double>::quiet_NaN()};
  result.outer = {310.0 * x, 110.0 * x, 2e9 / x, 1e-7 * x};
  result.life_hours = 5e4 * std::exp(-std::pow(std::log(result.input_speed / 110.0), 2.0));
  result.system_life_hours = result.life_hours * std::pow(8.0, -8.0 / 9.0);
  result.distribution = {{0.0, x, 2.0 * x}, {1.0 / x, 2.0 / x, 0.0}, {x, 0.0, 1.0}};
  return result;
}

/// Microseconds from 0 to 2000 without order, so that points overtake one another.
inline void sleep_some(std::size_t point) {
  std::this_thread::sleep_for(std::chrono::microseconds(point * 7919 % 2001));
}

inline ManifestHeader fake_header(std::size_t points) {
  return {"fake", "0123456789abcdef", "0.1.0", "x86-64", "quasi-static", points, std::nullopt, {}};
}

inline SweepRequest fake_request(const fs::path& folder, std::size_t points) {
  SweepRequest request;
  request.header = fake_header(points);
  request.resolved_case = "name: fake\n";
  for (std::size_t i = 0; i < points; ++i) request.points.push_back({"point", input_speed_of(i), {}});
  request.evaluate = [](std::size_t point) {
    sleep_some(point);
    return fake_result(point);
  };
  request.folder = folder;
  request.jobs = 2;
  return request;
}

/// sweep.csv of the undisturbed sweep.
inline std::string fake_table(const fs::path& folder, std::size_t points) {
  run_sweep(fake_request(folder, points));
  return read_file(folder / "sweep.csv");
}

/// Names and content of everything below `folder`.
inline std::set<std::pair<std::string, std::string>> snapshot(const fs::path& folder) {
  std::set<std::pair<std::string, std::string>> entries;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    entries.emplace(entry.path().string(), entry.is_regular_file() ? read_file(entry.path()) : "");
  return entries;
}

inline void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace orbearing::app::fake_sweep
