// The command line: which command, with which options, and how it ended.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/study/crown/crown_options.hpp"
#include "app/study/record_file.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// Words of the user after the subcommand. A command reads the options it declares.
struct Options {
  std::string case_file;
  std::vector<std::string> cases;     // validate: none means all that ship
  std::vector<std::string> folders;   // merge, report; spectrum: files of the records
  std::vector<std::string> settings;  // path=value
  std::string output;                 // empty: with --json, nothing is written
  std::string fidelity = "quasi-static";
  bool fidelity_given = false;           // by the user, where there may be no choice
  std::optional<std::string> speed;      // modes: none means no rotation
  std::optional<std::string> shard;      // "i/n"
  std::optional<std::string> direction;  // sweep --continue: "up" or "down"
  std::string other;                     // report --with: folder of the branch to draw as well
  std::optional<std::string> budget;     // run, sweep: processor time, "60 s"
  bool grid_only = false;                // sweep, merge: no points are added around the peak
  int jobs = 0;                          // 0: one for each core
  bool every_effect = false;             // report: all effects of the motion in time
  bool pdf = false;                      // report: the assessor's page as well
  bool data_only = false;                // report: the result is the data of its page, and no page is drawn
  std::string
      bearing_points;     // report: instead of that, these points of the bearing, as the page requests them
  bool motion = false;    // validate: only the effects of assumptions in motion
  int samples = 0;        // validate: of uncertain inputs, for the bands of measured rows
  bool gears = false;     // run: without the dynamics of bearings
  std::string fmi = "2";  // fmu: version of the interface
  std::string model = "bearing";    // fmu: "bearing" or "gearset"
  bool windows = false;             // fmu: the library for Windows as well
  std::vector<std::string> varied;  // signals: path=[value, value]
  double noise = 0.0;               // signals: root mean square [m/s^2]
  std::uint64_t seed = 1;           // signals: of the noise
  std::string bins = "8x8";         // spectrum: of torque and of speed
  std::optional<double> exponent;   // spectrum: of the life over the torque; none: by the life in use
  std::string share, hours;         // spectrum: of each record, comma between them; empty: of one record
  RecordColumns columns;            // spectrum: names of those of the record
  CrownOptions crown;
  bool resume = false;
  bool json = false;
  bool quiet = false;

  /// For a caller in the same process: the case instead of file and settings, functions that take the result
  /// and the line about failed points instead of the standard streams, one that receives each point of a
  /// sweep when it is finished, and one that receives the record of the result.
  std::optional<ResolvedCase> given{};
  std::function<void(const nlohmann::ordered_json& object)> take_result{};
  std::function<void(const std::string& line)> take_failures{};
  std::function<void(const nlohmann::ordered_json& row)> take_point{};
  std::function<void(const described::Record& record)> take_record{};

  std::string template_name{};                 // new
  bool no_browser = false;                     // open
  int port = 0;                                // open: 0: one that is free
  int linger = 60;                             // open: after the last page has gone [s]
  bool worker = false;                         // open: answers the requests of a page's server
  std::string result{};                        // sensitivities: its key; empty: the life that results go by
  std::vector<std::string> by{};               // sensitivities: inputs; none: all
  std::vector<std::string> over{}, results{};  // table: PATH=FROM..TO; columns
  double bound = 0.01;                         // table: error at which a cell is finished
  int points = 0;                              // table: at most; 0: the quasi-static default
};

/// Each prints its result on standard output. Throws BadInput and ComputationFailed; returns the exit code.
int demo_command(const Options& options);
int check_command(const Options& options);
int run_command(const Options& options);
int sweep_command(const Options& options);
int merge_command(const Options& options);
int crown_command(const Options& options);
int fmu_command(const Options& options);
int mesh_command(const Options& options);
int carrier_command(const Options& options);
int modes_command(const Options& options);
int stiffness_command(const Options& options);
int sensitivities_command(const Options& options);
int table_command(const Options& options);
int validate_command(const Options& options);
int report_command(const Options& options);
int signals_command(const Options& options);
int spectrum_command(const Options& options);
int new_command(const Options& options);
int open_command(const Options& options);

/// Throws BadInput where the result would go nowhere: neither --output nor --json; where there is nothing to
/// resume.
void require_output(const Options& options);

/// Command and options of the words behind the program's name.
struct Asked {
  int (*command)(const Options&) = nullptr;
  Options options;
};
/// Throws BadInput where no command takes them.
Asked asked_by(const std::vector<std::string>& words);

/// Exit code: 0 done; 1 the computation failed, wholly or at some points; 2 bad input or usage.
int run_command_line(int argc, char** argv);

}  // namespace orbearing::app
