// A record of torque and speed over time, made into a load spectrum by bins of both.
//
// A sample lasts until the next one. Of a bin the speed n is the mean over time and the torque T that which
// does the same damage as all samples of the bin to a bearing whose life goes by T^-p, so that the sums over
// the bins are those of the record, however wide they are:
//
//   sum of s_i n_i = mean of n over time,      sum of s_i n_i T_i^p = mean of n T^p over time
//
// p is that of the life by which the record is judged: 4 for lines of contact [LundbergPalmgren1952]
// [ISO16281], 10/3 for rollers and 3 for balls by [ISO281]. A record does not say which. A larger p than that
// of the life gives a larger T_i and a shorter life (power means grow with p), a smaller one a life that is
// too long: 4 is taken, the largest of them. Only lives with a_ISO fall faster, at most by p = 8
// (kSteepestExponent).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/load_spectrum.hpp"
#include "app/study/record_file.hpp"

namespace orbearing::app {

/// Rising times, and what the driving member did from each on.
struct LoadSeries {
  std::vector<double> time;    // [s]
  std::vector<double> torque;  // [N m]
  std::vector<double> speed;   // [rad/s]
  std::vector<std::string> warnings{};
};

/// From a file that read_record() takes. Throws BadInput with the place of what is missing or no number, and
/// of times that do not rise.
LoadSeries read_load_series(const std::filesystem::path& file, const RecordColumns& columns = {});

/// How many bins of torque and of speed.
struct BinCounts {
  int torque = 8;
  int speed = 8;
};

/// The life of Lundberg and Palmgren of rollers, and of laminae; on the safe side of ISO 281 and of balls.
inline constexpr double kLineExponent = 4.0;
/// No modified life falls faster [-]. With a_ISO = (1 - x)^-9.185/10, x ~ P^-0.4, at most 50: x <= 0.492, so
/// that -d ln(L)/d ln(P) = 4 + 9.185 * 0.4 x/(1 - x) <= 7.6 for rollers, 3 + 9.3/3 x/(1 - x) <= 6.0 for
/// balls.
inline constexpr double kSteepestExponent = 8.0;

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
  double steep_excess = 0.0;       // [-]  by how much a life by kSteepestExponent would come out too long
};

/// Bins of equal width between the least and the greatest torque and speed of all samples that turn. Torques
/// and speeds count by their magnitude: a load that turns round presses the same rollers from the other side.
/// Torques of a bin are averaged by `exponent` [-]. Throws BadInput where nothing ever turns.
BinnedSeries binned(const LoadSeries& series, const BinCounts& counts, double exponent = kLineExponent);

/// Rows as a case takes them: torque_N_m, speed_rpm, share.
std::string spectrum_file(const LoadSpectrum& spectrum);

}  // namespace orbearing::app
