#include "app/study/table_study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/case/case_file.hpp"
#include "app/case/field_table.hpp"
#include "app/case/mistake.hpp"
#include "app/case/resolved_writer.hpp"
#include "app/errors.hpp"
#include "app/results/durable_file.hpp"
#include "app/results/record_writers.hpp"
#include "app/study/analysis.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/sweep_study.hpp"
#include "app/version.hpp"
#include "orbearing/files.hpp"

namespace orbearing::analysis {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TableSplit, input, at, below, above)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TableCell, lower, upper, terms, weights, error)
}  // namespace orbearing::analysis

namespace orbearing {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TableInput, path, from, to, by_logarithm)
}

namespace orbearing::app {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TabulatedResult, name, unit, by_logarithm, scale, largest_error,
                                   mean_error, within_bound_share, within_stated_share)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TabulatedCase, case_name, case_hash, program_version, instruction_set,
                                   fidelity, resolved_case, inputs, results, bound, scatter, points,
                                   failed_points, check_points)

namespace {

using Json = nlohmann::ordered_json;

constexpr int table_format = 1;
constexpr std::size_t kPointsAtRest = 50000;
constexpr double kWideRange = 2.0;       // ratio of ends from which an input is taken by its logarithm
constexpr double kShift = 1e-9;          // [-]  of the inputs, for the scatter of a result
constexpr double kEndTolerance = 1e-12;  // [-]  by which rounding may put an end outside the box
constexpr std::uint64_t kCheckSeed = 0;
constexpr std::uint64_t kCellSeed = 1;  // of the first cell; each has one of its own

double value_at(const TableInput& input, double coordinate) {
  const double share = 0.5 * (1.0 + coordinate);
  const double value = input.by_logarithm ? input.from * std::pow(input.to / input.from, share)
                                          : input.from + share * (input.to - input.from);
  return std::clamp(value, input.from, input.to);
}

std::vector<Setting> settings_at(const std::vector<TableInput>& inputs, const double* values) {
  std::vector<Setting> settings;
  for (std::size_t i = 0; i < inputs.size(); ++i) settings.push_back({inputs[i].path, "", values[i]});
  return settings;
}

std::vector<double> values_at(const std::vector<TableInput>& inputs, const analysis::TablePoint& point) {
  std::vector<double> values;
  for (std::size_t i = 0; i < inputs.size(); ++i) values.push_back(value_at(inputs[i], point[i]));
  return values;
}

// Independent check points of the whole table, and check points of a cell, of so many points.
std::size_t independent_checks(std::size_t points) {
  return std::clamp<std::size_t>(points / 10, 4, 400);
}
std::size_t cell_checks(std::size_t points) {
  return std::clamp<std::size_t>(points / 40, 3, 24);
}

}  // namespace

Coordinate::Coordinate(const TableInput& input)
    : input_(input), range_(input.by_logarithm ? std::log(input.to / input.from) : input.to - input.from) {}

double Coordinate::operator()(double value) const {
  const double share = (input_.by_logarithm ? std::log(value / input_.from) : value - input_.from) / range_;
  const double at = 2.0 * share - 1.0;
  return std::abs(at) > 1.0 && std::abs(at) <= 1.0 + kEndTolerance ? std::copysign(1.0, at) : at;
}

std::string in_customary(const TableInput& input, double value) {
  const Field& field = *find_field(input.path);
  if (field.kind != Kind::quantity) return fmt::format("{}", value);
  return fmt::format("{} {}", in_customary_unit(field.dimension, value), field.dimension.customary);
}

double TabulatedResult::tabulated(double value) const {
  return by_logarithm ? std::log(value) : value / scale;
}

double TabulatedResult::value(double tabulated) const {
  return by_logarithm ? std::exp(tabulated) : tabulated * scale;
}

double TabulatedResult::error(double value, double tabulated) const {
  return by_logarithm ? std::abs(value) * std::expm1(tabulated) : tabulated * scale;
}

void describe(Record& record, const TabulatedCase& table) {
  using namespace described;
  record.value("fidelity", "of the points", table.fidelity);
  record.table("inputs", "input", "tabulated inputs", table.inputs, [](Record& row, const TableInput& input) {
    row.value("path", "of the input", input.path);
    row.value("from", "lower end, with its unit", in_customary(input, input.from));
    row.value("to", "upper end, with its unit", in_customary(input, input.to));
    row.value("by_logarithm", "whether polynomials are of its logarithm", input.by_logarithm);
  });
  record.table(
      "results", "result", "tabulated results", table.results,
      [](Record& row, const TabulatedResult& result) {
        row.value("name", "column of a sweep's table", result.name);
        row.value("by_logarithm", "whether its errors are over its value", result.by_logarithm);
        row.value("scale", Dimension{}, "value over which errors are otherwise", result.scale);
        row.value("largest_error", dimension::ratio, "at the independent check points", result.largest_error);
        row.value("mean_error", dimension::ratio, "at the independent check points", result.mean_error);
        row.value("within_bound_share", dimension::ratio, "share of them with an error within the bound",
                  result.within_bound_share);
        row.value("within_stated_share", dimension::ratio,
                  "share of them with an error within that of their cell", result.within_stated_share);
      });
  record.value("bound", dimension::ratio, "error at which a cell is finished", table.bound);
  record.value("scatter", dimension::ratio, "of the computed values", table.scatter);
  record.value("points", "computed points", table.points);
  record.value("failed_points", "points without a result", table.failed_points);
  record.value("check_points", "independent check points in cells within the bound", table.check_points);
  record.value("cells", "cells with polynomials of their own", table.table.cells().size());
  record.value("within_bound_volume", dimension::ratio,
               "share of the box in cells within the bound; elsewhere the program computes",
               table.table.share_within(std::log1p(table.bound)));
}

std::string table_text(const TabulatedCase& table) {
  nlohmann::json object = table;
  object["orbearing_table"] = table_format;
  object["splits"] = table.table.splits();
  object["cells"] = table.table.cells();
  return sealed_line(object.dump());
}

TabulatedCase read_table(const std::string& name) {
  namespace fs = std::filesystem;
  const fs::path path = fs::is_directory(name) ? fs::path(name) / table_file_name : fs::path(name);
  const std::string text = read_file(path);
  try {
    const std::string line = text.substr(0, text.find('\n'));
    const auto object = nlohmann::json::parse(line);
    if (!is_sealed(line) || object.at("orbearing_table") != table_format) throw std::invalid_argument(name);
    auto table = object.get<TabulatedCase>();
    table.file = path.string();
    table.table = {table.inputs.size(), table.results.size(), object.at("splits"), object.at("cells")};
    return table;
  } catch (const std::exception&) {
    throw BadInput(fmt::format(
        "{}: found no undamaged table of this format; required: the file that orbearing table wrote",
        path.string()));
  }
}

ResolvedCase over_box(const ResolvedCase& resolved, const std::vector<std::string>& over) {
  if (over.empty()) return resolved;
  std::string sweep;
  std::vector<std::string> mistakes;
  for (const std::string& one : over) {
    const std::size_t equals = one.find('='), dots = one.find("..");
    if (equals == std::string::npos || dots == std::string::npos || dots < equals)
      mistakes.push_back(
          fmt::format("--over: found {}; required: PATH=FROM..TO, as input.speed=1000 rpm..6000 rpm", one));
    else
      sweep += fmt::format("{}{}: [\"{}\", \"{}\"]", sweep.empty() ? "" : ", ", one.substr(0, equals),
                           one.substr(equals + 1, dots - equals - 1), one.substr(dots + 2));
  }
  if (!mistakes.empty()) throw BadInput(mistakes);
  return named_by_option({{"--set: sweep.", "--over: "}}, [&] {
    return parse_case(write_resolved(resolved), resolved.file(), {"sweep={" + sweep + "}"});
  });
}

// A table in progress. Rows of a resumed folder are processed again, so that each round follows from the same
// rows as in an undisturbed run.
struct TableStudy::State {
  ResolvedCase resolved;
  TabulatedCase table;
  TableChoice choice;
  std::size_t checks =
      0;  // independent check points, the first of all; the middle of the box follows, and beside it
  SweepRequest request;
  std::vector<analysis::TablePoint> first;
  std::unique_ptr<analysis::TableBuilder> builder;
  std::size_t taken = 0;  // rows

  SweepPoint sweep_point_of(const analysis::TablePoint& point) const;
  double value_of(const SweepRow& row, const TabulatedResult& result) const;
  std::vector<double> tabulated(const SweepRow& row) const;
  void begin(const std::vector<SweepRow>& rows);
  std::vector<SweepPoint> next(const std::vector<SweepRow>& rows);
  void measure(const std::vector<SweepRow>& rows);
};

SweepPoint TableStudy::State::sweep_point_of(const analysis::TablePoint& point) const {
  const std::vector<double> values = values_at(table.inputs, point);
  SweepPoint added{.label = "", .input_speed = resolved.quantity(keys().speed)};
  added.settings = settings_at(table.inputs, values.data());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (table.inputs[i].path == keys().speed)
      added.input_speed = values[i];
    else
      added.axis_values.push_back(in_customary_unit(find_field(table.inputs[i].path)->dimension, values[i]));
  return added;
}

// By the name that the user chose.
double TableStudy::State::value_of(const SweepRow& row, const TabulatedResult& result) const {
  return number_named(request.header, row, result.name);
}

std::vector<double> TableStudy::State::tabulated(const SweepRow& row) const {
  std::vector<double> values;
  for (const TabulatedResult& result : table.results)
    values.push_back(row.ok() ? result.tabulated(value_of(row, result)) : not_given);
  return values;
}

// The first points determine how each result is tabulated, and its scatter.
void TableStudy::State::begin(const std::vector<SweepRow>& rows) {
  for (TabulatedResult& result : table.results) {
    result.by_logarithm = result.unit != "1";
    result.scale = -1.0;
    for (const SweepRow& row : rows) {
      const double value = value_of(row, result);
      if (!row.ok() || std::isnan(value)) continue;
      result.by_logarithm = result.by_logarithm && value > 0.0;
      result.scale = std::max(result.scale, std::abs(value));
    }
    if (result.scale < 0.0)
      throw BadInput(
          fmt::format("--result: found {}, which has no value at any of {} points; required: a number of "
                      "this case",
                      result.name, rows.size()));
    if (result.scale == 0.0) result.scale = 1.0;
  }
  const std::vector<double> middle = tabulated(rows[checks]);
  for (std::size_t beside = checks + 1; beside < rows.size(); ++beside)
    for (std::size_t r = 0; r < middle.size(); ++r) {
      const double change = std::abs(tabulated(rows[beside])[r] - middle[r]);
      if (std::isfinite(change)) table.scatter = std::max(table.scatter, change);
    }
  builder = std::make_unique<analysis::TableBuilder>(
      analysis::TableTarget{.inputs = table.inputs.size(),
                            .results = table.results.size(),
                            .bound = std::log1p(table.bound),
                            .most_points = choice.points - rows.size(),
                            .scatter = table.scatter,
                            .checks = cell_checks(choice.points),
                            .box_checks = independent_checks(choice.points),
                            .seed = kCellSeed});
}

std::vector<SweepPoint> TableStudy::State::next(const std::vector<SweepRow>& rows) {
  if (!builder) {
    begin(rows);
  } else {
    std::vector<std::vector<double>> values;
    for (std::size_t row = taken; row < rows.size(); ++row) values.push_back(tabulated(rows[row]));
    builder->take(values);
  }
  taken = rows.size();
  std::vector<SweepPoint> points;
  for (const analysis::TablePoint& point : builder->next()) points.push_back(sweep_point_of(point));
  if (points.empty()) measure(rows);
  return points;
}

// Errors at the check points that no cell has used.
void TableStudy::State::measure(const std::vector<SweepRow>& rows) {
  table.table = builder->table();
  for (std::size_t r = 0; r < table.results.size(); ++r) {
    TabulatedResult& result = table.results[r];
    std::size_t answered = 0, within_bound = 0, within_stated = 0;
    for (std::size_t check = 0; check < checks; ++check) {
      const analysis::TableValue found = table.table.at(first[check], r);
      const double miss = std::abs(tabulated(rows[check])[r] - found.value);
      if (!(found.error <= std::log1p(table.bound)) || !std::isfinite(miss)) continue;
      const double error = result.by_logarithm ? std::expm1(miss) : miss;
      ++answered;
      within_bound += error <= table.bound ? 1 : 0;
      within_stated += miss <= found.error ? 1 : 0;
      result.mean_error += error;
      result.largest_error = std::max(result.largest_error, error);
    }
    table.check_points = answered;
    if (answered == 0) continue;
    const auto all = static_cast<double>(answered);
    result.mean_error /= all;
    result.within_bound_share = static_cast<double>(within_bound) / all;
    result.within_stated_share = static_cast<double>(within_stated) / all;
  }
}

namespace {

std::vector<TableInput> inputs_of_box(const ResolvedCase& resolved) {
  std::vector<TableInput> inputs;
  std::vector<std::string> mistakes;
  for (const SweepAxis& axis : resolved.axes()) {
    const auto [least, most] = std::minmax_element(axis.numbers.begin(), axis.numbers.end());
    if (*least == *most || find_field(axis.path)->kind == Kind::integer)
      mistakes.push_back(fmt::format("{}: sweep.{}: found {}; required: two ends of a range of real numbers",
                                     resolved.file(), axis.path, axis.written));
    inputs.push_back({axis.path, *least, *most, *least > 0.0 && *most >= kWideRange * *least});
  }
  if (inputs.empty() || inputs.size() > analysis::kMostTableInputs)
    mistakes.push_back(fmt::format("--over: found {} inputs; required: 1 to {}, here or in the case's sweep",
                                   inputs.size(), analysis::kMostTableInputs));
  if (!mistakes.empty()) throw BadInput(mistakes);
  return inputs;
}

std::vector<TabulatedResult> results_of_choice(const ManifestHeader& header,
                                               const std::vector<std::string>& chosen) {
  const ManifestHeader points{.sets = header.sets};  // without axes
  const Json units = units_of(record_of(points, row_of_numbers({}, points)));
  std::vector<std::string> numbers;
  for (const auto& [name, unit] : units.items()) numbers.push_back(name);
  std::vector<TabulatedResult> results;
  for (const std::string& name : chosen.empty() ? std::vector{header.life} : chosen) {
    if (!units.contains(name)) {
      const std::string near = nearest_word(name, numbers);
      throw BadInput(fmt::format("--result: found {}; required: a column of numbers of a sweep's table{}",
                                 name, near.empty() ? "" : ", such as " + near));
    }
    results.push_back({.name = name, .unit = units[name].get<std::string>()});
  }
  return results;
}

std::size_t most_points_of(const TableChoice& choice, std::size_t inputs, bool moves) {
  const std::size_t points = choice.points > 0 ? choice.points : kPointsAtRest;
  const std::size_t least =
      independent_checks(points) + 3 + analysis::table_first_points(inputs, cell_checks(points));
  if (choice.points == 0 && moves)
    throw BadInput(
        fmt::format("--points: missing; required: the largest number of runs in motion, at least {}",
                    independent_checks(0) + 3 + analysis::table_first_points(inputs, cell_checks(0))));
  if (points < least)
    throw BadInput(
        fmt::format("--points: found {}; required: at least {} for {} inputs", points, least, inputs));
  return points;
}

}  // namespace

TableStudy::TableStudy(const ResolvedCase& resolved, const std::string& fidelity, const TableChoice& choice)
    : state_(std::make_shared<State>(State{resolved, {}, choice})) {
  State& state = *state_;
  TabulatedCase& table = state.table;
  const analysis::Fidelity level = fidelity_of(fidelity);
  table.inputs = inputs_of_box(resolved);
  table.bound = choice.bound;
  table.scatter = in_time(level) ? scatter::in_motion : scatter::at_rest;
  if (table.bound < 2.0 * table.scatter)
    throw BadInput(
        fmt::format("--bound: found {}; required: at least {}, twice the scatter of computed values",
                    table.bound, 2.0 * table.scatter));
  state.choice.points = most_points_of(choice, table.inputs.size(), in_time(level));
  state.checks = independent_checks(state.choice.points);
  for (std::size_t check = 0; check < state.checks + 3; ++check) {
    analysis::TablePoint& point = state.first.emplace_back();
    for (std::size_t i = 0; i < table.inputs.size(); ++i)
      point[i] = check < state.checks
                     ? analysis::table_random(kCheckSeed, check * analysis::kMostTableInputs + i)
                     : kShift * static_cast<double>(check - state.checks);
  }
  SweepRequest& request = state.request = sweep_request(resolved, fidelity);
  table.results = results_of_choice(request.header, choice.results);
  table.case_name = request.header.case_name;
  table.case_hash = request.header.case_hash;
  table.program_version = request.header.program_version;
  table.instruction_set = request.header.instruction_set;
  table.fidelity = fidelity;
  table.resolved_case = request.resolved_case;
  request.points.clear();
  for (const analysis::TablePoint& point : state.first) request.points.push_back(state.sweep_point_of(point));
  request.header.points = request.points.size();
  request.header.spectrum = {};
  request.header.resonances = false;
  request.header.refined = true;
  std::vector<std::string> names = described::each(table.results, &TabulatedResult::name);
  request.header.table =
      fmt::format("{}; bound {}; {} points", fmt::join(names, ", "), table.bound, state.choice.points);
  request.point_files = in_time(level);
}

SweepRequest TableStudy::request() const {
  SweepRequest request = state_->request;
  const analysis::Fidelity level = fidelity_of(state_->table.fidelity);
  const auto compute = [resolved = state_->resolved, level](const SweepPoint& point) {
    return compute_point(resolved, point.settings, level);
  };
  request.evaluate = [compute, points = request.points](std::size_t index) { return compute(points[index]); };
  request.refinement = Refinement{
      [state = state_](const std::vector<SweepRow>& rows) { return state->next(rows); }, compute, "table"};
  return request;
}

TabulatedCase TableStudy::result(const SweepOutcome& outcome) const {
  TabulatedCase table = state_->table;
  table.points = outcome.rows.size();
  table.failed_points = outcome.failed;
  return table;
}

}  // namespace orbearing::app
