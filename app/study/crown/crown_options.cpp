#include "app/study/crown/crown_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>

#include "app/case/drivetrain_reader.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/spectrum_case.hpp"
#include "app/case/text_parts.hpp"
#include "app/case/text_table.hpp"
#include "app/errors.hpp"
#include "app/options/option_json.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/planetary_case.hpp"
#include "app/units.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

constexpr double kMostSteps = 1000.0;
constexpr double kWhole = 1e-9;  // of a step, by which a range may miss its end

// One quantity [dimension.si]; 0 where it is wrong.
double option_quantity(const std::string& option, const std::string& text, const Dimension& dimension,
                       std::vector<std::string>& mistakes) {
  const Reading<double> reading = read_quantity(text, dimension);
  if (reading.value) return *reading.value;
  mistakes.push_back(fmt::format("{}: found {}: {}; required: {} with its unit, for instance \"{}\"", option,
                                 quote(text), reading.fault, dimension.name, dimension.example));
  return 0.0;
}

void append_range(const std::string& option, const std::string& text, const Dimension& dimension,
                  std::vector<double>& values, std::vector<std::string>& mistakes) {
  const std::vector<std::string> parts = parts_of(text, ':');
  const std::size_t before = mistakes.size();
  std::vector<double> ends;
  for (const std::string& part : parts) ends.push_back(option_quantity(option, part, dimension, mistakes));
  if (mistakes.size() > before) return;
  const double steps = ends.size() == 3 ? (ends[1] - ends[0]) / ends[2] : -1.0;
  if (!(steps >= 0.0 && std::round(steps) <= kMostSteps) || std::abs(steps - std::round(steps)) > kWhole) {
    mistakes.push_back(
        fmt::format("{}: found {}; required: FROM : TO : STEP, where at most {} steps lead from "
                    "FROM to TO",
                    option, quote(text), kMostSteps));
    return;
  }
  for (int i = 0; i <= static_cast<int>(std::lround(steps)); ++i) values.push_back(ends[0] + i * ends[2]);
}

}  // namespace

std::vector<double> quantity_list(const std::string& option, const std::string& text,
                                  const Dimension& dimension, const ListRange& range,
                                  std::vector<std::string>& mistakes) {
  std::vector<double> values;
  for (const std::string& part : parts_of(text, ',')) {
    const std::size_t before = values.size(), wrong = mistakes.size();
    if (part.find(':') != std::string::npos)
      append_range(option, part, dimension, values, mistakes);
    else
      values.push_back(option_quantity(option, part, dimension, mistakes));
    const bool inside =
        std::all_of(values.begin() + static_cast<std::ptrdiff_t>(before), values.end(),
                    [&](double value) { return value >= range.least && value <= range.most; });
    if (!inside && mistakes.size() == wrong)
      mistakes.push_back(fmt::format("{}: found {}; required: {}", option, quote(part), range.words));
  }
  return values;
}

namespace {

namespace crowning = analysis::crowning;

constexpr Dimension kTilt{"angle", "rad", "mrad", "1 mrad"};
constexpr Dimension kDrop{"length", "m", "um", "5 um"};
constexpr int kLaminae = 40;             // of a case that does not cut its rollers
constexpr double kMostTilt = 0.1;        // [rad]  far beyond any mounting
constexpr double kShareRoundOff = 1e-6;  // of a sum of shares that were rounded for typing

using Mistakes = std::vector<std::string>;

// About 1/5 of the standard's drop, a round number of its decade; sixteen of them reach well beyond the best.
std::vector<double> default_drops(const bearing::Bearing& bearing) {
  const double fifth = crowning::reference_drop(bearing) / 5.0;
  const double decade = std::pow(10.0, std::floor(std::log10(fifth)));
  const double step = decade * (fifth >= 5.0 * decade ? 5.0 : fifth >= 2.0 * decade ? 2.0 : 1.0);
  std::vector<double> drops;
  for (int i = 0; i <= 16; ++i) drops.push_back(i * step);
  return drops;
}

bool states_computed_tilt(const ResolvedCase& resolved) {
  const std::string& state = keys().tilt;
  return resolved.has(state) && resolved.choice(state) == "computed";
}

// Input of the case that prevents a computed tilt by default; empty: none.
std::string reason_to_state(const ResolvedCase& resolved) {
  if (resolved.shape().several) return "several sets";
  if (resolved.has(keys().rim) && resolved.choice(keys().rim) == "elastic")
    return "gearset.planet_rim: elastic";
  if (const std::string uneven = unequal_loads_by(resolved); !uneven.empty()) return uneven;
  const std::string& wind_up = keys().wind_up;
  if (resolved.has(wind_up) && resolved.quantity(wind_up) != 0.0) return wind_up;
  return "";
}

std::vector<double> tilts_of(const CrownChoices& choices, bool computed, Mistakes& mistakes) {
  if (computed && !choices.tilts.empty())
    mistakes.push_back("--tilts: found together with bearing.tilt_state: computed; required: one of both");
  if (computed) return {0.0};
  if (choices.tilts.empty()) return {0.0, 1e-3, 2e-3};
  std::vector<double> tilts =
      quantity_list("--tilts", choices.tilts, kTilt, {0.0, kMostTilt, "tilts from 0 to 100 mrad"}, mistakes);
  std::sort(tilts.begin(), tilts.end());
  tilts.erase(std::unique(tilts.begin(), tilts.end()), tilts.end());
  return tilts;
}

std::vector<double> drops_of(const CrownChoices& choices, const bearing::Bearing& bearing,
                             Mistakes& mistakes) {
  if (choices.drops.empty()) return default_drops(bearing);
  const std::size_t before = mistakes.size();
  std::vector<double> drops =
      quantity_list("--drops", choices.drops, kDrop, {0.0, kMostDrop, "drops from 0 to 1000 um"}, mistakes);
  std::sort(drops.begin(), drops.end());
  drops.erase(std::unique(drops.begin(), drops.end()), drops.end());
  if (mistakes.size() == before && drops.back() <= 0.0)
    mistakes.push_back("--drops: found nothing above 0; required: at least one drop above 0 um");
  return drops;
}

double tolerance_of(const std::string& option, const std::string& text, const Dimension& dimension,
                    double most, const std::string& words, Mistakes& mistakes) {
  if (text.empty()) return 0.0;
  const double value = option_quantity(option, text, dimension, mistakes);
  if (!(value >= 0.0 && value < most))
    mistakes.push_back(
        fmt::format("{}: found {}; required: at least 0 and less than {}", option, quote(text), words));
  return value;
}

crowning::Distribution distribution_of(const CrownChoices& choices, bool computed, Mistakes& mistakes) {
  using enum crowning::Distribution;
  if (choices.distribution.empty()) return computed ? normal : worst;
  const crowning::Distribution stated = choices.distribution == name_of(normal)    ? normal
                                        : choices.distribution == name_of(uniform) ? uniform
                                                                                   : worst;
  if (!computed && stated != worst)
    mistakes.push_back("--distribution: found " + choices.distribution +
                       " together with stated tilts; required: worst, or computed tilts");
  if (choices.tolerance.empty() && choices.tilt_tolerance.empty())
    mistakes.push_back(
        "--distribution: found without a tolerance; required: --tolerance or --tilt-tolerance as well");
  return stated;
}

std::vector<double> shares_of(const CrownChoices& choices, std::size_t speeds, Mistakes& mistakes) {
  if (choices.shares.empty()) return std::vector<double>(speeds, 1.0 / static_cast<double>(speeds));
  std::vector<double> shares;
  double sum = 0.0;
  for (const std::string& part : parts_of(choices.shares, ',')) {
    const Reading<double> share = read_number(part);
    if (!share.value || *share.value <= 0.0) {
      mistakes.push_back(fmt::format("--shares: found {}; required: numbers above 0", quote(part)));
      return {};
    }
    shares.push_back(*share.value);
    sum += *share.value;
  }
  if (shares.size() != speeds)
    mistakes.push_back(fmt::format(
        "--shares: found {} of them; required: {}, one for each speed of the sweep", shares.size(), speeds));
  else if (std::abs(sum - 1.0) > kShareRoundOff)
    mistakes.push_back(fmt::format("--shares: found a sum of {:.6g}; required: 1", sum));
  for (double& share : shares) share /= sum;
  return shares;
}

// Points of the spectrum that the case states.
std::vector<crowning::SpectrumPoint> points_of(const LoadSpectrum& stated) {
  std::vector<crowning::SpectrumPoint> points;
  for (const LoadBin& bin : stated.bins)
    points.push_back({bin.turns() ? bin.speed : 0.0, bin.share, bin.entering_power()});
  return points;
}

std::vector<crowning::SpectrumPoint> spectrum_of(const ResolvedCase& resolved, const CrownChoices& choices,
                                                 Mistakes& mistakes) {
  if (const std::optional<LoadSpectrum> stated = load_spectrum(resolved)) {
    if (choices.spectrum || !choices.shares.empty())
      mistakes.push_back(
          "--spectrum, --shares: found with a case that states a spectrum; required: one of both");
    return points_of(*stated);
  }
  if (!choices.spectrum && choices.shares.empty()) return {{resolved.quantity(keys().speed), 1.0, {}}};
  const std::vector<SweepAxis>& axes = resolved.axes();
  if (std::none_of(axes.begin(), axes.end(),
                   [](const SweepAxis& axis) { return axis.path == keys().speed; })) {
    mistakes.push_back(
        "--spectrum: found a case without sweep.input.speed; required: the speeds of the spectrum there");
    return {};
  }
  const std::vector<double> speeds = swept_speeds(resolved);
  const std::vector<double> shares = shares_of(choices, speeds.size(), mistakes);
  std::vector<crowning::SpectrumPoint> spectrum;
  for (std::size_t i = 0; i < speeds.size() && i < shares.size(); ++i)
    spectrum.push_back({speeds[i], shares[i], resolved.with(keys().speed, speeds[i]).quantity(keys().power)});
  return spectrum;
}

std::vector<std::string> profiles_of(const CrownChoices& choices, const bearing::Bearing& bearing,
                                     Mistakes& mistakes) {
  const std::vector<std::string> known = crowning::family_names();
  const auto is_known = [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  };
  const std::string stated = bearing::profile::kind(bearing.rollers().profile);
  if (choices.profiles.empty()) return {is_known(stated) ? stated : "iso16281"};
  std::vector<std::string> names;
  for (const std::string& name : parts_of(choices.profiles, ',')) {
    if (!is_known(name))
      mistakes.push_back(
          fmt::format("--profile: found {}; required: {}", quote(name), fmt::join(known, ", ")));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

// Life for the comparison of crowns. Of the governing lives, those by C and P do not depend on the crown.
crowning::LifeMethod method_of(const ResolvedCase& resolved, const CrownChoices& choices) {
  const bool by_case = choices.life.empty() && life_method(resolved) == crowning::LifeMethod::iso16281;
  return by_case || choices.life == "iso16281" ? crowning::LifeMethod::iso16281
                                               : crowning::LifeMethod::lundberg_palmgren;
}

void require_bearing(const ResolvedCase& resolved) {
  if (resolved.model() != planetary_drivetrain)
    throw BadInput(resolved.origin("model") + ": model: found " + resolved.choice("model") +
                   "; required: planetary-drivetrain, for the crown of its planet bearings");
  if (!resolved.shape().several && !resolved.shape().bearing)
    throw BadInput(resolved.file() +
                   ": bearing: missing; required: a planet bearing, whose rollers are crowned");
}

analysis::NamedSet set_of(const ResolvedCase& resolved, const CrownChoices& choices) {
  std::vector<analysis::NamedSet> sets = bearing_sets(resolved);
  const auto named =
      std::find_if(sets.begin(), sets.end(), [&](const auto& set) { return set.name == choices.of_set; });
  if (resolved.shape().several ? named != sets.end() : choices.of_set.empty())
    return std::move(resolved.shape().several ? *named : sets.front());
  std::vector<std::string> names;
  for (const analysis::NamedSet& set : sets)
    if (!set.name.empty()) names.push_back(set.name);
  throw BadInput(
      names.empty()
          ? fmt::format("--of: found {}; required: nothing, for the case has one set", quote(choices.of_set))
          : fmt::format("--of: found {}; required: the set whose planet bearing is meant: {}",
                        choices.of_set.empty() ? "nothing" : quote(choices.of_set), fmt::join(names, ", ")));
}

}  // namespace

nlohmann::ordered_json choices_json(const CrownChoices& choices) {
  CrownChoices shown = choices;
  return json_of(option_list(shown));
}

CrownChoices choices_from(const nlohmann::ordered_json& object) {
  nlohmann::ordered_json stated;
  for (const auto& [key, value] : object.items())
    if (value != "") stated[key] = value;
  CrownChoices choices;
  put_json(stated, option_list(choices));
  return choices;
}

std::string choices_text(const CrownChoices& choices) {
  std::string text = "crown";
  const nlohmann::ordered_json object = choices_json(choices);
  for (const auto& [name, value] : object.items()) {
    if (value == "" || value == false) continue;
    text += fmt::format(" --{} {}", name, value.is_string() ? value.get<std::string>() : value.dump());
  }
  return printable(text);
}

CrownCase crown_case(const ResolvedCase& resolved, const CrownChoices& choices) {
  require_bearing(resolved);
  if (!choices.tilts.empty() || states_computed_tilt(resolved)) return {resolved, {}};
  if (const std::string reason = reason_to_state(resolved); !reason.empty())
    return {
        resolved,
        {"tilts: stated, 0 to 2 mrad, and not computed together with " + reason + "; --tilts states others"}};
  std::vector<Setting> settings{{keys().tilt, "computed"}};
  if (!resolved.has(keys().laminae)) settings.push_back({keys().laminae, std::to_string(kLaminae)});
  return {resolved.with(settings), {}};
}

CrownRequest crown_request(const ResolvedCase& resolved, const CrownChoices& choices) {
  require_bearing(resolved);
  analysis::NamedSet set = set_of(resolved, choices);
  const bearing::Bearing& bearing = set.drivetrain.bearing;
  const bool computed = set.drivetrain.seats.tilt == analysis::TiltState::computed;
  Mistakes mistakes;
  CrownRequest request{.method = method_of(resolved, choices),
                       .laminae = bearing.rollers().laminae > 0 ? bearing.rollers().laminae : kLaminae,
                       .spectrum = spectrum_of(resolved, choices, mistakes),
                       .profiles = profiles_of(choices, bearing, mistakes),
                       .tilts = tilts_of(choices, computed, mistakes),
                       .drops = drops_of(choices, bearing, mistakes),
                       .drops_stated = !choices.drops.empty(),
                       .distribution = distribution_of(choices, computed, mistakes),
                       .starts = choices.starts};
  const double greatest = request.drops.empty() ? kMostDrop : request.drops.back();
  request.tolerance = {
      tolerance_of("--tolerance", choices.tolerance, kDrop, greatest,
                   fmt::format("the greatest drop, {:.6g} um", per_micro * greatest), mistakes),
      tolerance_of("--tilt-tolerance", choices.tilt_tolerance, kTilt, kMostTilt, "100 mrad", mistakes)};
  if (!mistakes.empty()) throw BadInput(mistakes);
  request.drivetrain = std::move(set.drivetrain);
  request.geometry = set.geometry;
  return request;
}

}  // namespace orbearing::app
