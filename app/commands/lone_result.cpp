#include "app/commands/lone_result.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/commands/presentation.hpp"
#include "app/results/point_file.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

std::string lone_result_file(const ManifestHeader& header, const char* what, PointContent content,
                             const std::string& status) {
  content.attributes = result_attributes(header, what, status);
  return netcdf_bytes(content);
}

nlohmann::ordered_json lone_result_json(const ResolvedCase& resolved, const nlohmann::ordered_json& results,
                                        const std::vector<std::string>& warnings) {
  nlohmann::ordered_json object{{"case", resolved.text("name")}, {"model", resolved.choice("model")}};
  object.update(results);
  object["assumptions"] = assumptions_json(resolved);
  object["warnings"] = warnings;
  object["versions"] = versions_json();
  return object;
}

void present_lone_result(const nlohmann::ordered_json& object, const std::string& text,
                         const Options& options) {
  if (options.json) {
    print_object(object, options);
  } else if (!options.quiet) {
    fmt::print("{}", text);
    for (const nlohmann::ordered_json& warning : object.at("warnings"))
      fmt::print("warning: {}\n", warning.get<std::string>());
  }
}

ResultRow lone_row(const TableHead& head, const std::vector<std::pair<const char*, double>>& values) {
  ResultRow row{std::vector<double>(head.names.size(), std::numeric_limits<double>::quiet_NaN()), "ok"};
  for (const auto& [name, value] : values) {
    const auto found = std::find(head.names.begin(), head.names.end(), name);
    if (found != head.names.end() && std::isfinite(value))
      row.values[static_cast<std::size_t>(found - head.names.begin())] = in_table_unit(value, 1.0);
  }
  return row;
}

}  // namespace orbearing::app
