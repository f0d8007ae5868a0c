#include "app/case/field_use.hpp"

#include <algorithm>
#include <initializer_list>

namespace orbearing::app {

Use with_planet_defect(const Use& use, std::string_view path) {
  Use more = use;
  const auto is_one_of = [&](std::initializer_list<std::string_view> parts) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](std::string_view part) { return path.starts_with(part); });
  };
  if (is_one_of({"defect.", "signal."})) return more;
  unsigned* const statuses[] = {&more.by, &more.not_modelled_by, &more.refused_by};
  for (unsigned* status : statuses) *status &= ~unsigned{use::planet_defect};
  if (is_one_of({"life.", "spectrum", "lubricant.kinematic", "simulation.observed", "simulation.most_rev",
                 "simulation.load_drift", "simulation.cage_drift", "bearing.fatigue_load_limit",
                 "bearing.neighbour_friction"})) {  // of bearings without a cage, which is refused
    more.not_modelled_by |= use::planet_defect;
    return more;
  }
  for (unsigned* status : statuses)
    if ((*status & use::monolithic) != 0) *status |= use::planet_defect;
  const auto is_to_a_life = [](const Condition& condition) {
    return std::any_of(condition.paths.begin(), condition.paths.end(),
                       [](const std::string& other) { return other.starts_with("life."); });
  };
  for (Way& way : more.ways)
    if ((way.by & use::monolithic) != 0 &&
        std::none_of(way.conditions.begin(), way.conditions.end(), is_to_a_life))
      way.by |= use::planet_defect;
  return more;
}

Condition where(std::string path, std::vector<std::string> values) {
  return {.paths = {std::move(path)}, .values = std::move(values)};
}

Condition where_given(std::vector<std::string> paths) {
  return {.paths = std::move(paths)};
}

Condition where_absent(std::string path) {
  return {.paths = {std::move(path)}, .absent = true};
}

Condition where_planets_carry_unlike_loads() {
  return where_given({"gearset.dynamics.pin_error.radial", "gearset.dynamics.pin_error.tangential",
                      "gearset.planet_angles"});
}

Condition where_true(bool (*holds)(const ResolvedCase&, std::string_view), std::string text) {
  return {.paths = {}, .holds = holds, .text = std::move(text)};
}

Use Use::when(Condition condition) const {
  Use more = *this;
  for (Way& way : more.ways) way.conditions.push_back(condition);
  more.conditions.push_back(std::move(condition));
  return more;
}

Use Use::used_too(unsigned analyses, std::vector<Condition> all) const {
  Use more = *this;
  more.ways.push_back({analyses, std::move(all)});
  return more;
}

Use Use::used_too(unsigned analyses, Condition condition) const {
  return used_too(analyses, std::vector<Condition>{std::move(condition)});
}

Use Use::used_only(unsigned analyses, std::vector<Condition> all) const {
  Use more = used_too(analyses & by, std::move(all));
  more.by &= ~analyses;
  more.not_modelled_by |= by & analyses;
  return more;
}

Use Use::limited(unsigned analyses, const std::vector<Condition>& either) const {
  Use more = *this;
  more.by &= ~analyses;
  more.not_modelled_by |= by & analyses;
  more.ways.clear();
  std::vector<Way> limited = ways;
  if ((by & analyses) != 0) limited.push_back({by & analyses, {}});
  for (const Way& way : limited) {
    if ((way.by & ~analyses) != 0) more.ways.push_back({way.by & ~analyses, way.conditions});
    if ((way.by & analyses) == 0) continue;
    for (const Condition& condition : either) {
      more.ways.push_back({way.by & analyses, way.conditions});
      more.ways.back().conditions.push_back(condition);
    }
  }
  return more;
}

const std::vector<use::Analysis>& analyses() {
  static const std::vector<use::Analysis> every{
      use::quasi_static,  use::dynamic,         use::dynamic_of_sets, use::co_simulated,   use::monolithic,
      use::crown,         use::gears,           use::modes,           use::modes_at_speed, use::mesh,
      use::fmu_bearing,   use::fmu_gearset,     use::static_load,     use::ball_run,       use::defect,
      use::moving_defect, use::planet_defect,   use::duplex_modes,    use::duplex_run,     use::spin_film,
      use::stiffness,     use::planet_stiffness};
  return every;
}

std::string analysis_name(use::Analysis analysis) {
  switch (analysis) {
    case use::quasi_static:
      return "--fidelity quasi-static";
    case use::dynamic:
      return "--fidelity dynamic";
    case use::dynamic_of_sets:
      return "--fidelity dynamic of several sets";
    case use::co_simulated:
      return "--fidelity co-simulated";
    case use::monolithic:
      return "--fidelity monolithic";
    case use::crown:
      return "crown";
    case use::gears:
      return "run --gears";
    case use::modes:
      return "modes";
    case use::modes_at_speed:
      return "modes --speed";
    case use::mesh:
      return "mesh";
    case use::fmu_bearing:
      return "fmu --model bearing";
    case use::fmu_gearset:
      return "fmu --model gearset";
    case use::static_load:
      return "run of a single bearing";
    case use::ball_run:
      return "run of a ball bearing in time";
    case use::defect:
      return "run of a bearing with scratches";
    case use::moving_defect:
      return "run --fidelity dynamic of a bearing with scratches";
    case use::planet_defect:
      return "run of a set with a scratched planet bearing";
    case use::duplex_modes:
      return "modes of a duplex pair";
    case use::duplex_run:
      return "run of a duplex pair";
    case use::spin_film:
      return "run of a contact that rolls and spins";
    case use::stiffness:
      return "stiffness of a single bearing";
    case use::planet_stiffness:
      return "stiffness of a planet bearing";
  }
  return "";
}

}  // namespace orbearing::app
