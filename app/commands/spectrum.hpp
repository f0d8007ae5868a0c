// `orbearing spectrum`: a load spectrum from records over time.
#pragma once

#include "app/commands/common_options.hpp"
#include "app/study/record_file.hpp"

namespace orbearing::app {

struct SpectrumOptions {
  static constexpr const char* command = "spectrum";
  static constexpr const char* purpose = "load spectrum from records over time, by bins of torque and speed";
  Printing print;
  std::vector<std::string> series;  // files of the records
  RecordColumns columns;            // their names
  std::string share, hours;         // of each record, comma between them; empty: of one record
  std::string output;               // file of rows; with a case also a folder
  std::string bins = "8x8";         // of torque and of speed
  std::optional<double> exponent;   // of life over torque; none: that of the governing life
  StatedCase stated;                // whose bearings are rated; without a file: none
  std::string fidelity;
  int jobs = 0;  // 0: one for each core
  bool resume = false;
};
inline void describe(OptionList& list, SpectrumOptions& m) {
  const char* const with_case = "--case";
  const auto column = [](std::string& name, const char* of, const char* meaning) {
    return option(name, of, meaning, {.type = "COLUMN"});
  };
  described::rows(
      list, described::part(m.print),
      option(m.series, "SERIES",
             "records over time: CSV, output of OpenFAST (.out, .outb) or Bladed (.%NN, .$NN), or netCDF, "
             "with time, speed and torque or power of the driving member; several with --share or --hours",
             {.required = true}),
      column(m.columns.torque, "--torque",
             "name of the column of torque; default: a column whose name begins with torque"),
      column(m.columns.power, "--power", "name of the column of power, instead of torque"),
      column(m.columns.speed, "--speed", "name of the column of speed; units are those of the file"),
      column(m.columns.time, "--time", "name of the column of time"),
      option(m.share, "--share", "time share of each record, separated by commas; the sum is 1",
             {.type = "S,S"}),
      option(m.hours, "--hours", "hours of each record, separated by commas, instead of --share",
             {.type = "H,H"}),
      option(m.output, "-o,--output",
             "CSV file for spectrum: {file: ...} of a case; an existing file is replaced. With --case, a "
             "name that does not end in .csv is a folder of results",
             {.type = "FILE.csv|DIR"}),
      option(m.bins, "--bins", "bins of torque x bins of speed; default: 8x8", {.type = "NxM"}),
      option(m.exponent, "--exponent",
             "exponent p of life over torque, life ~ 1/torque^p. 4: Lundberg-Palmgren and ISO/TS 16281 of "
             "rollers; 10/3: ISO 281 of rollers; 3: balls; up to 8: modified lives (a_ISO). Default: 4, "
             "with --case that of the life in use (life.method, requirements.life_key). A larger p gives a "
             "shorter life",
             {.range = described::Range{1.0, 50.0}}),
      option(m.stated.file, with_case,
             "case file: compute the lives of its bearings under these bins, damage by bin and by file, and "
             "time in skid risk (life.minimum_load)",
             {.type = "CASE"}),
      settings_row(m.stated.settings, with_case), fidelity_row(m.fidelity, with_case),
      jobs_row(m.jobs, with_case),
      option(m.resume, "--resume", "continue in DIR with the missing bins", {.needs = with_case}));
}
std::vector<std::string> problems(const SpectrumOptions& options);

int execute(const SpectrumOptions& options);

}  // namespace orbearing::app
