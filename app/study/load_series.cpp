#include "app/study/load_series.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "app/case/text_parts.hpp"
#include "app/case/text_table.hpp"
#include "app/case/units.hpp"
#include "app/case/yaml_tree.hpp"
#include "app/errors.hpp"
#include "app/results/record_writers.hpp"
#include "app/study/record_file.hpp"
#include "app/units.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

constexpr double kNoise = 1e-3;  // [-]  of the greatest torque: noise of a record without rotation
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

// Numbers by which programs mark missing values, and the power of ten from which a number cannot belong to a
// drivetrain. A code counts as one only as an isolated value: a load near it is a measured one.
constexpr std::array kCodes{-999.0,    -999.25,  -999.9, -9999.0, -9999.25, -9999.9, -99999.0,
                            -999999.0, -32768.0, 9999.0, 99999.0, 999999.0, 32767.0};
constexpr double kBeyondMeasure = 1e20;  // [unit of the file]
constexpr double kNearCode = 0.05;       // [-]  of the code
constexpr double kSameNumber = 1e-9;     // [-]  round-off of a conversion there and back

bool is_number_near(double value, double code, double share) {
  return std::abs(value - code) <= share * std::abs(code);
}

bool stands_alone(const std::vector<double>& values, double code, double factor) {
  bool others = false;
  for (const double value : values) {
    if (is_number_near(value / factor, code, kSameNumber)) continue;
    if (is_number_near(value / factor, code, kNearCode)) return false;
    others = true;
  }
  return others || code < 0.0;  // a record may hold one positive load from end to end
}

void refuse_codes(const fs::path& file, const RecordTable& table) {
  for (const auto& [name, values] : table.values) {
    const double factor = table.factors.at(name);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!(std::abs(values[i] / factor) < kBeyondMeasure))
        refuse_record(position_of(file, table, i), fmt::format("{:g} as {}", values[i] / factor, name),
                      "a measured value; leave out samples without one");
    for (const double code : kCodes) {
      const auto found = std::ranges::find_if(
          values, [&](double value) { return is_number_near(value / factor, code, kSameNumber); });
      if (found == values.end() || !stands_alone(values, code, factor)) continue;
      refuse_record(
          position_of(file, table, static_cast<std::size_t>(found - values.begin())),
          fmt::format("{:g} as {}, a common code of a missing value", code, name),
          fmt::format("a measured value; leave out samples without one. Write a load of exactly this size "
                      "as {:g}",
                      code * (1.0 + 1e-5)));
    }
  }
}

// Mean over time of the magnitudes of a product, or of one of both.
double mean_magnitude(const std::vector<double>& time, const std::vector<double>& values,
                      const std::vector<double>& speed) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < time.size(); ++i)
    sum += (time[i + 1] - time[i]) * std::abs(values[i] * (speed.empty() ? 1.0 : speed[i]));
  return sum / (time.back() - time.front());
}

// Losses of a drivetrain and its machine at part load, in the mean, are less than this; a gear ratio is more.
constexpr double kMostLosses = 1.5;  // [-]  larger over smaller power

bool agree(double power, double other) {
  return power <= kMostLosses * other && other <= kMostLosses * power;
}

// Torque and speed of two shafts have another power than the file states.
void compare_powers(const fs::path& file, const RecordTable& table, std::vector<std::string>& warnings) {
  const std::vector<double>& time = table.values.at("time");
  const double own = mean_magnitude(time, table.values.at("torque"), table.values.at("speed"));
  constexpr double per_kilo = 1e-3;
  const auto text = [&](double power) { return fmt::format("{:.4g} kW", per_kilo * power); };
  if (const auto stated = table.values.find("power"); stated != table.values.end()) {
    const double power = mean_magnitude(time, stated->second, {});
    if (!agree(own, power))
      refuse_record(
          file.string(),
          fmt::format("a mean power of {}, and {} by torque and speed: they are of two shafts, or a unit "
                      "is wrong",
                      text(power), text(own)),
          "torque and speed of one shaft (--torque COLUMN, --speed COLUMN), or power and speed alone "
          "(--power COLUMN)");
    warnings.push_back(
        fmt::format("{}: torque and power found; torque is used: {} by torque and speed, {} by power",
                    file.string(), text(own), text(power)));
  }
  std::vector<std::string> powers;
  for (const auto& [name, values] : table.powers) {
    if (values.size() != time.size()) continue;  // some of them are no numbers
    const double power = mean_magnitude(time, values, {});
    if (agree(own, power)) return;
    if (power > 0.0) powers.push_back(fmt::format("{}: {}", name, text(power)));
  }
  if (!powers.empty())
    warnings.push_back(
        fmt::format("{}: torque times speed is a mean power of {}, which no column of power has ({}). "
                    "Take torque and speed of one shaft",
                    file.string(), text(own), fmt::join(powers, ", ")));
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
                    "no power at rest, or torque_N_m instead of power");
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

constexpr std::size_t kPowers = kLivesByPower.size();

/// Samples of a bin; torques over the greatest one.
struct BinSamples {
  double time = 0.0;                       // [s]
  double turns = 0.0;                      // [rad]
  double damage = 0.0;                     // [rad]
  std::array<double, kPowers> by_power{};  // [rad]  the same for each of kLivesByPower

  void take(double seconds, double speed, double torque, double exponent) {
    time += seconds;
    turns += seconds * speed;
    damage += seconds * speed * std::pow(torque, exponent);
    for (std::size_t i = 0; i < kPowers; ++i)
      by_power[i] += seconds * speed * std::pow(torque, kLivesByPower[i].power);
  }
  /// Torque over the greatest one that does the damage.
  double torque(double exponent) const { return std::pow(damage / turns, 1.0 / exponent); }
};

/// Damage of samples and of the bins that represent them, for each of kLivesByPower.
struct BinExcess {
  std::array<double, kPowers> samples{}, means{};

  void take(const BinSamples& sums, double exponent, double weight) {
    for (std::size_t i = 0; i < kPowers; ++i) {
      samples[i] += weight * sums.by_power[i];
      means[i] += weight * sums.turns * std::pow(sums.torque(exponent), kLivesByPower[i].power);
    }
  }
  std::array<double, kPowers> result() const {
    std::array<double, kPowers> excess{};
    for (std::size_t i = 0; i < kPowers; ++i) excess[i] = means[i] > 0.0 ? samples[i] / means[i] - 1.0 : 0.0;
    return excess;
  }
};

/// A sample by its magnitudes.
struct RecordSample {
  double time;    // [s]  until the next one
  double torque;  // [N m]
  double speed;   // [rad/s]
  bool reversed;

  bool turns() const { return LoadBin{.speed = speed}.turns(); }
};

// The last sample lasts for no time.
template <class Visit>
void visit_samples(const LoadSeries& series, const Visit& visit) {
  for (std::size_t i = 0; i + 1 < series.time.size(); ++i)
    visit(RecordSample{series.time[i + 1] - series.time[i], std::abs(series.torque[i]),
                       std::abs(series.speed[i]), series.torque[i] < 0.0 || series.speed[i] < 0.0});
}

double duration_of(const LoadSeries& series) {
  return series.time.back() - series.time.front();
}

/// Bins of torque and of speed for the samples that rotate.
struct BinGrid {
  Parts torques;
  Parts speeds;
  double greatest_torque() const { return torques.most > 0.0 ? torques.most : 1.0; }
};

BinGrid grid_of(const std::vector<WeightedSeries>& records, const BinCounts& counts) {
  BinGrid grid{{.count = counts.torque}, {.count = counts.speed}};
  bool any = false;
  for (const WeightedSeries& record : records)
    visit_samples(record.series, [&](const RecordSample& sample) {
      if (!sample.turns()) return;
      grid.torques.take(sample.torque, !any);
      grid.speeds.take(sample.speed, !any);
      any = true;
    });
  if (!any) throw BadInput("record: found a drivetrain at rest; required: a speed above 0 at some time");
  return grid;
}

void add_bins(const WeightedSeries& record, const BinGrid& grid, double exponent, BinnedSeries& result,
              BinExcess& excess) {
  const double duration = duration_of(record.series), greatest = grid.greatest_torque();
  std::map<std::pair<int, int>, BinSamples> bins;
  double rest = 0.0, reversed = 0.0, loaded_rest = 0.0;  // [s]
  visit_samples(record.series, [&](const RecordSample& sample) {
    if (!sample.turns()) {
      rest += sample.time;
      loaded_rest += sample.torque > kNoise * greatest ? sample.time : 0.0;
      return;
    }
    reversed += sample.reversed ? sample.time : 0.0;
    bins[{grid.torques.of(sample.torque), grid.speeds.of(sample.speed)}].take(
        sample.time, sample.speed, sample.torque / greatest, exponent);
  });
  result.duration += duration;
  result.reversed_share += record.share * reversed / duration;
  result.loaded_rest_share += record.share * loaded_rest / duration;
  for (const auto& [position, sums] : bins) {
    const double speed = sums.turns / sums.time;
    result.spectrum.bins.push_back({greatest * sums.torque(exponent) * speed, speed,
                                    record.share * (sums.time / duration), record.file});
    excess.take(sums, exponent, record.share / duration);
  }
  if (rest > 0.0) result.spectrum.bins.push_back({0.0, 0.0, record.share * (rest / duration), record.file});
}

constexpr double kSumRoundOff = 1e-6;  // of a sum of shares that were rounded for typing

std::vector<double> numbers_of(const std::string& option, const std::string& text, std::size_t files) {
  std::vector<double> numbers;
  for (const std::string& part : parts_of(text, ',')) {
    const Reading<double> number = read_number(part);
    if (!number.value || *number.value < 0.0)
      throw BadInput(
          fmt::format("{}: found {}; required: numbers from 0, comma between them", option, quote(part)));
    numbers.push_back(*number.value);
  }
  if (numbers.size() != files)
    throw BadInput(fmt::format("{}: found {} numbers for {} files; required: one for each file", option,
                               numbers.size(), files));
  return numbers;
}

/// A row of a spectrum as files and cases write it.
struct WrittenRow {
  double torque;  // [N m]
  double speed;   // [rpm]
  double time;    // share [-] or hours [h]
  std::string file;
};

std::vector<WrittenRow> written_rows(const LoadSpectrum& spectrum) {
  std::vector<WrittenRow> rows;
  for (const LoadBin& bin : spectrum.bins)
    rows.push_back({in_table_unit(bin.turns() ? bin.power / bin.speed : 0.0, 1.0), speed_in_rpm(bin.speed),
                    spectrum.hours > 0.0 ? bin.share * spectrum.hours : bin.share, bin.file});
  return rows;
}

const char* time_column(const LoadSpectrum& spectrum) {
  return spectrum.hours > 0.0 ? "hours" : "share";
}

}  // namespace

LoadSeries read_load_series(const fs::path& file, const RecordColumns& columns) {
  RecordTable table = read_record(file, columns);
  require_sound(file, table);
  refuse_codes(file, table);
  const bool by_torque = table.values.contains("torque");
  LoadSeries series{table.values.at("time"), {}, table.values.at("speed"), std::move(table.warnings)};
  series.torque = by_torque ? table.values.at("torque") : torque_of(file, table);
  if (by_torque) compare_powers(file, table, series.warnings);
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

RecordTimes record_times(const std::string& shares, const std::string& hours, std::size_t files) {
  if (!shares.empty() && !hours.empty())
    throw BadInput("--hours: found together with --share; required: one of both");
  if (shares.empty() && hours.empty()) {
    if (files > 1)
      throw BadInput(
          fmt::format("--share: missing together with {} files; required: the share of time of each file, as "
                      "in --share 0.3,0.7, or the hours, as in --hours 1000,5000",
                      files));
    return {{1.0}};
  }
  const bool by_share = hours.empty();
  RecordTimes times{numbers_of(by_share ? "--share" : "--hours", by_share ? shares : hours, files)};
  const double sum = std::accumulate(times.shares.begin(), times.shares.end(), 0.0);
  if (by_share && std::abs(sum - 1.0) > kSumRoundOff)
    throw BadInput(fmt::format("--share: found a sum of {:.8g}; required: 1; --hours require no sum", sum));
  if (!(sum > 0.0) || !std::isfinite(sum))
    throw BadInput(
        fmt::format("--hours: found a sum of {}; required: finite hours above 0 for at least one file", sum));
  for (double& share : times.shares) share /= sum;
  if (!by_share) times.hours = sum;
  return times;
}

double exponent_of_life(const std::string& life) {
  const auto falls = [&](const LivesByPower& one) {
    return std::string_view(one.names).find(life) != std::string::npos;
  };
  return std::find_if(kLivesByPower.begin(), kLivesByPower.end(), falls)->power;
}

BinnedSeries binned(const std::vector<WeightedSeries>& records, const BinCounts& counts, double exponent) {
  const BinGrid grid = grid_of(records, counts);
  BinnedSeries result;
  BinExcess excess;
  for (const WeightedSeries& record : records) add_bins(record, grid, exponent, result, excess);
  result.excess = excess.result();
  return result;
}

std::string spectrum_file(const LoadSpectrum& spectrum) {
  const bool named = !spectrum.files().empty();
  std::string text = fmt::format("torque_N_m,speed_rpm,{}{}\n", time_column(spectrum), named ? ",file" : "");
  for (const WrittenRow& row : written_rows(spectrum))
    text +=
        fmt::format("{},{},{}{}\n", row.torque, row.speed, row.time, named ? "," + csv_field(row.file) : "");
  return text;
}

std::string spectrum_rows(const LoadSpectrum& spectrum) {
  std::vector<std::string> rows;
  for (const WrittenRow& row : written_rows(spectrum))
    rows.push_back(fmt::format("{{torque: {} N.m, speed: {} rpm, {}: {}{}}}", row.torque, row.speed,
                               time_column(spectrum), row.time,
                               row.file.empty() ? "" : ", file: " + quoted_scalar(row.file)));
  return fmt::format("[{}]", fmt::join(rows, ", "));
}

}  // namespace orbearing::app
