#include "app/study/sweep_study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/version.hpp>

#include "app/case/field_table.hpp"
#include "app/case/resolved_writer.hpp"
#include "app/errors.hpp"
#include "app/results/terminal_chart.hpp"
#include "app/results/terminal_table.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/version.hpp"
#include "coupling/study/peak.hpp"

namespace orbearing::app {

namespace {

constexpr double kRadiansPerSecond = boost::math::double_constants::pi / 30.0;  // of 1 rpm
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

// Speeds of the swept axis next to the best one [rad/s], in ascending order with the best between them.
std::vector<double> neighbours(const ResolvedCase& resolved, double best) {
  std::vector<double> speeds;
  for (const SweepAxis& axis : resolved.axes()) {
    if (axis.path != kSpeedPath) continue;
    for (const std::string& value : axis.values)
      speeds.push_back(resolved.with(kSpeedPath, value).quantity(kSpeedPath));
  }
  std::sort(speeds.begin(), speeds.end());
  const auto above = std::upper_bound(speeds.begin(), speeds.end(), best);
  const auto below = std::lower_bound(speeds.begin(), speeds.end(), best);
  return {below == speeds.begin() ? best : *(below - 1), above == speeds.end() ? best : *above};
}

std::size_t best_index(const SweepOutcome& outcome, double life_h) {
  std::size_t row = 0;
  while (value_of(outcome.head, outcome.rows[row], "life_h") != life_h) ++row;
  const auto& shard = outcome.header.shard;
  return shard ? row * shard->count + shard->index - 1 : row;
}

void refine(const ResolvedCase& at_best, const std::vector<double>& bracket, FoundPeak& found) {
  const study::PlanetaryDrivetrain drivetrain = drivetrain_of(at_best);
  const study::DrivetrainGeometry geometry = study::derive(drivetrain);
  const study::Extremum best = study::largest(
      [&](double speed) { return study::life_at(drivetrain, geometry, speed); }, bracket[0], bracket[1]);
  found.peak.refined_speed_rpm = best.speed / kRadiansPerSecond;
  found.peak.refined_life_h = best.value;
  if (!best.inside)
    found.warnings.push_back(
        "sweep.input.speed: life still rises at the end of the swept range; widen it to find "
        "the peak");
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

FoundPeak find_peak(const ResolvedCase& resolved, const SweepOutcome& outcome) {
  FoundPeak found{.peak = grid_peak(outcome.head, outcome.rows)};
  const bool speed_swept = std::any_of(resolved.axes().begin(), resolved.axes().end(),
                                       [](const SweepAxis& axis) { return axis.path == kSpeedPath; });
  if (!speed_swept || !(found.peak.life_h > 0.0)) return found;
  const ResolvedCase at_best = resolved.with(sweep_point(resolved, best_index(outcome, found.peak.life_h)));
  const std::vector<double> bracket = neighbours(resolved, at_best.quantity(kSpeedPath));
  if (bracket[0] < bracket[1]) refine(at_best, bracket, found);
  return found;
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
