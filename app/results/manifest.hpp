// manifest.jsonl: what a result folder belongs to, then one line per finished point.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "app/load_spectrum.hpp"
#include "app/results/result_row.hpp"

namespace orbearing::app {

/// Part `index` (from 1) of `count`: the points whose number modulo `count` is `index` - 1.
struct Shard {
  std::size_t index = 1;
  std::size_t count = 1;
  bool holds(std::size_t point) const { return point % count == index - 1; }
  bool operator==(const Shard&) const = default;
};

/// Reads "i/n". Throws BadInput that names the option.
Shard parse_shard(const std::string& text);
std::string to_string(const Shard& shard);

/// Order in which a continued sweep takes its speeds, each point from the final state of the one before.
enum class Direction { up, down };

Direction parse_direction(const std::string& text);  // "up" or "down"
std::string to_string(Direction direction);

/// Properties that results must share to be continued or merged.
struct ManifestHeader {
  std::string case_name;
  std::string case_hash;  // of the resolved case
  std::string program_version;
  std::string instruction_set;  // results are equal to the last bit within one only
  std::string fidelity;
  std::size_t points = 0;                // of the whole sweep's grid and spectrum, all shards together
  std::optional<Shard> shard;            // none: the whole sweep
  std::vector<SweptAxis> axes;           // other than input.speed
  std::vector<std::string> sets{};       // with bearings, of a drivetrain of several sets
  std::optional<Direction> continued{};  // none: each point starts from its own quasi-static state
  bool refined = false;                  // points are added around the peak, numbered from `points` on
  bool resonances = false;               // rows name their nearest resonance
  LoadSpectrum spectrum{};     // its points are the last of `points`: bin by bin that turns, line by line
  std::string life{"life_h"};  // column of the life that results go by, by life.method
  std::string table{};         // results, bound and number of points of a table; empty: a sweep

  /// Points of the grid; those of the spectrum follow.
  std::size_t grid() const { return points - spectrum.points(); }
  /// Whether a point of grid or spectrum is one of this part of the sweep.
  bool holds(std::size_t point) const { return point < points && (!shard || shard->holds(point)); }
  /// Whether a point was added to the grid. A shard has none: `merge` adds them.
  bool adds(std::size_t point) const { return refined && !shard && point >= points; }
  std::size_t own_points() const;
};

/// Columns of the rows of these results.
TableHead head_of(const ManifestHeader& header);

/// points/NNNNN.nc, relative to the result folder.
std::string point_file_name(std::size_t point);

struct ManifestEntry {
  std::string file;      // point_file_name of the point; empty for a quasi-static table, which has none
  std::string checksum;  // of the file's bytes
  ResultRow row;
  std::map<std::string, std::string> others{};  // further files of the result, by name: check sums
};

/// A line after the first whose check sum is not that of its content.
struct DamagedLine {
  std::size_t number = 0;  // from 1
  std::size_t begin = 0;   // [bytes]
  std::size_t length = 0;  // [bytes]  line end excluded
};

struct Manifest {
  std::optional<ManifestHeader> header;          // none where not even the first line is complete
  std::map<std::size_t, ManifestEntry> entries;  // by point; of two lines for one point the later is used
  std::size_t sound_bytes = 0;                   // length without a last line that is torn or damaged
  std::vector<DamagedLine> damaged;              // their points are missing
};

/// The text of an object as a line whose last member is the check sum of the rest; whether a line, its end
/// left out, is one.
std::string sealed_line(const std::string& object);
bool is_sealed(std::string_view line);

/// One line each with its own check sum, line end included.
std::string header_line(const ManifestHeader& header);
std::string entry_line(const TableHead& head, std::size_t point, const ManifestEntry& entry);

/// Reads the text of a manifest. A last line without its end is left out, a line whose check sum is wrong is
/// listed as damaged, and a blank line is skipped. Throws BadInput with file and line where the first line is
/// damaged, or a sound one does not belong to this sweep. `place` is the file's name for messages.
Manifest parse_manifest(std::string_view text, const std::string& location);

/// Rows as a table shows them: the grid's points in their order, each followed by the points that were added
/// between it and the next higher speed, in ascending order.
std::vector<ResultRow> rows_in_table_order(const ManifestHeader& header,
                                           const std::map<std::size_t, ManifestEntry>& entries);

/// Differences between two headers, one line each, in the words of a message; the shard apart.
std::vector<std::string> differences(const ManifestHeader& found, const ManifestHeader& required);

}  // namespace orbearing::app
