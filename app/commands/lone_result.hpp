// What the analyses of a single part, which give one result and no sweep, write and print alike.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/commands/command_line.hpp"
#include "app/results/manifest.hpp"
#include "app/results/point_content.hpp"

namespace orbearing::app {

/// Bytes of the netCDF file of a result called `what`.
std::string lone_result_file(const ManifestHeader& header, const char* what, PointContent content,
                             const std::string& status = "ok");

/// Case, model, `results`, then assumptions, warnings and versions.
nlohmann::ordered_json lone_result_json(const ResolvedCase& resolved, const nlohmann::ordered_json& results,
                                        const std::vector<std::string>& warnings);

/// Prints `object`, or `text` with the object's warnings, as the options ask.
void present_lone_result(const nlohmann::ordered_json& object, const std::string& text,
                         const Options& options);

/// A row of the table of a sweep that has these values [in the columns' units]; all else stays empty.
ResultRow lone_row(const TableHead& head, const std::vector<std::pair<const char*, double>>& values = {});

}  // namespace orbearing::app
