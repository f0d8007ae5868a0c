#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/life_peak.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

// Each point waits for its neighbour: neither threads nor shards can share such a sweep.
void require_sequential(const Options& options) {
  std::vector<std::string> mistakes;
  if (options.shard)
    mistakes.push_back(
        "--continue: found with --shard; required: one of both, since a path of points cannot be divided");
  if (options.jobs > 1)
    mistakes.push_back("--continue: found with --jobs " + std::to_string(options.jobs) +
                       "; required: --jobs 1 or none, since each point waits for its neighbour");
  if (!mistakes.empty()) throw BadInput(mistakes);
}

SweepRequest request_of(const ResolvedCase& resolved, const Options& options) {
  SweepRequest request = sweep_request(resolved, options.fidelity);
  if (options.shard) request.header.shard = parse_shard(*options.shard);
  if (options.direction) {
    require_sequential(options);
    continue_from_neighbours(resolved, parse_direction(*options.direction), request);
  } else if (!options.grid_only) {
    refine_peak_of(resolved, request);
  }
  return request;
}

}  // namespace

int sweep_command(const Options& options) {
  require_output(options);
  const ResolvedCase stated = case_of(options);
  require_computable(stated, options.fidelity, true);
  auto [resolved, request] =
      plan_sweep(stated, options, [&](const ResolvedCase& in) { return request_of(in, options); });
  put_options(options, request);
  return present_sweep(resolved, run_sweep(request), options);
}

}  // namespace orbearing::app
