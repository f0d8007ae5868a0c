// From a resolved case of the model planetary-drivetrain to its sets with the dynamic model of their gears.
#pragma once

#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "coupling/analysis/drivetrain.hpp"
#include "coupling/analysis/multi_stage.hpp"
#include "coupling/analysis/power_of_members.hpp"

namespace orbearing::app {

/// Parameters of a case of the model planetary-drivetrain that has one set; with a bearing also the dynamic
/// model of its gears.
analysis::PlanetaryDrivetrain drivetrain_of(const ResolvedCase& resolved);

/// The set of a case with a scratched planet bearing, which moves; among several sets that of defect.set, at
/// the speeds and torques that its members have there.
analysis::PlanetaryDrivetrain scratched_drivetrain_of(const ResolvedCase& resolved);

/// The sets with bearings of a planetary drivetrain, in the order of the case; of a case of one set, that one
/// without a name.
std::vector<analysis::NamedSet> bearing_sets(const ResolvedCase& resolved);

/// Names of the sets with bearings where there are several sets; none for a case of one set.
std::vector<std::string> bearing_set_names(const ResolvedCase& resolved);

/// The sets of a case as they are stated, with or without bearings, each driven as a single one; without
/// their gears' motion and what follows from the inputs. None of a set without teeth, or of another model.
std::vector<analysis::NamedSet> stated_sets(const ResolvedCase& resolved);

/// Speeds, torques and power of every member of a sound case at its operating point.
analysis::PowerOfMembers power_of(const ResolvedCase& resolved);

/// The moment by which helical teeth overturn the planets of sets whose tilt is not computed.
std::vector<std::string> overturning_warnings(const ResolvedCase& resolved);

/// Slopes of the lead beside a computed tilt, in which the moment that they make is left out.
std::vector<std::string> slope_warnings(const ResolvedCase& resolved);

/// Quantities derived from the inputs, for `orbearing check`.
std::vector<Derived> derived_quantities(const ResolvedCase& resolved);

}  // namespace orbearing::app
