#include "app/case/use_conditions.hpp"

#include <algorithm>

#include "app/case/bearing_type.hpp"
#include "app/case/drivetrain_reader.hpp"
#include "coupling/analysis/drivetrain_conditions.hpp"
#include "mechanics/member_keys.hpp"

namespace orbearing::app {

namespace {

using analysis::StatedDrivetrain;
using analysis::StatedSet;

// Whether it holds for that set; where none is named, for one of them.
template <class Holds>
bool holds_for(const ResolvedCase& in, std::string_view prefix, const Holds& holds) {
  if (in.model() != planetary_drivetrain) return false;
  return std::ranges::any_of(stated_drivetrain(in).sets, [&](const auto& one) {
    return (prefix.empty() || set_prefix(one.name) == prefix) && holds(one.set);
  });
}

std::string name_of(const ResolvedCase& in, std::string_view prefix) {
  for (const std::string& set : in.shape().sets)
    if (set_prefix(set) == prefix) return set;
  return "";
}

// A value that no default has.
template <class Member>
bool states(const ResolvedCase& in, std::string_view prefix, const Member& member) {
  const std::string key = mechanics::key_of<StatedSet>(member);
  return is_stated(in, std::string(prefix) + key) || is_stated(in, key);
}

}  // namespace

bool planets_tilt(const ResolvedCase& in, std::string_view set) {
  return holds_for(in, set, analysis::planets_tilt);
}
bool bearings_tilt(const ResolvedCase& in, std::string_view set) {
  return holds_for(in, set, analysis::bearings_tilt);
}
bool pin_links_rows(const ResolvedCase& in, std::string_view set) {
  return holds_for(in, set, analysis::pin_links_rows);
}

bool carrier_rotates(const ResolvedCase& in, std::string_view set) {
  return in.model() == planetary_drivetrain &&
         analysis::carrier_rotates(stated_drivetrain(in), name_of(in, set));
}
bool carrier_pulls(const ResolvedCase& in, std::string_view set) {
  return carrier_rotates(in, set) && holds_for(in, set, [](const StatedSet& of) {
           return of.planets.dynamics.inertia.carrier_centrifugal;
         });
}
bool planet_counts_at_rest(const ResolvedCase& in, std::string_view set) {
  return carrier_pulls(in, set) || holds_for(in, set, analysis::planet_counts_without_mass);
}

bool carrier_is_body(const ResolvedCase& in, std::string_view) {
  return in.model() == planetary_drivetrain && analysis::carrier_is_body(stated_drivetrain(in));
}

bool bearings_make_springs(const ResolvedCase& in, std::string_view set) {
  return holds_for(in, set, analysis::bearings_make_springs);
}
bool loads_make_springs(const ResolvedCase& in, std::string_view set) {
  return holds_for(in, set, analysis::loads_make_springs);
}
bool teeth_make_meshes(const ResolvedCase& in, std::string_view set) {
  return holds_for(in, set, analysis::teeth_make_meshes);
}

bool material_makes_springs(const ResolvedCase& in, std::string_view set) {
  return holds_for(in, set, [&](const StatedSet& of) {
    const bool pins = !states(
        in, set, [](const auto& m) -> const auto& { return m.planets.dynamics.support.stiffness; });
    return analysis::teeth_make_meshes(of) || of.planets.rim == analysis::PlanetRim::elastic ||
           (analysis::bearings_make_springs(of) && (pins || of.planets.dynamics.race.film_in_approach));
  });
}

bool modulus_makes_springs(const ResolvedCase& in, std::string_view set) {
  if (material_makes_springs(in, set)) return true;
  return holds_for(in, set, [&](const StatedSet& of) {
    return of.has_teeth() &&
           !(states(
                 in, set,
                 [](const auto& m) -> const auto& { return m.gears.choice.sun.support_stiffness; }) &&
             states(
                 in, set,
                 [](const auto& m) -> const auto& { return m.gears.choice.ring.support_stiffness; }) &&
             states(
                 in, set,
                 [](const auto& m) -> const auto& { return m.gears.choice.carrier.support_stiffness; }));
  });
}

bool fits_are_warm(const ResolvedCase& in, std::string_view set) {
  return holds_for(in, set, analysis::fits_are_warm);
}

bool planets_have_rollers(const ResolvedCase& in, std::string_view set) {
  return in.model() != planetary_drivetrain ||
         holds_for(in, set, [](const StatedSet& of) { return !of.has_balls(); });
}

bool resonances_are_named(const ResolvedCase& in, std::string_view) {
  return in.model() == planetary_drivetrain && analysis::resonances_are_named(stated_drivetrain(in));
}
bool is_one_system(const ResolvedCase& in, std::string_view) {
  return in.model() == planetary_drivetrain && analysis::is_one_system(stated_drivetrain(in));
}
bool pin_is_race(const ResolvedCase& in, std::string_view set) {
  return holds_for(in, set, analysis::pin_is_race);
}
bool speed_is_steady(const ResolvedCase& in, std::string_view set) {
  return holds_for(in, set, analysis::speed_is_steady);
}
bool gears_run_up(const ResolvedCase& in, std::string_view set) {
  return holds_for(in, set, analysis::gears_run_up);
}

}  // namespace orbearing::app
