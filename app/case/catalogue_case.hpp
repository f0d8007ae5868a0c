// A catalogue bearing instead of single values: by its designation, its clearance class, the material of its
// cage, without a cage, without rings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/field.hpp"
#include "app/case/mistake.hpp"
#include "app/case/resolved_case.hpp"
#include "bearing/catalogue/classes.hpp"
#include "bearing/friction/published_torque.hpp"

namespace orbearing::app {

/// Replaces stated values by those of a stated catalogue bearing; the stated ones then have no effect; so
/// with each of several sets. Sizes of a cage that are left out with a designation are those of a typical
/// cage.
void fill_from_catalogue(CaseData& data, Model model);

/// Message on a designation that no line has; none where one has it. `table`: the case's own catalogue, if
/// any.
std::optional<ConsistencyMessage> unknown_designation(const std::string& name, const FieldValue* table,
                                                      Model model);

/// Mistakes of a catalogue bearing: values that are not known or do not fit together.
void check_catalogue_bearing(CheckedCase& resolved);

/// Whether the bearing has no cage: a full complement of rollers.
/// @param set what the paths of its set begin with
bool is_full_complement(const ResolvedCase& in, const std::string& set = "");

/// Boundary dimensions of the case's bearing: as stated, or by its designation; none where they are not
/// known. The series is that of the designation, else 2. Without C_0.
std::optional<bearing::friction::BearingSize> size_of(const ResolvedCase& in);

/// Range of the clearance of the case's bearing on the shelf by a class such as "CN"; of one set. Throws
/// std::invalid_argument where the tables have none.
bearing::catalogue::ClearanceRange clearance_range_of(const ResolvedCase& in, const std::string& which);

/// How far rollers or balls that are inferred from a designation may be off, and which of its ratings the
/// case replaces: what every result of theirs is to be read with.
std::vector<std::string> inferred_warnings(const ResolvedCase& resolved);

/// Messages on a study of the inputs `varied`: it varies a designation, or the catalogue, while the case
/// states ratings or sizes of a cage, which would be the same for all designations.
std::vector<std::string> stated_beside_designation(const ResolvedCase& resolved,
                                                   const std::vector<std::string>& varied);

/// The one line that the case takes out of its own catalogue at `path`, as a table; none where it takes none.
std::optional<std::string> table_in_use(const ResolvedCase& resolved, const std::string& path);

/// Quantities of a designation and a class besides the values that they replace, for `check`: ratings, the
/// range of the clearance.
std::vector<Derived> catalogue_quantities(const ResolvedCase& resolved);

}  // namespace orbearing::app
