#include "app/commands/defect_run.hpp"

#include <nlohmann/json.hpp>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/lone_result.hpp"
#include "app/errors.hpp"
#include "app/results/progress.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/defect_output.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

ResultRow defect_row(const TableHead& head, const DefectStudy& study) {
  const double largest = study.vibration.largest_load;
  return lone_row(head, {{"inner_load_max_N", largest}, {"outer_load_max_N", largest}});
}

std::string defect_file(const ManifestHeader& header, const DefectStudy& study) {
  return lone_result_file(header, "vibration of a bearing with scratches", defect_content(study));
}

void require_rung(const ResolvedCase& resolved, bool moving) {
  if (moving && resolved.model() == roller_defect)
    throw BadInput(
        "--fidelity: found dynamic for a scratched bearing of rollers by itself; required: none, or a "
        "planetary "
        "drivetrain with a block 'defect', where all of its bearings move");
}

namespace {

void keep(const ManifestHeader& header, const nlohmann::ordered_json& result, const DefectStudy& study,
          ResultFolder& folder) {
  if (folder.finished().contains(0)) return;
  if (!folder.path().empty()) {
    const std::string object = result.dump(2) + "\n", csv = signal_csv(study), wav = signal_wav(study);
    write_aside_and_rename({{folder.path() / defect_file_name, object},
                            {folder.path() / "signal.csv", csv},
                            {folder.path() / "signal.wav", wav}});
  }
  folder.keep({{0, defect_file(header, study), defect_row(folder.head(), study)}});
}

DefectStudy study_of(const ResolvedCase& resolved, bool moving, const Options& options) {
  if (!moving) return defect_study(resolved);
  constexpr std::size_t parts = 100;
  Progress progress(0, parts, !options.quiet, "signal, in hundredths: ");
  return defect_study(resolved, DefectRung::all,
                      [&](double share) { progress.show(static_cast<std::size_t>(share * parts)); });
}

}  // namespace

int run_defect_case(const ResolvedCase& resolved, const Options& options) {
  const bool moving = options.fidelity == "dynamic";
  require_rung(resolved, moving);
  if (!moving && options.fidelity != "quasi-static")
    throw BadInput("--fidelity: found " + options.fidelity +
                   "; required: none for the model raceway-defect, whose ring moves on balls without mass, or "
                   "dynamic, for all of the bearing in motion");
  const std::vector<std::string> unused =
      require_used(resolved, moving ? use::moving_defect : use::defect);
  const ManifestHeader header = manifest_header(resolved, moving ? "defect, all in motion" : "defect");
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.quiet);
  DefectStudy study = study_of(resolved, moving, options);
  study.warnings.insert(study.warnings.begin(), unused.begin(), unused.end());
  const nlohmann::ordered_json result = lone_result_json(resolved, defect_json(study), study.warnings);
  keep(header, result, study, folder);
  present_lone_result(result, defect_text(study), options);
  return 0;
}

}  // namespace orbearing::app
