#include "app/commands/table.hpp"

#include <fmt/format.h>

#include "app/case/spectrum_case.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/kept_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/results/durable_file.hpp"
#include "app/study/analysis.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/table_study.hpp"

namespace orbearing::app {

namespace {

std::vector<std::string> warnings_of(const TabulatedCase& table) {
  std::vector<std::string> warnings;
  const double share = table.table.share_within(std::log1p(table.bound));
  if (share < 1.0)
    warnings.push_back(fmt::format(
        "table: {:.3g} % of the box is above the bound after {} points and is computed for each query; "
        "increase --points or --bound",
        100.0 * (1.0 - share), table.points));
  for (const TabulatedResult& result : table.results)
    if (result.largest_error > table.bound)
      warnings.push_back(
          fmt::format("table: {} misses the bound of {} at {:.3g} % of {} independent check points, "
                      "by up to {:.3g}",
                      result.name, table.bound, 100.0 * (1.0 - result.within_bound_share), table.check_points,
                      result.largest_error));
  return warnings;
}

}  // namespace

std::vector<std::string> problems(const TableOptions& options) {
  return problems(ResultPlace{options.output, options.resume}, options.print);
}

int execute(const TableOptions& options) {
  const ResolvedCase resolved = over_box(case_of(options.stated), options.over);
  const std::string fidelity = fidelity_or_default(options.fidelity);
  require_computable(resolved, fidelity, true);
  std::vector<std::string> warnings = joined(require_used(resolved, rung_of(resolved, fidelity), Axes::all),
                                             spectrum_warnings(resolved, "table"));
  const TableStudy study(resolved, fidelity,
                         {.over = options.over,
                          .results = options.results,
                          .bound = options.bound,
                          .points = static_cast<std::size_t>(options.points)});
  SweepRequest request = study.request();
  put_execution({options.output, options.resume}, options.jobs, options.print, request);
  const TabulatedCase table = study.result(run_sweep(request));
  if (!options.output.empty()) write_aside_and_rename(request.folder / table_file_name, table_text(table));
  Record record;
  describe(record, table);
  present_record(resolved, record, joined(warnings, warnings_of(table)), options.print);
  if (table.failed_points == 0) return 0;
  print_failures(fmt::format("{} of {} points failed; queries beside them are computed", table.failed_points,
                             table.points),
                 options.print);
  return 1;
}

}  // namespace orbearing::app
