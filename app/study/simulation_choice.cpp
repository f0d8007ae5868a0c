#include "app/study/simulation_choice.hpp"

namespace orbearing::app {

integration::SteadyStateOptions steady_state_of(const ResolvedCase& in) {
  integration::SteadyStateOptions out;
  out.observed_windows = in.integer("simulation.observed_revolutions");
  out.most_windows = in.integer("simulation.most_revolutions");
  out.load_drift = in.number("simulation.load_drift");
  out.cage_drift = in.number("simulation.cage_drift");
  out.allowed_length_error = in.quantity("simulation.length_error");
  out.integration.method = in.choice("simulation.integrator") == "dopri5"
                               ? integration::Method::dopri5
                               : integration::Method::linearly_implicit;
  return out;
}

cosim::CoupledOptions exchange_of(const ResolvedCase& in) {
  const bool jacobi = in.choice("simulation.exchange.order") == "jacobi";
  return {.order = jacobi ? cosim::ExchangeOrder::jacobi : cosim::ExchangeOrder::gauss_seidel,
          .extrapolation = in.integer("simulation.exchange.extrapolation"),
          .iteration = {.most_passes = in.integer("simulation.exchange.passes")},
          .window = {.longest = in.quantity("simulation.exchange.window")}};
}

}  // namespace orbearing::app
