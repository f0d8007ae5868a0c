#include "app/case/spectrum_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/case/mistake.hpp"

namespace orbearing::app {

namespace {

constexpr double kShareRoundOff = 1e-6;  // of shares that were rounded for typing
constexpr double kRoundOff = 1e-12;      // of shares that add up: they stay as written
constexpr double kMostPower = 1e10;      // [W]  as of input.power
constexpr int kLoad = 1, kTime = 2;      // groups of columns of which a row has one

/// Columns of a row, in the order of the field.
struct StatedBin {
  double power = 0.0;   // [W]      0 where torque stands in its place
  double torque = 0.0;  // [N m]
  double speed = 0.0;   // [rad/s]
  double share = 0.0;   // [-]      0 where hours stand in its place
  double time = 0.0;    // [s]

  double own_power() const { return power + torque * speed; }
};

std::vector<StatedBin> stated_bins(const ResolvedCase& resolved) {
  constexpr std::size_t columns = 5;
  const std::vector<double>& list = resolved.list(kSpectrumPath);
  std::vector<StatedBin> bins;
  for (std::size_t i = 0; i + columns <= list.size(); i += columns)
    bins.push_back({list[i], list[i + 1], list[i + 2], list[i + 3], list[i + 4]});
  return bins;
}

double sum_of(const std::vector<StatedBin>& bins, double StatedBin::*member) {
  double sum = 0.0;
  for (const StatedBin& bin : bins) sum += bin.*member;
  return sum;
}

}  // namespace

Field spectrum_field() {
  return {.path = kSpectrumPath,
          .kind = Kind::list,
          .meaning =
              "load spectrum: how long which power or torque enters at which speed; share or hours, the same "
              "for all rows; speed 0 is rest",
          .use = Use(use::lives, use::all & ~use::lives),
          .models = planetary_drivetrain,
          .element = Kind::list,
          .columns = {{"power", dimension::power, {0.0, 1e7}, kLoad},
                      {"torque", dimension::torque, {0.0, 1e12}, kLoad},
                      {"speed", dimension::angular_speed, {0.0, 1e6}},
                      {"share", {}, {0.0, 1.0 + kShareRoundOff}, kTime},
                      {"hours", {"time", "s", "h", "120 h", 3600.0}, {0.0, 1e9}, kTime, "h"}},
          .from_file = true};
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
  LoadSpectrum spectrum{.hours = time / hour};
  for (const StatedBin& bin : bins)
    spectrum.bins.push_back({bin.own_power(), bin.speed, time > 0.0 ? bin.time / time : bin.share / shares});
  return spectrum;
}

void check_spectrum(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  if (!resolved.has(kSpectrumPath)) return;
  const auto add_error = [&](std::string found, std::string required) {
    add_error_at(resolved, kSpectrumPath, std::move(found), std::move(required), mistakes);
  };
  const std::vector<StatedBin> bins = stated_bins(resolved);
  const double time = sum_of(bins, &StatedBin::time);
  const double shares = sum_of(bins, &StatedBin::share);
  if (time > 0.0 && shares > 0.0)
    add_error("rows with a share beside rows with hours", "one of both, the same for all rows, is required");
  else if (time <= 0.0 && std::abs(shares - 1.0) > kShareRoundOff)
    add_error(
        fmt::format("shares that add up to {:.8g}", shares),
        "a sum of 1 is required; time at rest is a row of speed 0, and hours in place of share need no sum");
  if (std::none_of(bins.begin(), bins.end(), [](const StatedBin& bin) {
        return LoadBin{.speed = bin.speed}.turns() && bin.share + bin.time > 0.0;
      }))
    add_error("a spectrum at rest", "a row with a speed and a share above 0 is required");
  for (std::size_t i = 0; i < bins.size(); ++i)
    if (bins[i].power > 0.0 && !LoadBin{.speed = bins[i].speed}.turns())
      mistakes.push_back({resolved.item_location(kSpectrumPath, i),
                          kSpectrumPath,
                          {fmt::format("row {} with {:.4g} kW at speed 0", i + 1, 1e-3 * bins[i].power),
                           "power 0, or torque in place of power, is required at rest"}});
  for (std::size_t i = 0; i < bins.size(); ++i)
    if (bins[i].own_power() > kMostPower)
      add_error(fmt::format("row {} with {:.4g} kW", i + 1, 1e-3 * bins[i].own_power()),
                "at most 1e7 kW is required");
}

}  // namespace orbearing::app
