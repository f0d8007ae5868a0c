#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/presentation.hpp"
#include "app/commands/lone_result.hpp"
#include "app/errors.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/static_study.hpp"
#include "app/study/stiffness_output.hpp"
#include "app/study/stiffness_study.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

// A table for ROSS knows no load: one for each.
void write_tables(const StiffnessStudy& study, const std::filesystem::path& folder) {
  write_aside_and_rename(folder / "stiffness.csv", stiffness_csv(study));
  for (std::size_t series = 0; series < study.series; ++series) {
    const std::string name = study.series == 1 ? "ross.xls" : fmt::format("ross_{}.xls", series + 1);
    write_aside_and_rename(folder / name, ross_table(study, series));
  }
}

}  // namespace

int stiffness_command(const Options& options) {
  require_place_of_results(options);
  const ResolvedCase resolved = case_of(options);
  const bool planet = resolved.model() == planetary_drivetrain;
  const std::vector<std::string> unused =
      require_used(resolved, planet ? use::planet_stiffness : use::stiffness, Axes::all);
  StiffnessStudy study = stiffness_study(resolved);
  study.warnings.insert(study.warnings.begin(), unused.begin(), unused.end());
  const ManifestHeader header = manifest_header(resolved, "stiffness");
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.quiet);
  if (!folder.finished().contains(0)) {
    if (!folder.path().empty()) write_tables(study, folder.path());
    folder.keep(
        {{0, lone_result_file(header, "stiffness", stiffness_content(study)), lone_row(folder.head())}});
  }
  present_lone_result(lone_result_json(resolved, stiffness_json(study), study.warnings),
                      stiffness_text(study), options);
  const bool failed = std::any_of(study.points.begin(), study.points.end(),
                                  [](const StiffnessPoint& point) { return !point.stiffness; });
  return failed ? 1 : 0;
}

}  // namespace orbearing::app
