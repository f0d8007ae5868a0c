// One row of a sweep's table: the numbers that leave the program, in the units their names state.
#pragma once

#include <cstddef>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/analysis/plausible_values.hpp"
#include "coupling/study/operating_point.hpp"

namespace orbearing::app {

// Status of a point: "ok"; "implausible: ..." for values that no machine can have; else the cause of the
// failure.

using analysis::kImplausible;

/// Whether the point was computed and has values.
inline bool is_computed(std::string_view status) {
  return status == "ok" || status.starts_with(kImplausible);
}

/// The value of a column that has none.
inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

/// The one number of a point that failed.
inline constexpr std::string_view input_speed_column = "input_speed_rpm";
/// Names of the columns that hold text; the second only where there are several sets.
inline constexpr std::string_view status_column = "status";
inline constexpr std::string_view limiting_set_column = "limiting_set";
/// The column that states which points were added to the grid around the peak: true or false.
inline constexpr std::string_view refined_column = "refined";

/// A swept case key other than input.speed: its values in the rows have the unit of the case file.
struct SweptAxis {
  std::string column;  // with its unit: bearing.radial_clearance_um
  std::string units;   // as udunits reads it, "1" for a number
  std::string meaning;
};

/// Names of a row's values, in order; `status` is at `status_location` among them.
struct TableHead {
  std::vector<std::string> names;  // all columns, status included
  std::size_t status_location = 0;
  std::size_t first_axis = 0;                     // index of the first swept axis
  std::size_t axes = 0;                           // as many
  std::optional<std::size_t> set_place;           // of the limiting set's name; none with one set
  std::optional<std::size_t> refined_location{};  // of the column that states which points were added
  std::optional<std::size_t> first_resonance{};   // first column of the nearest resonance, if any
  std::string life{"life_h"};                     // column of the governing life, by life.method
  bool operator==(const TableHead&) const = default;
};

/// `sets` are the names of several sets with bearings; none for a case of one set. `resonances`: whether the
/// rows name their nearest resonance.
TableHead table_head(const std::vector<SweptAxis>& axes, const std::vector<std::string>& sets = {},
                     bool resonances = false);

/// Speed at which a harmonic of the mesh frequency meets a natural frequency of the gear set that it can
/// excite.
struct Resonance {
  std::string kind;        // rotational, translational or planet
  std::string mode;        // "T2": the second of the translational ones, as the report names it
  double frequency = 0.0;  // [Hz]
  int harmonic = 0;        // of the mesh frequency
  double speed = 0.0;      // [rad/s]  of the driving member
  double change = 0.0;     // [Hz]  of the natural frequency from 0.01 % below that speed to 0.01 % above
};

/// Text first, then the numbers.
void describe(described::Record& record, const Resonance& resonance);

struct ResultRow {
  std::vector<double> values;    // one per name; NaN where there is none (and at the places of text)
  std::string status;            // "ok", "implausible: ..." or the reason of the failure
  std::string limiting_set{};    // of several sets; empty where the point failed
  bool refined = false;          // added to the grid around the peak
  std::string resonance_kind{};  // of the nearest resonance; empty where none is known
  std::string resonance_mode{};
  std::vector<study::PlanetResult> planets{};  // one by one, where they carry unequal loads
  bool ok() const { return is_computed(status); }
};

/// The row of a computed point. A point that failed keeps its input speed and axes only.
ResultRow result_row(const study::PointResult& result, const std::vector<double>& axis_values,
                     const std::vector<std::string>& sets = {});

/// Writes the nearest resonance into the last columns of a row whose table has them; none: they stay empty.
void add_resonance(const std::optional<Resonance>& resonance, ResultRow& row);

/// Value in the column called `name`; NaN where the table has none.
double value_of(const TableHead& head, const ResultRow& row, const std::string& name);

/// The life of one bearing that results go by [h]; NaN where the row has none.
double governing_life_in(const TableHead& head, const ResultRow& row);
/// The first row with the longest of these lives, perhaps of those of the grid alone; null where none has
/// one.
const ResultRow* longest_lived(const TableHead& head, std::span<const ResultRow> rows,
                               bool grid_alone = false);

/// Whether two rows of a sweep differ in speed alone: all other axes have equal values.
bool on_one_line(const TableHead& head, const ResultRow& one, const ResultRow& other);

/// `value` x `per_unit` to 15 significant digits, which is what a conversion leaves of a double; so that
/// 6000 rpm, held as rad/s, is 6000 rpm again. Anything not finite becomes NaN.
double in_table_unit(double value, double per_unit);

/// A speed [rad/s] as the columns of speeds [rpm] show it.
double speed_in_rpm(double speed);

// Rows as text: lines of sweep.csv, JSON objects. Numbers are the shortest that read back to the same bits.

/// Lines of RFC 4180, ended by "\n". A missing value is an empty field.
std::string csv_head(const TableHead& head);
std::string csv_line(const TableHead& head, const ResultRow& row);

/// The row as part of a record; a missing value is absent.
void describe_row(described::Record& record, const TableHead& head, const ResultRow& row);

/// Object with a key for each column; a missing value is null. `planets` lists those that carry unequal
/// loads.
nlohmann::ordered_json row_json(const TableHead& head, const ResultRow& row);

/// The row that `row_json` wrote. Throws nlohmann::json::exception where a key is missing or of another type.
ResultRow row_from_json(const TableHead& head, const nlohmann::ordered_json& object);

}  // namespace orbearing::app
