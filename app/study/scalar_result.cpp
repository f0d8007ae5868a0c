#include "app/study/scalar_result.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "app/case/defect_case.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "app/results/result_row.hpp"
#include "app/results/row_text.hpp"
#include "app/study/ball_study.hpp"
#include "app/study/computable.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/rated_oil.hpp"
#include "app/study/static_study.hpp"
#include "coupling/study/multi_stage.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

// A run, as what it prints.
struct Run {
  use::Analysis analysis;
  double scatter;
  std::function<Json(const ResolvedCase&)> compute;
};

// The row of its one point.
Json drivetrain_point(const ResolvedCase& in, study::Fidelity fidelity) {
  const std::vector<std::string> sets = bearing_set_names(in);
  return row_json(table_head({}, sets), result_row(study::evaluate(bearing_sets(in), fidelity), {}, sets));
}

bool has_planet_bearing(const ResolvedCase& in) {
  return in.shape().several ? !bearing_set_names(in).empty() : in.shape().bearing;
}

Run run_of_drivetrain(const ResolvedCase& in, const std::string& fidelity) {
  require_computable(in, fidelity, false);
  const study::Fidelity level = fidelity_of(fidelity);
  return {rung_of(in, fidelity), in_time(level) ? scatter::in_motion : scatter::at_rest,
          [level](const ResolvedCase& changed) { return drivetrain_point(changed, level); }};
}

Run run_of(const ResolvedCase& in, const std::string& fidelity) {
  const Analysis* analysis = analysis_of(in, fidelity);
  if (analysis == nullptr && has_planet_bearing(in))
    return run_of_drivetrain(in, fidelity.empty() ? "quasi-static" : fidelity);
  const Analysis& row = analysis != nullptr ? *analysis : gears_alone();
  return {row.used, row.scatter,
          [compute = row.compute](const ResolvedCase& changed) { return json_of(compute(changed, {}).record); }};
}

[[noreturn]] void refuse_life(const ResolvedCase& in, const std::string& path, const std::string& found,
                              const std::string& required) {
  throw BadInput(in.origin(path) + ": " + path + ": found " + found + "; required: " + required);
}

// Key and unit of the life that results go by.
std::pair<std::string, std::string> life_key(const ResolvedCase& in) {
  if (is_static_bearing(in)) return {"L10r_Mrev", "Mrev"};
  if (is_ball_run(in)) return {"life_h", "h"};
  if (in.model() != planetary_drivetrain)
    refuse_life(
        in, "model", in.choice("model"),
        "a case with a life: planetary-drivetrain, roller-bearing or ball-bearing; --result names any "
        "other number of its run");
  if (is_planet_defect(in))
    throw BadInput(
        in.file() +
        ": defect: found a scratched planet bearing; required: none, for a life; --result names any "
        "other number of its run");
  if (!has_planet_bearing(in))
    throw BadInput(in.file() + ": bearing: missing; required: a planet bearing, for its life");
  return {life_to_go_by(in), "h"};
}

double number_of(const Json& object, const std::string& key) {
  const Json::json_pointer position("/" + key);
  const bool found = object.contains(position) && object.at(position).is_number();
  return found ? object.at(position).get<double>() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

ScalarResult scalar_result(const ResolvedCase& in, const std::string& fidelity, const std::string& key) {
  ScalarResult result{.quantity = key, .unit = ""};
  if (key.empty()) std::tie(result.quantity, result.unit) = life_key(in);
  Run run = run_of(in, fidelity);
  result.analysis = run.analysis;
  result.scatter = run.scatter;
  const std::string set = std::string(limiting_set_column);
  result.compute = [compute = std::move(run.compute), quantity = result.quantity,
                    set](const ResolvedCase& changed) -> ScalarResult::Value {
    const Json object = compute(changed);
    return {number_of(object, quantity), object.value(set, "")};
  };
  return result;
}

ScalarResult::Value value_here(const ResolvedCase& in, const ScalarResult& result) {
  ScalarResult::Value here = result.compute(in);
  if (std::isfinite(here.number)) return here;
  if (result.unit.empty())
    throw BadInput("--result: found " + result.quantity + "; required: the key of a number that run prints");
  if (is_static_bearing(in) || result.quantity == "life_h")
    throw ComputationFailed(in.text("name") + ": nothing is loaded; the life is without end");
  refuse_life(in, "life.method",
              in.choice("life.method") + ", by which there is no " + result.quantity + " here",
              "a case with that life, or lundberg-palmgren");
}

}  // namespace orbearing::app
