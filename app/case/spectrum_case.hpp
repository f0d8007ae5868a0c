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

/// Of a sum of shares that were rounded for typing.
inline constexpr double kShareRoundOff = 1e-6;

/// The power of a case that states torque, or torque over speed, at its speed. A value of --set replaces
/// another of the file; of two that differ in one place check_torque() says so.
void fill_from_torque(CaseData& data);
/// After `path` was set: what stood in its place before is gone.
void replace_other_duty(CaseData& data, const std::string& path);
void check_torque(CheckedCase& resolved);

/// None where the case states none. Hours become shares of their sum; shares, which were checked to add up to
/// 1, are divided by their sum to lose what rounding left. A row's torque times its speed is its power.
std::optional<LoadSpectrum> load_spectrum(const ResolvedCase& resolved);

/// Of a command that computes single points of a case with a spectrum.
std::vector<std::string> spectrum_warnings(const ResolvedCase& resolved, const std::string& command);

/// Objects to rows of which some have shares and some hours, to shares that do not add up to 1, to a spectrum
/// that never turns.
void check_spectrum(CheckedCase& resolved);

}  // namespace orbearing::app
