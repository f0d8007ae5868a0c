#include <fmt/core.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/results/durable_file.hpp"
#include "app/results/record_writers.hpp"
#include "app/results/result_row.hpp"
#include "app/study/load_series.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;
namespace dimension = described::dimension;

double torque_of_bin(const LoadBin& bin) {
  return bin.turns() ? bin.power / bin.speed : 0.0;
}

void describe_bin(Record& row, const LoadBin& bin) {
  row.value("torque_N_m", dimension::torque, "of the driving member", torque_of_bin(bin));
  row.value("speed_rpm", dimension::angular_speed, "of the driving member", bin.speed);
  row.value("share", dimension::ratio, "of time", bin.share);
}

void describe_series(Record& record, const std::string& file, const LoadSeries& series,
                     const BinnedSeries& found, const Options& options) {
  record.value("series", "file", file);
  record.value("samples", "of the record", series.time.size());
  record.value("duration_s", dimension::time, "of the record", found.duration);
  record.value("reversed_share", dimension::ratio, "of time, below 0", found.reversed_share);
  record.value("torque_exponent", dimension::ratio, "of the mean torque of a bin", options.exponent);
  record.table("bins", "bin", "of the load spectrum", found.spectrum.bins, describe_bin);
}

void write_rows(const Options& options, const std::string& series, const LoadSpectrum& spectrum) {
  std::error_code ignored;
  if (fs::equivalent(options.output, series, ignored))
    throw BadInput("--output: found the record itself; required: another file");
  if (fs::is_directory(options.output, ignored))
    throw BadInput("--output: found the folder " + options.output + "; required: a file such as loads.csv");
  const fs::path folder = fs::path(options.output).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, ignored))
    throw BadInput("--output: found the folder " + folder.string() +
                   ", which is not there; required: one that is");
  write_aside_and_rename(options.output, spectrum_file(spectrum));
}

}  // namespace

int spectrum_command(const Options& options) {
  if (options.output.empty() && !options.json)
    throw BadInput("--output: missing; required: a file for the rows, or --json to print them alone");
  const BinCounts counts = parse_bins(options.bins);
  const std::string& file = options.folders.front();
  if (!options.columns.torque.empty() && !options.columns.power.empty())
    throw BadInput("--power: found beside --torque; required: one of both");
  const LoadSeries series = read_load_series(file, options.columns);
  const BinnedSeries found = binned(series, counts, options.exponent);
  std::vector<std::string> warnings = series.warnings;
  if (found.reversed_share > 0.0)
    warnings.push_back(
        fmt::format("torque or speed is below 0 for {:.4g} % of the time; it counts by its magnitude",
                    100.0 * found.reversed_share));
  if (found.loaded_rest_share > 0.0)
    warnings.push_back(fmt::format(
        "the drivetrain stands under a torque for {:.4g} % of the time, which no life counts: its row "
        "is one at rest; see static_safety for such loads",
        100.0 * found.loaded_rest_share));
  constexpr double noticeable = 0.01;
  if (found.steep_excess > noticeable)
    warnings.push_back(
        fmt::format("--bins: torques differ within bins: a modified life (a_ISO) can come out up to {:.2g} % "
                    "too long, since it "
                    "falls by up to the power {:g} of the load and bins keep the power {:.4g}; for such "
                    "lives take more bins of "
                    "torque or --exponent {:g}",
                    100.0 * found.steep_excess, kSteepestExponent, options.exponent, kSteepestExponent));
  if (!options.output.empty()) write_rows(options, file, found.spectrum);
  Record record;
  describe_series(record, file, series, found, options);
  if (options.json) {
    nlohmann::ordered_json object = json_of(record);
    object["warnings"] = warnings;
    object["versions"] = versions_json();
    print_result(std::move(object), record, options);
  } else if (!options.quiet) {
    fmt::print("{}", text_of(record));
    print_warnings(warnings);
  }
  return 0;
}

}  // namespace orbearing::app
