#include "app/case/case_file.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/study/life_peak.hpp"
#include "app/study/sweep_study.hpp"
#include "app/version.hpp"

namespace orbearing::app {

namespace {

// The points that refine the peak must come from the same program as the shards.
void require_able_to_refine(const std::vector<std::filesystem::path>& shards) {
  std::vector<std::string> mistakes;
  for (const std::filesystem::path& shard : shards) {
    const ManifestHeader header = *read_results(shard).header;
    const auto require = [&](const char* what, const std::string& found, std::string_view own) {
      if (header.refined && found != own)
        mistakes.push_back(shard.string() + ": " + what + " '" + found + "' was found; '" + std::string(own) +
                           "' is required to refine the peak, or --grid-only to merge without");
    };
    require("program version", header.program_version, program_version);
    require("instruction set", header.instruction_set, instruction_set);
  }
  if (!mistakes.empty()) throw BadInput(mistakes);
}

}  // namespace

int merge_command(const Options& options) {
  if (!options.settings.empty())
    throw BadInput("--set: " + options.settings.front() +
                   ": found with merge; required: set it in the sweeps of all shards");
  const std::vector<std::filesystem::path> shards(options.folders.begin(), options.folders.end());
  if (!options.grid_only) require_able_to_refine(shards);
  const SweepOutcome grid = merge_shards(shards, options.output, options.grid_only);
  const ResolvedCase resolved = read_case(options.output + "/case.resolved.yaml");
  if (!grid.header.refined) return present_sweep(resolved, grid, options);
  SweepRequest request = sweep_request(resolved, grid.header.fidelity);
  refine_peak_of(resolved, request);
  put_options(options, request);
  request.resume = true;
  return present_sweep(resolved, run_sweep(request), options);
}

}  // namespace orbearing::app
