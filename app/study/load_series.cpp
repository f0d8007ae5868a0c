#include "app/study/load_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/case/printable.hpp"
#include "app/case/units.hpp"
#include "app/errors.hpp"
#include "app/results/result_row.hpp"
#include "app/study/record_file.hpp"
#include "app/units.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

constexpr double kNoise = 1e-3;  // [-]  of the greatest torque: what a record at rest may show
constexpr int kMostBins = 100;   // of torque, and of speed

std::string position_of(const fs::path& file, const RecordTable& table, std::size_t sample) {
  return sample < table.lines.size() ? fmt::format("{}:{}", file.string(), table.lines[sample])
                                     : fmt::format("{}: sample {}", file.string(), sample + 1);
}

void require_sound(const fs::path& file, const RecordTable& table) {
  const std::vector<double>& time = table.values.at("time");
  if (time.size() < 2)
    refuse_record(file.string(), fmt::format("{} samples", time.size()),
                  "at least 2, since each lasts until the next");
  for (const auto& [name, values] : table.values) {
    if (values.size() != time.size())
      refuse_record(file.string(),
                    fmt::format("{} times and {} values of {}", time.size(), values.size(), name),
                    "as many of both");
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isfinite(values[i]))
        refuse_record(position_of(file, table, i), "a value of " + name + " that is not finite", "a number");
  }
  for (std::size_t i = 1; i < time.size(); ++i)
    if (!(time[i] > time[i - 1]))
      refuse_record(position_of(file, table, i), "a time that is not later than the one before",
                    "rising times");
}

// Power over speed. At rest there is neither; a record that states one leaves its torque unknown.
std::vector<double> torque_of(const fs::path& file, const RecordTable& table) {
  const std::vector<double>&power = table.values.at("power"), &speed = table.values.at("speed");
  double greatest = 0.0;
  for (const double one : power) greatest = std::max(greatest, std::abs(one));
  std::vector<double> torque(power.size());
  for (std::size_t i = 0; i < power.size(); ++i) {
    const bool turns = LoadBin{.speed = std::abs(speed[i])}.turns();
    if (!turns && std::abs(power[i]) > kNoise * greatest)
      refuse_record(position_of(file, table, i), fmt::format("a power of {:g} W at speed 0", power[i]),
                    "no power at rest, or torque_N_m in place of power");
    torque[i] = turns ? power[i] / speed[i] : 0.0;
  }
  return torque;
}

/// Equal parts of a range.
struct Parts {
  double least = 0.0;
  double most = 0.0;
  int count = 1;

  void take(double value, bool first) {
    least = first ? value : std::min(least, value);
    most = first ? value : std::max(most, value);
  }
  int of(double value) const {
    constexpr double round_off = 1e-9;  // of a record that does not vary
    if (most - least <= round_off * most) return 0;
    return std::clamp(static_cast<int>((value - least) / (most - least) * count), 0, count - 1);
  }
};

struct Sums {
  double time = 0.0;    // [s]
  double turns = 0.0;   // [rad]
  double damage = 0.0;  // [rad]  with torques over the greatest one
  double steep = 0.0;   // [rad]  the same by kSteepestExponent

  /// Torque over the greatest one that does the damage.
  double torque(double exponent) const { return std::pow(damage / turns, 1.0 / exponent); }
};

/// Damage of the samples over that of their bins, less 1, for a life by kSteepestExponent.
double steep_excess(const std::map<std::pair<int, int>, Sums>& bins, double exponent) {
  double samples = 0.0, means = 0.0;
  for (const auto& [position, sums] : bins) {
    samples += sums.steep;
    means += sums.turns * std::pow(sums.torque(exponent), kSteepestExponent);
  }
  return means > 0.0 ? samples / means - 1.0 : 0.0;
}

}  // namespace

LoadSeries read_load_series(const fs::path& file, const RecordColumns& columns) {
  RecordTable table = read_record(file, columns);
  require_sound(file, table);
  const bool by_torque = table.values.contains("torque");
  LoadSeries series{table.values.at("time"), {}, table.values.at("speed"), std::move(table.warnings)};
  series.torque = by_torque ? table.values.at("torque") : torque_of(file, table);
  if (by_torque && table.values.contains("power"))
    series.warnings.push_back(file.string() + ": torque and power found; torque was taken");
  return series;
}

BinCounts parse_bins(const std::string& text) {
  const std::size_t cross = text.find('x');
  const auto count = [&](const std::string& part) {
    const Reading<double> number = read_number(part);
    const bool whole = number.value && *number.value == std::floor(*number.value);
    return whole && *number.value >= 1.0 && *number.value <= kMostBins ? static_cast<int>(*number.value) : 0;
  };
  const BinCounts counts{count(text.substr(0, cross)),
                         cross == std::string::npos ? 0 : count(text.substr(cross + 1))};
  if (counts.torque == 0 || counts.speed == 0)
    throw BadInput(fmt::format(
        "--bins: found {}; required: numbers of bins of torque and of speed from 1 to {}, as in 8x8",
        quote(text), kMostBins));
  return counts;
}

BinnedSeries binned(const LoadSeries& series, const BinCounts& counts, double exponent) {
  const auto magnitudes = [&](std::size_t i) {
    return LoadBin{.power = std::abs(series.torque[i] * series.speed[i]), .speed = std::abs(series.speed[i])};
  };
  Parts torques{.count = counts.torque}, speeds{.count = counts.speed};
  bool any = false;
  const std::size_t last = series.time.size() - 1;  // the last sample lasts for no time
  for (std::size_t i = 0; i < last; ++i) {
    if (!magnitudes(i).turns()) continue;
    torques.take(std::abs(series.torque[i]), !any);
    speeds.take(std::abs(series.speed[i]), !any);
    any = true;
  }
  if (!any) throw BadInput("record: found a drivetrain at rest; required: a speed above 0 at some time");
  const double greatest = torques.most > 0.0 ? torques.most : 1.0;
  std::map<std::pair<int, int>, Sums> bins;
  BinnedSeries result{.duration = series.time.back() - series.time.front()};
  double rest = 0.0;
  for (std::size_t i = 0; i < last; ++i) {
    const double time = series.time[i + 1] - series.time[i];
    const double speed = std::abs(series.speed[i]), torque = std::abs(series.torque[i]);
    if (!magnitudes(i).turns()) {
      rest += time;
      if (torque > kNoise * greatest) result.loaded_rest_share += time / result.duration;
      continue;
    }
    if (series.speed[i] < 0.0 || series.torque[i] < 0.0) result.reversed_share += time / result.duration;
    Sums& sums = bins[{torques.of(torque), speeds.of(speed)}];
    sums.time += time;
    sums.turns += time * speed;
    sums.damage += time * speed * std::pow(torque / greatest, exponent);
    sums.steep += time * speed * std::pow(torque / greatest, kSteepestExponent);
  }
  for (const auto& [position, sums] : bins) {
    const double speed = sums.turns / sums.time;
    const double torque = greatest * sums.torque(exponent);
    result.spectrum.bins.push_back({torque * speed, speed, sums.time / result.duration});
  }
  result.steep_excess = steep_excess(bins, exponent);
  if (rest > 0.0) result.spectrum.bins.push_back({0.0, 0.0, rest / result.duration});
  return result;
}

std::string spectrum_file(const LoadSpectrum& spectrum) {
  std::string text = "torque_N_m,speed_rpm,share\n";
  for (const LoadBin& bin : spectrum.bins)
    text += fmt::format("{},{},{}\n", in_table_unit(bin.turns() ? bin.power / bin.speed : 0.0, 1.0),
                        speed_in_rpm(bin.speed), bin.share);
  return text;
}

}  // namespace orbearing::app
