#include "app/commands/kept_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/motion_budget.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

int run_command(const Options& options) {
  const ResolvedCase resolved = point_of(options);
  const std::string fidelity = options.fidelity_given ? options.fidelity : "";
  if (options.gears && !fidelity.empty())
    throw BadInput("--fidelity: found " + fidelity +
                   "; required: none together with --gears, which runs the gears only");
  const Analysis* analysis = options.gears ? &gears_alone() : analysis_of(resolved, fidelity);
  if (analysis != nullptr && options.budget) refuse_budget(resolved, options.gears);
  if (analysis != nullptr) return run_analysis(resolved, options, *analysis);
  require_computable(resolved, options.fidelity, false);
  auto [planned, request] = plan_sweep(
      resolved, options, [&](const ResolvedCase& in) { return sweep_request(in, options.fidelity); });
  put_options(options, request);
  request.jobs = 1;
  return present_sweep(planned, run_sweep(request), options);
}

}  // namespace orbearing::app
