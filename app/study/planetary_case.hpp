// From a resolved case of the model planetary-drivetrain to its sets with the dynamic model of their gears.
#pragma once

#include <string>
#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/resolved_case.hpp"
#include "app/study/drivetrain_case.hpp"
#include "coupling/study/drivetrain.hpp"
#include "coupling/study/multi_stage.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// Parameters of a case of the model planetary-drivetrain that has one set.
study::PlanetaryDrivetrain drivetrain_of(const ResolvedCase& resolved);

/// The set of a case with a scratched planet bearing, which moves; among several sets that of defect.set, at
/// the speeds and torques that its members have there.
study::PlanetaryDrivetrain scratched_drivetrain_of(const ResolvedCase& resolved);

/// The sets with bearings of a planetary drivetrain, in the order of the case; of a case of one set, that one
/// without a name.
std::vector<study::NamedSet> bearing_sets(const ResolvedCase& resolved);

/// Names of the sets with bearings where there are several sets; none for a case of one set.
std::vector<std::string> bearing_set_names(const ResolvedCase& resolved);

/// Prefixes of the paths of each set; an empty one for a case of one set.
std::vector<std::string> prefixes_of_sets(const ResolvedCase& resolved);

/// Cages in motion without a land: nothing but rollers holds them.
std::vector<std::string> cage_warnings(const ResolvedCase& resolved);

/// Assumptions of a clearance before mounting: fits or temperatures that are not stated.
std::vector<std::string> clearance_warnings(const ResolvedCase& resolved);

/// The moment by which helical teeth overturn the planets of sets whose tilt is not computed, and what it
/// would be on their bearings.
std::vector<std::string> overturning_warnings(const ResolvedCase& resolved);

/// Slopes of the lead beside a computed tilt, in which the moment that they make is left out.
std::vector<std::string> slope_warnings(const ResolvedCase& resolved);

/// Quantities derived from the inputs, for `orbearing check`.
std::vector<Derived> derived_quantities(const ResolvedCase& resolved);

/// Speeds, torques and power of every member of a sound case at its operating point, and whether power
/// circulates. Torque is external, from the shaft on the member; power is positive where it enters the set.
/// `power_flow: [{set, member, shaft, speed_rpm, torque_N_m, power_W, share}]` and `power_circulation:
/// {present, largest_share, members}`.
void describe_power(described::Record& record, const ResolvedCase& resolved);

// Loads of the rollers of a planet bearing by position, which drawings of a bearing show.

/// Roller loads of one bearing of a set at a case's operating point, quasi-static.
struct RollerLoads {
  study::NamedSet set;  // without a name in a case of one set
  study::PointResult point;
};

/// The most loaded roller is that of the inner race; what is along it there is of a bearing cut into laminae
/// alone.
void describe(described::Record& row, const RollerLoads& loads);

/// Roller loads of all sets with bearings. Throws std::runtime_error where a bearing has no equilibrium.
std::vector<RollerLoads> roller_loads(const ResolvedCase& resolved);

/// `roller_loads: [{set, angle_deg, inner_load_N, outer_load_N, along_mm, inner_pressure_MPa,
/// outer_pressure_MPa}]`.
void describe(described::Record& record, const std::vector<RollerLoads>& sets);

}  // namespace orbearing::app
