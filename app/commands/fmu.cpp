#include "app/commands/fmu.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/presentation.hpp"
#include "app/commands/python_part.hpp"
#include "app/errors.hpp"
#include "app/resources.hpp"
#include "app/results/durable_file.hpp"
#include "app/study/analysis.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/fmu_model.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/sweep_study.hpp"
#include "coupling/fmu/model.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

void require_file_name(const fs::path& file) {
  std::error_code ignored;
  if (file.extension() != ".fmu" || fs::is_directory(file, ignored))
    throw BadInput("--output: found '" + file.string() + "'; required: a file that ends with .fmu or .ssp");
}

fmu::DescriptionOptions description_options(const ResolvedCase& resolved, const FmuOptions& options) {
  fmu::DescriptionOptions out;
  out.interface = options.fmi == "3" ? fmu::Interface::fmi3 : fmu::Interface::fmi2;
  out.name = resolved.text("name") + (options.model == "gearset" ? ", gear set" : ", planet bearing");
  return out;
}

std::vector<std::string> platforms_of(const std::vector<FmuLibrary>& libraries) {
  std::vector<std::string> names;
  for (const FmuLibrary& library : libraries) names.push_back(library.platform);
  return names;
}

struct Outcome {
  std::size_t inputs = 0;
  std::size_t outputs = 0;
  std::size_t parameters = 0;
  std::size_t bytes = 0;
  std::string token;
  std::vector<std::string> platforms;
  std::vector<std::string> warnings;
};

void present(const ResolvedCase& resolved, const FmuOptions& options, const Outcome& outcome) {
  if (options.print.json) {
    Record record;
    record.value("case", "name", resolved.text("name"));
    record.value("file", "that was written", options.output);
    record.value("fmi", "version of the interface", options.fmi);
    record.value("model", "what it is of", options.model);
    record.value("token", "of its variables and program", outcome.token);
    record.value("platforms", "of its libraries", outcome.platforms);
    record.value("inputs", "variables", outcome.inputs);
    record.value("outputs", "variables", outcome.outputs);
    record.value("parameters", "variables", outcome.parameters);
    record.value("bytes", "of the file", outcome.bytes);
    nlohmann::ordered_json object = json_of(record);
    object["assumptions"] = assumptions_json(resolved);
    object["warnings"] = outcome.warnings;
    object["versions"] = versions_json();
    print_result(std::move(object), record, options.print);
    return;
  }
  if (options.print.quiet) return;
  fmt::print("{}: FMI {}.0, model {}, {} inputs, {} outputs, {} parameters, for {}\n", options.output,
             options.fmi, options.model, outcome.inputs, outcome.outputs, outcome.parameters,
             fmt::join(outcome.platforms, " and "));
  print_warnings(outcome.warnings);
}

// The output life_used is by the loads alone: the warning compares it with the governing life of the case.
std::vector<std::string> life_warnings(const ResolvedCase& resolved) try {
  namespace rating = bearing::rating;
  const analysis::PointResult point = analysis::evaluate(bearing_sets(resolved));
  const rating::Life life = analysis::governing_life(point);
  const double governing = analysis::governing_hours(point);
  if (life == rating::Life::lundberg_palmgren || !(governing > 0.0)) return {};
  return {fmt::format(
      "life_used: by the life of Lundberg and Palmgren, without oil and profile: {:.5g} h at the case's "
      "point. The governing life there is {} {:.5g} h, so that the bearing is used up {:.3g} times as fast",
      point.life_hours, rating::hours_key(life), governing, point.life_hours / governing)};
} catch (const std::runtime_error&) {  // a case whose point has no quasi-static equilibrium
  return {};
}

// Makes the folder of `file` where it is missing; nothing is computed for a file that cannot be written.
void require_folder_of(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code error;
  fs::create_directories(folder, error);
  if (std::error_code ignored; !fs::is_directory(folder, ignored))
    throw BadInput(fmt::format("--output: {}: cannot be made: {}; required: a writable path", folder.string(),
                               error.message()));
  require_writable(folder);
}

void write_fmu(const fs::path& file, const std::string& content) {
  try {
    write_aside_and_rename(file, content);
  } catch (const WriteFailed& error) {
    throw ComputationFailed(error.cause + "; no FMU was written: " + error.remedy + ", then run it again");
  }
}

// Whether a system of both FMUs and their parameters is to be written, which the Python part does.
bool is_of_system(const FmuOptions& options) {
  return fs::path(options.output).extension() == ".ssp" && !options.stated.given;
}

int write_system(const FmuOptions& options) {
  std::vector<std::string> words{options.stated.file, "--output", options.output};
  for (const std::string& setting : options.stated.settings) words.insert(words.end(), {"--set", setting});
  if (options.windows) words.push_back("--windows");
  if (options.print.json) words.push_back("--json");
  if (options.print.quiet) words.push_back("--quiet");
  const int code = run_python("orbearing.ssp", words);
  if (code == not_started)
    throw ComputationFailed(
        fmt::format("fmu: {} is required for files that end with .ssp, with numpy (Debian: python3-numpy)",
                    resources().interpreter.string()));
  return code;
}

}  // namespace

std::vector<std::string> problems(const FmuOptions& options) {
  const std::string other = options.fmi != "2"           ? "--fmi " + options.fmi
                            : options.model != "bearing" ? "--model " + options.model
                                                         : "";
  if (!is_of_system(options) || other.empty()) return {};
  return {fmt::format(
      "--output: found '{}' together with {}; required: no such option, since a package of SSP 1.0 holds "
      "the gear set and the bearing, by FMI 2.0",
      other, options.output)};
}

int execute(const FmuOptions& options) {
  if (is_of_system(options)) return write_system(options);
  const fs::path file = options.output;
  require_file_name(file);
  const ResolvedCase resolved = point_of(options.stated);
  const std::vector<std::string> unused =
      require_used(resolved, options.model == "gearset" ? AnalysisId::fmu_gearset : AnalysisId::fmu_bearing);
  const fmu::NumberTable numbers =
      options.model == "gearset" ? gear_numbers(resolved) : bearing_numbers(resolved);
  require_folder_of(file);
  const fmu::DescriptionOptions description = description_options(resolved, options);
  const std::vector<FmuLibrary> libraries =
      fmu_libraries(numbers, description.interface, options.windows, options.print.quiet);
  const std::string content = fmu_content(numbers, description, libraries);
  write_fmu(file, content);
  const fmu::ModelFacts facts = fmu::facts_of(numbers);
  present(resolved, options,
          {facts.inputs.size(), facts.outputs.size(), facts.shown.parameters.size(), content.size(),
           fmu::token_of(numbers), platforms_of(libraries),
           options.model == "gearset" ? joined(gear_warnings(resolved), planar_warnings(resolved), unused)
                                      : joined(gear_warnings(resolved), overturning_warnings(resolved),
                                               life_warnings(resolved), unused)});
  return 0;
}

}  // namespace orbearing::app
