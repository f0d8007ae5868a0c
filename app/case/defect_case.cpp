#include "app/case/defect_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/case/arrangement_case.hpp"
#include "app/case/bearing_type.hpp"
#include "app/case/described_case.hpp"
#include "app/case/mistake.hpp"
#include "app/errors.hpp"
#include "bearing/geometry.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

void check_scratch_profile(CheckedCase& in) {
  if (!in.has("defect.form") || in.choice("defect.form") != "profile" ||
      (in.has("defect.profile") && in.list("defect.profile").size() >= 3))
    return;
  in.add_error_at("defect.form", "'profile' without three depths in defect.profile",
                  "at least three, at equal distances from edge to edge, are required");
}

// Mistakes in the scratch itself; `element` is a ball or a roller.
void check_scratch(CheckedCase& in, const char* element) {
  if (!in.has("defect.race") || in.choice("defect.race") == "none") return;
  check_scratch_profile(in);
  for (const char* path : {"defect.width", "defect.depth"})
    if (!in.has(path))
      in.add_error_at("defect.race", fmt::format("'{}' without {}", in.choice("defect.race"), path),
                      "width and depth of the scratch, or none, are required");
  const std::string diameter = fmt::format("bearing.{}_diameter", element);
  if (!in.has("defect.width") || !in.has(diameter)) return;
  // In a wider scratch an element would reach a depth without contact, which eq. 4 does not cover; two
  // elements share no scratch.
  const double widest = 0.5 * in.quantity(diameter);
  if (in.quantity("defect.width") > widest)
    in.add_error_at("defect.width",
                    fmt::format("{} for {}s that enter between its edges", in.given("defect.width"), element),
                    fmt::format("at most half a {} diameter, {:.4g} mm, is required", element, 1e3 * widest));
}

void check_band(CheckedCase& in) {
  if (!in.has("signal.band")) return;
  const std::vector<double> band = in.list("signal.band");
  const double highest = 0.5 * in.quantity("signal.sampling_rate");
  if (band.size() != 2 || !(band[0] < band[1]) || band[1] > highest)
    in.add_error_at("signal.band", in.given("signal.band"),
                    fmt::format("its lower and upper end, at most {:.4g} Hz, are required", highest));
}

void check_signal(CheckedCase& in) {
  if (in.has("operation.shaft_speed") && in.quantity("operation.shaft_speed") == 0.0)
    in.add_error_at("operation.shaft_speed", "a stationary shaft", "a speed is required");
  if (in.has("load.radial") && !(in.quantity("load.radial") > 0.0))
    in.add_error_at("load.radial", "no load", "a radial load greater than 0 N is required");
  if (!has_all(in, {"signal.sampling_rate", "signal.revolutions", "operation.shaft_speed"})) return;
  const double turns = std::abs(in.quantity("operation.shaft_speed")) / constants::two_pi;
  const double rate = in.quantity("signal.sampling_rate");
  if (turns == 0.0) return;
  const double samples =
      rate / turns * (in.number("signal.revolutions") + in.number("signal.settling_revolutions"));
  constexpr double most = 1e7;
  if (samples > most)
    in.add_error_at("signal.sampling_rate", fmt::format("{:.3g} samples in all", samples),
                    fmt::format("at most {:.0g}, by a lower rate or fewer revolutions, are required", most));
  if (rate < 100.0 * turns)
    in.add_error_at("signal.sampling_rate",
                    fmt::format("{} at {:.4g} revolutions a second", in.given("signal.sampling_rate"), turns),
                    fmt::format("at least 100 samples a revolution, {:.4g} Hz, are required", 100.0 * turns));
  check_band(in);
}

void check_planet_surface(CheckedCase& in) {
  if (!in.has("defect.race")) return;
  if (in.choice("defect.race") == "ball")
    in.add_error_at("defect.race", "'ball' in a bearing of rollers",
                    "outer, inner, roller or none is required");
  if (in.choice("defect.race") == "none") return;
  check_scratch(in, "roller");
  if (in.has("defect.form") && in.choice("defect.form") == "as-printed")
    in.add_error_at("defect.form", "'as-printed', which jumps at both edges",
                    "a continuous form is required where all of the bearing moves");
}

// Mistakes in the location of the scratch, for the set with the scratched bearing, whose inputs have `prefix`
// in the case.
void check_location(CheckedCase& in, const std::string& prefix) {
  const auto at_most = [&](const char* path, const char* count) {
    if (has_all(in, {path, count}) && in.integer(path) > in.integer(count))
      in.add_error_at(path, in.given(path),
                      fmt::format("at most {} ({}{}) is required", in.integer(count), prefix, count));
  };
  at_most("defect.planet", "gearset.planets");
  at_most("defect.bearing", "bearing.per_planet");
  at_most("defect.element", "bearing.rollers");
  check_band(in);
}

}  // namespace

namespace {

void check_planet_defect(CheckedCase& in, const std::string& prefix) {
  if (!in.has("defect.race"))
    in.mistakes.push_back(
        {{}, "defect.race", {"a block defect without it", "outer, inner, roller or none is required"}});
  check_planet_surface(in);
  check_location(in, prefix);
}

std::vector<std::string> sets_with_bearings(const ResolvedCase& in) {
  std::vector<std::string> names;
  for (const std::string& set : in.shape().sets)
    if (has_planet_bearing(in, set_prefix(set))) names.push_back(set);
  return names;
}

}  // namespace

void check_defect_of_sets(CheckedCase& in) {
  if (!is_planet_defect(in)) return;
  const std::string path(kScratchedSet);
  const std::vector<std::string> names = sets_with_bearings(in);
  const std::string required =
      fmt::format("the set with the scratched bearing, {}, is required", fmt::join(names, " or "));
  if (!in.has(path))
    return in.mistakes.push_back({{}, path, {"a block defect of several sets without it", required}});
  const std::string& set = in.text(path);
  if (std::ranges::find(names, set) == names.end()) return in.add_error_at(path, quote(set), required);
  CheckedCase of_set(in.of_set(set), in.mistakes);
  check_planet_defect(of_set, set_prefix(set));
  if (in.mistakes.empty() && !held_member_of(in, set))
    in.add_error_at(
        path, quote(set) + ", all of whose members rotate",
        "a set with a member on a shaft with 'ground' is required: a case does not state how stiffly "
        "other sets hold the rotation");
}

bool is_planet_defect(const ResolvedCase& in) {
  return in.model() == planetary_drivetrain && in.shape().defect && in.shape().bearing;
}

std::optional<gearset::Member> held_member_of(const ResolvedCase& in, const std::string& set) {
  const gearset::Arrangement arrangement = arrangement_of(in);
  for (const gearset::Shaft& shaft : arrangement.shafts)
    for (const gearset::SetMember& one : shaft.members)
      if (shaft.ground && arrangement.sets[one.set].name == set) return one.member;
  return std::nullopt;
}

bearing::defect::ScratchedBearing scratched_bearing_of(const ResolvedCase& in) {
  bearing::Bearing like{.elements = bearing::Balls{}};
  if (in.model() == roller_defect) like.elements = bearing::CylindricalRollers{};
  return {.bearing = from_case(in, like),
          .ring = from_case<bearing::defect::VibratingRing>(in),
          .load = in.quantity("load.radial"),
          .shaft_speed = in.quantity("operation.shaft_speed"),
          .scratch = from_case<bearing::defect::Scratch>(in)};
}

bearing::balls::MotionParameters scratched_motion_of(const ResolvedCase& in) {
  std::vector<std::string> missing;
  for (const char* path : {"bearing.cage.inner_diameter", "bearing.cage.outer_diameter", "bearing.cage.width",
                           "bearing.cage.density"})
    if (!in.has(path)) missing.emplace_back(path);
  if (!missing.empty())
    throw BadInput(
        fmt::format("--fidelity: found dynamic for a case without {}; required: all of them, since the cage "
                    "moves too, or no --fidelity",
                    fmt::join(missing, ", ")));
  return from_case<bearing::balls::MotionParameters>(in);
}

double scratched_length_error_of(const ResolvedCase& in) {
  return in.quantity("simulation.length_error");
}

study::Sampling sampling_of(const ResolvedCase& in) {
  return from_case<study::Sampling>(in);
}

std::optional<diagnosis::Band> stated_band_of(const ResolvedCase& in) {
  if (!in.has("signal.band")) return std::nullopt;
  const std::vector<double> band = in.list("signal.band");
  return diagnosis::Band{band.at(0), band.at(1)};
}

void check_defect(CheckedCase& in) {
  if (is_planet_defect(in)) return check_planet_defect(in, "");
  if ((in.model() & described::single_scratched) == 0) return;
  const bool rollers = in.model() == roller_defect;
  const char* const own = rollers ? "roller" : "ball";
  const char* const other = rollers ? "ball" : "roller";
  if (in.has("defect.race") && in.choice("defect.race") == other)
    in.add_error_at("defect.race", fmt::format("'{}' in a bearing of {}s", other, own),
                    fmt::format("outer, inner, {} or none is required", own));
  check_scratch(in, own);
  check_signal(in);
}

}  // namespace orbearing::app
