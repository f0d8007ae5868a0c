#include "app/commands/defect_run.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <limits>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "app/results/point_file.hpp"
#include "app/results/progress.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/defect_output.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

ResultRow defect_row(const TableHead& head, const DefectStudy& study) {
  ResultRow row{std::vector<double>(head.names.size(), std::numeric_limits<double>::quiet_NaN()), "ok"};
  for (std::size_t i = 0; i < head.names.size(); ++i)
    if (head.names[i] == "inner_load_max_N" || head.names[i] == "outer_load_max_N")
      row.values[i] = in_table_unit(study.vibration.largest_load, 1.0);
  return row;
}

std::string defect_file(const ManifestHeader& header, const DefectStudy& study) {
  PointContent content = defect_content(study);
  content.attributes = {{"Conventions", "CF-1.10"},
                        {"title", header.case_name + ", vibration of a bearing with scratches"},
                        {"source", "Orbearing " + header.program_version},
                        {"case", header.case_name},
                        {"case_hash", header.case_hash},
                        {"program_version", header.program_version},
                        {"instruction_set", header.instruction_set},
                        {"fidelity", header.fidelity},
                        {"status", "ok"}};
  return netcdf_bytes(content);
}

namespace {

nlohmann::ordered_json result_of(const ResolvedCase& resolved, const DefectStudy& study) {
  nlohmann::ordered_json object{{"case", resolved.text("name")}, {"model", resolved.choice("model")}};
  object.update(defect_json(study));
  object["assumptions"] = assumptions_json(resolved);
  object["warnings"] = study.warnings;
  object["versions"] = versions_json();
  return object;
}

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
  const nlohmann::ordered_json result = result_of(resolved, study);
  keep(header, result, study, folder);
  if (options.json) {
    fmt::print("{}\n", result.dump(2));
  } else if (!options.quiet) {
    fmt::print("{}", defect_text(study));
    for (const std::string& warning : study.warnings) fmt::print("warning: {}\n", warning);
  }
  return 0;
}

}  // namespace orbearing::app
