#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

#include "app/case/case_file.hpp"
#include "app/commands/command_line.hpp"
#include "app/errors.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/branches.hpp"
#include "app/study/crown/crown_figures.hpp"
#include "app/study/crown/crown_files.hpp"
#include "app/study/report_data.hpp"
#include "app/version.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

// The Python package: of the source tree this program was built from, or beside an installed program.
fs::path python_package() {
  const fs::path in_tree = fs::path(source_folder) / "python";
  if (fs::is_directory(in_tree)) return in_tree;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  return program.parent_path().parent_path() / "share" / "orbearing" / "python";
}

void write_data(const fs::path& file, const nlohmann::ordered_json& data) {
  const fs::path aside = file.string() + ".tmp";
  std::ofstream out(aside);
  out << data.dump(1) << '\n';
  out.close();
  if (!out)
    throw BadInput(file.string() + ": cannot be written; required: a folder with leave to write and room");
  fs::rename(aside, file);
}

// Runs Debian's own interpreter, which has the packages that the page needs, without a shell in between.
int draw(const fs::path& folder) {
  const pid_t child = fork();
  if (child == 0) {
    setenv("PYTHONPATH", python_package().c_str(), 1);
    const std::string target = folder.string();
    execl("/usr/bin/python3", "python3", "-m", "orbearing.report", target.c_str(), nullptr);
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

// Of a crowning study: its result and what its pictures show beyond it.
nlohmann::ordered_json crown_data(const ResolvedCase& resolved, const fs::path& folder) {
  const CrownResult stored = read_crown(folder);
  const CrownRequest request = crown_request(resolved, options_from(stored.object.at("options")));
  return {{"crown", stored.object}, {"figures", crown_figures(resolved, request, stored.object)}};
}

nlohmann::ordered_json sweep_data(const ResolvedCase& resolved, const Manifest& manifest,
                                  const Options& options) {
  const fs::path folder = options.folders.front();
  std::vector<Branch> branches{{folder, manifest}};
  if (!options.other.empty()) {
    branches.push_back({options.other, read_results(options.other)});
    require_two_branches(branches.front(), branches.back());
  }
  nlohmann::ordered_json data = report_data(resolved, manifest, options.every_effect);
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
  const ResolvedCase resolved = read_case((folder / "case.resolved.yaml").string());
  const fs::path page = folder / "report.html";
  const nlohmann::ordered_json data =
      holds_crown(folder) ? crown_data(resolved, folder) : sweep_data(resolved, manifest, options);
  write_data(folder / "report.json", data);
  if (draw(folder) != 0)
    throw ComputationFailed(page.string() +
                            ": was not drawn; required: /usr/bin/python3 with numpy, matplotlib, "
                            "xarray and netCDF4 (Debian: python3-matplotlib python3-xarray python3-netcdf4)");
  if (options.json)
    fmt::print("{}\n", nlohmann::ordered_json{{"report", page.string()}}.dump(2));
  else if (!options.quiet)
    fmt::print("{}\n", page.string());
  return 0;
}

}  // namespace orbearing::app
