#include "app/case/case_file.hpp"
#include "app/commands/command_line.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

int merge_command(const Options& options) {
  const SweepOutcome outcome = merge_shards({options.folders.begin(), options.folders.end()}, options.output);
  const ResolvedCase resolved = read_case(options.output + "/case.resolved.yaml");
  return present_sweep(resolved, outcome, options.json, options.quiet);
}

}  // namespace orbearing::app
