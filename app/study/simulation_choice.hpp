// From the block `simulation` of a resolved case to the options of runs in time.
#pragma once

#include "app/case/resolved_case.hpp"
#include "coupling/cosim/coupled_run.hpp"
#include "coupling/integration/steady_state.hpp"

namespace orbearing::app {

/// How a run settles, how long it is observed and by which integrator it goes.
integration::SteadyStateOptions steady_state_of(const ResolvedCase& in);

/// How gears and bearings exchange where they are co-simulated.
cosim::CoupledOptions exchange_of(const ResolvedCase& in);

}  // namespace orbearing::app
