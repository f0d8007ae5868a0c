#include "app/study/sweep_study.hpp"

#include <fmt/core.h>

#include <Eigen/Core>
#include <boost/version.hpp>

#include "app/case/field_table.hpp"
#include "app/case/resolved_writer.hpp"
#include "app/errors.hpp"
#include "app/results/terminal_chart.hpp"
#include "app/results/terminal_table.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/life_peak.hpp"
#include "app/version.hpp"

namespace orbearing::app {

namespace {

const std::string kSpeedPath = "input.speed";

std::string label_of(const std::vector<Setting>& settings) {
  std::string label;
  for (const auto& [path, value] : settings) label += (label.empty() ? "" : ", ") + path + " = " + value;
  return label;
}

// Values of the other axes stand in the table as they are held: in SI units, or as plain numbers.
SweptAxis swept_axis(const SweepAxis& axis) {
  const Field& field = *find_field(axis.path);
  const std::string unit = field.kind == Kind::quantity ? std::string(field.dimension.si) : "1";
  return {.column = axis.path, .units = unit, .meaning = field.meaning};
}

double axis_value(const ResolvedCase& resolved, const std::string& path) {
  switch (find_field(path)->kind) {
    case Kind::quantity:
      return resolved.quantity(path);
    case Kind::integer:
      return resolved.integer(path);
    default:
      return resolved.number(path);
  }
}

SweepPoint point_of(const ResolvedCase& resolved, std::size_t index) {
  const std::vector<Setting> settings = sweep_point(resolved, index);
  SweepPoint point{.label = label_of(settings)};
  try {
    const ResolvedCase at_point = resolved.with(settings);
    point.input_speed = at_point.quantity(kSpeedPath);
    for (const SweepAxis& axis : resolved.axes())
      if (axis.path != kSpeedPath) point.axis_values.push_back(axis_value(at_point, axis.path));
  } catch (const BadInput& error) {
    throw BadInput("sweep point " + point.label + ": " + error.what());
  }
  return point;
}

study::PointResult compute_point(const ResolvedCase& resolved, std::size_t index, study::Fidelity fidelity) {
  const study::PlanetaryDrivetrain drivetrain = drivetrain_of(resolved.with(sweep_point(resolved, index)));
  return study::evaluate(drivetrain, study::derive(drivetrain), fidelity);
}

}  // namespace

SweepRequest sweep_request(const ResolvedCase& resolved, const std::string& fidelity) {
  if (resolved.model() != planetary_drivetrain)
    throw BadInput(resolved.origin("model") + ": model: found " + resolved.choice("model") +
                   "; a sweep requires planetary-drivetrain");
  SweepRequest request;
  for (std::size_t i = 0; i < sweep_size(resolved); ++i) request.points.push_back(point_of(resolved, i));
  request.header = {.case_name = resolved.text("name"),
                    .case_hash = case_hash(resolved),
                    .program_version = std::string(program_version),
                    .instruction_set = std::string(instruction_set),
                    .fidelity = fidelity,
                    .points = request.points.size()};
  for (const SweepAxis& axis : resolved.axes())
    if (axis.path != kSpeedPath) request.header.axes.push_back(swept_axis(axis));
  request.resolved_case = write_resolved(resolved);
  const study::Fidelity level =
      fidelity == "dynamic" ? study::Fidelity::dynamic : study::Fidelity::quasi_static;
  request.evaluate = [resolved, level](std::size_t index) { return compute_point(resolved, index, level); };
  return request;
}

nlohmann::ordered_json assumptions_json(const ResolvedCase& resolved) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [key, reason] : resolved.assumed())
    list.push_back(
        {{"key", key}, {"value", resolved.has(key) ? resolved.given(key) : ""}, {"reason", reason}});
  return list;
}

nlohmann::ordered_json versions_json() {
  return {{"orbearing", program_version},
          {"instruction_set", instruction_set},
          {"compiler", compiler},
          {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"boost", BOOST_LIB_VERSION}};
}

std::vector<std::string> case_warnings(const ResolvedCase& resolved) {
  return gear_warnings(study::derive(drivetrain_of(resolved)));
}

int present_sweep(const ResolvedCase& resolved, const SweepOutcome& outcome, bool json, bool quiet) {
  const FoundPeak found = find_peak(resolved, outcome);
  std::vector<std::string> warnings = case_warnings(resolved);
  warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
  if (json) {
    fmt::print(
        "{}\n",
        sweep_json(outcome, found.peak, assumptions_json(resolved), warnings, versions_json()).dump(2));
  } else if (!quiet) {
    fmt::print("{}\n{}", sweep_table(outcome.head, outcome.rows),
               life_chart(outcome.head, outcome.rows, found.peak, glyphs_of_locale()));
    for (const std::string& warning : warnings) fmt::print("warning: {}\n", warning);
  }
  return outcome.failed > 0 ? 1 : 0;
}

}  // namespace orbearing::app
