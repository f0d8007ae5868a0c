#include "app/study/sweep_warnings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

#include "app/case/catalogue_case.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/case/use_conditions.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/plausibility.hpp"
#include "coupling/analysis/drivetrain_warnings.hpp"
#include "coupling/analysis/multi_stage.hpp"
#include "coupling/analysis/one_way.hpp"
#include "coupling/analysis/operating_point.hpp"

namespace orbearing::app {

namespace {

constexpr analysis::OneWayOptions kOneWay;

// Those of the table, and of the bins of a spectrum: of idle ones, whose lives are next to endless, where
// `idle`.
std::vector<const SweepRow*> rows_of(const SweepOutcome& outcome, bool idle) {
  std::vector<const SweepRow*> rows;
  for (const SweepRow& row : outcome.rows) rows.push_back(&row);
  for (const SpectrumResult& result : outcome.spectra)
    for (const SpectrumBin& bin : result.bins)
      if (bin.row && (idle || bin.bin.power > LoadBin{}.entering_power())) rows.push_back(&*bin.row);
  return rows;
}

// Observations from speed and power at the slowest and the fastest point.
std::vector<Observation> observations_at_ends(const ResolvedCase& resolved, const SweepOutcome& outcome) {
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (const SweepRow& row : outcome.rows) {
    const double speed = speed_in_rpm(row.point.input_speed);
    least = std::min(least, speed);
    most = std::max(most, speed);
  }
  std::vector<Observation> found;
  if (!(most > 0.0)) return found;
  for (const double speed : {least, most})
    for (Observation& one : observations(resolved.without_sweep().with({input_speed(speed)})))
      if (one.key != kThinnestRim) found.push_back(std::move(one));  // which does not depend on the speed
  return found;
}

using Texts = std::vector<std::string>;

void add(const Texts& more, Texts& warnings) {
  warnings.insert(warnings.end(), more.begin(), more.end());
}

// Adds `text` where some rows satisfy `holds`, with how many do and the first of them.
void warn_where(const SweepOutcome& outcome, const std::string& text,
                const std::function<bool(const SweepRow&)>& holds, Texts& warnings) {
  const std::vector<const SweepRow*> rows = rows_of(outcome, true);
  std::vector<const SweepRow*> found;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(found),
               [&](const SweepRow* row) { return holds(*row); });
  if (!found.empty())
    warnings.push_back(fmt::format("{}: {} of {} points, first at {:g} rpm", text, found.size(), rows.size(),
                                   speed_in_rpm(found.front()->point.input_speed)));
}

// Bores whose motion depends on the meshes that hold them: what was solved one way, and what was not.
void warn_of_free_bores(const ResolvedCase& resolved, const SweepOutcome& outcome, Texts& warnings) {
  if (outcome.header.fidelity != "dynamic") return;
  const bool full = std::ranges::any_of(set_prefixes(resolved.shape()), [&](const std::string& set) {
    return is_full_complement(resolved, set);
  });
  const auto together = [](const SweepRow& row) { return row.point.exchange_window == 0.0; };
  const auto drag = [](const SweepRow& row) {
    return row.point.motion ? row.point.motion->drag_over_traction.value_or(not_given) : not_given;
  };
  const std::string why = fmt::format(
      "the motion of the bore depends on the meshes that hold it where a bearing has no cage, or "
      "is lightly loaded (column drag_over_traction above {:g})",
      analysis::kLightLoad);
  warn_where(outcome,
             fmt::format("--fidelity dynamic: {}. Gears and bearings are solved as one system there, as by "
                         "--fidelity monolithic",
                         why),
             together, warnings);
  const bool squeezed = stated_sets(resolved).front().drivetrain.dynamics.race.squeeze;
  const char* advice =
      squeezed ? "drag_slip takes loads at rest: use cage_slip" : "Compare with contact.squeeze: true";
  warn_where(
      outcome,
      fmt::format(
          "cage_slip differs by more than {:g} from drag_slip, that of the loads at rest. Rollers that "
          "bounce, or a bore that whirls, may hold such a state up. {}",
          analysis::kDragSlipError, advice),
      [&](const SweepRow& row) {
        return drag(row) > analysis::kLightLoad &&
               std::abs(row.point.cage_slip - row.point.motion->drag_slip.value_or(not_given)) >
                   analysis::kDragSlipError;
      },
      warnings);
  const auto free = [&](const SweepRow& row) {
    return row.ok() && !together(row) && (full || drag(row) > analysis::kLightLoad);
  };
  if (std::ranges::none_of(rows_of(outcome, true), [&](const SweepRow* row) { return free(*row); })) return;
  const bool tried =
      std::ranges::any_of(bearing_sets(resolved.without_sweep()), [](const analysis::NamedSet& set) {
        return analysis::moves_with_its_gears(set.drivetrain, std::numeric_limits<double>::infinity());
      });
  const char* cause = tried
                          ? "As one system the motion could not be followed (--fidelity monolithic says why)"
                          : "Required for one system: one set, a steady speed and a stated tilt";
  warn_where(outcome,
             fmt::format("one way: {}. Here the bore is free under the load of the gears, and life and slip "
                         "are not reliable. {}",
                         why, cause),
             free, warnings);
}

constexpr double kOtherLife = 0.1;  // [-]  of the set's own life

// Compares the lives with those of the carrier as a body; warns where the carrier is not modelled so.
void warn_of_carrier(const ResolvedCase& resolved, const SweepOutcome& outcome, Texts& warnings) {
  const std::string stated = keys().carrier_bearings;
  if (!resolved.has(stated)) return;
  if (outcome.header.fidelity != "quasi-static") {
    if (carrier_is_body(resolved, ""))
      warnings.push_back(fmt::format(
          "gearset.carrier: --fidelity {} does not include the carrier as a body. Loads, lives and verdicts "
          "are those of the set in its plane. The worst bearing over a revolution is in the run at rest",
          outcome.header.fidelity));
    return;
  }
  if (!carrier_is_body(resolved, ""))
    warnings.push_back(stated +
                       ": the carrier is not taken as a body; required: one set with bearings, "
                       "gearset.fixed: ring, gearset.planet_rim: rigid");
  const std::string& life = outcome.header.life;
  warn_where(
      outcome,
      fmt::format("gearset.carrier: over a revolution of the carrier the worst planet bearing has a {0} "
                  "that differs by more than {1:g} % from that of the set in its plane (columns carrier_{0} "
                  "and {0})",
                  life, 100.0 * kOtherLife),
      [&](const SweepRow& row) {
        const analysis::PointRow& point = row.point;
        const auto hours = [&](double life_hours, const bearing::rating::RatedHours& rated) {
          return governing_hours(outcome.header, life_hours, rated);
        };
        const double shortest = hours(point.unlike.shortest_hours, point.unlike.shortest_rated);
        const double own = std::isfinite(shortest) ? shortest : governing_hours(outcome.header, point);
        return point.carrier && std::abs(hours(point.carrier->life_hours, point.carrier->rated_hours) / own -
                                         1.0) > kOtherLife;
      },
      warnings);
  warn_where(
      outcome,
      "gearset.carrier: weight, rotor or errors of the pins lift gears off their driving flanks, and their "
      "back flanks carry (column carrier_back_flank_load_N)",
      [](const SweepRow& row) { return row.point.carrier && row.point.carrier->back_flank_load > 0.0; },
      warnings);
}

// Sets so slow that rollers and cage follow gravity, which a case does not state: where weight is beside the
// field of the carrier and that of the rollers' own orbit.
void warn_of_weight(const ResolvedCase& resolved, const SweepOutcome& outcome, Texts& warnings) {
  if (is_stated(resolved, keys().gravity)) return;
  constexpr double gravity = 9.80665, share = 0.3;  // [m/s2], [-]  of the larger field
  const ResolvedCase at_point = resolved.without_sweep();
  for (const analysis::NamedSet& set : bearing_sets(at_point)) {
    const double field = analysis::inertial_field(set);  // [m/s2]
    const double input = speed_in_rpm(set.drivetrain.drive.speed);
    const auto at = [&](const SweepRow& row) {
      return field * std::pow(speed_in_rpm(row.point.input_speed) / input, 2);
    };
    warn_where(
        outcome,
        fmt::format("inertia.gravity: {}not stated, so motion leaves weight out, and gravity is more than "
                    "{:g} of the inertial fields of carrier and rollers there. Slip, impacts and unloaded "
                    "rollers of sets as slow follow gravity; loads of the meshes and lives hardly do. State "
                    "inertia.gravity: 9.81 m/s2 for a horizontal axis, or 0 m/s2 for a vertical one",
                    set.name.empty() ? "" : set.name + ": ", share),
        [&](const SweepRow& row) { return row.ok() && at(row) * share < gravity; }, warnings);
  }
}

// Motions that did not settle, and gears and bearings that one way or an exchange did not bring together.
void warn_of_motions(const SweepOutcome& outcome, Texts& warnings) {
  warn_where(
      outcome, "simulation.most_revolutions: the means still drifted at the end; allow more revolutions",
      [](const SweepRow& row) { return row.point.motion && !row.point.motion->steady; }, warnings);
  const auto is_displaced = [](const SweepRow& row) {
    return row.point.motion &&
           row.point.motion->one_way_load_difference.value_or(0.0) > kOneWay.load_difference;
  };
  warn_where(
      outcome,
      fmt::format("one way: no fitted model of the bearings agrees with a run (columns one_way_...). Where "
                  "there were fewer than {} runs, the gears diverge on the last model. --fidelity "
                  "monolithic requires no such model",
                  kOneWay.most_runs),
      [&](const SweepRow& row) {
        return row.point.one_way && !row.point.one_way->accepted && !is_displaced(row);
      },
      warnings);
  warn_where(
      outcome,
      fmt::format("one way: the gears' mean force on the planet bearings differs by more than {:g} % from "
                  "the load of the bearing run (column one_way_load_difference). One cause: displaced "
                  "planets use up the backlash. --fidelity monolithic includes this",
                  100.0 * kOneWay.load_difference),
      is_displaced, warnings);
  // docs/coupled_steady_state.md: lives by the window of the exchange and its residual.
  constexpr double most_residual = 0.01;  // [-]
  warn_where(
      outcome,
      fmt::format(
          "co-simulation: the exchange makes or loses more than {:g} % of the power that passes (column "
          "interface_energy_residual). Its pushes load the bearings: in the 150 kW reducer loads are 4 % too "
          "large and lives 4 % too short where it is 1.1 %, 42 % and 45 % where it is 6.5 %. Use "
          "simulation.exchange.extrapolation: 1, a shorter simulation.exchange.window, or "
          "--fidelity monolithic",
          100.0 * most_residual),
      [](const SweepRow& row) { return row.point.exchange_residual > most_residual; }, warnings);
}

bool has_elastic_rim(const std::vector<analysis::NamedSet>& sets) {
  return std::ranges::any_of(
      sets, [](const auto& set) { return set.drivetrain.rim == analysis::PlanetRim::elastic; });
}

}  // namespace

std::vector<std::string> sweep_warnings(const ResolvedCase& resolved, const SweepOutcome& outcome,
                                        const FoundPeak& found) {
  const std::vector<analysis::NamedSet> sets = stated_sets(resolved);
  Texts warnings = gear_warnings(resolved);
  add(require_used(resolved, rung_of(resolved, outcome.header.fidelity), Axes::all), warnings);
  add(found.warnings, warnings);
  add(overturning_warnings(resolved.without_sweep()), warnings);
  add(slope_warnings(resolved), warnings);
  if (in_time(fidelity_of(outcome.header.fidelity))) {
    add(planar_warnings(resolved), warnings);
    add(analysis::cage_warnings(sets), warnings);
    warn_of_weight(resolved, outcome, warnings);
  }
  add(analysis::clearance_warnings(sets), warnings);
  add(rim_warnings(resolved.without_sweep()), warnings);
  add(analysis::lamina_warnings(sets), warnings);
  add(rating_warnings(resolved), warnings);
  warn_of_carrier(resolved, outcome, warnings);
  warn_of_free_bores(resolved, outcome, warnings);
  if (outcome.header.fidelity == "quasi-static" && has_elastic_rim(sets))
    add(analysis::soft_rim_warnings(bearing_sets(resolved.without_sweep())), warnings);
  add(rare_values(rows_of(outcome, false)), warnings);
  add(judge(observations_at_ends(resolved, outcome)).warnings, warnings);
  warn_of_motions(outcome, warnings);
  return warnings;
}

}  // namespace orbearing::app
