// Whether numbers of a result are those of real machines: one table of bounds, which every analysis uses.
//
// Two levels. Values beyond the first are rare: a warning. Beyond the second, no such machine can exist, or a
// unit was mistaken: this is the status of the point. Its values stay: they are the results of the inputs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coupling/analysis/multi_stage.hpp"

namespace orbearing::analysis {

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

/// Beginning of the status of a computed point whose values no machine can have.
inline constexpr std::string_view kImplausible = "implausible: ";

/// Key of the rim of a planet over its module among observations, by which a point is judged.
inline constexpr const char* kThinnestRim = "thinnest_rim";

const std::vector<PlausibleRange>& plausible_ranges();
/// Range of a key; null where it has none.
const PlausibleRange* range_of(const std::string& key);
/// Text on a rare value; empty for a common one.
std::string rare_text(const PlausibleRange& range, double value);

/// "n_dm", from the relative speed of the rings [rad/s] and the pitch diameter [m].
Observation observed_speed(double relative_speed, double pitch_diameter);
/// Values from speeds and loads before any bearing is solved: n_dm, thinnest_rim, pitch_line_speed_m_s,
/// unit_load_MPa.
std::vector<Observation> observations(const std::vector<NamedSet>& sets);
/// Those of a set without bearings.
std::vector<Observation> observations_of_gears(const PlanetaryDrivetrain& drivetrain);

/// Rims of planets that are thin for their module.
std::vector<std::string> thin_rim_warnings(const std::vector<NamedSet>& sets);

}  // namespace orbearing::analysis
