#include "app/study/report_data.hpp"

#include <fmt/format.h>
#include <Eigen/Core>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/results/json_number.hpp"
#include "app/results/progress.hpp"
#include "app/study/effects.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/gear_report.hpp"
#include "app/study/life_peak.hpp"
#include "app/study/lives_of_sweep.hpp"
#include "app/study/missing_points.hpp"
#include "app/study/named_change.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/published_comparison.hpp"
#include "app/study/speed_slice.hpp"
#include "app/study/sweep_study.hpp"
#include "app/study/sweep_warnings.hpp"
#include "app/study/validation_table.hpp"
#include "app/units.hpp"
#include "coupling/study/drivetrain.hpp"
#include "coupling/study/scheme_convergence.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

std::string how(const cosim::CoupledOptions& exchange, const std::string& fidelity) {
  if (fidelity_of(fidelity) == study::Fidelity::monolithic)
    return "gears and all bearings as one system of equations";
  const char* order = exchange.order == cosim::ExchangeOrder::jacobi ? "Jacobi" : "Gauss-Seidel";
  return fmt::format("co-simulated, {} exchange of degree {} in windows of at most {:.3g} \u00b5s{}", order,
                     exchange.extrapolation, per_micro * exchange.window,
                     exchange.iteration.most_passes > 1
                         ? fmt::format(", each repeated up to {} times", exchange.iteration.most_passes)
                         : "");
}

Json one_way_curve(const ChangeResult& one_way, const std::vector<double>& speeds_rpm) {
  Json curve{{"speed_rpm", speeds_rpm}, {"life_h", Json::array()}, {"outer_load_rms_N", Json::array()}};
  for (const study::PointResult& point : one_way.points) {
    curve["life_h"].push_back(number_or_null(life_of(point)));
    curve["outer_load_rms_N"].push_back(is_computed(point.status) ? number_or_null(point.outer.load_rms)
                                                                  : Json());
  }
  return curve;
}

Json convergence(const study::PlanetaryDrivetrain& drivetrain) {
  const study::SchemeConvergence found =
      study::scheme_convergence(drivetrain, study::derive(drivetrain), study::common_schemes());
  Json object{{"path_ms", per_milli * found.path},
              {"speed_rpm", kRpm * drivetrain.drive.speed},
              {"rows", Json::array()},
              {"orders", Json::array()}};
  for (const study::SchemeError& error : found.errors)
    object["rows"].push_back({{"scheme", error.scheme},
                              {"window_us", per_micro * error.window},
                              {"force_error", number_or_null(error.force_error)},
                              {"energy_residual", number_or_null(error.energy_residual)}});
  for (const study::SchemeOrder& order : found.orders)
    object["orders"].push_back({{"scheme", order.scheme},
                                {"expected", order.expected},
                                {"measured", number_or_null(order.measured)},
                                {"stability_limit_us", number_or_null(per_micro * order.stability_limit)}});
  return object;
}

// Keys: `how` (the exchange in words), `one_way` (speeds and lives of the bearing that the gears drive
// without feeling it, at the speeds of the sweep) and `convergence` (errors, orders and stability limits of
// the schemes at the drivetrain's own speed).
Json coupled_report(const study::PlanetaryDrivetrain& drivetrain, const std::vector<double>& speeds_rpm,
                    const ChangeResult& one_way, const std::string& fidelity) {
  return {{"how", how(drivetrain.exchange, fidelity)},
          {"one_way", one_way_curve(one_way, speeds_rpm)},
          // One system exchanges nothing.
          {"convergence",
           fidelity_of(fidelity) == study::Fidelity::monolithic ? Json(nullptr) : convergence(drivetrain)}};
}

using Json = nlohmann::ordered_json;
constexpr int kFinePoints = 221;

Json scaled(const std::vector<double>& values, double factor) {
  Json list = Json::array();
  for (const double value : values) list.push_back(value * factor);
  return list;
}

std::vector<double> fine_speeds(const LifeCurve& grid) {
  const auto [low, high] = std::minmax_element(grid.speed_rpm.begin(), grid.speed_rpm.end());
  const Eigen::ArrayXd speeds = Eigen::ArrayXd::LinSpaced(kFinePoints, *low / kRpm, *high / kRpm);
  return {speeds.begin(), speeds.end()};
}

study::PointResult point_at(study::PlanetaryDrivetrain drivetrain, study::DrivetrainGeometry geometry,
                            double speed) {
  study::turn_at(speed, drivetrain, geometry);
  return study::evaluate(drivetrain, geometry);
}

Json fine_curve(const study::PlanetaryDrivetrain& drivetrain, const study::DrivetrainGeometry& geometry,
                const std::vector<double>& speeds) {
  Json curve{{"speed_rpm", scaled(speeds, kRpm)}};
  for (const double speed : speeds) {
    const study::PointResult point = point_at(drivetrain, geometry, speed);
    curve["life_h"].push_back(point.life_hours);
    curve["planet_load_N"].push_back(point.planet_load);
    curve["tangential_load_N"].push_back(point.tangential_load);
    curve["radial_mesh_load_N"].push_back(point.radial_mesh_load);
    curve["centrifugal_load_N"].push_back(point.centrifugal_load);
  }
  return curve;
}

// Speeds of the sweep nearest to the lowest, the best and the highest: what the polar plots show. `peak`: the
// best by another model too, where it is a number.
std::vector<double> shown_speeds(const LifeCurve& grid, double peak = std::nan("")) {
  const auto [low, high] = std::minmax_element(grid.speed_rpm.begin(), grid.speed_rpm.end());
  std::vector<double> speeds{*low, property(grid, "peak_speed_rpm"), *high};
  if (std::isfinite(peak)) speeds.push_back(peak);
  std::sort(speeds.begin(), speeds.end());
  speeds.erase(std::unique(speeds.begin(), speeds.end()), speeds.end());
  return speeds;
}

double best_speed_rpm(const LifePeak& peak) {
  return std::isfinite(peak.refined_speed_rpm) ? peak.refined_speed_rpm : peak.speed_rpm;
}

Json polar(const study::PlanetaryDrivetrain& drivetrain, const study::DrivetrainGeometry& geometry,
           const std::vector<double>& speeds_rpm) {
  Json list = Json::array();
  for (const double rpm : speeds_rpm) {
    const study::PointResult point = point_at(drivetrain, geometry, rpm / kRpm);
    list.push_back({{"speed_rpm", rpm},
                    {"angle_deg", scaled(point.distribution.angle, kDegree)},
                    {"inner_load_N", point.distribution.inner_load},
                    {"outer_load_N", point.distribution.outer_load},
                    {"planet_load_x_N", point.radial_mesh_load + point.centrifugal_load},
                    {"planet_load_y_N", point.tangential_load}});
  }
  return list;
}

Json drawing(const study::PlanetaryDrivetrain& drivetrain, const study::DrivetrainGeometry& geometry,
             double rpm) {
  const bearing::Bearing& b = drivetrain.bearing;
  const study::PointResult point = point_at(drivetrain, geometry, rpm / kRpm);
  const auto of_cage = [&](double length) { return b.has_cage() ? Json(length) : Json(); };
  Json drawn{{"speed_rpm", rpm},
             {"inner_raceway_diameter_mm", 2e3 * geometry.bearing.inner_radius},
             {"outer_raceway_diameter_mm", 2e3 * geometry.bearing.outer_radius},
             {"roller_diameter_mm", 1e3 * b.rollers().diameter},
             {"pitch_diameter_mm", 1e3 * b.pitch_diameter},
             {"rollers", b.rollers().count},
             {"cage_inner_mm", of_cage(1e3 * b.cage.inner_diameter)},
             {"cage_outer_mm", of_cage(1e3 * b.cage.outer_diameter)},
             {"bore_mm", 1e3 * b.inner.seat_diameter},
             {"outside_mm", 1e3 * b.outer.seat_diameter},
             {"guide_land_mm", of_cage(1e3 * drivetrain.dynamics.cage.guide_diameter)},
             {"clearance_um", 1e6 * b.radial_clearance}};
  const std::size_t stride = static_cast<std::size_t>(drivetrain.cage_positions);
  for (std::size_t position = 0; position < point.distribution.angle.size(); position += stride) {
    drawn["roller_angle_deg"].push_back(kDegree * point.distribution.angle[position]);
    drawn["inner_load_N"].push_back(point.distribution.inner_load[position]);
    drawn["outer_load_N"].push_back(point.distribution.outer_load[position]);
  }
  return drawn;
}

// Speeds at pure rolling relative to the carrier, as multiples of the input speed: what slip is measured
// against.
Json kinematics(const study::PlanetaryDrivetrain& drivetrain, const study::DrivetrainGeometry& geometry) {
  const study::BearingDuty duty = study::bearing_duty(drivetrain, geometry);
  const double inner = duty.point.inner_speed / drivetrain.drive.speed;
  const double outer = duty.point.outer_speed / drivetrain.drive.speed;
  return {{"inner_race", inner},
          {"outer_race", outer},
          {"cage", bearing::kinematic_cage_speed(geometry.bearing, inner, outer)},
          {"roller_spin", bearing::kinematic_roller_spin(geometry.bearing, inner, outer)},
          {"carrier", duty.gears.carrier_speed / drivetrain.drive.speed}};
}

Json axes_json(const ManifestHeader& header) {
  Json list = Json::array();
  for (const SweptAxis& axis : header.axes)
    list.push_back({{"column", axis.column}, {"units", axis.units}, {"meaning", axis.meaning}});
  return list;
}

const study::NamedSet& set_named(const std::vector<study::NamedSet>& sets, const std::string& name) {
  return *std::find_if(sets.begin(), sets.end(),
                       [&](const study::NamedSet& set) { return set.name == name; });
}

// Of the bearing shown, on the gears as the case states them: an effect is switched in the bearing alone.
ChangeStudy of_one_bearing(const study::NamedSet& shown, const std::vector<double>& speeds,
                           study::Fidelity fidelity) {
  return {.speed = speeds,
          .fidelity = fidelity,
          .evaluate = [name = shown.name, gears = shown.drivetrain.gear_set](
                          const std::vector<study::NamedSet>& sets, study::Fidelity level) {
            study::NamedSet one = set_named(sets, name);
            one.drivetrain.gear_set = gears;
            return study::evaluate(one.drivetrain, one.geometry, level);
          }};
}

std::vector<double> radians_per_second(const std::vector<double>& speeds_rpm) {
  std::vector<double> speeds;
  for (const double rpm : speeds_rpm) speeds.push_back(rpm / kRpm);
  return speeds;
}

Json effect_curves(const ResolvedCase& resolved, const study::NamedSet& shown,
                   const std::vector<double>& speeds) {
  Json list = Json::array();
  for (const ChangeResult& result :
       results_of(resolved, effects_at_rest(resolved, shown.name),
                  of_one_bearing(shown, speeds, study::Fidelity::quasi_static))) {
    const std::size_t best = best_point(result);
    list.push_back({{"name", result.change.name},
                    {"group", result.change.group},
                    {"speed_rpm", scaled(speeds, kRpm)},
                    {"life_h", Json::array()},
                    {"peak_speed_rpm", kRpm * speeds[best]},
                    {"peak_life_h", number_or_null(life_of(result.points[best]))}});
    for (const study::PointResult& point : result.points)
      list.back()["life_h"].push_back(number_or_null(life_of(point)));
  }
  return list;
}

Json effects_in_time(const ResolvedCase& resolved, const study::NamedSet& shown,
                     const std::vector<double>& speeds_rpm, bool every_effect, bool progress) {
  const std::vector<NamedChange> effects = effects_in_motion(resolved, every_effect, shown.name);
  Progress bar(0, effects.size() * speeds_rpm.size(), progress, "effects: ");
  const std::vector<ChangeResult> results = results_of(
      resolved, effects, of_one_bearing(shown, radians_per_second(speeds_rpm), study::Fidelity::dynamic),
      [&](const std::vector<ChangeResult>&, std::size_t done) { bar.show(done * speeds_rpm.size()); });
  Json list = Json::array();
  for (const ChangeResult& result : results) {
    list.push_back({{"name", result.change.name}, {"group", result.change.group}, {"points", Json::array()}});
    Json& row = list.back()["points"];
    for (std::size_t i = 0; i < result.points.size(); ++i) {
      const study::PointResult& point = result.points[i];
      row.push_back({{"speed_rpm", speeds_rpm[i]}, {"status", point.status}});
      if (!point.dynamic) continue;
      row.back().update(
          {{"life_h", point.life_hours},
           {"cage_slip", point.caged ? Json(point.cage_slip) : Json()},
           {"orbit_slip", point.dynamic->orbit_slip ? Json(*point.dynamic->orbit_slip) : Json()},
           {"roller_slip", point.dynamic->roller_slip},
           {"power_loss_W", point.dynamic->loss.total()},
           {"inner_load_rms_N", point.inner.load_rms},
           {"outer_load_rms_N", point.outer.load_rms},
           {"steady", point.dynamic->steady}});
    }
  }
  return list;
}

// The bearing that the gears drive, at the speeds of the sweep.
ChangeResult one_way(const ResolvedCase& resolved, const study::NamedSet& shown,
                     const std::vector<double>& speeds_rpm) {
  return results_of(resolved, with_reference({}),
                    of_one_bearing(shown, radians_per_second(speeds_rpm), study::Fidelity::dynamic))
      .front();
}

// Each assumption with what its first other reading is worth, where the project knows one.
Json assumptions_with_sensitivity(const ResolvedCase& resolved, const std::vector<Sensitivity>& all) {
  Json list = assumptions_json(resolved);
  for (Json& entry : list) {
    entry["worth_h"] = nullptr;
    entry["worth_text"] = "";
    for (const Sensitivity& one : all) {
      if (one.change.group != entry["key"] || !entry["worth_h"].is_null()) continue;
      entry["worth_h"] = one.difference_h;
      entry["worth_text"] = one.change.name;
    }
  }
  return list;
}

// Life and load over speed as the sweep itself computed them.
LifeCurve swept_curve(const SweepOutcome& outcome) {
  std::map<double, const ResultRow*> by_speed;
  for (const ResultRow& row : outcome.rows)
    if (row.ok()) by_speed[value_of(outcome.head, row, "input_speed_rpm")] = &row;
  LifeCurve curve;
  for (const auto& [speed, row] : by_speed) {
    curve.speed_rpm.push_back(speed);
    curve.life_h.push_back(value_of(outcome.head, *row, "life_h"));
    curve.roller_load_rms.push_back(value_of(outcome.head, *row, "outer_load_rms_N"));
  }
  return curve;
}

// Beside what the quasi-static model gives for each published number: what the points of the sweep give.
void add_numbers_of_sweep(const SweepOutcome& outcome, bool whole, Json& rows) {
  if (!outcome.header.axes.empty() || !whole) return;  // several curves, or a part of one
  const LifeCurve curve = swept_curve(outcome);
  for (Json& row : rows) {
    row["of_sweep"] = nullptr;
    if (curve.life_h.empty() || row["reading"] != "") continue;
    const double value = property(curve, row["quantity"].get<std::string>());
    if (std::isfinite(value)) row["of_sweep"] = value;
  }
}

// Pictures show one bearing: of several sets, of the one that limits life at the peak.
study::NamedSet shown_set(const ResolvedCase& resolved, const LifeCurve& grid) {
  const std::vector<study::NamedSet> sets = bearing_sets(resolved);
  const double speed = property(grid, "peak_speed_rpm") / kRpm;
  return set_named(sets, study::evaluate(study::at_speed(sets, speed)).limiting_set);
}

}  // namespace

nlohmann::ordered_json report_data(const ResolvedCase& resolved, const Manifest& manifest, bool every_effect,
                                   bool progress) {
  const SpeedSlice slice = speed_slice(resolved);
  const LifeCurve grid = life_curve(slice.at);
  const study::NamedSet shown = shown_set(slice.at, grid);
  const auto& [set, drivetrain, geometry] = shown;
  const SweepOutcome outcome = outcome_of(*manifest.header, manifest.entries);
  const FoundPeak found = find_peak(outcome);
  const std::vector<double> fine = fine_speeds(grid);
  const MissingPoints missing = missing_points(resolved, manifest);
  const PublishedComparison published = published_comparison(slice.at);
  // What assumptions are worth in this case, as it is.
  ExpectedFile readings = read_expected(shipped_expected(resolved.text("name")));
  readings.published.clear();
  const ValidationTable table = validation_table_of(resolved, readings);
  Json data = sweep_json(outcome, found.peak, assumptions_with_sensitivity(resolved, table.sensitivities),
                         sweep_warnings(resolved, outcome, found), versions_json());
  data["case"] = {{"name", set.empty() ? resolved.text("name") : resolved.text("name") + ", set " + set},
                  {"source", resolved.text("source")},
                  {"model", resolved.choice("model")}};
  data["fidelity"] = outcome.header.fidelity;
  data["missing"] = missing_json(missing, manifest);
  data["life_table"] = lives_record_of(resolved, outcome);
  data["axes"] = axes_json(outcome.header);
  data["slice"] = slice.columns;
  data["kinematics"] = kinematics(drivetrain, geometry);
  data["published"] = published_points(published.table.rows, outcome, resolved);
  data["changed_inputs"] = published.changed;
  data["fine"] = fine_curve(drivetrain, geometry, fine);
  data["polar"] = polar(drivetrain, geometry, shown_speeds(grid));
  data["drawing"] = drawing(drivetrain, geometry, property(grid, "peak_speed_rpm"));
  data["ablation"] = effect_curves(slice.at, shown, fine);
  data["validation"] = json_of(record_of(std::vector{published.table})).at("rows");
  add_numbers_of_sweep(outcome, missing.none(), data["validation"]);
  data["sensitivities"] = json_of(record_of(std::vector{table})).at("assumptions");
  if (has_gear_report(slice.at)) data["gears"] = gear_report(slice.at, grid.speed_rpm);
  data["dynamic"] = nullptr;
  const study::Fidelity fidelity = fidelity_of(outcome.header.fidelity);
  if (in_time(fidelity))
    data["dynamic"] = {
        {"ablation", is_coupled(fidelity)
                         ? Json::array()
                         : effects_in_time(slice.at, shown, shown_speeds(grid), every_effect, progress)},
        {"quasi_static",
         {{"polar", polar(drivetrain, geometry, shown_speeds(grid, best_speed_rpm(found.peak)))}}}};
  if (is_coupled(fidelity))
    data["coupled"] = coupled_report(drivetrain, grid.speed_rpm, one_way(slice.at, shown, grid.speed_rpm),
                                     outcome.header.fidelity);
  return data;
}

}  // namespace orbearing::app
