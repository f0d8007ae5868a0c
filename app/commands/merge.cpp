#include "app/commands/merge.hpp"

#include "app/case/case_file.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/study/life_peak.hpp"
#include "app/study/sweep_study.hpp"
#include "app/version.hpp"
#include "orbearing/results.hpp"

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

std::vector<std::string> problems(const MergeOptions& options) {
  if (options.settings.empty()) return {};
  return {"--set: " + options.settings.front() +
          ": found with merge; required: set it in the sweeps of all shards"};
}

int execute(const MergeOptions& options) {
  const std::vector<std::filesystem::path> shards(options.shards.begin(), options.shards.end());
  if (!options.grid_only) require_able_to_refine(shards);
  const SweepOutcome grid = merge_shards(shards, options.output, options.grid_only);
  const ResolvedCase resolved = read_case(options.output + "/" + resolved_case_name);
  if (!grid.header.refined) return present_sweep(resolved, grid, options.print);
  SweepRequest request = sweep_request(resolved, grid.header.fidelity);
  refine_peak_of(resolved, request);
  put_execution({options.output, true}, options.jobs, options.print, request);
  return present_sweep(resolved, run_sweep(request), options.print);
}

}  // namespace orbearing::app
