#include "app/commands/report.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

#include "app/case/case_file.hpp"
#include "app/case/static_case.hpp"
#include "app/commands/kept_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/commands/python_part.hpp"
#include "app/errors.hpp"
#include "app/resources.hpp"
#include "app/results/durable_file.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/analysis.hpp"
#include "app/study/crown/crown_study.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/report_data.hpp"
#include "app/study/scratch_case.hpp"
#include "app/study/sweep_study.hpp"
#include "orbearing/files.hpp"
#include "orbearing/results.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* data_name = "report.json";
constexpr const char* page_name = "report.html";
constexpr const char* pdf_name = "report.pdf";

void write_data(const fs::path& file, const nlohmann::ordered_json& data) {
  try {
    write_aside_and_rename(file, data.dump(1) + '\n');
  } catch (const WriteFailed& error) {
    throw ComputationFailed(error.cause + "; no report was written: " + error.remedy + ", then run it again");
  }
}

// Numbers whose page could not be drawn are taken back.
void draw_page(const fs::path& folder, const ReportOptions& options) {
  std::error_code ignored;
  std::vector<std::string> words{folder.string(), "--program", fs::read_symlink("/proc/self/exe", ignored)};
  if (options.every_effect) words.push_back("--every-effect");
  if (options.pdf) words.push_back("--pdf");
  if (options.print.quiet) words.push_back("--quiet");
  const int code = run_python("orbearing.report", words);
  if (code == 0) return;
  fs::remove(folder / data_name, ignored);
  throw ComputationFailed((folder / page_name).string() + ": was not drawn; " +
                          (code == not_started
                               ? resources().interpreter.string() +
                                     " is required, with matplotlib and netCDF4 (Debian: python3-matplotlib "
                                     "python3-netcdf4; for --pdf also weasyprint)"
                               : std::string("the message above says why")));
}

// Data of a crowning study: its result and the additional data of its figures.
nlohmann::ordered_json crown_data(const ResolvedCase& resolved, const fs::path& folder) {
  const CrownResult stored = read_crown(folder);
  const CrownRequest request = crown_request(resolved, choices_from(stored.object.at("options")));
  return {{"crown", stored.object}, {"figures", crown_figures(resolved, request, stored.object)}};
}

// Data of a single bearing in motion: the printed result of its run, as `name`; series over time are in its
// file of results.
nlohmann::ordered_json published_data(const fs::path& file, const char* name) {
  return {{name, nlohmann::ordered_json::parse(read_file(file))}};  // its checksum holds
}

nlohmann::ordered_json sweep_data(const ResolvedCase& resolved, const Manifest& manifest,
                                  const ReportOptions& options) {
  const fs::path folder = options.folder;
  std::vector<Branch> branches{{folder, manifest}};
  if (!options.other.empty()) {
    branches.push_back({options.other, read_results(options.other)});
    require_two_branches(branches.front(), branches.back());
  }
  nlohmann::ordered_json data = report_data(resolved, manifest);
  data["branches"] = branches_json(resolved, branches);
  return data;
}

/// Throws where a file of the folder differs from the one that was written there.
void require_as_written(const fs::path& folder, const Manifest& manifest) {
  std::vector<std::string> faults{fault_of_case(folder, *manifest.header)};
  for (const auto& [point, entry] : manifest.entries)
    if (!entry.others.empty()) faults.push_back(fault_of_point(folder, entry));
  require_undamaged(std::move(faults));
}

/// Throws where the folder has no finished point or no kind of result that has a page.
void require_results(const fs::path& folder, const ResolvedCase& resolved, const Manifest& manifest) {
  const std::vector<std::string>& names = fidelity_names();
  const bool sweep = std::find(names.begin(), names.end(), manifest.header->fidelity) != names.end();
  if (manifest.entries.empty())
    throw BadInput(folder.string() +
                   ": found no finished point; required: at least one. Give its command again with --resume");
  if (resolved.model() == planetary_drivetrain && !is_defect(resolved) && !sweep && !holds_crown(folder))
    throw BadInput(fmt::format(
        "{}: found results of '{}'; required: a sweep, a run or a crowning study that is complete "
        "({}), of which pages are drawn",
        folder.string(), printable(manifest.header->fidelity), crown_file_name));
}

// Whether the folder holds the run of a single bearing under a static load, or of a duplex pair.
bool is_static_run(const ResolvedCase& resolved, const Manifest& manifest) {
  if (!is_static_bearing(resolved) && resolved.model() != duplex_pair) return false;
  const Analysis* analysis = analysis_of(resolved);
  return analysis != nullptr && manifest.header && manifest.header->fidelity == analysis->names.name;
}

nlohmann::ordered_json data_of(const ResolvedCase& resolved, const Manifest& manifest,
                               const ReportOptions& options) {
  const fs::path folder = options.folder;
  if (is_defect(resolved)) return published_data(folder / defect_file_name, "defect");
  if (is_ball_run(resolved)) return published_data(folder / ball_file_name, "balls");
  if (is_static_run(resolved, manifest))
    return {{resolved.model() == duplex_pair ? "pair" : "static",
             printed_json(resolved, *analysis_of(resolved))}};
  if (holds_crown(folder)) return crown_data(resolved, folder);
  return sweep_data(resolved, manifest, options);
}

/// An assessor's page is of lives.
void require_lives(const fs::path& folder, const ResolvedCase& resolved) {
  if (is_defect(resolved) || holds_crown(folder))
    throw BadInput("--pdf: found " + folder.string() +
                   (is_defect(resolved) ? ", a run of a bearing with scratches" : ", a crowning study") +
                   "; required: a run or sweep with lives of bearings. Without --pdf the page is drawn");
}

}  // namespace

std::vector<std::string> problems(const ReportOptions& options) {
  if (options.settings.empty()) return {};
  return {"--set: " + options.settings.front() + ": found with report; required: set it in the sweep"};
}

int execute(const ReportOptions& options) {
  const fs::path folder = options.folder;
  if (!options.bearing_points.empty()) {
    print_object(bearing_points(read_case((folder / resolved_case_name).string()),
                                nlohmann::ordered_json::parse(options.bearing_points), !options.print.quiet),
                 options.print);
    return 0;
  }
  const Manifest manifest = read_results(folder);
  require_writable(folder);
  const FolderLock lock(folder);
  require_as_written(folder, manifest);
  const ResolvedCase resolved = read_case((folder / resolved_case_name).string());
  if (resolved.model() != planetary_drivetrain && !is_defect(resolved) && !is_ball_run(resolved) &&
      !is_static_run(resolved, manifest))
    throw BadInput(folder.string() + ": found results of the model " + resolved.choice("model") +
                   "; required: a sweep, a crowning study, or the run of a roller or ball bearing, of a "
                   "duplex pair or of a bearing with scratches");
  if (manifest.header && manifest.header->fidelity == "gears")
    throw BadInput(folder.string() +
                   ": found the motion of gears alone (run --gears); required: a sweep or a run of bearings");
  if (is_defect(resolved) && !fs::exists(folder / defect_file_name))
    throw BadInput(folder.string() +
                   ": found a set of signals; required: the folder of one run; labels.csv lists the set");
  require_results(folder, resolved, manifest);
  const fs::path page = folder / page_name;
  if (options.pdf) require_lives(folder, resolved);
  nlohmann::ordered_json data = data_of(resolved, manifest, options);
  data["given"] = given_json(resolved);
  if (options.data_only) {
    print_object(data, options.print);
    return 0;
  }
  write_data(folder / data_name, data);
  draw_page(folder, options);
  nlohmann::ordered_json written{{"report", page.string()}};
  if (options.pdf) written["pdf"] = (folder / pdf_name).string();
  if (options.print.json) {
    written["units"] = nlohmann::ordered_json::object();
    print_object(written, options.print);
  } else if (!options.print.quiet) {
    for (const auto& [what, file] : written.items()) fmt::print("{}\n", file.get<std::string>());
  }
  if (!options.print.json && !options.print.quiet && data.contains("missing") && data["missing"].is_object())
    print_warnings({data["missing"]["text"].get<std::string>()});
  return 0;
}

}  // namespace orbearing::app
