#include "app/study/variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <mutex>

#include "app/case/field_table.hpp"
#include "app/errors.hpp"
#include "app/study/computable.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/plausibility.hpp"
#include "app/study/sweep_study.hpp"
#include "coupling/study/parallel.hpp"

namespace orbearing::app {

namespace {

std::vector<Setting> settings_of(const Variants& variants, std::size_t index) {
  std::vector<Setting> settings;
  for (std::size_t i = 0; i < variants.paths.size(); ++i)
    settings.push_back({variants.paths[i], "", variants.values[index * variants.paths.size() + i]});
  return settings;
}

// What is wrong with all variants is said once, and not in each row.
void require_variable(const ResolvedCase& point, const Variants& variants) {
  std::vector<std::string> mistakes;
  for (const std::string& path : variants.paths) {
    if (std::count(variants.paths.begin(), variants.paths.end(), path) > 1)
      mistakes.push_back(path + ": found twice among the varied inputs; required: once");
    const std::string field = path.substr(0, path.find('['));
    const std::vector<Input> inputs = point.inputs();
    if (std::none_of(inputs.begin(), inputs.end(), [&](const Input& input) { return input.path == field; }))
      mistakes.push_back(
          fmt::format("{}: {}: found a path that this case does not know; required: the path of a "
                      "number of the case",
                      point.file(), path));
  }
  assert(variants.paths.empty() || variants.values.size() % variants.paths.size() == 0);
  if (!mistakes.empty()) throw BadInput(mistakes);
}

study::PointResult evaluate(const ResolvedCase& point, const std::vector<Setting>& settings,
                            study::Fidelity level) {
  study::PointResult result;
  try {
    const ResolvedCase variant = point.with(settings);
    result.input_speed = variant.quantity(kSpeedPath);
    const std::vector<study::NamedSet> sets = bearing_sets(variant);
    result = judged(study::evaluate(sets, level), sets);
  } catch (const std::exception& error) {
    result.status = error.what();
  }
  return result;
}

}  // namespace

VariantRows evaluate_variants(const ResolvedCase& resolved, const Variants& variants,
                              const std::string& fidelity, int jobs,
                              const std::function<void(std::size_t)>& done) {
  const ResolvedCase point = resolved.without_sweep();
  const std::vector<std::string> names = fidelity_names();
  if (std::find(names.begin(), names.end(), fidelity) == names.end())
    throw BadInput(fmt::format("fidelity: found {}; required: one of {}", fidelity, fmt::join(names, ", ")));
  require_variable(point, variants);
  sweep_request(point, fidelity);  // refuses what has no operating points
  require_computable(point, fidelity, false);
  const study::Fidelity level = fidelity_of(fidelity);
  const std::vector<std::string> sets = bearing_set_names(point);
  VariantRows table{table_head({}, sets), std::vector<ResultRow>(variants.count())};
  std::mutex telling;
  std::size_t finished = 0;
  study::in_parallel(table.rows.size(), jobs, [&](std::size_t index) {
    table.rows[index] = result_row(evaluate(point, settings_of(variants, index), level), {}, sets);
    if (!done) return;
    const std::scoped_lock lock(telling);
    done(++finished);
  });
  return table;
}

}  // namespace orbearing::app
