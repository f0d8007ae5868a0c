#include "app/commands/duplex_run.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/lone_result.hpp"
#include "app/errors.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/duplex_output.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

constexpr const char* kDuplexFile = "duplex.json";

void keep_pair(const ManifestHeader& header, const std::string& object, const DuplexStudy& study,
               ResultFolder& folder) {
  if (folder.finished().contains(0)) return;
  if (!folder.path().empty()) {
    const std::string csv = predictions_csv(study);
    write_aside_and_rename({{folder.path() / kDuplexFile, object}, {folder.path() / "predictions.csv", csv}});
    if (!study.over_speed.empty())
      write_aside_and_rename(folder.path() / "modes_over_speed.csv", pair_speeds_csv(study.over_speed));
  }
  const bearing::equilibrium::RingState& state = study.point.state;
  const double inner = state.contact_load.maxCoeff();
  const double outer = state.outer_load.size() > 0 ? state.outer_load.maxCoeff() : inner;
  folder.keep({{0, lone_result_file(header, "shaft on a duplex pair", duplex_content(study)),
                lone_row(folder.head(), {{"inner_load_max_N", inner}, {"outer_load_max_N", outer}})}});
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

bool has_failed(const std::vector<PairAtSpeed>& points) {
  return std::any_of(points.begin(), points.end(), [](const PairAtSpeed& point) { return !point.modes; });
}

}  // namespace

int duplex_modes(const ResolvedCase& resolved, const Options& options) {
  const std::vector<std::string> unused = require_used(resolved, use::duplex_modes);
  const PairPoint point = pair_point(resolved);
  const std::vector<PairAtSpeed> over_speed = pair_over_speed(resolved);
  const std::vector<std::string> warnings = joined(unused, point.warnings);
  nlohmann::ordered_json object{{"case", resolved.text("name")}};
  object.update(pair_modes_json(point));
  object.update(pair_speeds_json(over_speed));
  object["warnings"] = warnings;
  present_lone_result(object, pair_modes_text(point) + pair_speeds_text(over_speed), options);
  return has_failed(over_speed) ? 1 : 0;
}

int run_duplex_case(const ResolvedCase& resolved, const Options& options) {
  if (options.fidelity != "quasi-static")
    throw BadInput("--fidelity: found " + options.fidelity +
                   "; required: none for the model duplex-pair, which is in balance");
  const std::vector<std::string> unused = require_used(resolved, use::duplex_run);
  const ManifestHeader header = manifest_header(resolved, "duplex");
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.quiet);
  const DuplexStudy study = duplex_study(resolved);
  const std::vector<std::string> warnings = joined(unused, study.warnings);
  const nlohmann::ordered_json object = lone_result_json(resolved, duplex_json(study), warnings);
  keep_pair(header, object.dump(2) + "\n", study, folder);
  present_lone_result(object, duplex_text(study), options);
  return has_failed(study.over_speed) ? 1 : 0;
}

}  // namespace orbearing::app
