#include "orbearing/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/case/case_file.hpp"
#include "app/results/record_writers.hpp"
#include "app/study/table_study.hpp"
#include "coupling/analysis/parallel.hpp"
#include "orbearing/sweep.hpp"
#include "orbearing/version.hpp"

namespace orbearing {

Table::Table(std::shared_ptr<const app::TabulatedCase> content, Case stated)
    : content_(std::move(content)), stated_(std::move(stated)) {}

Table Table::read(const std::string& file) {
  auto content = std::make_shared<const app::TabulatedCase>(app::read_table(file));
  Case stated{app::parse_case(content->resolved_case, content->file).without_sweep()};
  return {std::move(content), std::move(stated)};
}

const std::vector<TableInput>& Table::inputs() const {
  return content_->inputs;
}

std::vector<std::string> Table::results() const {
  std::vector<std::string> names;
  for (const app::TabulatedResult& result : content_->results) names.push_back(result.name);
  return names;
}

double Table::bound() const {
  return content_->bound;
}

namespace {

// Why the table does not answer a query.
std::string reason_of(const app::TabulatedCase& table, std::size_t query, const double* values, double error,
                      double bound) {
  for (std::size_t i = 0; i < table.inputs.size(); ++i) {
    const TableInput& input = table.inputs[i];
    if (!(std::abs(app::Coordinate(input)(values[i])) <= 1.0))
      return fmt::format("{}: query {}: found {} = {}; required: {} to {}, the range of the table",
                         table.file, query, input.path, app::in_customary(input, values[i]),
                         app::in_customary(input, input.from), app::in_customary(input, input.to));
  }
  return fmt::format(
      "{}: query {}: found a stated error of {:.2g}; required: at most {:.2g}, or a computation", table.file,
      query, std::expm1(error), bound);
}

// Computed by the program instead of interpolated in the table.
void compute(const app::TabulatedCase& table, const Case& stated, const app::TabulatedResult& result,
             const std::vector<double>& values, int jobs, TableAnswers& answers) {
  std::vector<std::size_t> queries;
  std::vector<double> rows;
  std::vector<std::string> paths;
  for (const TableInput& input : table.inputs) paths.push_back(input.path);
  for (std::size_t n = 0; n < answers.computed.size(); ++n) {
    if (answers.computed[n] == 0) continue;
    queries.push_back(n);
    const auto row = values.begin() + static_cast<std::ptrdiff_t>(n * paths.size());
    rows.insert(rows.end(), row, row + static_cast<std::ptrdiff_t>(paths.size()));
  }
  if (queries.empty()) return;
  if (table.program_version != version())
    throw BadInput(
        fmt::format("{}: found a table of version {} and {} queries that it cannot answer; required: "
                    "that version to compute them, or a new table",
                    table.file, table.program_version, queries.size()));
  const Points found = evaluate(stated, paths, rows, table.fidelity, jobs);
  const auto column =
      std::find(found.columns.begin(), found.columns.end(), result.name) - found.columns.begin();
  for (std::size_t k = 0; k < queries.size(); ++k) {
    const bool good = app::is_computed(found.status[k]);
    if (!good) answers.failures[queries[k]] = found.status[k];
    const double value = found.numbers[k * found.columns.size() + static_cast<std::size_t>(column)];
    answers.values[queries[k]] = good ? value : app::not_given;
    answers.errors[queries[k]] = result.error(answers.values[queries[k]], table.scatter);
  }
}

}  // namespace

TableAnswers Table::answers(const std::string& name, const std::vector<double>& values,
                            const TableQuery& query) const {
  const app::TabulatedCase& table = *content_;
  const std::size_t inputs = table.inputs.size();
  const auto found = std::ranges::find(table.results, name, &app::TabulatedResult::name);
  if (found == table.results.end() || values.size() % inputs != 0)
    throw BadInput(
        fmt::format("{}: found the result {} and {} numbers; required: one of {}, and rows of {} inputs",
                    table.file, name, values.size(), fmt::join(results(), ", "), inputs));
  const auto result = static_cast<std::size_t>(found - table.results.begin());
  const std::size_t count = values.size() / inputs;
  const double bound = query.bound.value_or(table.bound), largest = std::log1p(bound);
  const std::vector<app::Coordinate> coordinates(table.inputs.begin(), table.inputs.end());
  TableAnswers answers{
      std::vector<double>(count), std::vector<double>(count), std::vector<char>(count, 0), {}};
  constexpr std::size_t together = 4096;  // queries of a task
  analysis::in_parallel((count + together - 1) / together, query.jobs, [&](std::size_t task) {
    for (std::size_t n = task * together; n < std::min(count, (task + 1) * together); ++n) {
      analysis::TablePoint point{};
      for (std::size_t i = 0; i < inputs; ++i) point[i] = coordinates[i](values[n * inputs + i]);
      const analysis::TableValue at = table.table.at(point, result);
      answers.values[n] = found->value(at.value);
      answers.errors[n] = found->error(answers.values[n], at.error);
      answers.computed[n] = at.error <= largest ? 0 : 1;
      if (answers.computed[n] == 1 && !query.compute)
        throw BadInput(reason_of(table, n, values.data() + n * inputs, at.error, bound));
    }
  });
  compute(table, stated_, *found, values, query.jobs, answers);
  return answers;
}

}  // namespace orbearing
