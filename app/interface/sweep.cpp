#include "orbearing/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "app/case/field_table.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/interface/points.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/plausibility.hpp"
#include "app/study/sweep_study.hpp"
#include "coupling/analysis/parallel.hpp"

namespace orbearing {

namespace {

// Mistakes that concern all points are reported once, and not in each row.
void require_varied(const app::ResolvedCase& point, const std::vector<std::string>& paths,
                    std::size_t numbers) {
  if (paths.empty() || numbers % paths.size() != 0)
    throw BadInput(
        fmt::format("values: found {} numbers for {} paths; required: at least one path, and a number for "
                    "each of them in each row",
                    numbers, paths.size()));
  std::vector<std::string> mistakes;
  const std::vector<app::Input> inputs = point.inputs();
  for (const std::string& path : paths) {
    if (std::count(paths.begin(), paths.end(), path) > 1)
      mistakes.push_back(path + ": found twice among the varied inputs; required: once");
    const std::string field = path.substr(0, path.find('['));
    if (std::none_of(inputs.begin(), inputs.end(),
                     [&](const app::Input& input) { return input.path == field; }))
      mistakes.push_back(fmt::format(
          "{}: {}: found a path that this case does not have; required: the path of a number of the case",
          point.file(), path));
  }
  if (!mistakes.empty()) throw BadInput(mistakes);
}

analysis::PointResult point_with(const app::ResolvedCase& point, const std::vector<app::Setting>& settings,
                                 analysis::Fidelity level) {
  analysis::PointResult result;
  try {
    const app::ResolvedCase variant = point.with(settings);
    result.input_speed = variant.quantity(app::keys().speed);
    const std::vector<analysis::NamedSet> sets = app::bearing_sets(variant);
    result = app::judged(analysis::evaluate(sets, level), sets);
  } catch (const std::exception& error) {
    result.status = error.what();
  }
  return result;
}

// Without the columns that hold text.
std::vector<std::pair<std::string, double>> numbers_of(const app::ManifestHeader& header,
                                                       const app::SweepRow& row) {
  std::vector<std::pair<std::string, double>> numbers = app::named_numbers(header, row);
  std::erase_if(numbers, [](const auto& one) { return one.first == app::refined_column; });
  return numbers;
}

Points points_of(const app::ManifestHeader& header, const std::vector<app::SweepRow>& rows) {
  Points points;
  for (const auto& [name, number] : numbers_of(header, app::row_of_numbers({}, header)))
    points.columns.push_back(name);
  for (const app::SweepRow& row : rows) {
    for (const auto& [name, number] : numbers_of(header, row)) points.numbers.push_back(number);
    points.status.push_back(row.point.status);
  }
  return points;
}

}  // namespace

Points evaluate(const Case& stated, const std::vector<std::string>& paths, const std::vector<double>& values,
                const std::string& fidelity, int jobs, const std::function<void(std::size_t)>& done) {
  return evaluate(stated, paths, values, fidelity, jobs, done, WithoutEffect::refused);
}

Points evaluate(const Case& stated, const std::vector<std::string>& paths, const std::vector<double>& values,
                const std::string& fidelity, int jobs, const std::function<void(std::size_t)>& done,
                WithoutEffect without_effect) {
  const app::ResolvedCase point = stated.content().without_sweep();
  const analysis::Fidelity level = app::fidelity_of(fidelity);
  require_varied(point, paths, values.size());
  app::sweep_request(point, fidelity);  // refuses what has no operating points
  app::require_computable(point, fidelity, false);
  if (without_effect == WithoutEffect::refused)
    app::require_effect({point}, app::rung_of(point, fidelity), paths);
  const app::ManifestHeader header{.sets = app::bearing_set_names(point)};
  std::vector<app::SweepRow> rows(values.size() / paths.size());
  std::mutex telling;
  std::size_t finished = 0;
  analysis::in_parallel(rows.size(), jobs, [&](std::size_t index) {
    std::vector<app::Setting> settings;
    for (std::size_t i = 0; i < paths.size(); ++i)
      settings.push_back({paths[i], "", values[index * paths.size() + i]});
    rows[index] = app::sweep_row(point_with(point, settings, level), header);
    if (!done) return;
    const std::scoped_lock lock(telling);
    done(++finished);
  });
  return points_of(header, rows);
}

}  // namespace orbearing
