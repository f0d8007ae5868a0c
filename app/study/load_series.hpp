// A record of torque and speed over time, made into a load spectrum by bins of both.
//
// A sample lasts until the next one. Of a bin the speed n is the mean over time and the torque T that which
// does the same damage to a roller bearing as all samples of the bin, so that the sums over the bins are
// those of the record, however wide they are:
//
//   sum of s_i n_i = mean of n over time,      sum of s_i n_i T_i^p = mean of n T^p over time,      p = 10/3
//   [ISO281]
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/load_spectrum.hpp"

namespace orbearing::app {

/// Rising times, and what the driving member did from each on.
struct LoadSeries {
  std::vector<double> time;    // [s]
  std::vector<double> torque;  // [N m]
  std::vector<double> speed;   // [rad/s]
  std::vector<std::string> warnings{};
};

/// From a CSV file whose first line names time, speed and torque or power with their units (time_s,
/// speed_rpm, torque_N_m), or from a netCDF file with variables of these names and their attribute `units`.
/// Other columns are passed over. Throws BadInput with the place of what is missing or no number, and of
/// times that do not rise.
LoadSeries read_load_series(const std::filesystem::path& file);

/// How many bins of torque and of speed.
struct BinCounts {
  int torque = 8;
  int speed = 8;
};

/// "8x8", torque first. Throws BadInput that names the option.
BinCounts parse_bins(const std::string& text);

/// A spectrum of bins, by rising torque, then speed; those without time are left out, time at rest comes
/// last.
struct BinnedSeries {
  LoadSpectrum spectrum;
  double duration = 0.0;        // [s]
  double reversed_share = 0.0;  // [-]  of the time, with torque against the speed or both against their sign:
                                // counted by magnitude
  double loaded_rest_share = 0.0;  // [-]  of the time, at rest under a torque, which uses up no life
};

/// Bins of equal width between the least and the greatest torque and speed of all samples that turn. Torques
/// and speeds count by their magnitude: a load that turns round presses the same rollers from the other side.
/// Throws BadInput where nothing ever turns.
BinnedSeries binned(const LoadSeries& series, const BinCounts& counts);

/// Rows as a case takes them: torque_N_m, speed_rpm, share.
std::string spectrum_file(const LoadSpectrum& spectrum);

}  // namespace orbearing::app
