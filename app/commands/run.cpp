#include <fmt/core.h>

#include "app/case/defect_case.hpp"
#include "app/commands/lone_runs.hpp"
#include "app/commands/presentation.hpp"
#include "app/study/ball_study.hpp"
#include "app/study/computable.hpp"
#include "app/study/defect_study.hpp"
#include "app/study/duplex_study.hpp"
#include "app/study/film_study.hpp"
#include "app/study/planet_defect.hpp"
#include "app/study/static_study.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

int run_command(const Options& options) {
  require_place_of_results(options);
  const ResolvedCase resolved = point_of(options);
  if (is_static_bearing(resolved) && !options.gears) return run_static_case(resolved, options);
  if (is_ball_run(resolved) && !options.gears) return run_ball_case(resolved, options);
  if (is_defect(resolved) && !options.gears) return run_defect_case(resolved, options);
  if (is_duplex(resolved) && !options.gears) return run_duplex_case(resolved, options);
  if (is_spin_film(resolved) && !options.gears) return run_film_case(resolved, options);
  if (is_planet_defect(resolved) && !options.gears) return run_planet_defect_case(resolved, options);
  if (options.gears || runs_gears_alone(resolved)) return run_gear_case(resolved, options);
  require_computable(resolved, options.fidelity, false);
  SweepRequest request = sweep_request(resolved, options.fidelity);
  request.folder = options.output;
  request.jobs = 1;
  request.resume = options.resume;
  request.quiet = options.quiet;
  return present_sweep(resolved, run_sweep(request), options);
}

}  // namespace orbearing::app
