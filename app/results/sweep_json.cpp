#include "app/results/sweep_json.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/results/record_writers.hpp"
#include "app/results/row_text.hpp"

namespace orbearing::app {
namespace {

using Json = nlohmann::ordered_json;

// Of the columns of the points.
Json column_units(const ManifestHeader& header) {
  Record columns;
  study::describe_row(columns, {});
  Json units = units_of(columns);
  for (const SweptAxis& axis : header.axes) units[axis.column] = axis.units;
  Record set;
  describe(set, study::SetResult{});
  const Json units_of_set = units_of(set);  // outlives its items
  for (const std::string& name : header.sets)
    for (const auto& [column, unit] : units_of_set.items()) units["sets." + name + "." + column] = unit;
  return units;
}

}  // namespace

void describe(Record& record, const LifePeak& peak) {
  using namespace described;
  constexpr Dimension rpm{"angular speed", "rpm", "rpm", ""};
  record.value("speed_rpm", rpm, "of the best point of the grid", peak.speed_rpm);
  record.value("life_h", dimension::hours, "there", peak.life_h);
  record.value("refined_speed_rpm", rpm, "of the best of all points", peak.refined_speed_rpm);
  record.value("refined_life_h", dimension::hours, "there", peak.refined_life_h);
  record.value("life_key", "life whose peak it is", peak.life);
  record.array("between_rpm", rpm, "neighbours of the refined peak", {"side"},
               std::array{peak.lower_rpm, peak.upper_rpm});
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
  const Record peak_record = record_of(peak);
  Json object{{"points", std::move(points)}, {"peak", json_of(peak_record)}};
  if (!outcome.spectra.empty()) object["spectrum"] = spectrum_json(outcome.header, outcome.spectra);
  object["assumptions"] = assumptions;
  object["warnings"] = warnings;
  object["versions"] = versions;
  object["units"] = column_units(outcome.header);
  object["units"].update(units_of(peak_record));
  return object;
}

}  // namespace orbearing::app
