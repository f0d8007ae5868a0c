#include "app/case/field_use.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace orbearing::app {

namespace {

// Members of Use that hold the possible uses of a field by an analysis.
constexpr unsigned Use::*kStatuses[]{&Use::by, &Use::not_modelled_by, &Use::refused_by};

void put(Use& use, use::Analysis analysis, unsigned Use::*status) {
  for (unsigned Use::*other : kStatuses) use.*other &= ~unsigned{analysis};
  use.*status |= analysis;
}

// `analysis` does with a field what `leader` does, its ways apart.
void follow(Use& use, use::Analysis analysis, use::Analysis leader) {
  for (unsigned Use::*status : kStatuses) {
    use.*status &= ~unsigned{analysis};
    if ((use.*status & leader) != 0) use.*status |= analysis;
  }
}

}  // namespace

Use with_planet_defect(const Use& use, std::string_view path) {
  Use more = use;
  if (begins_with_one_of(path, {"defect.", "signal."})) return more;
  if (begins_with_one_of(
          path, {"life.", "requirements.", "spectrum", "film.inlet_heating", "lubricant.kinematic",
                 "simulation.observed", "simulation.most_rev", "simulation.load_", "simulation.cage_drift",
                 "bearing.fatigue_load_limit", "bearing.dynamic_capacity", "bearing.static_capacity",
                 "bearing.neighbour_friction"})) {  // of bearings without a cage, which is refused
    put(more, use::planet_defect, &Use::not_modelled_by);
    return more;
  }
  // Planets with a computed quasi-static tilt, which the bearings keep in motion.
  const bool computed_tilt =
      path.starts_with("support.pin_") ||
      is_one_of(path, {"bearing.tilt_state", "bearing.axial_places", "bearing.clearance_differences",
                       "support.carrier_twist_stiffness"});
  follow(more, use::planet_defect, computed_tilt ? use::dynamic : use::monolithic);
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

bool links_rows(std::string_view path) {
  return is_one_of(path,
                   {"bearing.tilt_state", "support.pin_ends", "support.pin_span", "support.pin_diameter"});
}

namespace {

// Inputs of natural frequencies or of quasi-static points that the carrier as a body leaves out: rotation and
// supports of members in their planes, tilts that it computes itself, and inputs of lives.
bool is_left_out_of_carrier(std::string_view path) {
  const bool rotation = path.ends_with(".equivalent_mass") || path.ends_with(".torsional_stiffness");
  return (rotation && path.starts_with("gearset.dynamics.")) || links_rows(path) ||
         is_one_of(path, {"gearset.dynamics.ring.mass", "gearset.dynamics.ring.support_stiffness",
                          "gearset.dynamics.carrier.support_stiffness", "gearset.dynamics.separation",
                          "bearing.tilt_state", "bearing.axial_places", "bearing.clearance_differences",
                          "support.carrier_twist_stiffness", "life.method", "life.minimum_load"}) ||
         begins_with_one_of(path, {"gearset.dynamics.transmission_error.", "bearing.misalignment.",
                                   "support.pin_", "requirements.", "spectrum"});
}

}  // namespace

Use with_carrier_body(Use use, std::string_view path) {
  constexpr unsigned leaders = use::modes | use::quasi_static;
  if (path.starts_with("gearset.carrier.") ||
      is_one_of(path, {"gearset.dynamics.sun.tilt_stiffness", "gearset.dynamics.sun.axial_stiffness",
                       "gearset.dynamics.planet.axial_stiffness"}))
    return use;
  // Springs that are linked, a ring that turns, other rows than cylindrical ones, two gears on a planet,
  // pairs.
  if (is_one_of(path, {"gearset.planet_rim", "gearset.fixed", "bearing.balls", "bearing.ball_diameter"}) ||
      begins_with_one_of(path, {"bearing.rows.", "gearset.stepped_planet.", "gearset.second_planet."})) {
    put(use, use::carrier, &Use::refused_by);
    return use;
  }
  if (is_left_out_of_carrier(path)) {
    put(use, use::carrier, &Use::not_modelled_by);
    if (path == "bearing.axial_places") return use.used_too(use::carrier, std::vector<Condition>{});
    if (!links_rows(path)) return use;
    return use.used_too(use::carrier, where_body_has_pin(path));
  }
  if ((use.refused_by & use::quasi_static) != 0)
    put(use, use::carrier, &Use::refused_by);
  else if ((use.by & leaders) != 0)
    put(use, use::carrier, &Use::by);
  else
    follow(use, use::carrier, use::modes);
  for (Way& way : use.ways)
    if ((way.by & leaders) != 0) way.by |= use::carrier;
  // It moves back flanks whatever the pins do.
  if (path == "gearset.dynamics.backlash") put(use, use::carrier, &Use::by);
  return use;
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

Condition where_pin_links(std::string_view path) {
  if (path == "support.pin_diameter") return where("support.pin_ends", {"flexpin"});
  return where("support.pin_ends", {"one", "flexpin"});
}

Condition where_tilts_are_computed() {
  return where("bearing.tilt_state", {"computed"});
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
  if (analyses == 0) return more;
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

}  // namespace orbearing::app
