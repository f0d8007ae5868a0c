#include "app/study/sweep_study.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <boost/version.hpp>
#include <set>

#include "app/case/catalogue_case.hpp"
#include "app/case/field_table.hpp"
#include "app/case/resolved_writer.hpp"
#include "app/case/spectrum_case.hpp"
#include "app/case/sweep_axes.hpp"
#include "app/errors.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/plausibility.hpp"
#include "app/study/resonance_lines.hpp"
#include "app/version.hpp"

namespace orbearing::app {

namespace {

std::string label_of(const std::vector<Setting>& settings) {
  std::string label;
  for (const Setting& one : settings) label += (label.empty() ? "" : ", ") + one.path + " = " + one.text;
  return label;
}

// "kg/m3" as part of a column's name.
std::string in_name(std::string_view unit) {
  std::string name;
  for (const char c : unit) name += c == '/' ? "_per_" : c == '.' ? "_" : std::string(1, c);
  return name;
}

SweepPoint point_of(const ResolvedCase& resolved, std::vector<Setting> settings) {
  SweepPoint point{.label = label_of(settings), .settings = std::move(settings)};
  try {
    const ResolvedCase at_point = resolved.with(point.settings);
    point.input_speed = at_point.quantity(keys().speed);
    for (const SweepAxis& axis : resolved.axes())
      if (axis.path != keys().speed) point.axis_values.push_back(axis_value(at_point, axis.path));
  } catch (const BadInput& error) {
    throw BadInput("sweep point " + point.label + ": " + error.what());
  }
  return point;
}

/// Settings of one combination of the swept values that the bins of a spectrum do not state.
std::vector<std::vector<Setting>> lines_of_spectrum(const ResolvedCase& resolved) {
  std::vector<std::vector<Setting>> lines;
  std::set<std::vector<Setting>> known;
  for (std::size_t i = 0; i < sweep_size(resolved); ++i) {
    std::vector<Setting> line = sweep_point(resolved, i);
    std::erase_if(line, [](const Setting& setting) {
      return setting.path == keys().speed || setting.path == keys().power || setting.path == kTorquePath;
    });
    if (known.insert(line).second) lines.push_back(std::move(line));
  }
  return lines;
}

Setting entering_power(const LoadBin& bin) {
  return {keys().power, fmt::format("{} W", bin.entering_power()), bin.entering_power()};
}

// An idle bin has next to no power and next to endless life, which is no mistake.
bool is_idle_bin(const std::vector<Setting>& settings) {
  return std::find(settings.begin(), settings.end(), entering_power(LoadBin{})) != settings.end();
}

/// The bins that turn, for each combination of the other swept values.
void add_spectrum(const ResolvedCase& resolved, LoadSpectrum& spectrum, std::vector<SweepPoint>& points) {
  const std::vector<std::vector<Setting>> lines = lines_of_spectrum(resolved);
  const std::vector<std::size_t> rotating = spectrum.rotating();
  const std::size_t count = points.size() + lines.size() * rotating.size();
  if (static_cast<double>(count) > most_points)
    throw BadInput(
        fmt::format("{}: spectrum: found {} operating points with those of the sweep; required: at most {}",
                    resolved.origin(kSpectrumPath), count, most_points));
  spectrum.lines = lines.size();
  for (const std::vector<Setting>& line : lines)
    for (const std::size_t number : rotating) {
      const LoadBin& bin = spectrum.bins[number];
      std::vector<Setting> settings = line;
      settings.push_back(entering_power(bin));
      settings.push_back({keys().speed, fmt::format("{} rad/s", bin.speed), bin.speed});
      points.push_back(point_of(resolved, std::move(settings)));
    }
}

}  // namespace

SweepPoint point_at_rpm(const ResolvedCase& resolved, std::vector<Setting> settings, double rpm) {
  for (Setting& one : settings)
    if (one.path == keys().speed) one = input_speed(rpm);
  return point_of(resolved, std::move(settings));
}

analysis::PointResult compute_point(const ResolvedCase& resolved, const std::vector<Setting>& settings,
                                    analysis::Fidelity fidelity) {
  const ResolvedCase at_point = resolved.with(settings);
  const std::vector<analysis::NamedSet> sets = bearing_sets(at_point);
  analysis::PointResult result = analysis::evaluate(sets, fidelity);
  return is_idle_bin(settings) ? result : judged(std::move(result), sets);
}

SweptAxis axis_column(const std::string& path) {
  const Field& field = *find_field(path);
  if (field.kind == Kind::quantity)
    return {.column = path + "_" + in_name(field.dimension.customary),
            .units = std::string(field.dimension.customary),
            .meaning = field.meaning};
  return {.column = path, .units = "1", .meaning = field.meaning};
}

double axis_value(const ResolvedCase& resolved, const std::string& path) {
  const Field& field = *find_field(path);
  switch (field.kind) {
    case Kind::quantity:
      return in_table_unit(resolved.quantity(path),
                           *convert(1.0, field.dimension.si, field.dimension.customary).value);
    case Kind::integer:
      return resolved.integer(path);
    default:
      return resolved.number(path);
  }
}

ManifestHeader manifest_header(const ResolvedCase& resolved, const std::string& fidelity,
                               std::size_t points) {
  return {.case_name = resolved.text("name"),
          .case_hash = case_hash(resolved),
          .program_version = std::string(program_version),
          .instruction_set = std::string(instruction_set),
          .fidelity = fidelity,
          .points = points};
}

void require_planet_bearings(const ResolvedCase& resolved) {
  if (resolved.model() != planetary_drivetrain)
    throw BadInput(resolved.origin("model") + ": model: found " + resolved.choice("model") +
                   "; required: planetary-drivetrain, for the life of its planet bearings" +
                   (resolved.model() == gear_pair ? "; orbearing mesh gives the stiffness of a pair"
                                                  : "; orbearing run computes a single bearing"));
  if (!resolved.shape().bearing)
    throw BadInput(resolved.file() +
                   ": bearing: missing; required: a planet bearing, for its life; orbearing run gives the "
                   "vibration of gears alone");
  if (resolved.shape().several && bearing_set_names(resolved).empty())
    throw BadInput(resolved.file() +
                   ": sets: found no set with a bearing; required: at least one, for its life");
}

SweepRequest sweep_request(const ResolvedCase& resolved, const std::string& fidelity) {
  require_planet_bearings(resolved);
  SweepRequest request;
  for (std::size_t i = 0; i < sweep_size(resolved); ++i)
    request.points.push_back(point_of(resolved, sweep_point(resolved, i)));
  const std::size_t grid = request.points.size();
  LoadSpectrum spectrum = load_spectrum(resolved).value_or(LoadSpectrum{});
  if (!spectrum.bins.empty()) add_spectrum(resolved, spectrum, request.points);
  request.header = manifest_header(resolved, fidelity, request.points.size());
  request.header.spectrum = std::move(spectrum);
  for (const SweepAxis& axis : resolved.axes())
    if (axis.path != keys().speed) request.header.axes.push_back(axis_column(axis.path));
  request.header.sets = bearing_set_names(resolved);
  request.header.life = governing_life_key(resolved);
  request.resolved_case = write_resolved(resolved);
  const analysis::Fidelity level = fidelity_of(fidelity);
  const std::vector<SweepPoint> bins(request.points.begin() + static_cast<std::ptrdiff_t>(grid),
                                     request.points.end());
  request.evaluate = [resolved, level, grid, bins](std::size_t index) {
    return compute_point(resolved, index < grid ? sweep_point(resolved, index) : bins[index - grid].settings,
                         level);
  };
  name_resonances(resolved, request);
  return request;
}

void continue_from_neighbours(const ResolvedCase& resolved, Direction direction, SweepRequest& request) {
  std::vector<std::string> mistakes;
  if (request.header.fidelity != "dynamic")
    mistakes.push_back("--continue: found --fidelity " + request.header.fidelity +
                       "; required: --fidelity dynamic, the only one with a state to continue from");
  const std::vector<SweepAxis>& axes = resolved.axes();
  const bool swept = std::any_of(axes.begin(), axes.end(), [](const SweepAxis& axis) {
    return axis.path == keys().speed && axis.values.size() > 1;
  });
  if (!swept)
    mistakes.push_back("--continue: found fewer than two values of " + keys().speed +
                       "; required: at least two speeds, so that points have neighbours");
  if (resolved.has(kSpectrumPath))
    mistakes.push_back(
        "--continue: found with a load spectrum; required: one of both, since bins have no order of "
        "speeds");
  if (resolved.shape().several)
    mistakes.push_back(
        "--continue: found a drivetrain of several sets; required: one set, since a point keeps the "
        "final state of one bearing");
  if (!resolved.shape().several && is_full_complement(resolved))
    mistakes.push_back(
        "--continue: found bearing.complement full, which is solved together with its gears; required: a "
        "cage, since a point keeps the final state of one bearing");
  if (!mistakes.empty()) throw BadInput(mistakes);
  request.header.continued = direction;
  request.evaluate_from = [resolved](std::size_t index, const Eigen::VectorXd& start) {
    if (start.size() == 0)
      return compute_point(resolved, sweep_point(resolved, index), analysis::Fidelity::dynamic);
    const std::vector<analysis::NamedSet> sets = bearing_sets(resolved.with(sweep_point(resolved, index)));
    return judged(analysis::evaluate_from(sets.front().drivetrain, sets.front().geometry, start), sets);
  };
}

nlohmann::ordered_json assumptions_json(const ResolvedCase& resolved) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [key, reason] : resolved.assumed())
    list.push_back(
        {{"key", key}, {"value", resolved.has(key) ? resolved.given(key) : ""}, {"reason", reason}});
  return list;
}

nlohmann::ordered_json assumptions_json(const ResolvedCase& resolved,
                                        const std::vector<AssumedEffect>& effects) {
  nlohmann::ordered_json list = assumptions_json(resolved);
  for (const AssumedEffect& one : effects)
    for (nlohmann::ordered_json& assumption : list)
      if (assumption.at("key") == one.path) assumption["effect"] = one.text;
  return list;
}

nlohmann::ordered_json given_json(const ResolvedCase& resolved) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [path, field] : resolved.inputs())
    if (resolved.has(path) && !resolved.is_replaced(path) && !resolved.assumed().contains(path))
      list.push_back({{"key", path}, {"value", resolved.given(path)}});
  return list;
}

nlohmann::ordered_json versions_json() {
  return {{"orbearing", program_version},
          {"instruction_set", instruction_set},
          {"compiler", compiler},
          {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"boost", BOOST_LIB_VERSION}};
}

}  // namespace orbearing::app
