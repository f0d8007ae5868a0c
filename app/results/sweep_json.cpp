#include "app/results/sweep_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/results/row_text.hpp"

namespace orbearing::app {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json peak_json(const LifePeak& peak) {
  return {{"speed_rpm", number_or_null(peak.speed_rpm)},
          {"life_h", number_or_null(peak.life_h)},
          {"refined_speed_rpm", number_or_null(peak.refined_speed_rpm)},
          {"refined_life_h", number_or_null(peak.refined_life_h)},
          {"life_key", peak.life},
          {"between_rpm", {number_or_null(peak.lower_rpm), number_or_null(peak.upper_rpm)}}};
}

}  // namespace

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
  Json object{{"points", std::move(points)}, {"peak", peak_json(peak)}};
  if (!outcome.spectra.empty()) object["spectrum"] = spectrum_json(outcome.header, outcome.spectra);
  object["assumptions"] = assumptions;
  object["warnings"] = warnings;
  object["versions"] = versions;
  return object;
}

}  // namespace orbearing::app
