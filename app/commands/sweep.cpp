#include "app/case/case_file.hpp"
#include "app/commands/command_line.hpp"
#include "app/study/refinements.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

int sweep_command(const Options& options) {
  const ResolvedCase resolved = read_case(options.case_file, options.settings);
  require_computable(resolved, options.fidelity, true);
  SweepRequest request = sweep_request(resolved, options.fidelity);
  if (options.shard) request.header.shard = parse_shard(*options.shard);
  request.folder = options.output;
  request.jobs = options.jobs;
  request.resume = options.resume;
  request.quiet = options.quiet;
  return present_sweep(resolved, run_sweep(request), options.json, options.quiet);
}

}  // namespace orbearing::app
