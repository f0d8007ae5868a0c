// A row of a sweep's table: an operating point with its location in the sweep.
//
// A row that was computed and the same row from a file are equal to the last bit: numbers are those that the
// table shows (15 digits in the unit of the column).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/results/manifest_header.hpp"
#include "app/results/record_writers.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "coupling/analysis/plausible_values.hpp"
#include "mechanics/columns.hpp"

namespace orbearing::app {

// Status of a point: "ok"; "implausible: ..." for values that no machine can have; else the cause of the
// failure.

using analysis::kImplausible;

/// Whether the point was computed and has values.
inline bool is_computed(std::string_view status) {
  return status == "ok" || status.starts_with(kImplausible);
}

// Columns of a sweep besides those of its points.

inline constexpr const char* limiting_set_column = "limiting_set";
/// Whether the point was added to the grid around the peak.
inline constexpr const char* refined_column = "refined";

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
void list(described::Columns& columns, Resonance& resonance);
void describe(described::Record& record, const Resonance& resonance);

struct SweepRow {
  analysis::PointRow point;              // of a point that failed: its speed and status
  std::vector<double> axes{};            // one per header.axes, in its unit
  std::optional<Resonance> resonance{};  // the nearest, where header.resonances
  bool refined = false;                  // added to the grid around the peak
  bool ok() const { return is_computed(point.status); }
};

/// The row of a point. With several sets it has results of each.
SweepRow sweep_row(const analysis::PointResult& result, const ManifestHeader& header,
                   std::vector<double> axes = {}, const std::optional<Resonance>& resonance = {});

/// The row that has these values [in the columns' units] by their names, and no others.
SweepRow row_of_numbers(const std::vector<std::pair<std::string, double>>& values,
                        const ManifestHeader& header);

/// The life of one bearing that results go by [h]; not a number where the row has none.
double governing_hours(const ManifestHeader& header, const analysis::PointNumbers& point);
/// The same of a bearing with these lives [h].
double governing_hours(const ManifestHeader& header, double life_hours,
                       const bearing::rating::RatedHours& rated);
/// The first row with the longest of these lives, perhaps of those of the grid alone; null where none has
/// one.
const SweepRow* longest_lived(const ManifestHeader& header, std::span<const SweepRow> rows,
                              bool grid_alone = false);

/// Whether two rows of a sweep differ in speed alone: all other axes have equal values.
inline bool on_one_line(const SweepRow& one, const SweepRow& other) {
  return one.axes == other.axes;
}

/// Value of a swept axis by its column; not a number where the sweep has no such axis.
double axis_value(const ManifestHeader& header, const SweepRow& row, std::string_view column);

/// The columns of a row, in their order.
void list(described::Columns& columns, const ManifestHeader& header, SweepRow& row);
void describe(described::Record& record, const ManifestHeader& header, const SweepRow& row);
Record record_of(const ManifestHeader& header, const SweepRow& row);

/// A result as the user names it: the number in the column of that name [its unit]; not a number where there
/// is none.
double number_named(const ManifestHeader& header, const SweepRow& row, std::string_view name);
/// All numbers of the row by name, in the columns' units.
std::vector<std::pair<std::string, double>> named_numbers(const ManifestHeader& header, const SweepRow& row);

/// Lines of sweep.csv.
std::string csv_head(const ManifestHeader& header);
std::string csv_line(const ManifestHeader& header, const SweepRow& row);

/// Object with a key for each column; a missing value is null. `planets` lists those that carry unequal
/// loads.
nlohmann::ordered_json row_json(const ManifestHeader& header, const SweepRow& row);

/// The row that `row_json` wrote. Throws nlohmann::json::exception where a key is missing or of another type.
SweepRow row_from_json(const ManifestHeader& header, const nlohmann::ordered_json& object);

}  // namespace orbearing::app
