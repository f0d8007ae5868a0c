#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <filesystem>

#include "app/case/case_file.hpp"
#include "app/commands/lone_runs.hpp"
#include "app/commands/presentation.hpp"
#include "app/commands/python_part.hpp"
#include "app/errors.hpp"
#include "app/resources.hpp"
#include "app/results/durable_file.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/ball_study.hpp"
#include "app/study/branches.hpp"
#include "app/study/crown/crown_figures.hpp"
#include "app/study/crown/crown_files.hpp"
#include "app/study/defect_study.hpp"
#include "app/study/report_data.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* data_name = "report.json";
constexpr const char* page_name = "report.html";

void write_data(const fs::path& file, const nlohmann::ordered_json& data) {
  try {
    write_aside_and_rename(file, data.dump(1) + '\n');
  } catch (const WriteFailed& error) {
    throw ComputationFailed(error.cause + "; no report was written: make room, then run it again");
  }
}

// Numbers whose page could not be drawn are taken back.
void draw_page(const fs::path& folder) {
  const int code = run_python("orbearing.report", {folder.string()});
  if (code == 0) return;
  std::error_code ignored;
  fs::remove(folder / data_name, ignored);
  throw ComputationFailed((folder / page_name).string() + ": was not drawn; " +
                          (code == not_started
                               ? resources().interpreter.string() +
                                     " is required, with matplotlib and netCDF4 (Debian: python3-matplotlib "
                                     "python3-netcdf4)"
                               : std::string("the message above says why")));
}

// Of a crowning study: its result and what its pictures show beyond it.
nlohmann::ordered_json crown_data(const ResolvedCase& resolved, const fs::path& folder) {
  const CrownResult stored = read_crown(folder);
  const CrownRequest request = crown_request(resolved, options_from(stored.object.at("options")));
  return {{"crown", stored.object}, {"figures", crown_figures(resolved, request, stored.object)}};
}

// Of a single bearing in motion: what its run printed, as `name`; what is drawn over time stands in its file
// of results.
nlohmann::ordered_json printed_data(const fs::path& file, const char* name) {
  try {
    return {{name, nlohmann::ordered_json::parse(read_file(file))}};
  } catch (const nlohmann::json::exception& error) {
    throw BadInput(file.string() + ": is not a result of this program (" + error.what() +
                   "); required: an untouched one. Run it again into another folder");
  }
}

nlohmann::ordered_json sweep_data(const ResolvedCase& resolved, const Manifest& manifest,
                                  const Options& options) {
  const fs::path folder = options.folders.front();
  std::vector<Branch> branches{{folder, manifest}};
  if (!options.other.empty()) {
    branches.push_back({options.other, read_results(options.other)});
    require_two_branches(branches.front(), branches.back());
  }
  nlohmann::ordered_json data = report_data(resolved, manifest, options.every_effect, !options.quiet);
  data["branches"] = branches_json(resolved, branches);
  return data;
}

}  // namespace

int report_command(const Options& options) {
  if (!options.settings.empty())
    throw BadInput("--set: " + options.settings.front() +
                   ": found with report; required: set it in the sweep");
  const fs::path folder = options.folders.front();
  const Manifest manifest = read_results(folder);
  require_writable(folder);
  const ResolvedCase resolved = read_case((folder / "case.resolved.yaml").string());
  if (resolved.model() != planetary_drivetrain && !is_defect(resolved) && !is_ball_run(resolved))
    throw BadInput(
        folder.string() + ": found results of the model " + resolved.choice("model") +
        "; required: a sweep, a crowning study, a ball bearing in time or a bearing with scratches, of which "
        "pages are drawn");
  if (manifest.header && manifest.header->fidelity == "gears")
    throw BadInput(folder.string() +
                   ": found the motion of gears alone (run --gears); required: a sweep or a run of "
                   "bearings, of which pages are drawn");
  if (is_defect(resolved) && !fs::exists(folder / defect_file_name))
    throw BadInput(
        folder.string() +
        ": found a set of signals; required: the folder of one run, of which a page is drawn; labels.csv "
        "lists the set");
  const fs::path page = folder / page_name;
  const nlohmann::ordered_json data = is_defect(resolved) ? printed_data(folder / defect_file_name, "defect")
                                      : is_ball_run(resolved) ? printed_data(folder / ball_file_name, "balls")
                                      : holds_crown(folder)   ? crown_data(resolved, folder)
                                                              : sweep_data(resolved, manifest, options);
  if (options.data_only) {
    print_object(data, options);
    return 0;
  }
  write_data(folder / data_name, data);
  draw_page(folder);
  if (options.json)
    print_object(nlohmann::ordered_json{{"report", page.string()}}, options);
  else if (!options.quiet)
    fmt::print("{}\n", page.string());
  return 0;
}

}  // namespace orbearing::app
