#include "app/study/refinements.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "app/study/fidelity.hpp"

namespace orbearing::app {

namespace {

void add_waves(const ResolvedCase& in, const std::string& block, bool turning,
               std::vector<bearing::RaceHarmonic>& form) {
  if (!in.has(block + ".order")) return;
  const std::vector<double>& order = in.list(block + ".order");
  const std::vector<double>& amplitude = in.list(block + ".amplitude");
  const std::string phase = block + ".phase";
  for (std::size_t i = 0; i < order.size(); ++i)
    form.push_back({.order = static_cast<int>(std::lround(order[i])),
                    .amplitude = amplitude[i],
                    .phase = in.has(phase) ? in.list(phase)[i] : 0.0,
                    .turning = turning});
}

std::vector<bearing::RaceHarmonic> form_of(const ResolvedCase& in, const std::string& race) {
  std::vector<bearing::RaceHarmonic> form;
  add_waves(in, race + ".standing_form", false, form);
  add_waves(in, race + ".turning_form", true, form);
  return form;
}

bool printed(const ResolvedCase& in, const char* path) {
  return in.choice(path) == "as-printed";
}

void add_lubrication(const ResolvedCase& in, bearing::dynamics::DynamicsParameters& out) {
  using namespace bearing::dynamics;
  out.race.lubrication = in.choice("contact.lubrication") == "mixed" ? Lubrication::mixed : Lubrication::full;
  out.race.roughness = in.quantity("contact.roughness");
  out.race.boundary_friction = in.number("contact.boundary_friction");
  out.race.damping_law =
      printed(in, "contact.damping_law") ? DampingLaw::as_printed : DampingLaw::approach_speed;
  out.cage.pocket_film =
      in.choice("bearing.cage.pocket_film") == "hydrodynamic" ? PocketFilm::hydrodynamic : PocketFilm::none;
  out.cage.pocket_roughness = in.quantity("bearing.cage.pocket_roughness");
  out.cage.reference_speed =
      printed(in, "bearing.cage.reference_speed") ? ReferenceSpeed::as_printed : ReferenceSpeed::rolling;
}

study::Misalignment misalignment_of(const ResolvedCase& in) {
  const auto angle = [&](const char* path) { return in.has(path) ? in.quantity(path) : 0.0; };
  return {.planet_tilt = angle("bearing.misalignment.planet_tilt"),
          .carrier_wind_up = angle("bearing.misalignment.carrier_wind_up")};
}

const std::string kAcceleration = "input.acceleration";

[[noreturn]] void refuse(const ResolvedCase& in, const std::string& path, const std::string& found,
                         const std::string& required) {
  throw BadInput(fmt::format("{}: {}: found {}; required: {}", in.origin(path), path, found, required));
}

bool runs_up(const ResolvedCase& in) {
  return in.quantity(kAcceleration) != 0.0;
}

}  // namespace

void add_refinements(const ResolvedCase& in, study::PlanetaryDrivetrain& drivetrain) {
  drivetrain.bearing.inner_form = form_of(in, "bearing.inner_race");
  drivetrain.bearing.outer_form = form_of(in, "bearing.outer_race");
  if (in.has("bearing.roller_diameter_deviation"))
    drivetrain.bearing.roller_diameter_deviation = in.list("bearing.roller_diameter_deviation");
  drivetrain.film_approach =
      printed(in, "film.approach") ? bearing::FilmApproach::as_printed : bearing::FilmApproach::added;
  drivetrain.run_up = {.acceleration = in.quantity(kAcceleration),
                       .duration = in.quantity("simulation.run_up_time")};
  drivetrain.misalignment = misalignment_of(in);
  add_lubrication(in, drivetrain.dynamics);
}

namespace {

// Gears and bearings that act on each other: one set with teeth.
void require_two_way(const ResolvedCase& in, const std::string& fidelity) {
  if (in.shape().several)
    throw BadInput(in.file() +
                   ": sets: found several sets; required: one set, as gearset at the top of a case, for "
                   "--fidelity " +
                   fidelity);
}

}  // namespace

void require_computable(const ResolvedCase& in, const std::string& fidelity, bool sweep) {
  if (in.model() != planetary_drivetrain || !in.has(kAcceleration)) return;  // gears alone have none
  if (two_way(fidelity_of(fidelity))) require_two_way(in, fidelity);
  const bool swept = std::any_of(in.axes().begin(), in.axes().end(),
                                 [](const SweepAxis& axis) { return axis.path == kAcceleration; });
  if (sweep && (swept || runs_up(in)))
    refuse(in, kAcceleration, swept ? "a sweep of it" : in.given(kAcceleration),
           "0 rpm/s in a sweep, whose points are steady; a run-up is a run with --fidelity dynamic");
  require_used(in, rung_of(in, fidelity), sweep ? Axes::all : Axes::none);
}

}  // namespace orbearing::app
