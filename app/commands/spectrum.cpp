#include "app/commands/spectrum.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/case/mistake.hpp"
#include "app/case/requirements_case.hpp"
#include "app/case/spectrum_case.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/results/durable_file.hpp"
#include "app/results/record_writers.hpp"
#include "app/study/analysis.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/load_series.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;
namespace dimension = described::dimension;

/// Records with what was made of them.
struct BinnedRecords {
  std::vector<std::string> files;
  std::vector<WeightedSeries> records{};
  double exponent = kLineExponent;
  BinnedSeries found{};
};

void describe_time(Record& record, double share, double hours) {
  record.value("share", dimension::ratio, "of time", share);
  if (hours > 0.0) record.value("hours", dimension::hours, "of time", share * hours);
}

void describe_series(Record& record, const BinnedRecords& binned) {
  const LoadSpectrum& spectrum = binned.found.spectrum;
  std::size_t samples = 0;
  for (const WeightedSeries& one : binned.records) samples += one.series.time.size();
  if (binned.files.size() == 1) record.value("series", "file", binned.files.front());
  record.value("samples", "of the record", samples);
  record.value("duration_s", dimension::time, "of the record", binned.found.duration);
  record.value("reversed_share", dimension::ratio, "of time, below 0", binned.found.reversed_share);
  record.value("torque_exponent", dimension::ratio, "of the mean torque of a bin", binned.exponent);
  if (binned.files.size() > 1)
    record.table("files", "file", "records", binned.records, [&](Record& row, const WeightedSeries& one) {
      row.value("file", "record", one.file);
      row.value("samples", "of the record", one.series.time.size());
      row.value("duration_s", dimension::time, "of the record",
                one.series.time.back() - one.series.time.front());
      describe_time(row, one.share, spectrum.hours);
    });
  record.table("bins", "bin", "of the load spectrum", spectrum.bins, [&](Record& row, const LoadBin& bin) {
    row.value("torque_N_m", dimension::torque, "of the driving member", bin.torque());
    row.value("speed_rpm", dimension::angular_speed, "of the driving member", bin.speed);
    describe_time(row, bin.share, spectrum.hours);
    if (!bin.file.empty()) row.value("file", "record", bin.file);
  });
}

// Whether there is a case whose bearings have lives.
bool has_case(const SpectrumOptions& options) {
  return !options.stated.file.empty() || options.stated.given;
}

// Rows for a case have a name that ends in .csv; beside a case, all else is a folder of results.
bool keeps_rows(const SpectrumOptions& options) {
  return !options.output.empty() && (!has_case(options) || fs::path(options.output).extension() == ".csv");
}

void write_rows(const SpectrumOptions& options, const LoadSpectrum& spectrum) {
  std::error_code ignored;
  for (const std::string& series : options.series)
    if (fs::equivalent(options.output, series, ignored))
      throw BadInput("--output: found the record itself; required: another file");
  if (fs::is_directory(options.output, ignored))
    throw BadInput("--output: found the folder " + options.output + "; required: a file such as loads.csv");
  const fs::path folder = fs::path(options.output).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, ignored))
    throw BadInput("--output: found the folder " + folder.string() +
                   ", which does not exist; required: an existing folder");
  write_aside_and_rename(options.output, spectrum_file(spectrum));
}

BinnedRecords read_records(const SpectrumOptions& options) {
  BinnedRecords binned{.files = options.series};
  const RecordTimes times = record_times(options.share, options.hours, binned.files.size());
  binned.found.spectrum.hours = times.hours;
  for (std::size_t i = 0; i < binned.files.size(); ++i) {
    const std::string& file = binned.files[i];
    if (std::count(binned.files.begin(), binned.files.end(), file) > 1)
      throw BadInput(fmt::format("SERIES: found {} twice; required: each file once", file));
    binned.records.push_back({read_load_series(file, options.columns), times.shares[i],
                              binned.files.size() > 1 ? file : std::string()});
  }
  return binned;
}

void put_bins(const SpectrumOptions& options, double exponent, BinnedRecords& binned) {
  const double hours = binned.found.spectrum.hours;
  binned.exponent = options.exponent.value_or(exponent);
  binned.found = app::binned(binned.records, parse_bins(options.bins), binned.exponent);
  binned.found.spectrum.hours = hours;
}

// `oil`: whether there are lives with a_ISO; without a case it is not known.
void add_excess_warnings(const BinnedRecords& binned, bool oil, std::vector<std::string>& warnings) {
  constexpr double noticeable = 0.01;
  for (std::size_t i = 0; i < kLivesByPower.size(); ++i) {
    const LivesByPower& lives = kLivesByPower[i];
    const double excess = binned.found.excess[i];
    if (excess <= noticeable || lives.power <= binned.exponent || (lives.of_oil && !oil)) continue;
    warnings.push_back(
        fmt::format("--bins: torques differ within bins: {} can be up to {:.2g} % too long. They fall by up "
                    "to the power {:g} of the load, and bins keep the power {:.4g}. For such lives use more "
                    "bins of torque or --exponent {:g}",
                    lives.names, 100.0 * excess, lives.power, binned.exponent, lives.power));
  }
}

std::vector<std::string> warnings_of(const BinnedRecords& binned, bool oil) {
  std::vector<std::string> warnings;
  for (const WeightedSeries& one : binned.records)
    for (const std::string& warning : one.series.warnings)
      warnings.push_back(one.file.empty() || warning.starts_with(one.file) ? warning
                                                                           : one.file + ": " + warning);
  const BinnedSeries& found = binned.found;
  if (found.reversed_share > 0.0)
    warnings.push_back(
        fmt::format("torque or speed is below 0 for {:.4g} % of the time; it counts by its magnitude",
                    100.0 * found.reversed_share));
  if (found.loaded_rest_share > 0.0)
    warnings.push_back(
        fmt::format("the drivetrain is at rest under a torque for {:.4g} % of the time, which no life "
                    "includes. See static_safety for such loads",
                    100.0 * found.loaded_rest_share));
  add_excess_warnings(binned, oil, warnings);
  return warnings;
}

int present_bins(const BinnedRecords& binned, const Printing& print) {
  const std::vector<std::string> warnings = warnings_of(binned, true);
  Record record;
  describe_series(record, binned);
  if (print.json) {
    nlohmann::ordered_json object = json_of(record);
    object["warnings"] = warnings;
    object["versions"] = versions_json();
    print_result(std::move(object), record, print);
  } else if (!print.quiet) {
    fmt::print("{}", text_of(record));
    print_warnings(warnings);
  }
  return 0;
}

// The largest of the lives that results and requirements go by: a larger one makes a life shorter.
double exponent_of_case(const ResolvedCase& resolved) {
  double exponent = exponent_of_life(governing_life_key(resolved));
  for (const Requirement& one : stated_requirements(resolved))
    if (one.name == "life") exponent = std::max(exponent, exponent_of_life(one.key));
  return exponent;
}

/// A case whose lives are those under the bins of the records.
struct RatedCase {
  ResolvedCase resolved;
  std::vector<std::string> warnings{};
};

RatedCase rated_case(const StatedCase& stated) {
  RatedCase rated{point_of(stated)};
  require_planet_bearings(rated.resolved);
  if (!rated.resolved.has(kSpectrumPath)) return rated;
  if (rated.resolved.location(kSpectrumPath).option)
    throw BadInput("--set: spectrum: found together with records; required: one of both");
  rated.warnings.push_back("spectrum: the bins of the records replace the rows of the case");
  return rated;
}

int present_lives(const RatedCase& rated, const BinnedRecords& binned, const SpectrumOptions& options) {
  const ResolvedCase& resolved = rated.resolved;
  const std::string fidelity = fidelity_or_default(options.fidelity);
  require_computable(resolved, fidelity, false);
  SweepRequest request = sweep_request(resolved, fidelity);
  put_execution({keeps_rows(options) ? "" : options.output, options.resume}, options.jobs, options.print,
                request);
  Record record;
  describe_series(record, binned);
  return present_sweep(
      resolved, run_sweep(request), options.print,
      {&record, joined(warnings_of(binned, stated_oil(resolved).has_value()), rated.warnings)});
}

}  // namespace

std::vector<std::string> problems(const SpectrumOptions& options) {
  std::vector<std::string> found;
  if (options.output.empty() && !options.print.json && !has_case(options))
    found.emplace_back("--output: missing; required: a file for the rows, or --json to print them alone");
  if (options.resume && (options.output.empty() || keeps_rows(options)))
    found.emplace_back("--resume: found without a folder; required: -o DIR, the folder to continue");
  if (!options.columns.torque.empty() && !options.columns.power.empty())
    found.emplace_back("--power: found together with --torque; required: one of both");
  return found;
}

int execute(const SpectrumOptions& options) {
  parse_bins(options.bins);
  std::optional<RatedCase> of_case;
  if (has_case(options)) of_case = rated_case(options.stated);
  BinnedRecords binned = read_records(options);
  put_bins(options, of_case ? exponent_of_case(of_case->resolved) : kLineExponent, binned);
  if (of_case)
    of_case->resolved = named_by_option({{"--set: " + kSpectrumPath, "records"}}, [&] {
      return of_case->resolved.with(kSpectrumPath, spectrum_rows(binned.found.spectrum));
    });
  if (keeps_rows(options)) write_rows(options, binned.found.spectrum);
  return of_case ? present_lives(*of_case, binned, options) : present_bins(binned, options.print);
}

}  // namespace orbearing::app
