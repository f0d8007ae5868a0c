#include "app/results/spectrum_life.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/case/spectrum_case.hpp"
#include "app/results/motion_summary.hpp"
#include "app/results/record_writers.hpp"
#include "app/units.hpp"
#include "bearing/life/basic_life.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {
namespace {

using Json = nlohmann::ordered_json;
namespace dimension = described::dimension;

constexpr double infinite_life = std::numeric_limits<double>::infinity();

/// A life in the rows of bins. Where `beside` has no number either, a point that was computed carries no load
/// and lives for ever; else the life is not known, as by film and cleanliness without an oil.
using LifeInRow = std::function<double(const analysis::PointRow& point)>;

struct LifeColumn {
  std::string name;
  LifeInRow life;
  LifeInRow beside;
  bool in_revolutions = false;
  LifeInRow alike{};  // of bins with equal loads of all bearings, where other bins differ
};

/// Lives of one bearing in hours: of rows, of sets and, with "system_" before them, of all bearings together.
constexpr std::array<const char*, 5> kHours{"life_h", "L10h", "L10rh", "L10mh", "L10mrh"};

struct Hours {
  double lundberg_palmgren = not_given;
  bearing::rating::RatedHours rated{};
};
using HoursInRow = std::function<Hours(const analysis::PointRow& point)>;

// The life in the place `k` of kHours.
LifeInRow life_at(std::size_t k, const HoursInRow& hours) {
  if (!hours) return {};
  return [k, hours](const analysis::PointRow& point) {
    const Hours all = hours(point);
    return k == 0 ? all.lundberg_palmgren : all.rated.*bearing::rating::kRatedHours[k - 1];
  };
}

/// Columns of lives whose names begin alike; members as those of LifeColumn.
struct ColumnsOfHours {
  std::string prefix;
  HoursInRow hours;
  HoursInRow beside;
  HoursInRow alike{};
};

std::vector<ColumnsOfHours> hours_of_point() {
  using analysis::PointRow;
  const HoursInRow own = [](const PointRow& point) { return Hours{point.life_hours, point.rating.hours}; };
  const HoursInRow system = [](const PointRow& point) {
    return Hours{point.system_life_hours, point.rating.system_hours};
  };
  const HoursInRow shortest = [](const PointRow& point) {
    return Hours{point.unlike.shortest_hours, point.unlike.shortest_rated};
  };
  const HoursInRow carrier = [](const PointRow& point) {
    return point.carrier ? Hours{point.carrier->life_hours, point.carrier->rated_hours} : Hours{};
  };
  return {{"", own, own},
          {"system_", system, system},
          {"shortest_", shortest, own, own},
          {"carrier_", carrier, own}};
}

std::vector<ColumnsOfHours> hours_of_set(const std::string& name, std::size_t i) {
  const HoursInRow own = [i](const analysis::PointRow& point) {
    return Hours{point.sets[i].life_hours, point.sets[i].rating.hours};
  };
  const HoursInRow shortest = [i](const analysis::PointRow& point) {
    return Hours{point.sets[i].unlike.shortest_hours, point.sets[i].unlike.shortest_rated};
  };
  return {{column_prefix(name), own, own}, {column_prefix(name) + "shortest_", shortest, own, own}};
}

void add_hours(const std::vector<ColumnsOfHours>& all, std::vector<LifeColumn>& columns) {
  for (std::size_t k = 0; k < kHours.size(); ++k)
    for (const ColumnsOfHours& one : all)
      columns.push_back({one.prefix + kHours[k], life_at(k, one.hours), life_at(0, one.beside), false,
                         life_at(k, one.alike)});
}

void add_revolutions(std::vector<LifeColumn>& columns) {
  using analysis::PointRow;
  const auto in_millions = [](const LifeInRow& life) {
    return [life](const PointRow& point) {
      return in_customary_unit(described::dimension::revolutions, life(point));
    };
  };
  const auto add = [&](const std::string& name, const LifeInRow& life, const LifeInRow& beside) {
    columns.push_back({name, in_millions(life), in_millions(beside), true});
  };
  const auto own = [](const PointRow& point) { return point.life; };
  const auto inner = [](const PointRow& point) { return point.inner.life; };
  const auto outer = [](const PointRow& point) { return point.outer.life; };
  using Lives = bearing::rating::RatingLives;
  const auto rated = [](double (*life)(const Lives&)) {
    return [life](const PointRow& point) { return life(point.rating.lives); };
  };
  add("life_Mrev", own, own);
  add("L10_Mrev", rated([](const Lives& lives) { return lives.basic; }), own);
  add("L10r_Mrev", rated([](const Lives& lives) { return lives.reference.bearing; }), own);
  add("L10m_Mrev", rated([](const Lives& lives) { return lives.modified; }), own);
  add("L10mr_Mrev", rated([](const Lives& lives) { return lives.modified_reference.bearing; }), own);
  add("inner_life_Mrev", inner, inner);
  add("inner_L10m_Mrev", rated([](const Lives& lives) { return lives.modified_reference.inner; }), inner);
  add("outer_life_Mrev", outer, outer);
  add("outer_L10m_Mrev", rated([](const Lives& lives) { return lives.modified_reference.outer; }), outer);
}

std::vector<LifeColumn> life_columns(const ManifestHeader& header) {
  std::vector<LifeColumn> columns;
  add_hours(hours_of_point(), columns);
  add_revolutions(columns);
  for (std::size_t i = 0; i < header.sets.size(); ++i) add_hours(hours_of_set(header.sets[i], i), columns);
  return columns;
}

double life_in_row(const SweepRow& row, const LifeInRow& life_of, const LifeInRow& beside) {
  const double life = life_of(row.point);
  if (std::isfinite(life) || !row.ok()) return life;
  return std::isfinite(beside(row.point)) ? not_given : infinite_life;
}

Eigen::ArrayXd lives_in_bins(const std::vector<SpectrumBin>& bins, const LifeColumn& column) {
  const auto has_own = [&](const SpectrumBin& bin) {
    return bin.row && std::isfinite(column.life(bin.row->point));
  };
  const bool unlike = column.alike && std::ranges::any_of(bins, has_own);
  Eigen::ArrayXd lives(static_cast<Eigen::Index>(bins.size()));
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const LifeInRow& life = unlike && !has_own(bins[i]) ? column.alike : column.life;
    lives[static_cast<Eigen::Index>(i)] =
        bins[i].row ? life_in_row(*bins[i].row, life, column.beside) : infinite_life;
  }
  return lives;
}

/// Shares of time, or of revolutions: speeds of all members keep their ratio to that of the driving one.
Eigen::ArrayXd shares_of(const std::vector<SpectrumBin>& bins, bool of_revolutions) {
  Eigen::ArrayXd shares(static_cast<Eigen::Index>(bins.size()));
  for (std::size_t i = 0; i < bins.size(); ++i)
    shares[static_cast<Eigen::Index>(i)] = bins[i].bin.share * (of_revolutions ? bins[i].bin.speed : 1.0);
  return of_revolutions ? Eigen::ArrayXd(shares / shares.sum()) : shares;
}

/// A bin without time causes no damage, also where its life is not known.
Eigen::ArrayXd lives_that_count(const Eigen::ArrayXd& shares, const Eigen::ArrayXd& lives) {
  return (shares > 0.0).select(lives, infinite_life);
}

double life_by_miner(const Eigen::ArrayXd& shares, const Eigen::ArrayXd& all_lives) {
  const Eigen::ArrayXd lives = lives_that_count(shares, all_lives);
  return lives.isNaN().any() ? not_given : bearing::rating::spectrum_life(shares, lives);
}

/// Parts of the bins in the damage to one bearing; NaN where the life is not known.
Eigen::ArrayXd damage_shares(const Eigen::ArrayXd& shares, const Eigen::ArrayXd& lives) {
  const double life = life_by_miner(shares, lives);
  if (std::isinf(life)) return Eigen::ArrayXd::Zero(shares.size());
  return life * shares / lives_that_count(shares, lives);
}

// The worst bearing under the spectrum. Lives of one bearing are those of its set, as in the rows.
void take_worst_bearing(const ManifestHeader& header, SpectrumResult& result) {
  result.worst =
      worst_bearing(header.life, header.sets, [&](const std::string& name) { return life_of(result, name); });
  if (header.sets.empty()) return;
  for (auto& [name, life] : result.lives) {
    if (name.ends_with("_Mrev")) life = not_given;  // rows give those of the set that limits each point
    const std::string key = name.starts_with("shortest_") ? name.substr(name.find('_') + 1) : name;
    if (std::ranges::find(kHours, key) != kHours.end())
      life = life_of(result, column_prefix(result.worst.set) + name);
  }
}

// The life of that name of the worst bearing, bin by bin.
const LifeColumn& column_of_worst(const std::vector<LifeColumn>& columns, const SpectrumResult& result,
                                  const std::string& life) {
  WorstBearing worst = worst_bearing(life, {}, [&](const std::string& name) {
    return life_of(result, column_prefix(result.worst.set) + name);
  });
  worst.set = result.worst.set;
  return *std::ranges::find(columns, worst.column(), &LifeColumn::name);
}

void put_lives(const ManifestHeader& header, SpectrumResult& result) {
  const std::vector<LifeColumn> columns = life_columns(header);
  for (const LifeColumn& column : columns)
    result.lives.emplace_back(column.name, life_by_miner(shares_of(result.bins, column.in_revolutions),
                                                         lives_in_bins(result.bins, column)));
  take_worst_bearing(header, result);
  const Eigen::ArrayXd shares = shares_of(result.bins, false);
  const Eigen::ArrayXd lives = lives_in_bins(result.bins, column_of_worst(columns, result, header.life));
  const Eigen::ArrayXd damage = damage_shares(shares, lives);
  const Eigen::ArrayXd modified =
      damage_shares(shares, lives_in_bins(result.bins, column_of_worst(columns, result, "L10mh")));
  for (std::size_t i = 0; i < result.bins.size(); ++i) {
    const auto bin = static_cast<Eigen::Index>(i);
    if (result.bins[i].row) result.bins[i].worst_life = lives[bin];
    result.bins[i].damage_share = damage[bin];
    result.bins[i].modified_damage_share = modified[bin];
  }
}

// Minimum load P/C of the case, or a swept one.
double minimum_load_of(const ManifestHeader& header, const SpectrumResult& result) {
  for (const SpectrumBin& bin : result.bins)
    if (const double swept = bin.row ? axis_value(header, *bin.row, kMinimumLoadPath) : not_given;
        std::isfinite(swept))
      return swept;
  return header.spectrum.minimum_load;
}

// Skid risk of the bearing of a row; of several sets, of any. Without rotation there is none.
std::optional<bool> has_skid_risk(double minimum_load, const std::optional<SweepRow>& row) {
  if (!row) return false;
  const std::optional<SkidRisk> risk = skid_risk_of(row->point, minimum_load);
  return risk ? std::optional(risk->present()) : std::nullopt;
}

std::vector<double> axis_values_of(const SpectrumResult& result) {
  for (const SpectrumBin& bin : result.bins)
    if (bin.row) return bin.row->axes;
  return {};
}

/// Swept values that the rows of a spectrum do not state themselves, by their index among all.
std::vector<std::size_t> own_axes(const ManifestHeader& header) {
  std::vector<std::size_t> own;
  for (std::size_t i = 0; i < header.axes.size(); ++i)
    if (!header.axes[i].column.starts_with("input.power_")) own.push_back(i);
  return own;
}

/// A bin by its number, from 0, among those of a result.
struct NumberedBin {
  const SpectrumResult* result;
  std::size_t number;
};

std::vector<NumberedBin> bins_of(const SpectrumResult& result) {
  std::vector<NumberedBin> bins;
  for (std::size_t i = 0; i < result.bins.size(); ++i) bins.push_back({&result, i});
  return bins;
}

SweepRow row_at_rest(const ManifestHeader& header, const SpectrumResult& result) {
  SweepRow row = row_of_numbers({}, header);
  row.point.status = "at rest";
  for (const std::size_t i : own_axes(header))
    if (i < result.axis_values.size()) row.axes[i] = result.axis_values[i];
  return row;
}

// A yes or no that may be unknown.
void describe_risk(Record& row, const std::optional<bool>& risk) {
  described::Entry& entry =
      row.value("skid_risk", "whether P/C is below the minimum load", risk.value_or(false));
  if (!risk) std::get<described::Numbers>(entry.content).values.front() = described::kAbsent;
}

// A share of the time of the spectrum; in hours where they were stated.
void describe_time(Record& record, const LoadSpectrum& spectrum, const std::string& prefix,
                   const std::string& meaning, double share) {
  record.value(prefix + "share", dimension::ratio, meaning + ", of the time of the spectrum", share);
  if (spectrum.hours > 0.0) record.value(prefix + "hours", dimension::hours, meaning, share * spectrum.hours);
}

void describe_file(Record& record, const LoadSpectrum& spectrum, const std::string& file,
                   const BinSums& sums) {
  record.value("file", "record that the bins were made of", file);
  describe_time(record, spectrum, "", "of its bins", sums.share);
  record.value("damage_share", dimension::ratio, "of the life of the worst bearing", sums.damage_share);
  record.value("damage_share_L10mh", dimension::ratio, "the same of L10mh", sums.modified_damage_share);
  describe_time(record, spectrum, "skid_risk_", "with P/C below the minimum load", sums.skid_risk_share);
}

void describe_bin(Record& row, const ManifestHeader& header, const NumberedBin& numbered) {
  const SpectrumBin& bin = numbered.result->bins[numbered.number];
  row.value("bin", "number, as stated", numbered.number + 1);
  row.value("power_kW", dimension::power, "that enters", bin.bin.power);
  row.value("torque_N_m", dimension::torque, "of the shaft whose speed is input.speed", bin.bin.torque());
  row.value("speed_rpm", dimension::angular_speed, "input.speed of the bin", bin.bin.speed);
  row.value("share", dimension::ratio, "of time", bin.bin.share);
  row.value("worst_bearing_h", dimension::hours,
            "life, in this bin alone, of the bearing that requirements are judged by",
            std::isfinite(bin.worst_life) ? bin.worst_life : not_given);
  row.value("damage_share", dimension::ratio, "of the life of that bearing", bin.damage_share);
  row.value("damage_share_L10mh", dimension::ratio, "the same of L10mh", bin.modified_damage_share);
  describe_risk(row, bin.skid_risk);
  if (!bin.bin.file.empty()) row.value("file", "record that it was made of", bin.bin.file);
  describe(row, header, bin.row ? *bin.row : row_at_rest(header, *numbered.result));
  for (const described::Entry& entry : row.entries())
    if (entry.detail) row.entry(entry.name).detail = false;  // a table has all columns
}

void describe_bins(Record& record, const ManifestHeader& header, const std::vector<NumberedBin>& bins) {
  record.table("bins", "bin", "of the load spectrum", bins,
               [&](Record& row, const NumberedBin& bin) { describe_bin(row, header, bin); });
}

void describe_result(Record& record, const ManifestHeader& header, const SpectrumResult& result) {
  for (const std::size_t i : own_axes(header))
    if (i < result.axis_values.size())
      record.value(header.axes[i].column, {}, "swept", result.axis_values[i]);
  for (const auto& [name, life] : result.lives)
    record.value(name, name.ends_with("_Mrev") ? in_million_revolutions : dimension::hours,
                 "under the spectrum", life);
  record.value("life_key", "life that results go by", header.life);
  record.value("worst_bearing_key", "the same of the bearing that requirements are judged by",
               result.worst.key);
  record.value("worst_bearing_h", dimension::hours, "life of that bearing under the spectrum",
               result.worst.value);
  if (!result.worst.set.empty()) record.value("limiting_set", "the one with that bearing", result.worst.set);
  if (header.spectrum.hours > 0.0) {
    record.value("hours", dimension::hours, "required", header.spectrum.hours);
    record.value("used_up", dimension::ratio, "of the life of that bearing in these hours",
                 header.spectrum.hours / result.worst.value);
  }
  record.value("minimum_load", dimension::ratio, "P/C below which rolling elements may skid",
               minimum_load_of(header, result));
  describe_time(record, header.spectrum, "skid_risk_", "with P/C below the minimum load",
                sums_of(result.bins).skid_risk_share);
  if (const std::vector<std::string> files = header.spectrum.files(); !files.empty())
    record.table("files", "file", "records of the load spectrum", files,
                 [&](Record& row, const std::string& file) {
                   describe_file(row, header.spectrum, file, sums_of(result.bins, file));
                 });
  describe_bins(record, header, bins_of(result));
}

/// Bins that use up most first.
std::vector<std::size_t> by_damage(const SpectrumResult& result) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < result.bins.size(); ++i) order.push_back(i);
  const auto damage = [&](std::size_t i) {
    const double share = result.bins[i].damage_share;
    return std::isfinite(share) ? share : 0.0;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t one, std::size_t other) { return damage(one) > damage(other); });
  return order;
}

std::string hours_text(double hours) {
  if (std::isinf(hours)) return "no load";
  return std::isfinite(hours) ? fmt::format("{:.5g}", hours) : "-";
}

std::string shortest_text(double hours) {
  return std::isfinite(hours) ? fmt::format(", shortest {} h", hours_text(hours)) : "";
}

// Lives of the worst bearing, in its set; of several sets then those of each set by the governing life.
std::string lives_under_spectrum(const ManifestHeader& header, const SpectrumResult& result) {
  const bool unlike = std::isfinite(life_of(result, "shortest_life_h"));
  const auto shortest = [&](const std::string& name) {
    return unlike ? fmt::format(" {:>14}", hours_text(life_of(result, "shortest_" + name))) : "";
  };
  const std::string head = unlike ? fmt::format(" {:>14}", "shortest [h]") : "";
  std::string text =
      fmt::format("{:<8} {:>16}{} {:>18}\n", "life", "one bearing [h]", head, "all bearings [h]");
  for (const std::string name : kHours)
    text += fmt::format("{:<8} {:>16}{} {:>18}{}\n", name, hours_text(life_of(result, name)), shortest(name),
                        hours_text(life_of(result, "system_" + name)),
                        name == header.life ? "  results go by this life (life.method)" : "");
  if (header.sets.empty()) return text;
  text += fmt::format("lives of one bearing: set {}, which has the worst bearing\n", result.worst.set);
  for (const std::string& set : header.sets)
    text += fmt::format("{} of set {}: {} h{}\n", header.life, set,
                        hours_text(life_of(result, column_prefix(set) + header.life)),
                        shortest_text(life_of(result, column_prefix(set) + "shortest_" + header.life)));
  return text;
}

// "shortest L10mrh" of shortest_L10mrh.
std::string spaced(std::string key) {
  if (key.starts_with("shortest_") || key.starts_with("carrier_")) key[key.find('_')] = ' ';
  return key;
}

std::string percent_text(double share) {
  return std::isfinite(share) ? fmt::format("{:.3g}", 100.0 * share) : "-";
}

std::string hours_of_share(const LoadSpectrum& spectrum, double share) {
  return spectrum.hours > 0.0 && std::isfinite(share) ? fmt::format("{:.5g}", share * spectrum.hours) : "-";
}

std::string risk_text(const LoadSpectrum& spectrum, double minimum_load, const SpectrumResult& result) {
  const double share = sums_of(result.bins).skid_risk_share;
  const std::string hours =
      spectrum.hours > 0.0 ? fmt::format(", {} h", hours_of_share(spectrum, share)) : "";
  return fmt::format("skid risk: P/C below {:g} (life.minimum_load) for {} % of the time{}\n", minimum_load,
                     percent_text(share), hours);
}

std::string files_text(const LoadSpectrum& spectrum, const SpectrumResult& result) {
  const std::vector<std::string> files = spectrum.files();
  if (files.empty()) return "";
  std::string text = fmt::format("{:>9} {:>9} {:>14} {:>14}  file\n", "time [%]", "uses [%]", "skid risk [%]",
                                 "skid risk [h]");
  for (const std::string& file : files) {
    const BinSums sums = sums_of(result.bins, file);
    text += fmt::format("{:>9} {:>9} {:>14} {:>14}  {}\n", percent_text(sums.share),
                        percent_text(sums.damage_share), percent_text(sums.skid_risk_share),
                        hours_of_share(spectrum, sums.skid_risk_share), printable(std::string_view(file)));
  }
  return text;
}

}  // namespace

double life_of(const SpectrumResult& result, const std::string& name) {
  const auto found = std::find_if(result.lives.begin(), result.lives.end(),
                                  [&](const auto& life) { return life.first == name; });
  return found == result.lives.end() ? not_given : found->second;
}

BinSums sums_of(const std::vector<SpectrumBin>& bins, const std::string& file) {
  BinSums sums;
  for (const SpectrumBin& bin : bins) {
    if (!file.empty() && bin.bin.file != file) continue;
    const double share = bin.bin.share;
    sums.share += share;
    sums.damage_share += bin.damage_share;
    sums.modified_damage_share += bin.modified_damage_share;
    if (share > 0.0) sums.skid_risk_share += bin.skid_risk ? (*bin.skid_risk ? share : 0.0) : not_given;
  }
  return sums;
}

std::vector<SpectrumResult> spectrum_results(const ManifestHeader& header,
                                             const std::map<std::size_t, ManifestEntry>& entries) {
  const std::vector<std::size_t> rotating = header.spectrum.rotating();
  std::vector<SpectrumResult> results;
  for (std::size_t line = 0; line < header.spectrum.lines; ++line) {
    SpectrumResult result;
    for (const LoadBin& bin : header.spectrum.bins) result.bins.push_back({bin});
    for (std::size_t i = 0; i < rotating.size(); ++i) {
      const auto entry = entries.find(header.grid() + line * rotating.size() + i);
      if (entry == entries.end()) return {};
      result.bins[rotating[i]].row = entry->second.row;
      result.failed += entry->second.row.ok() ? 0 : 1;
    }
    result.axis_values = axis_values_of(result);
    const double minimum_load = minimum_load_of(header, result);
    for (SpectrumBin& bin : result.bins) bin.skid_risk = has_skid_risk(minimum_load, bin.row);
    put_lives(header, result);
    results.push_back(std::move(result));
  }
  return results;
}

Json spectrum_json(const ManifestHeader& header, const std::vector<SpectrumResult>& results) {
  if (results.empty()) return nullptr;
  Json list = Json::array();
  for (const SpectrumResult& result : results) {
    Record record;
    describe_result(record, header, result);
    list.push_back(json_of(record));
  }
  return own_axes(header).empty() ? list.front() : list;
}

std::string spectrum_csv(const ManifestHeader& header, const std::vector<SpectrumResult>& results) {
  std::vector<NumberedBin> bins;
  for (const SpectrumResult& result : results)
    for (const NumberedBin& bin : bins_of(result)) bins.push_back(bin);
  Record record;
  describe_bins(record, header, bins);
  return csv_of(record.entry("bins"));
}

std::string spectrum_text(const ManifestHeader& header, const std::vector<SpectrumResult>& results) {
  constexpr std::size_t most_bins = 24;  // shown
  std::string text;
  for (const SpectrumResult& result : results) {
    text +=
        fmt::format("\nload spectrum of {} bins, by the rule of Palmgren and Miner\n", result.bins.size()) +
        lives_under_spectrum(header, result) +
        risk_text(header.spectrum, minimum_load_of(header, result), result) +
        files_text(header.spectrum, result);
    for (const std::size_t i : own_axes(header))
      if (i < result.axis_values.size())
        text += fmt::format("{} = {:.10g}\n", header.axes[i].column, result.axis_values[i]);
    text += fmt::format("{:>5} {:>11} {:>11} {:>12} {:>9} {:>15} {:>9}\n", "bin", "power [kW]", "speed [rpm]",
                        "torque [N.m]", "time [%]", spaced(result.worst.key), "uses [%]");
    const std::vector<std::size_t> order = by_damage(result);
    for (std::size_t i = 0; i < std::min(order.size(), most_bins); ++i) {
      const SpectrumBin& bin = result.bins[order[i]];
      text +=
          fmt::format("{:>5} {:>11.5g} {:>11.5g} {:>12.5g} {:>9.3g} {:>15} {:>9}\n", order[i] + 1,
                      per_kilo * bin.bin.power, kRpm * bin.bin.speed, bin.bin.torque(), 100.0 * bin.bin.share,
                      std::isfinite(bin.worst_life) ? fmt::format("{:.5g}", bin.worst_life) : "-",
                      percent_text(bin.damage_share));
    }
    if (order.size() > most_bins)
      text += fmt::format("{} more bins are not shown\n", order.size() - most_bins);
  }
  return text;
}

}  // namespace orbearing::app
