#include "app/study/drivetrain_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/case/arrangement_case.hpp"
#include "app/case/bearing_type.hpp"
#include "app/case/catalogue_case.hpp"
#include "app/case/described_case.hpp"
#include "app/case/machine_of.hpp"
#include "app/case/oil_case.hpp"
#include "app/case/profile_case.hpp"
#include "app/case/set_case.hpp"
#include "bearing/race_waves.hpp"
#include "coupling/analysis/drivetrain_warnings.hpp"
#include "coupling/analysis/planet_rating.hpp"

namespace orbearing::app {

namespace rating = bearing::rating;

study::PlanetaryDrivetrain drivetrain_without_gear_set(const ResolvedCase& in) {
  if (!has_planet_bearing(in)) return {.set = set_of(in), .drive = drive_of(in)};
  study::PlanetaryDrivetrain out = from_case<study::PlanetaryDrivetrain>(in);
  out.set = set_of(in);
  out.drive = drive_of(in);
  if (is_full_complement(in)) out.bearing.cage = {};  // what is stated of one has no effect
  out.rows.type = bearing_type_of(in);
  if (out.rows.has_balls())
    out.bearing.elements = bearing::Balls{out.rows.balls, out.rows.ball_diameter};
  else
    out.bearing.rollers().profile = roller_profile_of(in);
  const auto forms = machine_of<bearing::RaceForms>(in);
  out.bearing.inner.form = harmonics_of(forms.inner);
  out.bearing.outer.form = harmonics_of(forms.outer);
  out.uneven_planets = !uneven_planets_by(in).empty();
  out.rated = analysis::rated_bearing(machine_of<analysis::PlanetRating>(in), oil_density(in),
                                      out.dynamics.race.roughness);
  out.mounting.unmounted_clearance = out.bearing.radial_clearance;
  // Without inner ring the pin itself carries the race and moves with it, down to its hole; of a solid one a
  // hole of no account, since a bore is above 0.
  if (out.mounting.rings != bearing::Rings::both)
    out.bearing.inner.seat_diameter = std::max(out.mounting.pin_bore, 1e-3 * out.bearing.inner.seat_diameter);
  study::mount(out);
  return out;
}

std::vector<std::string> gear_warnings(const ResolvedCase& in) {
  std::vector<std::string> texts;
  if (in.shape().several) texts = analysis::idle_set_warnings(arrangement_of(in));
  if (!in.shape().teeth) return texts;
  const auto add = [&](const std::string& prefix, const ResolvedCase& set) {
    for (const gearset::Warning& warning :
         analysis::tooth_warnings(set_of(set), second_planet_of(set), stated_geometry(set)))
      texts.push_back(prefix + location_in_case(set, warning.key) + ": " + warning.text);
  };
  if (!in.shape().several) add("", in);
  for (const std::string& set : in.shape().sets) add(set_prefix(set), in.of_set(set));
  return texts;
}

namespace {

std::vector<gearset::PlanetarySet> stated_teeth(const ResolvedCase& in) {
  if (!in.shape().several) return {stated_set(in)};
  std::vector<gearset::PlanetarySet> sets;
  for (const std::string& set : in.shape().sets) sets.push_back(stated_set(in.of_set(set)));
  return sets;
}

}  // namespace

bool is_helical(const ResolvedCase& in) {
  return std::ranges::any_of(stated_teeth(in), [](const auto& set) { return set.helix_angle != 0.0; });
}

std::vector<std::string> planar_warnings(const ResolvedCase& in) {
  return is_helical(in) ? analysis::planar_warnings() : std::vector<std::string>{};
}

std::optional<rating::StatedOil> stated_oil(const ResolvedCase& in) {
  return analysis::stated_oil(machine_of<analysis::LifeInputs>(in), machine_of<analysis::BearingOil>(in),
                              oil_density(in));
}

std::vector<std::string> rating_warnings(const ResolvedCase& in) {
  std::vector<std::string> warnings;
  if (analysis::cleanliness_is_assumed(machine_of<analysis::LifeInputs>(in),
                                       machine_of<analysis::BearingOil>(in)))
    warnings.emplace_back(
        "life.cleanliness: not given with the oil; 'high' (-/15/12 of ISO 4406) is taken for a_ISO");
  const std::string governing = governing_life_key(in);
  if (in.has("requirements.life_key") && in.choice("requirements.life_key") != governing)
    warnings.push_back(
        fmt::format("requirements.life_key: {} is judged; the governing life of this case is {} "
                    "(life.method: {})",
                    in.choice("requirements.life_key"), governing, in.choice("life.method")));
  return warnings;
}

rating::LifeMethod life_method(const ResolvedCase& in) {
  return machine_of<analysis::LifeInputs>(in).method;
}

rating::Life governing_life(const ResolvedCase& in) {
  return rating::governing_life(life_method(in), stated_oil(in).has_value());
}

std::string governing_life_key(const ResolvedCase& in) {
  return rating::hours_key(governing_life(in));
}

}  // namespace orbearing::app
