#include "app/case/spectrum_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/mistake.hpp"
#include "app/case/oil_case.hpp"
#include "app/units.hpp"

namespace orbearing::app {

namespace {

constexpr double kRoundOff = 1e-12;  // of shares that add up: they stay as written
constexpr double kMostPower = 1e10;  // [W]  as of input.power

/// Columns of a row, in the order of the field.
struct StatedBin {
  double power = 0.0;   // [W]      0 where torque is given instead
  double torque = 0.0;  // [N m]
  double speed = 0.0;   // [rad/s]
  double share = 0.0;   // [-]      0 where hours are given instead
  double time = 0.0;    // [s]
  double file = 0.0;    // number of its text; 0: the row names none

  double own_power() const { return power + torque * speed; }
};

std::vector<StatedBin> stated_bins(const ResolvedCase& resolved) {
  constexpr std::size_t columns = 6;
  const std::vector<double>& list = resolved.list(kSpectrumPath);
  std::vector<StatedBin> bins;
  for (std::size_t i = 0; i + columns <= list.size(); i += columns)
    bins.push_back({list[i], list[i + 1], list[i + 2], list[i + 3], list[i + 4], list[i + 5]});
  return bins;
}

double sum_of(const std::vector<StatedBin>& bins, double StatedBin::*member) {
  double sum = 0.0;
  for (const StatedBin& bin : bins) sum += bin.*member;
  return sum;
}

// Rows of (speed, torque) in ascending order of speed.
constexpr std::size_t curve_columns = 2;

/// Linear between its rows; none beyond them.
std::optional<double> torque_at(const std::vector<double>& curve, double speed) {
  for (std::size_t i = curve_columns; i + 1 < curve.size(); i += curve_columns) {
    const double before = curve[i - 2], after = curve[i];
    if (speed < before * (1.0 - kRoundOff) || speed > after * (1.0 + kRoundOff)) continue;
    return std::lerp(curve[i - 1], curve[i + 1], (speed - before) / (after - before));
  }
  return std::nullopt;
}

// Inputs of the duty, of which a case states one.
std::array<const std::string*, 3> duty_paths() {
  return {&keys().power, &kTorquePath, &kTorqueCurvePath};
}

const std::string* stated_duty(const CaseData& data) {
  for (const std::string* path : {&kTorquePath, &kTorqueCurvePath})
    if (data.values.contains(*path)) return path;
  return nullptr;
}

}  // namespace

void replace_other_duty(CaseData& data, const std::string& path) {
  if (std::ranges::none_of(duty_paths(), [&](const std::string* duty) { return *duty == path; })) return;
  for (const std::string* other : duty_paths())
    if (*other != path) {
      data.values.erase(*other);
      data.assumed.erase(*other);
    }
}

void fill_from_torque(CaseData& data) {
  const std::string* by_option = nullptr;
  int options = 0;
  for (const std::string* path : duty_paths())
    if (const auto found = data.values.find(*path);
        found != data.values.end() && !found->second.from_default && found->second.location.option) {
      by_option = path;
      ++options;
    }
  if (options == 1) replace_other_duty(data, *by_option);
  const std::string* path = stated_duty(data);
  const auto speed = data.values.find(keys().speed);
  if (path == nullptr || speed == data.values.end()) return;
  const FieldValue& value = data.values.at(*path).value;
  const double at = speed->second.value.number;
  const std::optional<double> torque = *path == kTorquePath ? value.number : torque_at(value.list, at);
  if (!torque) return;  // reported by check_torque()
  const auto power = data.values.find(keys().power);
  const double derived = *torque * at;
  if (power != data.values.end() && !power->second.from_default &&
      std::abs(power->second.value.number - derived) > kShareRoundOff * derived)
    return;
  substitute(data, keys().power, fmt::format("{} W", derived), *path + " x input.speed");
}

namespace {

void check_curve(CheckedCase& in) {
  if (!in.has(kTorqueCurvePath)) return;
  const std::vector<double>& curve = in.list(kTorqueCurvePath);
  for (std::size_t i = curve_columns; i < curve.size(); i += curve_columns)
    if (curve[i] <= curve[i - curve_columns])
      return in.add_error_at(
          kTorqueCurvePath,
          fmt::format("row {} at no higher speed than the row before", i / curve_columns + 1),
          "rows in ascending order of speed are required");
  if (in.has(keys().speed) && !torque_at(curve, in.quantity(keys().speed)))
    in.add_error_at(kTorqueCurvePath,
                    fmt::format("{:g} to {:g} rpm without {:g} rpm", kRpm * curve.front(),
                                kRpm * curve[curve.size() - curve_columns], kRpm * in.quantity(keys().speed)),
                    "rows on both sides of input.speed are required: nothing is extrapolated");
}

}  // namespace

void check_torque(CheckedCase& in) {
  if (in.has(kSpectrumPath) && in.has(keys().application_factor) &&
      in.number(keys().application_factor) != 1.0)
    in.add_error_at(keys().application_factor,
                    fmt::format("{:g} together with a spectrum", in.number(keys().application_factor)),
                    "1 is required: a spectrum has the loads that act (ISO 6336-6)");
  check_curve(in);
  std::vector<std::string> stated;
  for (const std::string* path : duty_paths())
    if (is_stated(in, *path)) stated.push_back(*path);
  if (stated.size() > 1)
    in.add_error_at(stated.back(), fmt::format("a duty stated by {}", fmt::join(stated, " and ")),
                    "one of them is required");
  if (in.has(kTorquePath) && in.has(keys().speed) && !in.has(keys().power))
    in.add_error_at(
        kTorquePath,
        fmt::format("{:g} kW at input.speed", 1e-3 * in.quantity(kTorquePath) * in.quantity(keys().speed)),
        "a torque that makes 1e-06 to 1e7 kW is required");
  if (in.has(kTorqueCurvePath) && in.has(keys().speed) && !in.has(keys().power) &&
      torque_at(in.list(kTorqueCurvePath), in.quantity(keys().speed)))
    in.add_error_at(kTorqueCurvePath, "no torque at input.speed",
                    "a torque above 0 at each speed is required");
  for (const SweepAxis& axis : in.axes())
    if (axis.path == keys().power && !stated.empty() && stated.back() != keys().power)
      in.add_error_at(stated.back(), "a torque together with a sweep over input.power",
                      "one of both is required");
}

std::vector<std::string> spectrum_warnings(const ResolvedCase& resolved, const std::string& command) {
  if (!resolved.has(kSpectrumPath)) return {};
  return {kSpectrumPath + ": has no effect on " + command +
          ", which computes single operating points; used by run, sweep and crown"};
}

std::optional<LoadSpectrum> load_spectrum(const ResolvedCase& resolved) {
  if (!resolved.has(kSpectrumPath)) return std::nullopt;
  constexpr double hour = 3600.0;  // [s]
  const std::vector<StatedBin> bins = stated_bins(resolved);
  const double time = sum_of(bins, &StatedBin::time);
  const double sum = sum_of(bins, &StatedBin::share);
  const double shares = std::abs(sum - 1.0) < kRoundOff ? 1.0 : sum;
  LoadSpectrum spectrum{.hours = time / hour, .minimum_load = resolved.number(kMinimumLoadPath)};
  for (const StatedBin& bin : bins)
    spectrum.bins.push_back({bin.own_power(), bin.speed, time > 0.0 ? bin.time / time : bin.share / shares,
                             text_numbered(resolved.texts(kSpectrumPath), bin.file)});
  return spectrum;
}

void check_spectrum(CheckedCase& resolved) {
  if (!resolved.has(kSpectrumPath)) return;
  const auto add_error = [&](std::string found, std::string required) {
    resolved.add_error_at(kSpectrumPath, std::move(found), std::move(required));
  };
  const std::vector<StatedBin> bins = stated_bins(resolved);
  const double time = sum_of(bins, &StatedBin::time);
  const double shares = sum_of(bins, &StatedBin::share);
  if (time > 0.0 && shares > 0.0)
    add_error("rows with a share together with rows with hours",
              "one of both, the same for all rows, is required");
  else if (time <= 0.0 && std::abs(shares - 1.0) > kShareRoundOff)
    add_error(fmt::format("shares that add up to {:.8g}", shares),
              "a sum of 1 is required; time at rest is a row of speed 0, and hours instead of share require "
              "no sum");
  if (std::none_of(bins.begin(), bins.end(), [](const StatedBin& bin) {
        return LoadBin{.speed = bin.speed}.turns() && bin.share + bin.time > 0.0;
      }))
    add_error("a spectrum at rest", "a row with a speed and a share above 0 is required");
  for (std::size_t i = 0; i < bins.size(); ++i)
    if (bins[i].power > 0.0 && !LoadBin{.speed = bins[i].speed}.turns())
      resolved.mistakes.push_back(
          {resolved.item_location(kSpectrumPath, i),
           kSpectrumPath,
           {fmt::format("row {} with {:.4g} kW at speed 0", i + 1, 1e-3 * bins[i].power),
            "power 0, or torque instead of power, is required at rest"}});
  for (std::size_t i = 0; i < bins.size(); ++i)
    if (bins[i].own_power() > kMostPower)
      add_error(fmt::format("row {} with {:.4g} kW", i + 1, 1e-3 * bins[i].own_power()),
                "at most 1e7 kW is required");
}

}  // namespace orbearing::app
