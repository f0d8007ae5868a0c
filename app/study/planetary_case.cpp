#include "app/study/planetary_case.hpp"

#include <algorithm>
#include <stdexcept>

#include "app/case/drivetrain_reader.hpp"
#include "app/case/input_keys.hpp"
#include "app/errors.hpp"
#include "app/study/gear_case.hpp"
#include "coupling/analysis/carrier_revolution.hpp"
#include "coupling/analysis/drivetrain_warnings.hpp"
#include "coupling/analysis/set_quantities.hpp"

namespace orbearing::app {

namespace {

// Throws BadInput where lists of the carrier's bearings do not fit.
void require_sound_carrier(const ResolvedCase& in, const analysis::StatedDrivetrain& stated) {
  if (!analysis::carrier_is_body(stated)) return;
  try {
    analysis::require_sound(stated.single().carrier);
  } catch (const std::invalid_argument& error) {
    throw BadInput(in.file() + ": " + error.what());
  }
}

}  // namespace

analysis::PlanetaryDrivetrain drivetrain_of(const ResolvedCase& in) {
  return with_refused_gears(in, analysis::moving_set(stated_drivetrain(in), ""));
}

analysis::PlanetaryDrivetrain scratched_drivetrain_of(const ResolvedCase& in) {
  if (!in.shape().several) return drivetrain_of(in);
  const std::string& name = in.text(kScratchedSet);
  return with_refused_gears(in.of_set(name), analysis::moving_set(stated_drivetrain(in), name));
}

std::vector<std::string> bearing_set_names(const ResolvedCase& in) {
  return analysis::bearing_set_names(stated_drivetrain(in));
}

std::vector<analysis::NamedSet> bearing_sets(const ResolvedCase& in) {
  const analysis::StatedDrivetrain& stated = stated_drivetrain(in);
  require_sound_carrier(in, stated);
  std::vector<analysis::NamedSet> sets = analysis::bearing_sets(stated);
  for (auto& [name, drivetrain, geometry] : sets)
    drivetrain = in.shape().several ? with_refused_gears(in.of_set(name), std::move(drivetrain))
                                    : with_sound_gears(in, std::move(drivetrain));
  return sets;
}

std::vector<analysis::NamedSet> stated_sets(const ResolvedCase& in) {
  if (in.model() != planetary_drivetrain) return {};
  return analysis::stated_sets(stated_drivetrain(in));
}

analysis::PowerOfMembers power_of(const ResolvedCase& in) {
  return analysis::power_of(stated_drivetrain(in));
}

std::vector<std::string> overturning_warnings(const ResolvedCase& in) {
  const analysis::StatedDrivetrain& stated = stated_drivetrain(in);
  return analysis::is_helical(stated) ? analysis::overturning_warnings(analysis::bearing_sets(stated))
                                      : std::vector<std::string>{};
}

std::vector<std::string> slope_warnings(const ResolvedCase& in) {
  std::vector<std::string> texts;
  for (const analysis::NamedSet& set : stated_sets(in))
    if (set.name.empty())
      for (const mechanics::Problem& warning : analysis::slope_warnings(set.drivetrain))
        texts.push_back(warning.key + ": " + in.given(warning.key) + " " + warning.text);
  return texts;
}

namespace {

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
    if (axis.path == keys().speed && axis.values.size() <= most_speeds)
      for (std::size_t i = 0; i < axis.values.size(); ++i)
        speeds.push_back({axis.values[i], axis.numbers[i]});
  return speeds;
}

const analysis::SetGears& gears_of(const analysis::StatedDrivetrain& stated, const std::string& set) {
  const auto named = std::ranges::find(stated.sets, set, &analysis::NamedStatedSet::name);
  return named == stated.sets.end() ? stated.single().gears : named->set.gears;  // planets of pairs
}

}  // namespace

std::vector<Derived> derived_quantities(const ResolvedCase& in) {
  std::vector<Derived> rows;
  const analysis::StatedDrivetrain& stated = stated_drivetrain(in);
  if (!stated.is_single() || in.shape().bearing) {
    for (const analysis::NamedSet& set : bearing_sets(in))
      add_rows_of(analysis::quantities_of(set, gears_of(stated, set.name), few_swept_speeds(in)), set.name,
                  rows);
    // Pins of all sets are alike where the case states one stiffness for all.
    if (in.has(keys().support_stiffness))
      std::erase_if(rows, [](const Derived& row) { return row.path.ends_with(keys().support_stiffness); });
    for (const analysis::NamedSet& set : analysis::sets_without_bearing(stated))
      add_rows_of(analysis::quantities_of_gears(set.drivetrain), set.name, rows);
  } else if (in.shape().teeth) {
    add_rows_of(analysis::quantities_of_gears(stated_sets(in).front().drivetrain), "", rows);
  }
  if (stated.is_single() && !in.shape().teeth) return rows;
  if (const auto ratio = analysis::overall_ratio(arrangement_of(stated), drive_of(stated)))
    add_rows_of(*ratio, "", rows);
  return rows;
}

}  // namespace orbearing::app
