#include "app/study/report_data.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "app/case/case_file.hpp"
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/use_conditions.hpp"
#include "app/errors.hpp"
#include "app/results/progress.hpp"
#include "app/results/record_writers.hpp"
#include "app/results/verdicts.hpp"
#include "app/study/carrier_study.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/life_peak.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/sweep_study.hpp"
#include "app/study/sweep_warnings.hpp"
#include "app/units.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;  // which writes null for numbers that are not finite

// The value of the axis nearest to the case's own.
Setting nearest(const ResolvedCase& resolved, const SweepAxis& axis) {
  if (!resolved.has(axis.path)) return axis.setting(0);
  const double own = resolved.value(axis.path).number;
  const auto best = std::min_element(axis.numbers.begin(), axis.numbers.end(), [&](double one, double other) {
    return std::abs(one - own) < std::abs(other - own);
  });
  return axis.setting(static_cast<std::size_t>(best - axis.numbers.begin()));
}

// They name the case or choose its operating points.
bool chooses_operating_points(const std::string& path) {
  const std::array<std::string_view, 4> others{"name", "source", keys().speed, "life.duration"};
  return std::find(others.begin(), others.end(), path) != others.end() || path.starts_with("spectrum") ||
         path.starts_with("requirements.");
}

// Units written otherwise round otherwise.
bool equal_but_for_units(double one, double other) {
  constexpr double round_off = 1e-12;
  return one == other || std::abs(one - other) <= round_off * std::max(std::abs(one), std::abs(other));
}

bool same_input(const Field& field, const FieldValue& one, const FieldValue& other) {
  if (one.given == other.given) return true;
  if (!is_numeric(field) || !std::isfinite(one.number)) return one == other;
  return equal_but_for_units(one.number, other.number);
}

std::string stated_or_not(const ResolvedCase& in, const std::string& path) {
  return in.has(path) ? in.given(path) : "not stated";
}

}  // namespace

SpeedSlice speed_slice(const ResolvedCase& resolved) {
  const std::vector<SweepAxis>& axes = resolved.axes();
  const bool speed_swept =
      std::any_of(axes.begin(), axes.end(), [](const SweepAxis& axis) { return axis.path == keys().speed; });
  if (!speed_swept || axes.size() < 2) return {resolved, {}, nullptr};
  std::vector<Setting> settings;
  for (const SweepAxis& axis : axes)
    if (axis.path != keys().speed) settings.push_back(nearest(resolved, axis));
  SpeedSlice slice{resolved.with(settings), {}, Json::object()};
  for (const Setting& one : settings) {
    slice.settings.push_back(one.path + "=" + one.text);
    slice.columns[axis_column(one.path).column] = axis_value(slice.at, one.path);
  }
  return slice;
}

std::vector<std::string> changed_inputs(const ResolvedCase& resolved, const ResolvedCase& shipped) {
  std::vector<std::string> changed;
  const auto compare = [&](const std::string& path, const Field& field) {
    if (chooses_operating_points(path) || (!resolved.has(path) && !shipped.has(path))) return;
    const bool both = resolved.has(path) && shipped.has(path);
    if (both && same_input(field, resolved.value(path), shipped.value(path))) return;
    changed.push_back(fmt::format("{}: {} (published: {})", path, stated_or_not(resolved, path),
                                  stated_or_not(shipped, path)));
  };
  if (resolved.model() != shipped.model()) return {"model"};
  const std::vector<Input> ours = resolved.inputs();
  for (const auto& [path, field] : ours) compare(path, *field);
  for (const auto& [path, field] : shipped.inputs()) {
    const bool ours_too =
        std::any_of(ours.begin(), ours.end(), [&](const Input& input) { return input.path == path; });
    if (!ours_too) compare(path, *field);
  }
  return changed;
}

PublishedComparison published_comparison(const ResolvedCase& resolved) {
  const std::string file = shipped_expected(resolved.text("name"));
  ExpectedFile expected = read_expected(file);
  PublishedComparison found{.table = {.case_name = resolved.text("name")}};
  if (expected.published.empty()) return found;
  expected.alternatives.clear();
  const ResolvedCase shipped = read_case((std::filesystem::path(file).parent_path() / "case.yaml").string());
  found.changed = changed_inputs(resolved, shipped);
  if (found.changed.empty()) found.table = validation_table_of(shipped, expected);
  return found;
}

namespace {

// The bearing to scale.
Json drawing(const analysis::PlanetaryDrivetrain& drivetrain, const analysis::DrivetrainGeometry& geometry) {
  const bearing::Bearing& b = drivetrain.bearing;
  const auto of_cage = [&](double length) { return b.has_cage() ? Json(1e3 * length) : Json(); };
  return {{"inner_raceway_diameter_mm", 2e3 * geometry.bearing.inner_radius},
          {"outer_raceway_diameter_mm", 2e3 * geometry.bearing.outer_radius},
          {"roller_diameter_mm", 1e3 * b.element_diameter()},
          {"pitch_diameter_mm", 1e3 * b.pitch_diameter},
          {"rollers", b.element_count()},
          {"cage_inner_mm", of_cage(b.cage.inner_diameter)},
          {"cage_outer_mm", of_cage(b.cage.outer_diameter)},
          {"bore_mm", 1e3 * b.inner.seat_diameter},
          {"outside_mm", 1e3 * b.outer.seat_diameter},
          {"guide_land_mm", of_cage(drivetrain.dynamics.cage.guide_diameter)},
          {"clearance_um", 1e6 * b.radial_clearance}};
}

// Speeds at pure rolling relative to the carrier, as multiples of the input speed: what slip is measured
// against.
Json kinematics(const analysis::PlanetaryDrivetrain& drivetrain,
                const analysis::DrivetrainGeometry& geometry) {
  const analysis::BearingDuty duty = analysis::bearing_duty(drivetrain, geometry);
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

const analysis::NamedSet& set_named(const std::vector<analysis::NamedSet>& sets, const std::string& name) {
  return *std::find_if(sets.begin(), sets.end(),
                       [&](const analysis::NamedSet& set) { return set.name == name; });
}

Json point_json(const analysis::PointResult& point, bool loads) {
  if (!is_computed(point.status)) return {{"status", point.status}};
  Record row;
  analysis::describe_row(row, point);
  Json json = json_of(row);
  if (!loads) return json;
  const analysis::LoadDistribution& by_place = point.distribution;
  for (const double angle : by_place.angle) json["angle_deg"].push_back(kDegree * angle);
  json["inner_load_N"] = by_place.inner_load;
  json["outer_load_N"] = by_place.outer_load;
  return json;
}

// Life and load over speed as the sweep itself computed them.
LifeCurve swept_curve(const SweepOutcome& outcome) {
  std::map<double, const SweepRow*> by_speed;
  for (const SweepRow& row : outcome.rows)
    if (row.ok()) by_speed[speed_in_rpm(row.point.input_speed)] = &row;
  LifeCurve curve;
  for (const auto& [speed, row] : by_speed) {
    curve.speed_rpm.push_back(speed);
    curve.life_h.push_back(governing_hours(outcome.header, row->point));
    curve.roller_load_rms.push_back(row->point.outer.load_rms);
  }
  return curve;
}

// Beside what the quasi-static model gives for each published number: what the points of the sweep give.
void add_numbers_of_sweep(const SweepOutcome& outcome, bool whole, Json& rows) {
  if (!outcome.header.axes.empty() || !whole) return;  // several curves, or a part of one
  const LifeCurve curve = swept_curve(outcome);
  for (Json& row : rows) {
    row["of_sweep"] = nullptr;
    if (!curve.life_h.empty() && row["reading"] == "")
      row["of_sweep"] = property(curve, row["quantity"].get<std::string>());
  }
}

// Pictures show one bearing: of several sets, of the one that limits life at the peak.
analysis::NamedSet shown_set(const ResolvedCase& resolved, const LifeCurve& grid) {
  const std::vector<analysis::NamedSet> sets = bearing_sets(resolved);
  const double speed = property(grid, "peak_speed_rpm") / kRpm;
  return set_named(sets, analysis::evaluate(analysis::at_speed(sets, speed)).limiting_set);
}

// Rows as a refinement takes them: the grid's in their order, then those that were added.
bool wants_more(const ManifestHeader& header, const Manifest& manifest, const Refinement& refinement) {
  std::vector<SweepRow> rows;
  for (const auto& [point, entry] : manifest.entries)
    if (point < header.grid() || point >= header.points) rows.push_back(entry.row);
  return !refinement.next(rows).empty();
}

std::string name_of(const Manifest& manifest) {
  return manifest.header->continued ? to_string(*manifest.header->continued) : "own start";
}

Json rows_of(const Manifest& manifest) {
  Json rows = Json::array();
  // Points that only one of two sweeps added to their common grid have nothing beside them.
  for (const auto& [index, entry] : manifest.entries)
    if (index < manifest.header->grid()) rows.push_back(row_json(*manifest.header, entry.row));
  return rows;
}

}  // namespace

nlohmann::ordered_json report_data(const ResolvedCase& resolved, const Manifest& manifest) {
  const SpeedSlice slice = speed_slice(resolved);
  const LifeCurve grid = life_curve(slice.at);
  const auto& [set, drivetrain, geometry] = shown_set(slice.at, grid);
  const SweepOutcome outcome = outcome_of(*manifest.header, manifest.entries);
  const FoundPeak found = find_peak(outcome);
  const MissingPoints missing = missing_points(resolved, manifest);
  const PublishedComparison published = published_comparison(slice.at);
  // Effects of assumptions in this case, unchanged.
  ExpectedFile readings = read_expected(shipped_expected(resolved.text("name")));
  readings.published.clear();
  const ValidationTable table = validation_table_of(resolved, readings);
  Json data = sweep_json(outcome, found.peak, assumptions_json(resolved),
                         sweep_warnings(resolved, outcome, found), versions_json());
  Record judged;
  describe_verdicts(judged, verdicts_of(stated_requirements(resolved), outcome));
  data.update(json_of(judged));
  data["case"] = {{"name", set.empty() ? resolved.text("name") : resolved.text("name") + ", set " + set},
                  {"source", resolved.text("source")},
                  {"model", resolved.choice("model")}};
  data["fidelity"] = outcome.header.fidelity;
  data["missing"] = missing_json(missing, manifest);
  data["life_table"] = lives_record_of(resolved, outcome);
  data["own_speed_rpm"] = speed_in_rpm(resolved.quantity(keys().speed));
  data["axes"] = axes_json(outcome.header);
  data["slice"] = slice.columns;
  data["kinematics"] = kinematics(drivetrain, geometry);
  data["changed_inputs"] = published.changed;
  data["drawing"] = drawing(drivetrain, geometry);
  data["validation"] = json_of(record_of(std::vector{published.table})).at("rows");
  add_numbers_of_sweep(outcome, missing.none(), data["validation"]);
  data["sensitivities"] = json_of(record_of(std::vector{table})).at("assumptions");
  // At the case's own point, as the command carrier has it.
  if (const ResolvedCase point = slice.at.without_sweep(); carrier_is_body(point, ""))
    data["carrier"] = json_of(record_of(carrier_study(point)));
  if (has_gear_report(slice.at)) data["gears"] = gear_report(slice.at, grid.speed_rpm);
  data["shown"] = {{"set", set},
                   {"settings", slice.settings},
                   {"speeds_rpm", grid.speed_rpm},
                   {"peak_speed_rpm", property(grid, "peak_speed_rpm")}};
  return data;
}

nlohmann::ordered_json bearing_points(const ResolvedCase& resolved, const Json& wanted, bool progress) {
  const ResolvedCase at = with_settings(resolved, wanted.at("settings"));
  const std::string set = wanted.at("set");
  const auto gears = set_named(bearing_sets(at), set).drivetrain.gear_set;
  const ChangeStudy study{
      .speed = wanted.at("speeds"),
      .fidelity = fidelity_of(wanted.at("fidelity")),
      .evaluate = [&](const std::vector<analysis::NamedSet>& sets, analysis::Fidelity level) {
        analysis::NamedSet one = set_named(sets, set);
        one.drivetrain.gear_set = gears;
        return analysis::evaluate(one.drivetrain, one.geometry, level);
      }};
  Json lists = Json::array();
  std::vector<NamedChange> changes;
  for (const Json& settings : wanted.at("changes")) {
    const NamedChange change{"", std::to_string(lists.size()), settings};
    lists.push_back(nullptr);
    if (fits(at, change)) changes.push_back(change);
  }
  Progress bar(0, changes.size() * study.speed.size(), progress, "effects: ");
  const std::vector<ChangeResult> results = results_of(
      at, changes, study,
      [&](const std::vector<ChangeResult>&, std::size_t done) { bar.show(done * study.speed.size()); });
  for (const ChangeResult& result : results) {
    Json& list = lists[std::stoul(result.change.group)] = Json::array();
    for (const analysis::PointResult& point : result.points)
      list.push_back(point_json(point, wanted.at("loads")));
  }
  return lists;
}

MissingPoints missing_points(const ResolvedCase& resolved, const Manifest& manifest) {
  const ManifestHeader& header = *manifest.header;
  SweepRequest request = sweep_request(resolved, header.fidelity);
  MissingPoints missing{.of = request.points.size()};
  for (std::size_t point = 0; point < request.points.size(); ++point) {
    if (manifest.entries.contains(point)) continue;
    const std::string& label = request.points[point].label;
    missing.labels.push_back(label.empty() ? "the operating point" : label);
  }
  if (!missing.labels.empty() || !header.refined || header.shard) return missing;
  refine_peak_of(resolved, request);
  missing.peak_unfinished = request.refinement && wants_more(header, manifest, *request.refinement);
  return missing;
}

std::string missing_text(const MissingPoints& missing, const Manifest& manifest) {
  if (missing.none()) return "";
  const std::optional<Shard>& shard = manifest.header->shard;
  if (missing.peak_unfinished)
    return "the sweep was interrupted while its peak was refined: the speed of the longest life is that of "
           "the points so far; continue with --resume";
  constexpr std::size_t most_named = 12;
  std::vector<std::string> named(
      missing.labels.begin(),
      missing.labels.begin() + static_cast<std::ptrdiff_t>(std::min(most_named, missing.labels.size())));
  if (named.size() < missing.labels.size())
    named.push_back(fmt::format("and {} more", missing.labels.size() - named.size()));
  return fmt::format("{} of {} points of the sweep are missing{}: {}; {}", missing.labels.size(), missing.of,
                     shard ? fmt::format(" (this is shard {})", to_string(*shard)) : "",
                     fmt::join(named, "; "),
                     shard ? "merge the shards, then report on the merged folder" : "continue with --resume");
}

nlohmann::ordered_json missing_json(const MissingPoints& missing, const Manifest& manifest) {
  if (missing.none()) return nullptr;
  const std::optional<Shard>& shard = manifest.header->shard;
  return {{"of", missing.of},
          {"found", missing.of - missing.labels.size()},
          {"shard", shard ? nlohmann::ordered_json(to_string(*shard)) : nlohmann::ordered_json(nullptr)},
          {"points", missing.labels},
          {"peak_unfinished", missing.peak_unfinished},
          {"text", missing_text(missing, manifest)}};
}

void require_two_branches(const Branch& one, const Branch& other) {
  std::vector<std::string> messages;
  ManifestHeader alike = *other.manifest.header;
  alike.continued = one.manifest.header->continued;
  alike.refined = one.manifest.header->refined;
  for (const std::string& line : differences(alike, *one.manifest.header))
    messages.push_back(
        fmt::format("--with: {}: {}, as in {}", other.folder.string(), line, one.folder.string()));
  if (one.manifest.header->fidelity != "dynamic")
    messages.push_back(
        fmt::format("--with: {}: fidelity '{}' was found; dynamic is required, which alone has branches",
                    one.folder.string(), one.manifest.header->fidelity));
  if (other.manifest.header->continued == one.manifest.header->continued)
    messages.push_back(
        fmt::format("--with: {}: direction of --continue '{}' was found, as in {}; another is required",
                    other.folder.string(), name_of(other.manifest), one.folder.string()));
  if (!messages.empty()) throw BadInput(messages);
}

Json branches_json(const ResolvedCase& resolved, const std::vector<Branch>& branches) {
  if (std::none_of(branches.begin(), branches.end(),
                   [](const Branch& branch) { return branch.manifest.header->continued.has_value(); }))
    return nullptr;
  Json runs = Json::array();
  for (const Branch& branch : branches)
    runs.push_back({{"name", name_of(branch.manifest)}, {"points", rows_of(branch.manifest)}});
  return {{"load_drift", resolved.number(keys().load_drift)}, {"runs", runs}};
}

}  // namespace orbearing::app
