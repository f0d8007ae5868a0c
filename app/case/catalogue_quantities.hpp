// Quantities of a catalogue bearing besides the values that it replaces.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "bearing/catalogue/classes.hpp"
#include "bearing/friction/published_torque.hpp"

namespace orbearing::app {

/// Boundary dimensions of the case's bearing: as stated, or by its designation; none where they are not
/// known. The series is that of the designation, else 2. Without C_0.
std::optional<bearing::friction::BearingSize> size_of(const ResolvedCase& in);

/// Range of the clearance of the case's bearing on the shelf by a class such as "CN"; of one set. Throws
/// std::invalid_argument where the tables have none.
bearing::catalogue::ClearanceRange clearance_range_of(const ResolvedCase& in, const std::string& which);

/// The one line that the case takes out of its own catalogue at `path`, as a table; none where it takes none.
std::optional<std::string> table_in_use(const ResolvedCase& resolved, const std::string& path);

/// Quantities of a designation and a class besides the values that they replace, for `check`: ratings, the
/// range of the clearance.
std::vector<Derived> catalogue_quantities(const ResolvedCase& resolved);

}  // namespace orbearing::app
