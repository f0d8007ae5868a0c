#include "app/study/effects.hpp"

#include <fmt/format.h>

#include <span>

#include "app/case/catalogue_case.hpp"
#include "app/case/field_table.hpp"

namespace orbearing::app {

namespace {

// No cage is lighter than its range allows; this one's mass vanishes in the round-off of any load.
const std::vector<NamedChange>& changes_at_rest() {
  static const std::vector<NamedChange> list{
      {"all effects", "inertia", {}},
      {"no carrier centrifugal", "inertia", {"inertia.carrier_centrifugal=false"}},
      {"no Coriolis", "inertia", {"inertia.coriolis=false"}},
      {"no own orbit", "inertia", {"inertia.own_orbit=false"}},
      {"cage without mass", "inertia", {"bearing.cage.density=1e-30 kg/m3"}},
      {"clearance 0 um", "clearance", {"bearing.radial_clearance=0 um"}},
      {"clearance 10 um", "clearance", {"bearing.radial_clearance=10 um"}},
      {"clearance 37 um", "clearance", {"bearing.radial_clearance=37 um"}},
      {"film in the approach", "clearance", {"film.enabled=true"}},
  };
  return list;
}

// Each beside the waves that the case has.
const std::vector<NamedChange>& one_wave_more() {
  static const std::vector<NamedChange> list{
      {"oval bore, 5 um",
       "form",
       {"bearing.outer_race.out_of_roundness.order=[2]",
        "bearing.outer_race.out_of_roundness.amplitude=[5e-6 m]"}},
      {"oval pin, 5 um",
       "form",
       {"bearing.inner_race.out_of_roundness.order=[2]",
        "bearing.inner_race.out_of_roundness.amplitude=[5e-6 m]"}},
      {"11 waves on the bore, 0.5 um",
       "form",
       {"bearing.outer_race.waviness.order=[11]", "bearing.outer_race.waviness.amplitude=[0.5e-6 m]"}},
  };
  return list;
}

// An effect that the case has is left out, one that it lacks is added.
struct Effect {
  const char* group;
  const char* path;
  const char* on;          // value where the case has the effect
  const char* added;       // what the change is called where the case has it not; empty: it is not asked
  const char* off;         // value without it
  const char* left_out;    // what the change is called where the case has it; empty: it is not asked
  const char* needs = "";  // flag without which the case has it not, whatever the path says
};

constexpr const char* kGears = "gears";

constexpr Effect kChief[] = {
    {"inertia", "inertia.coriolis", "true", "Coriolis", "false", "no Coriolis"},
    {"inertia", "inertia.carrier_centrifugal", "true", "carrier centrifugal", "false",
     "no carrier centrifugal"},
    {"inertia", "inertia.own_orbit", "true", "own orbit", "false", "no own orbit"},
    {kGears, "gearset.mesh_variation", "true", "", "false", "constant mesh stiffness"},
    {"oil", "film.enabled", "true", "film in the approach", "false", "no film in the approach"},
    {"oil", "traction.law", "limiting-shear", "limiting-shear traction", "regularised-coulomb",
     "Coulomb traction"},
};

constexpr Effect kOil[] = {
    {"oil", "traction.rolling_resistance", "true", "rolling resistance", "false", "no rolling resistance"},
    {"oil", "traction.rolling_law", "reynolds", "rolling resistance computed", "goksem-hargreaves",
     "rolling resistance by regression", "traction.rolling_resistance"},
    {"oil", "drag.enabled", "true", "oil drag", "false", "no oil drag"},
    {"oil", "contact.squeeze", "true", "squeeze of the films", "false", "no squeeze of the films"},
    {"oil", "contact.lubrication", "mixed", "mixed lubrication", "full", "no mixed lubrication"},
    {"oil", "bearing.cage.pocket_film", "hydrodynamic", "film in the pockets", "none",
     "no film in the pockets"},
};

// What the source prints and the default replaces.
constexpr Effect kAsPublished[] = {
    {"as printed", "film.approach", "as-printed", "film subtracted, as printed", "added", "", "film.enabled"},
    {"as printed", "contact.damping_law", "as-printed", "damping as printed", "approach-speed", ""},
    {"as printed", "bearing.cage.guidance_film", "as-printed", "guidance film as printed", "short-bearing",
     ""},
    {"as printed", "bearing.cage.reference_speed", "as-printed", "cage speed as printed", "rolling", ""},
};

bool is_of_missing_cage(const ResolvedCase& in, std::string_view setting) {
  return setting.starts_with("bearing.cage.") && is_full_complement(in);
}

bool has_value(const ResolvedCase& in, const char* path, const std::string& value) {
  return find_field(path)->kind == Kind::flag ? in.flag(path) == (value == "true") : in.choice(path) == value;
}

void add_effects(const ResolvedCase& in, std::span<const Effect> effects, std::vector<NamedChange>& list) {
  for (const Effect& effect : effects) {
    if (is_of_missing_cage(in, effect.path)) continue;
    const std::string needs = effect.needs;
    const bool has = has_value(in, effect.path, effect.on) && (needs.empty() || in.flag(needs));
    const std::string name = has ? effect.left_out : effect.added;
    if (name.empty()) continue;
    list.push_back({name, effect.group, {std::string(effect.path) + "=" + (has ? effect.off : effect.on)}});
    if (!needs.empty()) list.back().settings.push_back(needs + "=true");
  }
}

// The cage on the land of the other ring, with the clearance it has.
void add_guidance(const ResolvedCase& in, std::vector<NamedChange>& list) {
  const std::string land = "bearing.cage.guide_land_diameter", guidance = "bearing.cage.guidance=";
  if (is_full_complement(in)) {
    list.push_back({"no friction between rollers", "cage", {"bearing.neighbour_friction=0"}});
    return;
  }
  if (!in.has(land)) return;
  const double inner = in.quantity("bearing.cage.inner_diameter");
  const double outer = in.quantity("bearing.cage.outer_diameter");
  const double now = in.quantity(land);
  if (in.choice("bearing.cage.guidance") == "outer")
    list.push_back({"cage on the inner ring",
                    "cage",
                    {guidance + "inner", fmt::format("{}={} m", land, inner - (now - outer))}});
  else
    list.push_back({"cage on the outer ring",
                    "cage",
                    {guidance + "outer", fmt::format("{}={} m", land, outer + (inner - now))}});
}

void add_forms(const ResolvedCase& in, std::vector<NamedChange>& list) {
  for (NamedChange change : one_wave_more()) {
    const std::string& order = change.settings.front();
    const std::string phase = order.substr(0, order.find("order=")) + "phase";
    if (in.has(phase)) change.settings.push_back(phase + "=[0 deg]");
    for (std::string& setting : change.settings) {
      const std::size_t equals = setting.find('=');
      if (const std::string path = setting.substr(0, equals); in.has(path)) {
        std::string own = in.given(path);  // "[1 um, 2 um]"
        own.pop_back();
        setting.replace(equals + 1, 1, own + ", ");
      }
    }
    list.push_back(std::move(change));
  }
}

void add_larger_roller(const ResolvedCase& in, std::vector<NamedChange>& list) {
  const std::string path = "bearing.roller_diameter_deviation";
  std::string text = fmt::format("{}=[", path);
  std::vector<double> deviations = in.has(path) ? in.list(path) : std::vector<double>{};
  if (deviations.empty()) deviations.resize(1);
  deviations.front() += 2e-6;
  for (const double deviation : deviations) text += fmt::format("{} m, ", deviation);
  text.replace(text.size() - 2, 2, "]");
  list.push_back({"one roller 2 um larger", "form", {text}});
}

// Of the set that is looked at, as changes of the whole case.
std::vector<NamedChange> placed(const ResolvedCase& resolved, const std::string& set,
                                const std::vector<NamedChange>& list) {
  std::vector<NamedChange> all;
  for (NamedChange change : list) {
    if (!set.empty() && change.group == kGears) continue;  // several sets give mean forces
    for (std::string& setting : change.settings)
      if (!set.empty() && in_each_set(*find_field(setting.substr(0, setting.find('=')))))
        setting.insert(0, set_prefix(set));
    if (fits(resolved, change)) all.push_back(std::move(change));
  }
  return all;
}

}  // namespace

std::vector<NamedChange> effects_at_rest(const ResolvedCase& resolved, const std::string& set) {
  std::vector<NamedChange> list = changes_at_rest();
  const ResolvedCase in = set.empty() ? resolved : resolved.of_set(set);
  std::erase_if(list, [&](const NamedChange& change) {
    return !change.settings.empty() && is_of_missing_cage(in, change.settings.front());
  });
  return placed(resolved, set, list);
}

std::vector<NamedChange> effects_in_motion(const ResolvedCase& resolved, bool every, const std::string& set) {
  const ResolvedCase in = set.empty() ? resolved : resolved.of_set(set);
  std::vector<NamedChange> list{{"all effects", "reference", {}}};
  add_effects(in, kChief, list);
  if (every) {
    add_effects(in, kOil, list);
    add_guidance(in, list);
    add_forms(in, list);
    add_larger_roller(in, list);
    add_effects(in, kAsPublished, list);
  }
  return placed(resolved, set, list);
}

}  // namespace orbearing::app
