// Records of torque and speed over time, made into a load spectrum by bins of both.
//
// A sample lasts until the next one. In a bin the speed n is the mean over time and the torque T does the
// same damage as all samples of the bin to a bearing whose life is proportional to T^-p, so that the sums
// over the bins are those of the record, however wide they are:
//
//   sum of s_i n_i = mean of n over time,      sum of s_i n_i T_i^p = mean of n T^p over time
//
// p is that of the life by which the record is judged: 4 for lines of contact [LundbergPalmgren1952]
// [ISO16281], 10/3 for rollers and 3 for balls by [ISO281]. A record does not say which. A larger p than that
// of the life gives a larger T_i and a shorter life (power means grow with p), a smaller one a life that is
// too long: 4 is taken, the largest of them. Only lives with a_ISO fall faster, at most by p = 8
// (kSteepestExponent).
#pragma once

#include <array>
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

/// How long the drivetrain runs as each of several records shows.
struct RecordTimes {
  std::vector<double> shares;  // [-]  of the time; they add up to 1
  double hours = 0.0;          // [h]  in all; 0 where shares were stated
};

/// From the texts of --share and --hours, numbers with commas between them, of which several files need one.
/// Throws BadInput that names the option.
RecordTimes record_times(const std::string& shares, const std::string& hours, std::size_t files);

/// A record among several.
struct WeightedSeries {
  LoadSeries series;
  double share = 1.0;  // [-]  of the time
  std::string file{};  // that its bins name; empty: none
};

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

/// Lives that fall by the same power of the load, for bearings with rollers.
struct LivesByPower {
  double power;
  const char* names;
  bool of_oil;  // lives with a_ISO
};
inline constexpr std::array<LivesByPower, 3> kLivesByPower{{{10.0 / 3.0, "L10h", false},
                                                            {kLineExponent, "life_h and L10rh", false},
                                                            {kSteepestExponent, "L10mh and L10mrh", true}}};
/// The power of one of these lives.
double exponent_of_life(const std::string& life);

/// "8x8", torque first. Throws BadInput that names the option.
BinCounts parse_bins(const std::string& text);

/// A spectrum of bins, record by record, by rising torque, then speed; those without time are left out, time
/// without rotation comes last.
struct BinnedSeries {
  LoadSpectrum spectrum;
  double duration = 0.0;        // [s]  of all records
  double reversed_share = 0.0;  // [-]  of the time, with torque against the speed or both against their sign:
                                // counted by magnitude
  double loaded_rest_share = 0.0;  // [-]  of the time, without rotation under a torque, which uses up no life
  std::array<double, kLivesByPower.size()> excess{};  // [-]  by how much lives by kLivesByPower would come
                                                      // out too long
};

/// Bins of equal width between the least and the greatest torque and speed of all samples of all records that
/// rotate. Torques and speeds are taken by their magnitude: a load with reversed sense presses the same
/// rollers from the other side. Torques of a bin are averaged by `exponent` [-]. Throws BadInput where
/// nothing ever rotates.
BinnedSeries binned(const std::vector<WeightedSeries>& records, const BinCounts& counts,
                    double exponent = kLineExponent);

/// Rows as the file of a case takes them: torque_N_m, speed_rpm, share or hours, and file where bins name
/// one.
std::string spectrum_file(const LoadSpectrum& spectrum);
/// The same as a case writes them.
std::string spectrum_rows(const LoadSpectrum& spectrum);

}  // namespace orbearing::app
