#include "app/commands/bearing_run.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/lone_result.hpp"
#include "app/errors.hpp"
#include "app/results/progress.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/ball_study.hpp"
#include "app/study/static_output.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

ResultRow row_of(const TableHead& head, const StaticStudy& study) {
  const Eigen::ArrayXd& inner = study.contact_load;
  const Eigen::ArrayXd& outer = study.outer_load.size() > 0 ? study.outer_load : study.contact_load;
  return lone_row(head, {{"inner_load_max_N", inner.maxCoeff()},
                       {"outer_load_max_N", outer.maxCoeff()},
                       {"inner_load_rms_N", std::sqrt(inner.square().mean())},
                       {"outer_load_rms_N", std::sqrt(outer.square().mean())},
                       {"inner_life_Mrev", 1e-6 * study.reference_life.inner},
                       {"outer_life_Mrev", 1e-6 * study.reference_life.outer}});
}

ResultRow row_of(const TableHead& head, const BallStudy& study) {
  const system::BallMeans& m = study.run.means;
  return lone_row(head, {{"inner_load_max_N", m.inner_load_max},
                       {"outer_load_max_N", m.outer_load_max},
                       {"inner_load_rms_N", m.inner_load_rms},
                       {"outer_load_rms_N", m.outer_load_rms},
                       {"inner_life_Mrev", 1e-6 * m.life.inner},
                       {"outer_life_Mrev", 1e-6 * m.life.outer},
                       {"life_h", study.life_hours},
                       {"cage_slip", m.cage_slip},
                       {"film_inner_um", 1e6 * m.inner_film},
                       {"film_outer_um", 1e6 * m.outer_film}});
}

}  // namespace

int run_ball_case(const ResolvedCase& resolved, const Options& options) {
  if (options.fidelity != "quasi-static" && options.fidelity != "dynamic")
    throw BadInput("--fidelity: found " + options.fidelity + "; required: dynamic for a ball bearing in time");
  const std::vector<std::string> unused = require_used(resolved, use::ball_run);
  const ManifestHeader header = manifest_header(resolved, "dynamic");
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.quiet);
  BallStudy study = [&] {
    constexpr std::size_t parts = 1000;
    Progress progress(0, parts, !options.quiet, "time, in thousandths: ");
    return ball_study(resolved, [&](double share) { progress.show(static_cast<std::size_t>(share * parts)); });
  }();
  study.warnings.insert(study.warnings.begin(), unused.begin(), unused.end());
  const nlohmann::ordered_json object = lone_result_json(resolved, ball_json(study), study.warnings);
  if (!folder.finished().contains(0)) {
    if (!folder.path().empty())
      write_aside_and_rename(folder.path() / ball_file_name, object.dump(2) + "\n");
    folder.keep({{0, lone_result_file(header, "ball bearing in time", ball_content(study)), row_of(folder.head(), study)}});
  }
  present_lone_result(object, ball_text(study), options);
  return 0;
}

int run_static_case(const ResolvedCase& resolved, const Options& options) {
  if (options.fidelity != "quasi-static")
    throw BadInput("--fidelity: found " + options.fidelity +
                   "; required: quasi-static for a single bearing under a static load");
  const std::vector<std::string> unused = require_used(resolved, use::static_load);
  const ManifestHeader header = manifest_header(resolved, "static");
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.quiet);
  StaticStudy study = static_study(resolved);
  study.warnings.insert(study.warnings.begin(), unused.begin(), unused.end());
  if (!folder.finished().contains(0))
    folder.keep({{0, lone_result_file(header, "bearing under a static load", static_content(study)), row_of(folder.head(), study)}});
  present_lone_result(lone_result_json(resolved, static_json(study), study.warnings), static_text(study), options);
  return 0;
}

}  // namespace orbearing::app
