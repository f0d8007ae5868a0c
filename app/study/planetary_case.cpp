#include "app/study/planetary_case.hpp"

#include <algorithm>
#include <stdexcept>

#include "app/case/arrangement_case.hpp"
#include "app/case/bearing_type.hpp"
#include "app/case/defect_case.hpp"
#include "app/case/described_case.hpp"
#include "app/case/set_case.hpp"
#include "app/case/use_conditions.hpp"
#include "app/errors.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/gear_case.hpp"
#include "coupling/analysis/drivetrain_warnings.hpp"
#include "coupling/analysis/power_of_members.hpp"
#include "coupling/analysis/set_quantities.hpp"
#include "gearset/drivetrain/power_flow.hpp"

namespace orbearing::app {

namespace {

// How the housing holds the carrier, where it is taken as a body. Throws BadInput where lists do not fit.
std::optional<gearset::spatial::CarrierMounting> carrier_mounting_of(const ResolvedCase& in) {
  if (!carrier_is_body(in, "")) return std::nullopt;
  const auto mounting = from_case<gearset::spatial::CarrierMounting>(in);
  try {
    study::require_sound(mounting);
  } catch (const std::invalid_argument& error) {
    throw BadInput(in.file() + ": " + error.what());
  }
  return mounting;
}

}  // namespace

study::PlanetaryDrivetrain drivetrain_of(const ResolvedCase& in) {
  study::PlanetaryDrivetrain out = drivetrain_without_gear_set(in);
  if (has_planet_bearing(in)) out.gear_set = gears_of(in, out);
  return out;
}

namespace {

// Names of planets in pairs, which are modelled as two sets that share the power.
const std::vector<std::string> kPairNames{"first_planet", "second_planet"};

std::vector<study::NamedSet> planets_of_pairs(const ResolvedCase& resolved) {
  const gearset::PowerFlow flow = gearset::power_flow(arrangement_of(resolved));
  std::vector<study::NamedSet> planets;
  for (const std::string& name : kPairNames) {
    study::PlanetaryDrivetrain drivetrain = drivetrain_without_gear_set(resolved);
    drivetrain.of_pair = {second_planet_of(resolved), name == kPairNames.back()};
    drivetrain.in_arrangement = flow.sets.front();
    drivetrain.mesh_variation = false;
    const study::DrivetrainGeometry geometry = study::derive(drivetrain);
    planets.push_back({name, std::move(drivetrain), geometry});
  }
  return planets;
}

}  // namespace

std::vector<std::string> bearing_set_names(const ResolvedCase& resolved) {
  if (has_planet_pairs(resolved)) return kPairNames;
  std::vector<std::string> names;
  for (const std::string& set : resolved.shape().sets)
    if (has_planet_bearing(resolved, set_prefix(set))) names.push_back(set);
  return names;
}

namespace {

// One of several, without its gears.
study::PlanetaryDrivetrain arranged_drivetrain(const ResolvedCase& resolved, const ResolvedCase& of_set,
                                               const std::string& name, const gearset::PowerFlow& flow) {
  const std::vector<std::string>& all = resolved.shape().sets;
  study::PlanetaryDrivetrain drivetrain = drivetrain_without_gear_set(of_set);
  drivetrain.drive = drive_of(resolved);
  drivetrain.in_arrangement = flow.sets[static_cast<std::size_t>(std::ranges::find(all, name) - all.begin())];
  study::mount(drivetrain);
  return drivetrain;
}

}  // namespace

study::PlanetaryDrivetrain scratched_drivetrain_of(const ResolvedCase& resolved) {
  if (!resolved.shape().several) return drivetrain_of(resolved);
  const std::string& name = resolved.text(kScratchedSet);
  const ResolvedCase of_set = resolved.of_set(name);
  study::PlanetaryDrivetrain drivetrain =
      arranged_drivetrain(resolved, of_set, name, gearset::power_flow(arrangement_of(resolved)));
  drivetrain.set.fixed_member = held_member_of(resolved, name).value();
  drivetrain.gear_set = gears_of(of_set, drivetrain);
  return drivetrain;
}

std::vector<study::NamedSet> bearing_sets(const ResolvedCase& resolved) {
  if (has_planet_pairs(resolved)) return planets_of_pairs(resolved);
  if (!resolved.shape().several) {
    study::PlanetaryDrivetrain drivetrain = drivetrain_without_gear_set(resolved);
    const study::DrivetrainGeometry geometry = study::derive(drivetrain);
    if (drivetrain.has_bearing() && drivetrain.bearing.has_rollers())
      drivetrain.gear_set = gears_of(resolved, drivetrain, geometry);
    drivetrain.carrier_mounting = carrier_mounting_of(resolved);
    return {{"", std::move(drivetrain), geometry}};
  }
  const gearset::PowerFlow flow = gearset::power_flow(arrangement_of(resolved));
  std::vector<study::NamedSet> sets;
  for (const std::string& name : bearing_set_names(resolved)) {
    const ResolvedCase of_set = resolved.of_set(name);
    study::PlanetaryDrivetrain drivetrain = arranged_drivetrain(resolved, of_set, name, flow);
    drivetrain.mesh_variation = false;  // gears of several sets do not move yet: they share loads at rest
    drivetrain.gear_set = gears_of(of_set, drivetrain);
    const study::DrivetrainGeometry geometry = study::derive(drivetrain);
    sets.push_back({name, std::move(drivetrain), geometry});
  }
  return sets;
}

std::vector<study::NamedSet> stated_sets(const ResolvedCase& in) {
  std::vector<study::NamedSet> sets;
  if (in.model() != planetary_drivetrain) return sets;
  if (in.shape().several)
    for (const std::string& name : in.shape().sets)
      sets.push_back({name, drivetrain_without_gear_set(in.of_set(name)), {}});
  else if (in.shape().teeth || in.shape().bearing)
    sets.push_back({"", drivetrain_without_gear_set(in), {}});
  return sets;
}

analysis::PowerOfMembers power_of(const ResolvedCase& in) {
  return analysis::power_of_members(arrangement_of(in), drive_of(in));
}

std::vector<std::string> overturning_warnings(const ResolvedCase& in) {
  return is_helical(in) ? analysis::overturning_warnings(bearing_sets(in)) : std::vector<std::string>{};
}

std::vector<std::string> slope_warnings(const ResolvedCase& in) {
  std::vector<std::string> texts;
  for (const study::NamedSet& set : stated_sets(in))
    if (set.name.empty())
      for (const mechanics::Problem& warning : analysis::slope_warnings(set.drivetrain))
        texts.push_back(warning.key + ": " + in.given(warning.key) + " " + warning.text);
  return texts;
}

namespace {

constexpr const char* kPinStiffness = "support.stiffness";

// Numbers of a record as `check` lists them, under the keys of the set.
void add_rows(const described::Record& record, const std::string& set, std::vector<Derived>& rows) {
  for (const described::Entry& entry : record.entries())
    rows.push_back(
        {set_prefix(set) + described::name_without_unit(entry),
         std::get<described::Numbers>(entry.content).values.front() * (1.0 / entry.dimension.factor),
         std::string(entry.dimension.customary), entry.meaning});
}
template <class Result>
void add_rows_of(const Result& result, const std::string& set, std::vector<Derived>& rows) {
  described::Record record;
  describe(record, result);
  add_rows(record, set, rows);
}

// Speeds of the sweep, where they are few.
std::vector<analysis::NamedSpeed> few_swept_speeds(const ResolvedCase& in) {
  constexpr std::size_t most_speeds = 24;
  std::vector<analysis::NamedSpeed> speeds;
  for (const SweepAxis& axis : in.axes())
    if (axis.path == kSpeedPath && axis.values.size() <= most_speeds)
      for (std::size_t i = 0; i < axis.values.size(); ++i)
        speeds.push_back({axis.values[i], axis.numbers[i]});
  return speeds;
}

void add_sets_without_bearing(const ResolvedCase& in, std::vector<Derived>& rows) {
  const gearset::PowerFlow flow = gearset::power_flow(arrangement_of(in));
  const std::vector<std::string>& names = in.shape().sets;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (has_planet_bearing(in, set_prefix(names[i]))) continue;
    study::PlanetaryDrivetrain drivetrain = drivetrain_without_gear_set(in.of_set(names[i]));
    drivetrain.drive = drive_of(in);
    drivetrain.in_arrangement = flow.sets[i];
    add_rows_of(analysis::quantities_of_gears(drivetrain), names[i], rows);
  }
}

}  // namespace

std::vector<Derived> derived_quantities(const ResolvedCase& in) {
  std::vector<Derived> rows;
  const bool several = in.shape().several;
  if (several || in.shape().bearing) {
    for (const study::NamedSet& set : bearing_sets(in))
      add_rows_of(analysis::quantities_of(set, set_gears_of(several ? in.of_set(set.name) : in),
                                          few_swept_speeds(in)),
                  set.name, rows);
    // Pins of all sets are alike where the case states one stiffness for all.
    if (in.has(kPinStiffness))
      std::erase_if(rows, [](const Derived& row) { return row.path.ends_with(kPinStiffness); });
    if (several) add_sets_without_bearing(in, rows);
  } else if (in.shape().teeth) {
    add_rows_of(analysis::quantities_of_gears(drivetrain_without_gear_set(in)), "", rows);
  }
  if (!several && !in.shape().teeth) return rows;
  if (const auto ratio = analysis::overall_ratio(arrangement_of(in), drive_of(in)))
    add_rows_of(*ratio, "", rows);
  return rows;
}

}  // namespace orbearing::app
