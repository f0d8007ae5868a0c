#include "app/study/report_data.hpp"

#include <Eigen/Core>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "app/study/coupled_report.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/gear_report.hpp"
#include "app/study/ledger.hpp"
#include "app/study/life_peak.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/speed_slice.hpp"
#include "app/study/sweep_study.hpp"
#include "app/study/sweep_warnings.hpp"
#include "app/units.hpp"
#include "coupling/study/ablation.hpp"

namespace orbearing::app {

namespace {

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

study::PointResult point_at(study::PlanetaryDrivetrain drivetrain, const study::DrivetrainGeometry& geometry,
                            double speed) {
  drivetrain.drive.speed = speed;
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
  Json drawn{{"speed_rpm", rpm},
             {"inner_raceway_diameter_mm", 2e3 * geometry.bearing.inner_radius},
             {"outer_raceway_diameter_mm", 2e3 * geometry.bearing.outer_radius},
             {"roller_diameter_mm", 1e3 * b.rollers().diameter},
             {"pitch_diameter_mm", 1e3 * b.pitch_diameter},
             {"rollers", b.rollers().count},
             {"cage_inner_mm", 1e3 * b.cage.inner_diameter},
             {"cage_outer_mm", 1e3 * b.cage.outer_diameter},
             {"bore_mm", 1e3 * b.inner.seat_diameter},
             {"outside_mm", 1e3 * b.outer.seat_diameter},
             {"guide_land_mm", 1e3 * drivetrain.dynamics.cage.guide_diameter},
             {"clearance_um", 1e6 * b.radial_clearance}};
  const std::size_t stride = static_cast<std::size_t>(drivetrain.cage_positions);
  for (std::size_t place = 0; place < point.distribution.angle.size(); place += stride) {
    drawn["roller_angle_deg"].push_back(kDegree * point.distribution.angle[place]);
    drawn["inner_load_N"].push_back(point.distribution.inner_load[place]);
    drawn["outer_load_N"].push_back(point.distribution.outer_load[place]);
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

Json ablation_curves(const study::PlanetaryDrivetrain& drivetrain, const std::vector<double>& speeds) {
  Json list = Json::array();
  for (const study::Ablation& ablation : study::ablations()) {
    const std::vector<double> lives = study::life_over_speed(drivetrain, ablation, speeds);
    const auto best = std::max_element(lives.begin(), lives.end());
    const double best_speed = speeds[static_cast<std::size_t>(best - lives.begin())];
    list.push_back({{"name", ablation.name},
                    {"group", ablation.group},
                    {"speed_rpm", scaled(speeds, kRpm)},
                    {"life_h", lives},
                    {"peak_speed_rpm", kRpm * best_speed},
                    {"peak_life_h", *best}});
  }
  return list;
}

Json dynamic_ablation(const study::PlanetaryDrivetrain& drivetrain, const std::vector<double>& speeds_rpm,
                      bool every_effect) {
  std::vector<double> speeds;
  for (const double rpm : speeds_rpm) speeds.push_back(rpm / kRpm);
  const std::vector<study::Ablation> ablations =
      every_effect ? study::dynamic_ablations(drivetrain) : study::chief_dynamic_ablations(drivetrain);
  const std::vector<study::PointResult> points =
      study::evaluate_all(drivetrain, ablations, speeds, study::Fidelity::dynamic);
  Json list = Json::array();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % speeds.size() == 0)
      list.push_back({{"name", ablations[i / speeds.size()].name},
                      {"group", ablations[i / speeds.size()].group},
                      {"points", Json::array()}});
    Json& row = list.back()["points"];
    row.push_back({{"speed_rpm", speeds_rpm[i % speeds.size()]}, {"status", points[i].status}});
    if (!points[i].dynamic) continue;
    row.back().update({{"life_h", points[i].life_hours},
                       {"cage_slip", points[i].cage_slip},
                       {"roller_slip", points[i].dynamic->roller_slip},
                       {"power_loss_W", points[i].dynamic->loss.total()},
                       {"inner_load_rms_N", points[i].inner.load_rms},
                       {"outer_load_rms_N", points[i].outer.load_rms},
                       {"steady", points[i].dynamic->steady}});
  }
  return list;
}

// Each assumption with what its first alternative is worth, where the project knows one.
Json assumptions_with_worth(const ResolvedCase& resolved, const std::vector<Worth>& worths) {
  Json list = assumptions_json(resolved);
  for (Json& entry : list) {
    entry["worth_h"] = nullptr;
    entry["worth_text"] = "";
    for (const Worth& worth : worths) {
      if (worth.alternative.assumption != entry["key"] || !entry["worth_h"].is_null()) continue;
      entry["worth_h"] = worth.worth_h;
      entry["worth_text"] = worth.alternative.reading;
    }
  }
  return list;
}

Json published_points(const std::vector<LedgerRow>& rows) {
  Json list = Json::array();
  Json speed;
  for (const LedgerRow& row : rows)
    if (row.reading.empty() && row.quantity == "peak_speed_rpm" && row.published) speed = *row.published;
  for (const LedgerRow& row : rows)
    if (row.reading.empty() && row.quantity == "peak_life_h" && row.published && !speed.is_null())
      list.push_back({{"source", row.source},
                      {"quantity", row.quantity},
                      {"speed_rpm", speed},
                      {"life_h", *row.published}});
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
void add_numbers_of_sweep(const SweepOutcome& outcome, Json& rows) {
  if (!outcome.header.axes.empty()) return;  // several curves
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
  std::vector<study::NamedSet> sets = bearing_sets(resolved);
  const double speed = property(grid, "peak_speed_rpm") / kRpm;
  const std::string name = study::evaluate(study::at_speed(sets, speed)).limiting_set;
  return *std::find_if(sets.begin(), sets.end(),
                       [&](const study::NamedSet& set) { return set.name == name; });
}

}  // namespace

nlohmann::ordered_json report_data(const ResolvedCase& resolved, const Manifest& manifest,
                                   bool every_effect) {
  const SpeedSlice slice = speed_slice(resolved);
  const LifeCurve grid = life_curve(slice.at);
  const auto [set, drivetrain, geometry] = shown_set(slice.at, grid);
  const SweepOutcome outcome = outcome_of(*manifest.header, manifest.entries);
  const FoundPeak found = find_peak(outcome);
  const std::vector<double> fine = fine_speeds(grid);
  // The published numbers belong to the shipped case of this name, changed by the user or not.
  const Ledger ledger = ledger_of(resolved, read_expected(shipped_expected(resolved.text("name"))));
  Json data = sweep_json(outcome, found.peak, assumptions_with_worth(resolved, ledger.worth),
                         sweep_warnings(resolved, outcome, found), versions_json());
  data["case"] = {{"name", set.empty() ? resolved.text("name") : resolved.text("name") + ", set " + set},
                  {"source", resolved.text("source")},
                  {"model", resolved.choice("model")}};
  data["fidelity"] = outcome.header.fidelity;
  data["axes"] = axes_json(outcome.header);
  data["slice"] = slice.columns;
  data["kinematics"] = kinematics(drivetrain, geometry);
  data["published"] = published_points(ledger.rows);
  data["fine"] = fine_curve(drivetrain, geometry, fine);
  data["polar"] = polar(drivetrain, geometry, shown_speeds(grid));
  data["drawing"] = drawing(drivetrain, geometry, property(grid, "peak_speed_rpm"));
  data["ablation"] = ablation_curves(drivetrain, fine);
  data["ledger"] = rows_json(ledger);
  add_numbers_of_sweep(outcome, data["ledger"]);
  data["worth"] = worth_json(ledger);
  if (has_gear_report(slice.at)) data["gears"] = gear_report(slice.at, grid.speed_rpm);
  data["dynamic"] = nullptr;
  const study::Fidelity fidelity = fidelity_of(outcome.header.fidelity);
  if (in_time(fidelity))
    data["dynamic"] = {
        {"ablation",
         two_way(fidelity) ? Json::array() : dynamic_ablation(drivetrain, shown_speeds(grid), every_effect)},
        {"quasi_static",
         {{"polar", polar(drivetrain, geometry, shown_speeds(grid, best_speed_rpm(found.peak)))}}}};
  if (two_way(fidelity))
    data["two_way"] = coupled_report(drivetrain, grid.speed_rpm, outcome.header.fidelity);
  return data;
}

}  // namespace orbearing::app
