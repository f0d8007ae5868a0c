// manifest.jsonl: what a result folder belongs to, then one line per finished point.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "app/results/manifest_header.hpp"
#include "app/results/sweep_row.hpp"

namespace orbearing::app {

/// points/NNNNN.nc, relative to the result folder.
std::string point_file_name(std::size_t point);

struct ManifestEntry {
  std::string file;      // point_file_name of the point; empty for a quasi-static table, which has none
  std::string checksum;  // of the file's bytes
  SweepRow row;
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
std::string entry_line(const ManifestHeader& header, std::size_t point, const ManifestEntry& entry);

/// Reads the text of a manifest. A last line without its end is left out, a line whose check sum is wrong is
/// listed as damaged, and a blank line is skipped. Throws BadInput with file and line where the first line is
/// damaged, or a sound one does not belong to this sweep. `place` is the file's name for messages.
Manifest parse_manifest(std::string_view text, const std::string& location);

/// Rows as a table shows them: the grid's points in their order, each followed by the points that were added
/// between it and the next higher speed, in ascending order.
std::vector<SweepRow> rows_in_table_order(const ManifestHeader& header,
                                          const std::map<std::size_t, ManifestEntry>& entries);

}  // namespace orbearing::app
