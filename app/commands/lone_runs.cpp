#include "app/commands/lone_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/case/unused_inputs.hpp"
#include "app/commands/lone_result.hpp"
#include "app/errors.hpp"
#include "app/results/progress.hpp"
#include "app/study/ball_study.hpp"
#include "app/study/defect_output.hpp"
#include "app/study/duplex_study.hpp"
#include "app/study/film_study.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/gear_output.hpp"
#include "app/study/planet_defect.hpp"
#include "app/study/static_study.hpp"
#include "app/units.hpp"

namespace orbearing::app {

namespace {

using Row = std::vector<std::pair<std::string, double>>;

void require_fidelity(const Options& options, std::initializer_list<const char*> known,
                      const char* required) {
  if (std::find(known.begin(), known.end(), options.fidelity) == known.end())
    throw BadInput("--fidelity: found " + options.fidelity + "; required: " + required);
}

// Of an analysis that is not the one at rest, which is the default of the option.
void require_given_fidelity(const Options& options, std::initializer_list<const char*> known,
                            const char* required) {
  if (options.fidelity_given) require_fidelity(options, known, required);
}

// Shows the share done of what `study` computes, as "signal, in hundredths: 7 of 100 ...".
template <class Study>
auto with_progress(const Options& options, const char* doing, std::size_t parts, const Study& study) {
  Progress progress(0, parts, !options.quiet, doing);
  return study(
      [&](double share) { progress.show(static_cast<std::size_t>(share * static_cast<double>(parts))); });
}

// Columns are of lives: a vibration has none but the largest load.
Row row_of_load(double inner, double outer) {
  return {{"inner_load_max_N", inner}, {"outer_load_max_N", outer}};
}

constexpr const char* defect_title = "vibration of a bearing with scratches";

}  // namespace

int run_static_case(const ResolvedCase& resolved, const Options& options) {
  require_fidelity(options, {"quasi-static"}, "quasi-static for a single bearing under a static load");
  const std::vector<std::string> unused = require_used(resolved, use::static_load);
  return run_alone(resolved, options, {"static", "bearing under a static load"}, [&]() -> LoneResult {
    const StaticStudy study = static_study(resolved);
    LoneResult result = described_result(study, joined(unused, study.warnings));
    result.text = lives_text(study.life_table()) + "\n" + result.text;
    return result;
  });
}

int run_ball_case(const ResolvedCase& resolved, const Options& options) {
  require_given_fidelity(options, {"dynamic"},
                         "dynamic for a ball bearing in time, or a case without the block simulation");
  const std::vector<std::string> unused = require_used(resolved, use::ball_run);
  const LoneAnalysis analysis{"dynamic", "ball bearing in time", ball_file_name};
  return run_alone(resolved, options, analysis, [&]() -> LoneResult {
    const BallStudy study = with_progress(options, "time, in thousandths: ", 1000, [&](const auto& progress) {
      return ball_study(resolved, progress);
    });
    LoneResult result = described_result(study, joined(unused, study.warnings));
    result.text = lives_text(study.life_table()) + "\n" + result.text;
    return result;
  });
}

void require_rung(const ResolvedCase& resolved, bool moving) {
  if (moving && resolved.model() == roller_defect)
    throw BadInput(
        "--fidelity: found dynamic for a scratched bearing of rollers by itself; required: none, or a "
        "planetary drivetrain with a block 'defect', where all of its bearings move");
}

ResultRow defect_row(const TableHead& head, const DefectStudy& study) {
  return lone_row(head, row_of_load(study.vibration.largest_load, study.vibration.largest_load));
}

std::string defect_file(const ManifestHeader& header, const DefectStudy& study) {
  return lone_result_file(header, defect_title, content_of(record_of(study)));
}

int run_defect_case(const ResolvedCase& resolved, const Options& options) {
  const bool moving = options.fidelity == "dynamic";
  require_rung(resolved, moving);
  require_fidelity(
      options, {"quasi-static", "dynamic"},
      "none for the model raceway-defect, whose ring moves on balls without mass, or dynamic, for all of "
      "the bearing in motion");
  const std::vector<std::string> unused = require_used(resolved, moving ? use::moving_defect : use::defect);
  const LoneAnalysis analysis{moving ? "defect, all in motion" : "defect", defect_title, defect_file_name};
  return run_alone(resolved, options, analysis, [&]() -> LoneResult {
    const DefectStudy study =
        !moving ? defect_study(resolved)
                : with_progress(options, "signal, in hundredths: ", 100, [&](const auto& progress) {
                    return defect_study(resolved, DefectRung::all, progress);
                  });
    LoneResult result = described_result(study, joined(unused, study.warnings));
    result.row = row_of_load(study.vibration.largest_load, study.vibration.largest_load);
    if (!options.output.empty())
      result.files = {{"signal.csv", signal_csv(study)}, {"signal.wav", signal_wav(study)}};
    return result;
  });
}

int run_planet_defect_case(const ResolvedCase& resolved, const Options& options) {
  require_given_fidelity(
      options, {"monolithic"},
      "none, or monolithic, for a gear set with a scratched planet bearing, which is one system of gears "
      "and bearings");
  const std::vector<std::string> unused = require_used(resolved, use::planet_defect);
  const LoneAnalysis analysis{"scratched planet bearing",
                              "vibration of a gear set with a scratched planet bearing", defect_file_name};
  return run_alone(resolved, options, analysis, [&]() -> LoneResult {
    const PlanetDefectStudy study =
        with_progress(options, "signal, in hundredths: ", 100,
                      [&](const auto& progress) { return planet_defect_study(resolved, progress); });
    LoneResult result = described_result(study, unused);
    result.row = row_of_load(study.vibration.largest_load, study.vibration.largest_load);
    return result;
  });
}

int run_film_case(const ResolvedCase& resolved, const Options& options) {
  require_fidelity(options, {"quasi-static"}, "none for the model spin-film, which is steady");
  const std::vector<std::string> unused = require_used(resolved, use::spin_film);
  return run_alone(resolved, options, {"film", "film of a contact"}, [&]() -> LoneResult {
    const FilmStudy study = film_study(resolved);
    LoneResult result = described_result(study, joined(unused, study.warnings));
    result.failed = std::ranges::any_of(study.points, &FilmPoint::lost);
    return result;
  });
}

namespace {

bool has_failed(const std::vector<PairAtSpeed>& points) {
  return std::any_of(points.begin(), points.end(), [](const PairAtSpeed& point) { return !point.modes; });
}

}  // namespace

int duplex_modes(const ResolvedCase& resolved, const Options& options) {
  const std::vector<std::string> unused = require_used(resolved, use::duplex_modes);
  const PairPoint point = pair_point(resolved);
  const std::vector<PairAtSpeed> over_speed = pair_over_speed(resolved);
  Record record = record_of(point);
  if (!over_speed.empty()) record.table("over_speed", "speed", "the pair at operation.speeds", over_speed);
  present_record(resolved, record, joined(unused, point.warnings), options);
  return has_failed(over_speed) ? 1 : 0;
}

int run_duplex_case(const ResolvedCase& resolved, const Options& options) {
  require_fidelity(options, {"quasi-static"}, "none for the model duplex-pair, which is in balance");
  const std::vector<std::string> unused = require_used(resolved, use::duplex_run);
  const LoneAnalysis analysis{"duplex", "shaft on a duplex pair", "duplex.json"};
  return run_alone(resolved, options, analysis, [&]() -> LoneResult {
    const DuplexStudy study = duplex_study(resolved);
    LoneResult result = described_result(study, joined(unused, study.warnings));
    result.failed = has_failed(study.over_speed);
    return result;
  });
}

bool runs_gears_alone(const ResolvedCase& resolved) {
  return resolved.model() == planetary_drivetrain && !resolved.shape().several && !resolved.shape().bearing;
}

int run_gear_case(const ResolvedCase& resolved, const Options& options) {
  require_given_fidelity(options, {},
                         options.gears ? "none beside --gears, which runs the gears alone"
                                       : "none for a gear set without a bearing, which runs alone");
  const std::vector<std::string> unused = require_used(resolved, use::gears);
  const gearset::dynamics::SetModel model = moving_gears_of(resolved);
  if (!resolved.shape().teeth)
    throw BadInput(resolved.file() +
                   ": gearset.teeth: missing; required: teeth, which give loads and mesh frequency; "
                   "orbearing modes shows the natural frequencies of a set without");
  return run_alone(resolved, options, {"gears", "vibration of the gear set"}, [&]() -> LoneResult {
    const study::GearRunResult run = study::run_gears(model, gear_run_options(resolved));
    if (!run.completed) throw ComputationFailed(resolved.text("name") + ": " + run.message);
    std::vector<std::string> warnings = joined(gear_dynamics_warnings(resolved), unused);
    if (!run.steady) warnings.push_back(run.message);
    Record record;
    describe_gear_run(record, run);
    LoneResult result = recorded_result(record, warnings);
    result.row = {{"input_speed_rpm", kRpm * resolved.quantity("input.speed")},
                  {"carrier_speed_rpm", kRpm * model.operation.speeds.carrier}};
    if (!run.message.empty()) result.status = run.message;
    return result;
  });
}

}  // namespace orbearing::app
