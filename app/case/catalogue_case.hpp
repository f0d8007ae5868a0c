// A catalogue bearing instead of single values: by its designation, its clearance class, the material of its
// cage, without a cage, without rings.
#pragma once

#include <string>

#include "app/case/field.hpp"
#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Replaces stated values by those of a stated catalogue bearing; the stated ones then have no effect; so
/// with each of several sets. Sizes of a cage that are left out with a designation are those of a typical
/// cage.
void fill_from_catalogue(CaseData& data, Model model);

/// Whether the bearing has no cage: a full complement of rollers.
/// @param set what the paths of its set begin with
bool is_full_complement(const ResolvedCase& in, const std::string& set = "");

}  // namespace orbearing::app
