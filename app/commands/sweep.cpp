#include "app/commands/sweep.hpp"

#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/life_peak.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

SweepRequest request_of(const ResolvedCase& resolved, const SweepOptions& options) {
  SweepRequest request = sweep_request(resolved, fidelity_or_default(options.fidelity));
  if (!options.shard.empty()) request.header.shard = parse_shard(options.shard);
  if (!options.direction.empty()) {
    continue_from_neighbours(resolved, parse_direction(options.direction), request);
  } else if (!options.grid_only) {
    refine_peak_of(resolved, request);
  }
  return request;
}

}  // namespace

// Points that follow from their neighbours wait for them: neither threads nor shards can share such a sweep.
std::vector<std::string> problems(const SweepOptions& options) {
  const ResultPlace place{options.output, options.resume};
  std::vector<std::string> found = problems(place, options.print);
  if (options.direction.empty()) return found;
  if (!options.shard.empty())
    found.emplace_back(
        "--continue: found with --shard; required: one of both, since a path of points cannot be divided");
  if (options.jobs > 1)
    found.push_back("--continue: found with --jobs " + std::to_string(options.jobs) +
                    "; required: --jobs 1 or none, since each point waits for its neighbour");
  return found;
}

int execute(const SweepOptions& options) {
  const ResolvedCase stated = case_of(options.stated);
  const std::string fidelity = fidelity_or_default(options.fidelity);
  require_computable(stated, fidelity, true);
  auto [resolved, request] = plan_sweep(
      stated,
      {.budget = options.budget, .fidelity = fidelity, .jobs = options.jobs, .quiet = options.print.quiet},
      [&](const ResolvedCase& in) { return request_of(in, options); });
  put_execution({options.output, options.resume}, options.jobs, options.print, request);
  return present_sweep(resolved, run_sweep(request), options.print);
}

}  // namespace orbearing::app
