// Whether numbers of a result are those of real machines: one table of bounds, which every analysis uses.
//
// Two levels. Values beyond the first are rare: a warning. Beyond the second, no such machine can exist, or a
// unit was mistaken: this is the status of the point. Its values stay: they are the results of the inputs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/sweep_row.hpp"
#include "coupling/study/multi_stage.hpp"
#include "coupling/study/operating_point.hpp"

namespace orbearing::app {

/// Bounds of one quantity, in its unit; infinite where there is none.
struct PlausibleRange {
  struct {
    std::vector<std::string> keys;  // of --json and columns of sweep.csv, all in this unit
    std::string block;              // begin of a warning: the block of the case to check
    std::string name;
    std::string unit;
  } of;
  struct Bound {
    double value;
    std::string why;  // a value beyond is rare
  } rare_low, rare_high;
  struct {
    double least;
    double most;
    std::string reason;
  } outer;
};

/// A value found, by its key.
struct Observation {
  std::string key;
  double value = 0.0;
};

struct Judgement {
  std::vector<std::string> warnings;
  std::string status = "ok";  // or "implausible: " and the first value beyond the outer bounds
};

/// Judges values; those that are not finite, and keys that no range has, are passed over.
Judgement judge(const std::vector<Observation>& observed);

/// The values in a result as --json prints it, at any level.
std::vector<Observation> observations(const nlohmann::ordered_json& object);

/// Pressure, lives, film and their ratios at a point.
std::vector<Observation> observations(const study::PointNumbers& point);

/// Values from speeds and loads of the case before any bearing is solved: n_dm, pitch_line_speed_m_s,
/// unit_load_MPa, thinnest_rim. Empty for models without them.
std::vector<Observation> observations(const ResolvedCase& at_point);

/// Key of the rim of a planet over its module among observations, by which a point is judged.
inline constexpr const char* kThinnestRim = "thinnest_rim";

/// Warning of a planet's rim that is thin for its module, before any bearing is solved; empty where none is.
std::vector<std::string> rim_warnings(const ResolvedCase& at_point);

/// The point with the status that its values deserve.
study::PointResult judged(study::PointResult result, const std::vector<study::NamedSet>& sets);

/// Warnings of rare values in the rows of a sweep, each once, with how many points have them.
std::vector<std::string> rare_values(const std::vector<const SweepRow*>& rows);

}  // namespace orbearing::app
