// Properties of the results of a sweep, stated in the first line of their manifest: case, program, points,
// shard, axes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/load_spectrum.hpp"

namespace orbearing::app {

/// A swept case key other than input.speed: its values in the rows have the unit of the case file.
struct SweptAxis {
  std::string column;  // with its unit: bearing.radial_clearance_um
  std::string units;   // as udunits reads it, "1" for a number
  std::string meaning;
};

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

/// Reads "up" or "down". Throws std::invalid_argument.
Direction parse_direction(const std::string& text);
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

/// Differences between two headers, one line each, in the words of a message; the shard apart.
std::vector<std::string> differences(const ManifestHeader& found, const ManifestHeader& required);

}  // namespace orbearing::app
