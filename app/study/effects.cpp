#include "app/study/effects.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

#include "app/case/field_table.hpp"

namespace orbearing::app {

namespace {

constexpr const char* kAllEffects = "all effects";

struct FixedChange {
  const char* name;
  const char* group;
  const char* path;
  const char* value;
};

// No cage is lighter than its range allows; this one's mass vanishes in the round-off of any load.
constexpr FixedChange kAtRest[] = {
    {"no carrier centrifugal", "inertia", "inertia.carrier_centrifugal", "false"},
    {"no Coriolis", "inertia", "inertia.coriolis", "false"},
    {"no own orbit", "inertia", "inertia.own_orbit", "false"},
    {"cage without mass", "inertia", "bearing.cage.density", "1e-30 kg/m3"},
    {"clearance 0 um", "clearance", "bearing.radial_clearance", "0 um"},
    {"clearance 10 um", "clearance", "bearing.radial_clearance", "10 um"},
    {"clearance 37 um", "clearance", "bearing.radial_clearance", "37 um"},
    {"film in the approach", "clearance", "film.enabled", "true"},
};

struct Effect {
  const char* group;
  const char* path;
  const char* on;          // value where the case has the effect
  const char* added;       // what the change is called where the case has it not; empty: it is not asked
  const char* off;         // value without it
  const char* left_out;    // what the change is called where the case has it; empty: it is not asked
  const char* needs = "";  // flag without which the case has it not, whatever the path says
};

constexpr Effect kChief[] = {
    {"inertia", "inertia.coriolis", "true", "Coriolis", "false", "no Coriolis"},
    {"inertia", "inertia.carrier_centrifugal", "true", "carrier centrifugal", "false",
     "no carrier centrifugal"},
    {"inertia", "inertia.own_orbit", "true", "own orbit", "false", "no own orbit"},
    {"gears", "gearset.mesh_variation", "true", "", "false", "constant mesh stiffness"},
    {"oil", "film.enabled", "true", "film in the approach", "false", "no film in the approach"},
    {"oil", "traction.law", "limiting-shear", "limiting-shear traction", "regularised-coulomb",
     "Coulomb traction"},
};

constexpr Effect kOil[] = {
    {"oil", "traction.rolling_resistance", "true", "rolling resistance", "false", "no rolling resistance"},
    {"oil", "drag.enabled", "true", "oil drag", "false", "no oil drag"},
    {"oil", "contact.lubrication", "mixed", "mixed lubrication", "full", "no mixed lubrication"},
    {"oil", "bearing.cage.pocket_film", "hydrodynamic", "film in the pockets", "none",
     "no film in the pockets"},
};

// What the source prints and the default replaces.
constexpr Effect kAsPrinted[] = {
    {"as printed", "film.approach", "as-printed", "film subtracted, as printed", "added", "", "film.enabled"},
    {"as printed", "contact.damping_law", "as-printed", "damping as printed", "approach-speed", ""},
    {"as printed", "bearing.cage.guidance_film", "as-printed", "guidance film as printed", "short-bearing",
     ""},
    {"as printed", "bearing.cage.reference_speed", "as-printed", "cage speed as printed", "rolling", ""},
};

struct Wave {
  const char* name;
  const char* block;
  int order;
  double amplitude;  // [m]
};

constexpr Wave kWaves[] = {
    {"oval bore, 5 um", "bearing.outer_race.standing_form", 2, 5e-6},
    {"oval pin, 5 um", "bearing.inner_race.standing_form", 2, 5e-6},
    {"11 waves on the bore, 0.5 um", "bearing.outer_race.turning_form", 11, 0.5e-6},
};

// Changes of one set's bearing, collected.
class Changes {
 public:
  Changes(const ResolvedCase& resolved, const std::string& set, const char* group_of_reference)
      : resolved_(resolved), of_set_(set.empty() ? resolved : resolved.of_set(set)), set_(set) {
    list_.push_back({kAllEffects, group_of_reference, {}});
  }

  const ResolvedCase& of_set() const { return of_set_; }

  void add(const char* name, const char* group, const std::vector<Setting>& settings) {
    NamedChange change{name, group, {}};
    for (const auto& [path, value] : settings) change.settings.push_back(placed(path) + "=" + value);
    if (fits(resolved_, change)) list_.push_back(std::move(change));
  }

  void add(std::span<const Effect> effects) {
    for (const Effect& effect : effects) {
      if (!set_.empty() && std::string(effect.group) == "gears") continue;  // several sets give mean forces
      const bool needs = *effect.needs != '\0';
      const bool has = holds(effect.path, effect.on) && (!needs || of_set_.flag(effect.needs));
      const char* name = has ? effect.left_out : effect.added;
      if (*name == '\0') continue;
      std::vector<Setting> settings{{effect.path, has ? effect.off : effect.on}};
      if (needs) settings.emplace_back(effect.needs, "true");
      add(name, effect.group, settings);
    }
  }

  std::vector<NamedChange> list() && { return std::move(list_); }

 private:
  std::string placed(const std::string& path) const {
    return set_.empty() || !in_each_set(*find_field(path)) ? path : set_prefix(set_) + path;
  }

  bool holds(const char* path, const std::string& value) const {
    return find_field(path)->kind == Kind::flag ? of_set_.flag(path) == (value == "true")
                                                : of_set_.choice(path) == value;
  }

  const ResolvedCase& resolved_;
  ResolvedCase of_set_;
  const std::string& set_;
  std::vector<NamedChange> list_;
};

std::vector<double> list_of(const ResolvedCase& in, const std::string& path) {
  return in.has(path) ? in.list(path) : std::vector<double>{};
}

std::string list_text(const std::vector<double>& values, const char* unit) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(fmt::format("{}{}", value, unit));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

// The cage on the land of the other ring, with the clearance it has.
void add_guidance(Changes& changes) {
  const ResolvedCase& in = changes.of_set();
  const std::string land = "bearing.cage.guide_land_diameter";
  if (!in.has(land)) return;
  const bool outer = in.choice("bearing.cage.guidance") == "outer";
  const double inner_diameter = in.quantity("bearing.cage.inner_diameter");
  const double outer_diameter = in.quantity("bearing.cage.outer_diameter");
  const double clearance = outer ? in.quantity(land) - outer_diameter : inner_diameter - in.quantity(land);
  const double other = outer ? inner_diameter - clearance : outer_diameter + clearance;  // [m]
  changes.add(outer ? "cage on the inner ring" : "cage on the outer ring", "cage",
              {{"bearing.cage.guidance", outer ? "inner" : "outer"}, {land, fmt::format("{} m", other)}});
}

// One wave more, or a larger first roller, beside those that the case has.
void add_forms(Changes& changes) {
  const ResolvedCase& in = changes.of_set();
  for (const Wave& wave : kWaves) {
    const std::string block = wave.block, phase = block + ".phase";
    std::vector<double> orders = list_of(in, block + ".order"),
                        amplitudes = list_of(in, block + ".amplitude");
    orders.push_back(wave.order);
    amplitudes.push_back(wave.amplitude);
    std::vector<Setting> settings{{block + ".order", list_text(orders, "")},
                                  {block + ".amplitude", list_text(amplitudes, " m")}};
    if (in.has(phase)) {
      std::vector<double> phases = in.list(phase);
      phases.push_back(0.0);
      settings.emplace_back(phase, list_text(phases, " rad"));
    }
    changes.add(wave.name, "form", settings);
  }
  const std::string path = "bearing.roller_diameter_deviation";
  std::vector<double> deviations = list_of(in, path);
  if (deviations.empty()) deviations.resize(1);
  deviations.front() += 2e-6;
  changes.add("one roller 2 um larger", "form", {{path, list_text(deviations, " m")}});
}

}  // namespace

std::vector<NamedChange> effects_at_rest(const ResolvedCase& resolved, const std::string& set) {
  Changes changes(resolved, set, "inertia");
  for (const FixedChange& change : kAtRest)
    changes.add(change.name, change.group, {{change.path, change.value}});
  return std::move(changes).list();
}

std::vector<NamedChange> effects_in_motion(const ResolvedCase& resolved, bool every, const std::string& set) {
  Changes changes(resolved, set, "reference");
  changes.add(kChief);
  if (every) {
    changes.add(kOil);
    add_guidance(changes);
    add_forms(changes);
    changes.add(kAsPrinted);
  }
  return std::move(changes).list();
}

}  // namespace orbearing::app
