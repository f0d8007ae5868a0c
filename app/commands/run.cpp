#include "app/commands/run.hpp"

#include "app/commands/kept_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/motion_budget.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

std::vector<std::string> problems(const RunOptions& options) {
  if (!options.gears || options.fidelity.empty()) return {};
  return {"--fidelity: found " + options.fidelity +
          "; required: none together with --gears, which runs the gears only"};
}

int execute(const RunOptions& options) {
  const ResolvedCase resolved = point_of(options.stated);
  const ResultPlace place{options.output, options.resume};
  const Analysis* analysis = options.gears ? &gears_alone() : analysis_of(resolved, options.fidelity);
  if (analysis != nullptr && !options.budget.empty()) refuse_budget(resolved, options.gears);
  if (analysis != nullptr) return run_analysis(resolved, place, options.print, *analysis);
  const std::string fidelity = fidelity_or_default(options.fidelity);
  require_computable(resolved, fidelity, false);
  auto [planned, request] =
      plan_sweep(resolved, {.budget = options.budget, .fidelity = fidelity, .quiet = options.print.quiet},
                 [&](const ResolvedCase& in) { return sweep_request(in, fidelity); });
  put_execution(place, 1, options.print, request);
  return present_sweep(planned, run_sweep(request), options.print);
}

}  // namespace orbearing::app
