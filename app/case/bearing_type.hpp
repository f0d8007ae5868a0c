// Planet bearings of other types than cylindrical rollers: what a case states of them, and what works with
// them.
#pragma once

#include <string>
#include <string_view>

#include "app/case/field_use.hpp"
#include "app/case/resolved_case.hpp"
#include "bearing/planet_rows.hpp"

namespace orbearing::app {

/// Type of the planet bearing; cylindrical rollers for a case that states none and for other models. `set`:
/// "sets.NAME." or "".
bearing::PlanetBearingType bearing_type_of(const ResolvedCase& resolved, std::string_view set = "");

/// Whether all sets have cylindrical rollers.
bool has_cylindrical_rollers(const ResolvedCase& resolved);

/// Whether a set has a planet bearing, of rollers or balls.
bool has_planet_bearing(const ResolvedCase& resolved, std::string_view set = "");

/// Analyses that model planet bearings of any type.
inline constexpr AnalysisSet knows_every_type = AnalysisId::quasi_static | AnalysisId::mesh;

/// Whether `input` is a type of bearing that `analysis` does not model.
bool is_unknown_type(const ResolvedCase& resolved, const Input& input, AnalysisId analysis);

/// Whether bearings of this type do not have the field: balls have no fields of rollers.
bool goes_without(std::string_view type, std::string_view path);

}  // namespace orbearing::app
