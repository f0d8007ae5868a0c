#include "app/commands/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <sstream>
#include <system_error>

#include "app/case/field_table.hpp"
#include "app/case/printable.hpp"
#include "app/case/units.hpp"
#include "app/commands/python_part.hpp"
#include "app/errors.hpp"
#include "app/resources.hpp"
#include "app/results/durable_file.hpp"
#include "app/results/progress.hpp"
#include "app/standard_error.hpp"
#include "app/study/fidelity.hpp"
#include "app/version.hpp"
#include "mechanics/cancellation.hpp"

namespace orbearing::app {

namespace {

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kBadInput = 2;

using Command = int (*)(const Options&);

void add_jobs(CLI::App& command, Options& options) {
  command.add_option("--jobs", options.jobs, "threads; default: one for each core")
      ->check(CLI::Range(1, 4096));
}

// An option that may be repeated, with one value each time.
void add_repeated(CLI::App& command, const char* name, std::vector<std::string>& values,
                  const std::string& meaning, const char* type) {
  command.add_option(name, values, meaning)
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name(type);
}

// An empty text, as a shell makes it of a variable that is not set, is no choice.
template <class Text>
CLI::Option& add_text(CLI::App& command, const char* name, Text& text, const std::string& meaning) {
  return *command.add_option(name, text, meaning)
              ->check(CLI::Validator(
                  [](const std::string& given) {
                    return given.empty() ? std::string("an empty text; a value is required") : "";
                  },
                  ""));
}

void add_settings(CLI::App& command, Options& options) {
  add_repeated(command, "--set", options.settings,
               "path=value: replace one independent value; repeatable, e.g. --set \"input.power=75 kW\". "
               "path=null leaves "
               "the key out",
               "PATH=VALUE");
}

void add_case(CLI::App& command, Options& options) {
  command.add_option("CASE", options.case_file, "case file")->required();
  add_settings(command, options);
}

CLI::Option& add_output(CLI::App& command, Options& options) {
  return *command.add_option("-o,--output", options.output, "folder of the results; created if missing")
              ->check([](const std::string& name) { return std::string(name.empty() ? "empty name" : ""); })
              ->type_name("DIR");
}

void add_output_or_json(CLI::App& command, Options& options) {
  add_output(command, options)
      .description(
          "folder of the results; created if missing. Optional with --json: nothing is written without it");
}

void add_fidelity(CLI::App& command, Options& options) {
  command
      .add_option("--fidelity", options.fidelity,
                  "quasi-static (default); dynamic: the gears drive the bearing in time; co-simulated or "
                  "monolithic: gears and all bearings act on each other")
      ->each([&options](const std::string&) { options.fidelity_given = true; })
      ->check(CLI::IsMember(fidelity_names()));
}

void add_computing(CLI::App& command, Options& options) {
  add_case(command, options);
  add_output_or_json(command, options);
  add_fidelity(command, options);
  command.add_flag("--resume", options.resume, "continue in DIR with the missing points");
}

void add_budget(CLI::App& command, Options& options) {
  command
      .add_option(
          "--budget", options.budget,
          "processor time of a motion, e.g. \"60 s\" or \"5 min\": fewer revolutions of the cage, then "
          "larger steps, chosen from the number of steps and written into the resolved case. No change "
          "where the estimate is below it")
      ->type_name("TIME");
}

void add_peak(CLI::App& command, Options& options) {
  add_jobs(command, options);
  command.add_flag("--grid-only", options.grid_only,
                   "compute only the points that the case lists; default: add points until the uncertainty "
                   "of the speed of the longest life is 10 rpm in motion, 2 rpm quasi-static");
}

void add_sweep(CLI::App& command, Options& options) {
  add_computing(command, options);
  add_budget(command, options);
  add_peak(command, options);
  command.add_option("--shard", options.shard, "compute part i of n; join the parts by merge")
      ->type_name("i/n");
  command
      .add_option(
          "--continue", options.direction,
          "up or down: one point after the other, each from the final state of its neighbour in speed")
      ->check(CLI::IsMember({"up", "down"}));
}

void add_crown_choices(CLI::App& command, CrownOptions& crown) {
  add_text(command, "--profile", crown.profiles,
           "kinds of profile, separated by commas: chamfer, circular, straight-circular, lundberg, "
           "johns-gohar, iso16281, fujiwara-kawase; default: that of the case, else iso16281");
  add_text(command, "--tilts", crown.tilts,
           "stated tilts of the planet's bore on its pin: a list or FROM : TO : STEP. Default: none, tilts "
           "are computed from planet, pin and bearings (if not possible: \"0 mrad, 1 mrad, 2 mrad\")");
  add_text(command, "--drops", crown.drops,
           "relief of one roller at the outermost of 40 laminae: a list or FROM : TO : STEP of "
           "lengths. Default: 17 from 0 to about three times that of ISO/TS 16281");
  command.add_flag("--spectrum", crown.spectrum,
                   "all speeds of the sweep, for equal times, instead of the one speed of the case");
  add_text(command, "--shares", crown.shares,
           "with --spectrum: shares of the time, one for each speed, separated by commas");
}

void add_crown_aims(CLI::App& command, CrownOptions& crown) {
  add_text(command, "--tolerance", crown.tolerance,
           "tolerance of the drop, plus and minus, that the recommended drop takes into account, e.g. "
           "\"1 um\"");
  add_text(command, "--tilt-tolerance", crown.tilt_tolerance,
           "the same for each stated tilt, or for the inclination of the pin in either direction "
           "where tilts are computed, e.g. \"0.5 mrad\"");
  command
      .add_option("--distribution", crown.distribution,
                  "distribution of deviations within the tolerances: normal (cut off at three standard "
                  "deviations; default), uniform, or worst (the limits only; the only one for stated tilts)")
      ->check(CLI::IsMember({"normal", "uniform", "worst"}));
  command
      .add_option("--life", crown.life,
                  "lundberg-palmgren (the life of a sweep for straight rollers without tilt) or iso16281 "
                  "(with its stress riser at the ends); default: by life.method of the case")
      ->check(CLI::IsMember({"lundberg-palmgren", "iso16281"}));
  command
      .add_option("--of", crown.of_set, "the set of the studied planet bearing, if the case has several sets")
      ->type_name("SET");
  command.add_option("--starts", crown.starts, "random starts of the search for the best crown; default: 10")
      ->check(CLI::Range(1, 1000));
}

void add_crown(CLI::App& command, Options& options) {
  add_case(command, options);
  add_output_or_json(command, options);
  add_crown_choices(command, options.crown);
  add_crown_aims(command, options.crown);
  add_jobs(command, options);
  command.add_flag("--resume", options.resume, "if DIR holds exactly this study, show its results again");
}

void add_fmu(CLI::App& command, Options& options) {
  add_case(command, options);
  command
      .add_option("-o,--output", options.output,
                  "file of the FMU; FILE.ssp: a package of gear set, bearings and parameters (SSP 1.0). An "
                  "existing file is replaced")
      ->required()
      ->type_name("FILE.fmu");
  command.add_option("--fmi", options.fmi, "version of the interface: 2 (default) or 3")
      ->check(CLI::IsMember({"2", "3"}));
  command
      .add_option(
          "--model", options.model,
          "bearing (default): one bearing of one planet; gearset: the gears without their planet bearings")
      ->check(CLI::IsMember({"bearing", "gearset"}));
  command.add_flag(
      "--windows", options.windows,
      "add the library for Windows to that for Linux. The first use builds it, which takes as long as "
      "a large part of the program: 5 to 20 minutes");
}

void add_signals(CLI::App& command, Options& options) {
  add_case(command, options);
  add_output_or_json(command, options);
  add_repeated(command, "--vary", options.varied,
               "path=[value, value]: input that is varied from signal to signal; repeatable, all "
               "combinations; default: defect.race, all elements that can be scratched",
               "PATH=[...]");
  command
      .add_option(
          "--fidelity", options.fidelity,
          "quasi-static (default): the ring on balls without mass; dynamic: the whole bearing in motion")
      ->check(CLI::IsMember({"quasi-static", "dynamic"}));
  CLI::Option* noise = command.add_option("--noise", options.noise,
                                          "noise of the instrument, root mean square [m/s2]; default: none");
  command.add_option("--seed", options.seed, "seed of the noise; default: 1")->needs(noise);
  add_jobs(command, options);
  command.add_flag("--resume", options.resume, "continue in DIR with the missing signals");
}

void add_sensitivities(CLI::App& command, Options& options) {
  add_case(command, options);
  add_output(command, options)
      .description("folder for sensitivities.csv and sensitivities.json; nothing is written without it");
  add_fidelity(command, options);
  command
      .add_option("--result", options.result,
                  "key of another number that run --json prints; a number within another one as "
                  "displacement/radial_um; default: the life selected by life.method")
      ->type_name("KEY");
  add_repeated(command, "--by", options.by,
               "only this input, repeatable: two runs for each of its numbers; default: all inputs; "
               "required in motion",
               "PATH");
  add_jobs(command, options);
  command.add_flag("--resume", options.resume, "if DIR holds exactly this table, show it again");
}

void add_table(CLI::App& command, Options& options) {
  add_computing(command, options);
  add_repeated(
      command, "--over", options.over,
      "input and its range, e.g. --over \"input.speed=1000 rpm..6000 rpm\"; repeatable, at most 6 inputs; "
      "default: the ranges of the case's sweep",
      "PATH=FROM..TO");
  add_repeated(command, "--result", options.results,
               "column of a sweep's table, repeatable; default: the life selected by life.method", "KEY");
  command
      .add_option("--bound", options.bound, "largest error of an answer from the table; default: 0.01 (1 %)")
      ->check(CLI::Range(1e-9, 1.0));
  command
      .add_option("--points", options.points,
                  "largest number of computed points; default: 50000 quasi-static, required in motion")
      ->check(CLI::Range(1, 100000));
  add_jobs(command, options);
}

void add_spectrum(CLI::App& command, Options& options) {
  command
      .add_option("SERIES", options.folders,
                  "records over time: CSV, output of OpenFAST (.out, .outb) or Bladed (.%NN, .$NN), or "
                  "netCDF, with time, speed "
                  "and torque "
                  "or power of the driving member; several with --share or --hours")
      ->required();
  const auto add_column = [&](const char* name, std::string& column, const std::string& of) {
    add_text(command, name, column, of).type_name("COLUMN");
  };
  add_column("--torque", options.columns.torque,
             "name of the column of torque; default: a column whose name begins with torque");
  add_column("--power", options.columns.power, "name of the column of power, instead of torque");
  add_column("--speed", options.columns.speed, "name of the column of speed; units are those of the file");
  add_column("--time", options.columns.time, "name of the column of time");
  add_text(command, "--share", options.share, "time share of each record, separated by commas; the sum is 1")
      .type_name("S,S");
  add_text(command, "--hours", options.hours, "hours of each record, separated by commas, instead of --share")
      .type_name("H,H");
  command
      .add_option("-o,--output", options.output,
                  "CSV file for spectrum: {file: ...} of a case; an existing file is replaced. With --case, "
                  "a name that does not end in .csv is a folder of results")
      ->type_name("FILE.csv|DIR");
  command.add_option("--bins", options.bins, "bins of torque x bins of speed; default: 8x8")
      ->type_name("NxM");
  command
      .add_option("--exponent", options.exponent,
                  "exponent p of life over torque, life ~ 1/torque^p. 4: Lundberg-Palmgren and ISO/TS 16281 "
                  "of rollers; 10/3: ISO 281 of rollers; 3: balls; up to 8: modified lives (a_ISO). Default: "
                  "4, with --case that of the life in use (life.method, requirements.life_key). A larger p "
                  "gives a shorter life")
      ->check(CLI::Range(1.0, 50.0));
  CLI::Option* stated =
      add_text(
          command, "--case", options.case_file,
          "case file: compute the lives of its bearings under these bins, damage by bin and by file, and "
          "time in skid risk (life.minimum_load)")
          .type_name("CASE");
  add_settings(command, options);
  add_fidelity(command, options);
  add_jobs(command, options);
  command.add_flag("--resume", options.resume, "continue in DIR with the missing bins");
  for (const char* of_case : {"--set", "--fidelity", "--jobs", "--resume"})
    command.get_option(of_case)->needs(stated);
}

void add_demo(CLI::App& command, Options& options) {
  add_output(command, options)
      .description(
          "folder of the results; created if missing. Default: orbearing-demo, or orbearing-demo-2, -3 ... "
          "if "
          "that exists");
}

void add_new(CLI::App& command, Options& options) {
  command.add_option("TEMPLATE", options.template_name, fmt::format("{}", fmt::join(template_names(), ", ")))
      ->required();
  command.add_option("FILE", options.output, "new case file; an existing file is not changed")->required();
}

void add_open(CLI::App& command, Options& options) {
  command
      .add_option("WHAT", options.case_file,
                  "case file, folder of results, or template (" +
                      fmt::format("{}", fmt::join(template_names(), ", ")) +
                      "); default: the page offers these")
      ->type_name("CASE|TEMPLATE|DIR");
  command.add_flag("--no-browser", options.no_browser,
                   "print the address of the page and do not open a browser");
  command.add_option("--port", options.port, "port on the loopback address; default: any free port")
      ->check(CLI::Range(1, 65535));
  command.add_option("--linger", options.linger)->group("")->check(CLI::Range(1, 3600));
  command.add_flag("--worker", options.worker)->group("");
}

// Subcommands in the order in which they are shown.
struct CommandTable {
  CLI::App& program;
  Options& options;
  Command& chosen;

  CLI::App& add(const char* name, const char* purpose, Command command) {
    CLI::App& sub = *program.add_subcommand(name, purpose);
    sub.add_flag("--json", options.json, "print only the result, as one JSON object");
    sub.add_flag("--quiet", options.quiet, "print errors only");
    sub.callback([&into = chosen, command] { into = command; });  // the table no longer exists when this runs
    return sub;
  }
};

// Named here so that the help lists them; what follows their names is theirs to read.
void add_python_commands(CLI::App& program) {
  for (const PythonCommand& command : python_commands())
    program.add_subcommand(command.name, command.purpose)->prefix_command();
}

void add_commands(CommandTable table) {
  Options& options = table.options;
  add_demo(
      table.add("demo", "life over speed of a 150 kW reducer with its report, in about 10 s", demo_command),
      options);
  add_new(table.add("new", "write a commented case file as a start", new_command), options);
  add_open(table.add("open", "open the page with forms, figures and variants in a browser", open_command),
           options);
  add_case(table.add("check", "print every input of a case with its value and source", check_command),
           options);
  CLI::App& run = table.add("run", "compute the case at its operating point", run_command);
  add_computing(run, options);
  add_budget(run, options);
  run.add_flag("--gears", options.gears,
               "vibration of the gears only, with bearings as springs; default for a case without a bearing");
  add_sweep(table.add("sweep", "compute all operating points of the case", sweep_command), options);
  CLI::App& merge = table.add("merge", "join the shards of a sweep", merge_command);
  add_settings(merge, options);
  merge.add_option("DIR", options.folders, "folders of the shards")->required();
  add_output(merge, options).required();
  add_peak(merge, options);
  add_crown(
      table.add("crown", "roller crowning study: life and pressure over the crown drop, recommended drop",
                crown_command),
      options);
  add_case(table.add("mesh", "mesh stiffness over a mesh period, contact ratio, phases", mesh_command),
           options);
  add_case(
      table.add("carrier",
                "loads and lives of each planet bearing over a revolution of a carrier on its own bearings",
                carrier_command),
      options);
  CLI::App& modes = table.add(
      "modes", "natural frequencies and kinds of modes of gears, or of a shaft on a pair of bearings",
      modes_command);
  add_case(modes, options);
  modes.add_option("--speed", options.speed,
                   "speed of the driven member (of the carrier if the set has no teeth), e.g. \"6000 rpm\"; "
                   "of a shaft on a pair of bearings, instead of operation.shaft_speed; default: at rest");
  CLI::App& stiffness = table.add(
      "stiffness", "5 x 5 stiffness of a bearing over speed and load, for rotor dynamics", stiffness_command);
  add_case(stiffness, options);
  add_output_or_json(stiffness, options);
  stiffness.add_flag("--resume", options.resume, "if DIR holds exactly this table, show it again");
  add_sensitivities(table.add("sensitivities", "sensitivity of the life to every number of the case",
                              sensitivities_command),
                    options);
  add_table(
      table.add("table", "results over up to 6 inputs as a table with its error, for queries in microseconds",
                table_command),
      options);
  add_fmu(
      table.add("fmu", "export the planet bearing or the gear set for other simulation tools (FMI 2.0, 3.0)",
                fmu_command),
      options);
  add_signals(table.add("signals", "labelled vibration signals of scratched bearings", signals_command),
              options);
  add_spectrum(table.add("spectrum", "load spectrum from records over time, by bins of torque and speed",
                         spectrum_command),
               options);
  CLI::App& validate =
      table.add("validate", "compare published numbers with those of the program", validate_command);
  add_settings(validate, options);
  validate.add_option("CASE", options.cases,
                      "case files or folders; default: all cases supplied with the program");
  validate.add_flag("--motion", options.motion,
                    "instead of published numbers: change of life at the peak by the assumptions that affect "
                    "only motion; takes minutes");
  validate
      .add_option(
          "--samples", options.samples,
          "samples of each case's uncertain inputs for the bands of measured rows; default: 0, no bands")
      ->check(CLI::Range(0, 1000000));
  add_jobs(validate, options);
  CLI::App& report =
      table.add("report", "write DIR/report.html, and DIR/report.pdf with --pdf", report_command);
  report.add_flag(
      "--pdf", options.pdf,
      "also write DIR/report.pdf: at most 8 pages of ratings, lives and verdicts for an assessor");
  report.add_flag("--data-only", options.data_only, "what the page is made of, and no page")->group("");
  report.add_option("--bearing-points", options.bearing_points, "points that the page requests")->group("");
  add_settings(report, options);
  report.add_option("DIR", options.folders, "folder of a run or sweep")->required()->expected(1);
  report
      .add_option("--with", options.other,
                  "folder of the same sweep, continued in the other direction: both branches are drawn")
      ->type_name("DIR2");
  report.add_flag("--every-effect", options.every_effect,
                  "of a dynamic sweep: effect of every model term, not only of the main ones; takes minutes");
}

bool known(const CLI::App& program, const std::string& word) {
  const std::vector<const CLI::App*> commands = program.get_subcommands({});
  return std::any_of(commands.begin(), commands.end(),
                     [&](const CLI::App* command) { return command->check_name(word); });
}

// The name of a command that does not exist is reported as such and not as a missing command.
void require_known_command(const CLI::App& program, const std::string& word) {
  if (word.empty() || word.front() == '-' || known(program, word)) return;
  throw BadInput(fmt::format(
      "orbearing: found the command {}; required: demo, new, open, check, run, sweep, merge, crown, mesh, "
      "carrier, modes, stiffness, sensitivities, table, fmu, signals, spectrum, study, uncertainty, convert, "
      "validate or report",
      word));
}

// Names and values of the user's go into JSON, CSV and messages, all of them UTF-8.
void require_utf8(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const std::size_t byte = first_byte_not_utf8(word);
    if (byte == word.size()) continue;
    const bool setting = std::string_view(argv[i - 1]) == "--set" || word.starts_with("--set=");
    throw BadInput(fmt::format("{}: found {}, whose byte {} is not UTF-8; required: text in UTF-8",
                               setting ? "--set" : fmt::format("argument {}", i), quote(word), byte + 1));
  }
}

// Line by line, so that text from the user in a message cannot move the cursor.
void print_error(std::string_view text) {
  for (bool more = true; more;) {
    const std::size_t end = text.find('\n');
    more = end != std::string_view::npos;
    print_to_standard_error("{}\n", printable(text.substr(0, end)));
    if (more) text.remove_prefix(end + 1);
  }
}

// Up to 18 digits, which every type of a count holds.
bool is_whole(std::string_view text, bool natural) {
  if (text.starts_with('+') || (!natural && text.starts_with('-'))) text.remove_prefix(1);
  return !text.empty() && text.size() <= 18 && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// Requirement for a value of an option that does not meet it; empty for a sound one. An empty text, as of a
// shell's variable that is not set, would select a default; nan is in every range, and a seed of -1 becomes
// another one.
std::string required_of(const CLI::Option& option, const std::string& given) {
  const std::string type = option.get_type_name(), text = trimmed(given);
  const bool natural = type.starts_with("UINT"), whole = natural || type.starts_with("INT");
  const bool numeric = whole || type.starts_with("FLOAT");
  if (text.empty()) return numeric ? "a number" : "a value";
  if (whole && !is_whole(text, natural))
    return natural ? "a whole number from 0, of at most 18 digits" : "a whole number of at most 18 digits";
  return numeric && !read_number(text).value ? "a finite number" : "";
}

void require_values(const CLI::App& program) {
  for (const CLI::App* command : program.get_subcommands())
    for (const CLI::Option* option : command->get_options())
      for (const std::string& given : option->results())
        if (const std::string required = required_of(*option, given); !required.empty())
          throw BadInput(fmt::format("{}: found {}; required: {}", option->get_name(),
                                     trimmed(given).empty() ? "an empty text" : quote(given), required));
}

// A line for each option that was not expected and resembles one of its command.
std::string proposals(const CLI::App& program) {
  std::string lines;
  for (const CLI::App* command : program.get_subcommands()) {
    std::vector<std::string> known;
    for (const CLI::Option* option : command->get_options())
      if (!option->get_group().empty()) known.push_back(option->get_name(false, true));
    for (const std::string& word : command->remaining()) {
      const std::string near =
          word.starts_with("--") ? nearest_word(word.substr(0, word.find('=')), known) : "";
      if (!near.empty()) lines += fmt::format("\nDid you mean {}?", near);
    }
  }
  return lines;
}

// The program of all commands, which stores the command line in `asked`.
class Reader {
 public:
  explicit Reader(Asked& asked) {
    program_.set_version_flag("--version", std::string(program_version));
    program_.require_subcommand(1);
    program_.failure_message([](const CLI::App* program, const CLI::Error& error) {
      return error.what() + proposals(*program) + "\nRun with --help for more information.\n";
    });
    add_commands(CommandTable{program_, asked.options, asked.command});
  }

  CLI::App& program() { return program_; }

 private:
  CLI::App program_{"Orbearing: planet bearings inside planetary drivetrains", "orbearing"};
};

int parse_and_run(int argc, char** argv) {
  require_utf8(argc, argv);
  Asked asked;
  Reader reader(asked);
  CLI::App& program = reader.program();
  add_python_commands(program);
  require_known_command(program, argc > 1 ? argv[1] : "");
  hand_over(argc, argv);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Not into the streams themselves: they flush, and the reason of a full disk would be lost.
    std::ostringstream answer;
    const int code = program.exit(error, answer, answer);
    if (code != 0) {
      print_error(answer.view().substr(0, answer.view().find_last_not_of('\n') + 1));
      return kBadInput;
    }
    fmt::print("{}", answer.str());
    return kDone;
  }
  require_values(program);
  return asked.command(asked.options);
}

// Flushes the output: a full disk is reported here and not by the print functions.
void require_printed() {
  // First of all, since the stream of the standard library flushes it too and gives no reason.
  errno = 0;
  const bool whole = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  const int error = whole ? 0 : errno;
  if (whole && std::cout.flush()) return;
  std::clearerr(stdout);
  std::cout.clear();
  throw WriteFailed(fmt::format("standard output: cannot be written{}{}", error == 0 ? "" : ": ",
                                error == 0 ? "" : std::strerror(error)),
                    remedy_of(error));
}

}  // namespace

void require_output(const Options& options) {
  if (!options.output.empty()) return;
  if (!options.json)
    throw BadInput("--output: missing; required: a folder for the results, or --json to print them alone");
  if (options.resume) throw BadInput("--resume: found without --output; required: the folder to continue");
}

Asked asked_by(const std::vector<std::string>& words) {
  Asked asked;
  Reader reader(asked);
  require_known_command(reader.program(), words.empty() ? "" : words.front());
  try {
    reader.program().parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError& error) {
    throw BadInput(error.what() + proposals(reader.program()));
  }
  require_values(reader.program());
  return asked;
}

int run_command_line(int argc, char** argv) {
  const Interruption interruption;
  // A file grown beyond the user's limit is an error of the write then, which cleans up, not the end.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const int code = parse_and_run(argc, argv);
    require_printed();
    return code;
  } catch (const BadInput& error) {
    for (const std::string& line : error.messages) print_error(line);
    return kBadInput;
  } catch (const ComputationFailed& error) {
    print_error(error.what());
    return kFailed;
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) != 0)
      print_to_standard_error("standard output: {}; {}, then give the command again\n", error.what(),
                              remedy_of(error.code().value()));
    else
      print_to_standard_error("orbearing: {}\n", error.what());
    return kFailed;
  } catch (const std::exception& error) {
    print_error(std::string("orbearing: ") + error.what());
    return kFailed;
  } catch (const Cancelled& wish) {
    print_to_standard_error("orbearing: {}\n", wish.what());
    return kFailed;
  }
}

}  // namespace orbearing::app
