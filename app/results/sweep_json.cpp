#include "app/results/sweep_json.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/results/record_writers.hpp"
#include "app/results/row_text.hpp"

namespace orbearing::app {
namespace {

using Json = nlohmann::ordered_json;

// Of the points, with swept values and sets, and of the peak.
Json units_of_sweep(const ManifestHeader& header, const LifePeak& peak) {
  Json units = units_of(sweep_form(peak));
  for (const SweptAxis& axis : header.axes) units[axis.column] = axis.units;
  const Json units_of_set = units_of(record_of(study::SetResult{}));  // outlives its items
  for (const std::string& name : header.sets)
    for (const auto& [column, unit] : units_of_set.items()) units["sets." + name + "." + column] = unit;
  return units;
}

}  // namespace

void describe(Record& record, const LifePeak& peak) {
  using namespace described;
  record.value("speed_rpm", in_rpm, "of the best point of the grid", peak.speed_rpm);
  record.value("life_h", dimension::hours, "there", peak.life_h);
  record.value("refined_speed_rpm", in_rpm, "of the best of all points", peak.refined_speed_rpm);
  record.value("refined_life_h", dimension::hours, "there", peak.refined_life_h);
  record.value("life_key", "life whose peak it is", peak.life);
  record.array("between_rpm", in_rpm, "neighbours of the refined peak", {"side"},
               std::array{peak.lower_rpm, peak.upper_rpm});
}

Record sweep_form(const LifePeak& peak) {
  Record record;
  record.table("points", "point", "operating points", std::array{study::PointResult{}},
               [](Record& row, const study::PointResult& point) {
                 study::describe_row(row, point);
                 row.value(std::string(refined_column), "whether it was added around the peak", false);
                 row.value(std::string(limiting_set_column), "of several sets, whose bearings live shortest",
                           point.limiting_set);
                 describe(row, Resonance{});
               });
  record.child("peak", "longest life over speed", peak);
  return record;
}

LifePeak grid_peak(const TableHead& head, const std::vector<ResultRow>& rows) {
  LifePeak peak{.life = head.life};
  for (const ResultRow& row : rows) {
    const double life = life_to_go_by(head, row);
    if (row.refined || std::isnan(life) || life <= peak.life_h) continue;
    peak.life_h = life;
    peak.speed_rpm = value_of(head, row, "input_speed_rpm");
  }
  return peak;
}

Json sweep_json(const SweepOutcome& outcome, const LifePeak& peak, const Json& assumptions,
                const Json& warnings, const Json& versions) {
  Json points = Json::array();
  for (const ResultRow& row : outcome.rows) points.push_back(row_json(outcome.head, row));
  Json object{{"points", std::move(points)}, {"peak", json_of(record_of(peak))}};
  if (!outcome.spectra.empty()) object["spectrum"] = spectrum_json(outcome.header, outcome.spectra);
  object["assumptions"] = assumptions;
  object["warnings"] = warnings;
  object["versions"] = versions;
  object["units"] = units_of_sweep(outcome.header, peak);
  return object;
}

}  // namespace orbearing::app
