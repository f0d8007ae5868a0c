#include "app/study/fidelity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>

#include "app/case/input_keys.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"

namespace orbearing::app {

const std::vector<std::string>& fidelity_names() {
  static const std::vector<std::string> names{"quasi-static", "dynamic", "co-simulated", "monolithic"};
  return names;
}

analysis::Fidelity fidelity_of(const std::string& name) {
  const std::vector<std::string>& names = fidelity_names();  // in the order of the rungs
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    throw BadInput(fmt::format("fidelity: found '{}'; required: {}", name, fmt::join(names, ", ")));
  return static_cast<analysis::Fidelity>(found - names.begin());
}

namespace {

const std::string kAcceleration = keys().acceleration;

}  // namespace

void require_computable(const ResolvedCase& in, const std::string& fidelity, bool sweep) {
  if (in.model() != planetary_drivetrain || !in.has(kAcceleration)) return;  // gears alone have none
  if (is_coupled(fidelity_of(fidelity)) && in.shape().several)
    throw BadInput(in.file() +
                   ": sets: found several sets; required: one set, as gearset at the top of a case, for "
                   "--fidelity " +
                   fidelity);
  const auto swept = std::find_if(in.axes().begin(), in.axes().end(),
                                  [](const SweepAxis& axis) { return axis.path == kAcceleration; });
  if (sweep && swept != in.axes().end())
    throw_mistakes(in.file(), {{swept->location,
                                "sweep." + kAcceleration,
                                {"a sweep of a run-up", "steady points are required: no axis of it"}}});
  if (sweep && in.quantity(kAcceleration) != 0.0)
    throw BadInput(
        fmt::format("{}: {}: found {}; required: 0 rpm/s in a sweep, whose points are steady; a run-up is a "
                    "run with --fidelity dynamic",
                    in.origin(kAcceleration), kAcceleration, in.given(kAcceleration)));
  require_used(in, rung_of(in, fidelity), sweep ? Axes::all : Axes::none);
}

}  // namespace orbearing::app
