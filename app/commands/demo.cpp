#include "app/commands/demo.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/commands/presentation.hpp"
#include "app/commands/report.hpp"
#include "app/commands/sweep.hpp"
#include "app/errors.hpp"
#include "app/resources.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* default_folder = "orbearing-demo";

// A new folder in each call: results are never overwritten.
std::string free_folder() {
  std::error_code ignored;
  std::string name = default_folder;
  for (int number = 2; fs::exists(fs::symlink_status(name, ignored)); ++number)
    name = fmt::format("{}-{}", default_folder, number);
  return name;
}

void require_new_or_empty(const fs::path& folder) {
  std::error_code ignored;
  if (fs::exists(folder, ignored) && !fs::is_empty(folder, ignored))
    throw BadInput(printable(folder.string()) + ": is not empty; a new or empty folder is required");
}

Printing taken_into(Json& result) {
  return {.json = true, .quiet = true, .to = {.result = [&result](const Json& object) { result = object; }}};
}

Json summary(const SweepOptions& of_case, const Json& sweep, const Json& report) {
  const Json& peak = sweep.at("peak");
  Json units = Json::object();
  for (const auto& [key, unit] : sweep.at("units").items())
    if (peak.contains(key)) units[key] = unit;
  return {{"case", of_case.stated.file},         {"folder", of_case.output},
          {"report", report.at("report")},       {"peak", peak},
          {"points", sweep.at("points").size()}, {"units", units}};
}

void print_beginning(const SweepOptions& of_case) {
  fmt::print(
      "Demo: planet bearings of a 150 kW reducer. Life over speed at constant power, quasi-static, and a "
      "report.\nIt takes about 10 s.\n\ncase:    {}\n",
      of_case.stated.file);
  std::fflush(stdout);  // before the work that it announces
}

void print_end(const Json& result, const Json& sweep) {
  const Json& points = sweep.at("points");
  const auto speed = [](const Json& point) { return point.at("input_speed_rpm").get<double>(); };
  const auto life = [](const Json& point) { return point.at("life_h").get<double>(); };
  const std::string folder = printable(result.at("folder").get<std::string>());
  fmt::print(
      "results: {0}: {1} speeds in sweep.csv, loads of the rollers in points\n"
      "report:  {2}\n\n"
      "Longest L10 life of one bearing (life_h): {3:.0f} h at {4:.0f} rpm of the sun.\n"
      "At {5:.0f} rpm the torque limits it to {6:.0f} h. At {7:.0f} rpm the centrifugal load limits it to "
      "{8:.0f} h.\n\n"
      "Open the report in a browser. Then start a case of your own:\n"
      "  orbearing new industrial mine.yaml\n"
      "  orbearing open mine.yaml\n",
      folder, points.size(), printable(result.at("report").get<std::string>()),
      result.at("peak").at("refined_life_h").get<double>(),
      result.at("peak").at("refined_speed_rpm").get<double>(), speed(points.front()), life(points.front()),
      speed(points.back()), life(points.back()));
}

}  // namespace

int execute(const DemoOptions& options) {
  Json sweep, report;
  const std::string folder = options.output.empty() ? free_folder() : options.output;
  require_new_or_empty(folder);
  const std::string file = (shipped_cases() / "reducer_150kW" / "case.yaml").string();
  const SweepOptions of_sweep{.print = taken_into(sweep), .stated = {.file = file}, .output = folder};
  const ReportOptions of_report{.print = taken_into(report), .folder = folder};
  const bool text = !options.print.json && !options.print.quiet;
  if (text) print_beginning(of_sweep);
  if (const int code = execute(of_sweep); code != 0) return code;
  if (const int code = execute(of_report); code != 0) return code;
  const Json result = summary(of_sweep, sweep, report);
  if (options.print.json) print_object(result, options.print);
  if (text) print_end(result, sweep);
  return 0;
}

}  // namespace orbearing::app
