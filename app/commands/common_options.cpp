#include "app/commands/common_options.hpp"

#include "app/study/fidelity.hpp"

namespace orbearing::app {

Option settings_row(std::vector<std::string>& settings, const std::string& needs) {
  return option(settings, "--set",
                "path=value: replace one independent value; repeatable, e.g. --set \"input.power=75 kW\". "
                "path=null leaves the key out",
                {.type = "PATH=VALUE", .needs = needs});
}

Option output_row(std::string& folder, const char* meaning, bool required) {
  return option(folder, "-o,--output", meaning, {.type = "DIR", .required = required});
}

Option output_or_json_row(std::string& folder) {
  return output_row(
      folder,
      "folder of the results; created if missing. Optional with --json: nothing is written without it");
}

std::vector<std::string> problems(const ResultPlace& place, const Printing& print) {
  if (!place.folder.empty()) return {};
  if (!print.json)
    return {"--output: missing; required: a folder for the results, or --json to print them alone"};
  if (place.resume) return {"--resume: found without --output; required: the folder to continue"};
  return {};
}

Option fidelity_row(std::string& fidelity, const std::string& needs) {
  return option(fidelity, "--fidelity",
                "quasi-static (default); dynamic: the gears drive the bearing in time; co-simulated or "
                "monolithic: gears and all bearings act on each other",
                {.choices = fidelity_names(), .needs = needs});
}

Option jobs_row(int& jobs, const std::string& needs) {
  return option(jobs, "--jobs", "threads; default: one for each core",
                {.range = described::Range{1, 4096}, .needs = needs});
}

Option budget_row(std::string& budget) {
  return option(budget, "--budget",
                "processor time of a motion, e.g. \"60 s\" or \"5 min\": fewer revolutions of the cage, then "
                "larger steps, chosen from the number of steps and written into the resolved case. No change "
                "where the estimate is below it",
                {.type = "TIME"});
}

Option grid_only_row(bool& grid_only) {
  return option(grid_only, "--grid-only",
                "compute only the points that the case lists; default: add points until the uncertainty "
                "of the speed of the longest life is 10 rpm in motion, 2 rpm quasi-static");
}

}  // namespace orbearing::app
