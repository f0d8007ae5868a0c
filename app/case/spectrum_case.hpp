// The duty that a case states besides one power: a load spectrum, a torque, torque over speed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/load_spectrum.hpp"

namespace orbearing::app {

/// The field: rows of {power or torque, speed, share or hours}, or {file: loads.csv}.
inline const std::string kSpectrumPath = "spectrum";
/// P/C below which rolling elements may skid.
inline const std::string kMinimumLoadPath = "life.minimum_load";

/// Tolerance of the sum of shares that were rounded for typing.
inline constexpr double kShareRoundOff = 1e-6;

/// Power of a case that states torque, or torque over speed, at its speed. A value of --set replaces another
/// of the file; check_torque() reports two of the same source (file or settings).
void fill_from_torque(CaseData& data);
/// After `path` was set: removes the input that stated the duty before.
void replace_other_duty(CaseData& data, const std::string& path);
void check_torque(CheckedCase& resolved);

/// None where the case states none. Hours become shares of their sum; shares, which were checked to add up to
/// 1, are divided by their sum to lose what rounding left. A row's torque times its speed is its power.
std::optional<LoadSpectrum> load_spectrum(const ResolvedCase& resolved);

/// Warnings of a command that computes single points of a case with a spectrum.
std::vector<std::string> spectrum_warnings(const ResolvedCase& resolved, const std::string& command);

/// Adds mistakes for rows of which some have shares and some hours, for shares that do not add up to 1, and
/// for a spectrum without rotation.
void check_spectrum(CheckedCase& resolved);

}  // namespace orbearing::app
