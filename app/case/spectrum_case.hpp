// The load spectrum that a case states.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/load_spectrum.hpp"

namespace orbearing::app {

/// The field: rows of {power or torque, speed, share or hours}, or {file: loads.csv}.
inline const std::string kSpectrumPath = "spectrum";

/// Field of the table.
Field spectrum_field();

/// None where the case states none. Hours become shares of their sum; shares, which were checked to add up to
/// 1, are divided by their sum to lose what rounding left. A row's torque times its speed is its power.
std::optional<LoadSpectrum> load_spectrum(const ResolvedCase& resolved);

/// Of a command that computes single points of a case with a spectrum.
std::vector<std::string> spectrum_warnings(const ResolvedCase& resolved, const std::string& command);

/// Objects to rows of which some have shares and some hours, to shares that do not add up to 1, to a spectrum
/// that never turns.
void check_spectrum(const ResolvedCase& resolved, std::vector<Mistake>& mistakes);

}  // namespace orbearing::app
