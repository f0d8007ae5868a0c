// A load spectrum: how long a drivetrain runs at which power and speed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace orbearing::app {

/// One operating point of a spectrum.
struct LoadBin {
  double power = 0.0;  // [W]
  double speed = 0.0;  // [rad/s]  of the driving member
  double share = 0.0;  // [-]      of the time
  std::string file{};  // record that it was made of; empty: none is named

  /// A drivetrain at rest uses up no life: such a bin counts as time alone and is not computed. Below the
  /// least speed that a case can have, 0.001 rpm, it is at rest.
  bool turns() const { return speed >= 1.1e-4; }
  /// [N m]  Of the driving member.
  double torque() const { return turns() ? power / speed : 0.0; }
  /// [W]  An idling drivetrain is computed with next to no power, since a case has some.
  double entering_power() const { return std::max(power, 0.01); }
  bool operator==(const LoadBin&) const = default;
};

struct LoadSpectrum {
  std::vector<LoadBin> bins;  // shares add up to 1
  double hours = 0.0;         // [h]  in all; 0 where shares were given
  double minimum_load = 0.0;  // [-]  P/C below which rolling elements may skid
  std::size_t lines = 0;      // as often it is computed: once for each combination of the other swept values

  /// Numbers of the bins that turn, in order.
  std::vector<std::size_t> rotating() const {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < bins.size(); ++i)
      if (bins[i].turns()) numbers.push_back(i);
    return numbers;
  }
  /// Records that bins name, each once, in the order of the bins.
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const LoadBin& bin : bins)
      if (!bin.file.empty() && std::find(names.begin(), names.end(), bin.file) == names.end())
        names.push_back(bin.file);
    return names;
  }
  /// Operating points that it adds to a sweep.
  std::size_t points() const { return lines == 0 ? 0 : lines * rotating().size(); }
};

}  // namespace orbearing::app
