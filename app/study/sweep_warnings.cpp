#include "app/study/sweep_warnings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "app/case/catalogue_case.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/case/use_conditions.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/plausibility.hpp"
#include "bearing/life/rating_lives.hpp"
#include "coupling/study/multi_stage.hpp"
#include "coupling/study/one_way.hpp"
#include "coupling/study/operating_point.hpp"

namespace orbearing::app {

namespace {

constexpr study::OneWayOptions kOneWay;

// Those of the table, and of the bins of a spectrum: of idle ones, whose lives are next to endless, where
// `idle`.
std::vector<const ResultRow*> rows_of(const SweepOutcome& outcome, bool idle) {
  std::vector<const ResultRow*> rows;
  for (const ResultRow& row : outcome.rows) rows.push_back(&row);
  for (const SpectrumResult& result : outcome.spectra)
    for (const SpectrumBin& bin : result.bins)
      if (bin.row && (idle || bin.bin.power > LoadBin{}.entering_power())) rows.push_back(&*bin.row);
  return rows;
}

// What speed and power say at the slowest and the fastest point.
std::vector<Observation> observations_at_ends(const ResolvedCase& resolved, const SweepOutcome& outcome) {
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (const ResultRow& row : outcome.rows) {
    const double speed = value_of(outcome.head, row, "input_speed_rpm");
    least = std::min(least, speed);
    most = std::max(most, speed);
  }
  std::vector<Observation> found;
  if (!(most > 0.0)) return found;
  for (const double speed : {least, most})
    for (Observation& one : observations(resolved.without_sweep().with({input_speed(speed)})))
      found.push_back(std::move(one));
  return found;
}

// How many rows satisfy `holds`, and the first of them, in words.
std::string rows_where(const SweepOutcome& outcome, const std::function<bool(const ResultRow&)>& holds) {
  std::size_t count = 0;
  std::string first;
  const std::vector<const ResultRow*> rows = rows_of(outcome, true);
  for (const ResultRow* row : rows) {
    if (!holds(*row)) continue;
    if (count++ == 0) first = fmt::format("{:g} rpm", value_of(outcome.head, *row, "input_speed_rpm"));
  }
  return count == 0 ? "" : fmt::format("{} of {} points, first at {}", count, rows.size(), first);
}

// Where a profile or a tilt is resolved by so few that they hardly show it.
std::vector<std::string> lamina_warnings(const ResolvedCase& resolved) {
  constexpr int enough = 10;  // within 2 % of the life of many, the wind turbine's planets
  std::vector<std::string> warnings;
  for (const std::string& prefix : prefixes_of_sets(resolved)) {
    const auto has = [&](const char* path) { return resolved.has(prefix + path); };
    if (!has("bearing.laminae") || resolved.integer(prefix + "bearing.laminae") >= enough) continue;
    const bool computed =
        has("bearing.tilt_state") && resolved.choice(prefix + "bearing.tilt_state") == "computed";
    if (!computed && !has("bearing.profile.kind") && !has("bearing.misalignment.planet_tilt") &&
        !has("bearing.misalignment.carrier_wind_up"))
      continue;
    warnings.push_back(
        fmt::format("{}bearing.laminae: {} resolve a profile or a tilt coarsely (one: not at all), which "
                    "affects loads and lives. Use {} or more",
                    prefix, resolved.integer(prefix + "bearing.laminae"), enough));
  }
  return warnings;
}

// Where lives go by ISO/TS 16281, whose stress riser depends on the number of laminae.
std::vector<std::string> rated_lamina_warnings(const ResolvedCase& resolved) {
  constexpr int least = bearing::rating::kLeastRatedLaminae;
  std::vector<std::string> warnings;
  if (resolved.choice("life.method") != "iso-16281") return warnings;
  for (const std::string& prefix : prefixes_of_sets(resolved)) {
    const std::string path = prefix + "bearing.laminae";
    if (resolved.has(path) && resolved.integer(path) > 0 && resolved.integer(path) < least)
      warnings.push_back(fmt::format("{}: {} laminae; ISO/TS 16281 requires at least {} for L10rh and L10mrh",
                                     path, resolved.integer(path), least));
  }
  return warnings;
}

// Rims softer than that of the longest life: a stiffer one is tried at the case's own speed and power.
std::vector<std::string> rim_warnings(const ResolvedCase& resolved, const SweepOutcome& outcome) {
  constexpr double stiffer = 2.0, gain_told = 0.02;  // as well as influences agree with finite elements
  std::vector<std::string> warnings;
  if (outcome.header.fidelity != "quasi-static") return warnings;
  const std::vector<std::string> prefixes = prefixes_of_sets(resolved);
  if (std::ranges::none_of(prefixes, [&](const std::string& set) {
        const std::string rim = set + "gearset.planet_rim";
        return resolved.has(rim) && resolved.choice(rim) == "elastic";
      }))
    return warnings;
  const std::vector<study::NamedSet> sets = bearing_sets(resolved.without_sweep());
  for (const study::NamedSet& set : sets) try {
      const double gain = study::gain_by_stiffer_rim(set.drivetrain, set.geometry, stiffer);
      if (gain > gain_told)
        warnings.push_back(
            fmt::format("{}gearset.planet_rim: the rim is softer than that of the longest life. Twice as "
                        "stiff, the life at "
                        "{:g} rpm is {:.3g} % longer. Increase its thickness or the modulus of its material",
                        sets.size() > 1 ? set_prefix(set.name) : "",
                        set.drivetrain.drive.speed * 30.0 / std::numbers::pi, 100.0 * gain));
    } catch (const std::runtime_error&) {  // no equilibrium there, which its own row says
    }
  return warnings;
}

// Bores whose motion depends on the meshes that hold them: what was solved one way, and what was not.
std::vector<std::string> free_bore_warnings(const ResolvedCase& resolved, const SweepOutcome& outcome) {
  std::vector<std::string> warnings;
  if (outcome.header.fidelity != "dynamic") return warnings;
  const std::vector<std::string> sets = prefixes_of_sets(resolved);
  const bool full =
      std::ranges::any_of(sets, [&](const std::string& set) { return is_full_complement(resolved, set); });
  const auto together = [&](const ResultRow& row) {
    return value_of(outcome.head, row, "interface_window_us") == 0.0;
  };
  const std::string why = fmt::format(
      "the motion of the bore depends on the meshes that hold it where a bearing has no cage, or "
      "is lightly loaded (column drag_slip above {:g} %)",
      100.0 * study::kLightSlip);
  const std::string solved = rows_where(outcome, together);
  if (!solved.empty())
    warnings.push_back(fmt::format(
        "--fidelity dynamic: {}. Gears and bearings are solved as one system there, as by --fidelity "
        "monolithic: {}",
        why, solved));
  // Another state than the closed form has: as close as the two come where oil is squeezed.
  constexpr double share = 0.15, creep = 0.003;
  const std::string whirling = rows_where(outcome, [&](const ResultRow& row) {
    const double slip = value_of(outcome.head, row, "drag_slip");
    return slip > study::kLightSlip &&
           std::abs(value_of(outcome.head, row, "cage_slip") - slip) > share * slip + creep;
  });
  if (!whirling.empty())
    warnings.push_back(fmt::format(
        "cage_slip differs by more than {:g} % from the slip by drag against traction (drag_slip). "
        "Rollers that bounce, or a bore that whirls, may hold such a state up. Compare with "
        "contact.squeeze: true: {}",
        100.0 * share, whirling));
  const std::string free = rows_where(outcome, [&](const ResultRow& row) {
    return row.ok() && !together(row) &&
           (full || value_of(outcome.head, row, "drag_slip") > study::kLightSlip);
  });
  if (!free.empty()) {
    const std::vector<study::NamedSet> bearings = bearing_sets(resolved.without_sweep());
    const bool tried = std::ranges::any_of(bearings, [](const study::NamedSet& set) {
      return study::moves_with_its_gears(set.drivetrain, std::numeric_limits<double>::infinity());
    });
    const char* cause =
        tried ? "As one system the motion could not be followed (--fidelity monolithic says why)"
              : "Required for one system: one set, a steady speed and a stated tilt";
    warnings.push_back(
        fmt::format("one way: {}. Here the bore is free under the load of the gears, and life and slip are "
                    "not reliable. {}: {}",
                    why, cause, free));
  }
  return warnings;
}

constexpr double kOtherLife = 0.1;  // [-]  of the set's own life

// What the carrier as a body says of the lives beside it, and where it is none.
std::vector<std::string> carrier_warnings(const ResolvedCase& resolved, const SweepOutcome& outcome) {
  std::vector<std::string> warnings;
  const std::string stated = "gearset.carrier.bearing_positions";
  if (outcome.header.fidelity != "quasi-static" || !resolved.has(stated)) return warnings;
  if (!carrier_is_body(resolved, ""))
    warnings.push_back(stated +
                       ": the carrier is not taken as a body; required: one set with bearings, "
                       "gearset.fixed: ring, gearset.planet_rim: rigid");
  const auto column = [&](const ResultRow& row, const std::string& name) {
    return value_of(outcome.head, row, name);
  };
  const std::string life = outcome.head.life;
  const std::string unlike = rows_where(outcome, [&](const ResultRow& row) {
    const double shortest = column(row, "shortest_" + life);
    const double own = std::isfinite(shortest) ? shortest : column(row, life);
    return std::abs(column(row, "carrier_" + life) / own - 1.0) > kOtherLife;
  });
  if (!unlike.empty())
    warnings.push_back(
        fmt::format("gearset.carrier: over a revolution of the carrier the worst planet bearing has a {0} "
                    "that differs by "
                    "more than {1:g} % from that of the set in its plane (columns carrier_{0} and {0}): {2}",
                    life, 100.0 * kOtherLife, unlike));
  const std::string lifted = rows_where(
      outcome, [&](const ResultRow& row) { return column(row, "carrier_back_flank_load_N") > 0.0; });
  if (!lifted.empty())
    warnings.push_back(
        "gearset.carrier: weight, rotor or errors of the pins lift gears off their driving flanks, and their "
        "back flanks carry (column carrier_back_flank_load_N): " +
        lifted);
  return warnings;
}

}  // namespace

std::vector<std::string> sweep_warnings(const ResolvedCase& resolved, const SweepOutcome& outcome,
                                        const FoundPeak& found) {
  std::vector<std::string> warnings = gear_warnings(resolved);
  const std::vector<std::string> unused =
      require_used(resolved, rung_of(resolved, outcome.header.fidelity), Axes::all);
  warnings.insert(warnings.end(), unused.begin(), unused.end());
  warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
  const auto add = [&warnings](const std::vector<std::string>& more) {
    warnings.insert(warnings.end(), more.begin(), more.end());
  };
  add(overturning_warnings(resolved.without_sweep()));
  add(slope_warnings(resolved));
  if (in_time(fidelity_of(outcome.header.fidelity))) {
    add(planar_warnings(resolved));
    add(cage_warnings(resolved));
  }
  add(clearance_warnings(resolved));
  add(lamina_warnings(resolved));
  add(rated_lamina_warnings(resolved));
  add(oil_warnings(resolved));
  const auto column = [&](const ResultRow& row, const char* name) {
    return value_of(outcome.head, row, name);
  };
  add(carrier_warnings(resolved, outcome));
  add(free_bore_warnings(resolved, outcome));
  add(rim_warnings(resolved, outcome));
  add(rare_values(outcome.head, rows_of(outcome, false)));
  add(judge(observations_at_ends(resolved, outcome)).warnings);
  const std::string drifting =
      rows_where(outcome, [&](const ResultRow& row) { return column(row, "steady") == 0.0; });
  if (!drifting.empty())
    warnings.push_back(
        "simulation.most_revolutions: the means still drifted at the end; allow more revolutions: " +
        drifting);
  const auto is_displaced = [&](const ResultRow& row) {
    return column(row, "one_way_load_difference") > kOneWay.load_difference;
  };
  const std::string unsettled = rows_where(outcome, [&](const ResultRow& row) {
    return column(row, "one_way_accepted") == 0.0 && !is_displaced(row);
  });
  if (!unsettled.empty())
    warnings.push_back(
        fmt::format("one way: no fitted model of the bearings agrees with a run (columns one_way_...). Where "
                    "there were fewer than {} runs, the gears diverge on the last model. --fidelity "
                    "monolithic requires no such model: {}",
                    kOneWay.most_runs, unsettled));
  const std::string displaced = rows_where(outcome, is_displaced);
  if (!displaced.empty())
    warnings.push_back(
        fmt::format("one way: the gears' mean force on the planet bearings differs by more than {:g} % from "
                    "the load of the bearing run (column one_way_load_difference). One cause: displaced "
                    "planets use up the backlash. --fidelity monolithic includes this: {}",
                    100.0 * kOneWay.load_difference, displaced));
  return warnings;
}

}  // namespace orbearing::app
