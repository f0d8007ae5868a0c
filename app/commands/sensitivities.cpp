#include "app/case/spectrum_case.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/lone_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/study/life_derivatives_output.hpp"
#include "app/study/static_study.hpp"

namespace orbearing::app {

int sensitivities_command(const Options& options) {
  if (options.resume && options.output.empty())
    throw BadInput("--resume: found without --output; required: the folder to go on with");
  const ResolvedCase resolved = point_of(options);
  const LifeDerivatives derivatives = life_derivatives(resolved);
  std::vector<std::string> warnings =
      require_used(resolved, is_static_bearing(resolved) ? use::static_load : use::quasi_static);
  for (std::string& text : spectrum_warnings(resolved, "sensitivities")) warnings.push_back(std::move(text));
  const LoneAnalysis analysis{"sensitivities", "sensitivities of a life", "sensitivities.json"};
  return run_alone(resolved, options, analysis, [&]() -> LoneResult {
    return {.json = derivatives_json(derivatives),
            .text = derivatives_text(derivatives),
            .content = derivatives_content(derivatives),
            .warnings = warnings,
            .files = {{"sensitivities.csv", derivatives_csv(derivatives)}}};
  });
}

}  // namespace orbearing::app
