#include "app/commands/lone_result.hpp"

#include <fmt/core.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "app/results/point_file.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

std::string lone_result_file(const ManifestHeader& header, const char* what, PointContent content) {
  content.attributes = {{"Conventions", "CF-1.10"},
                        {"title", header.case_name + ", " + what},
                        {"source", "Orbearing " + header.program_version},
                        {"case", header.case_name},
                        {"case_hash", header.case_hash},
                        {"program_version", header.program_version},
                        {"instruction_set", header.instruction_set},
                        {"fidelity", header.fidelity},
                        {"status", "ok"}};
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
    fmt::print("{}\n", object.dump(2));
  } else if (!options.quiet) {
    fmt::print("{}", text);
    for (const nlohmann::ordered_json& warning : object.at("warnings"))
      fmt::print("warning: {}\n", warning.get<std::string>());
  }
}

ResultRow empty_row(const TableHead& head) {
  return {std::vector<double>(head.names.size(), std::numeric_limits<double>::quiet_NaN()), "ok"};
}

}  // namespace orbearing::app
