// Life under a load spectrum, by the rule of Palmgren and Miner, from the rows of its bins.
//
//   1/L = sum of s_i/L_i,      d_i = (s_i/L_i) L,      s_i share of time, L_i life [h] in bin i, d_i its part
//   in the damage
//
// for each of the lives of one bearing, of one set and of the whole drivetrain. For lives in revolutions s_i
// is the share of the revolutions. Results include the time in skid risk too: that of bins whose equivalent
// load P is below the minimum load, P/C < LoadSpectrum::minimum_load, where rolling elements may skid and
// smear.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/results/manifest.hpp"
#include "app/results/worst_bearing.hpp"

namespace orbearing::app {

/// One bin with what it gave.
struct SpectrumBin {
  LoadBin bin;
  std::optional<SweepRow> row;    // none: without rotation
  double worst_life = not_given;  // [h]  in this bin alone, of the bearing that requirements are judged by
  double damage_share = 0.0;      // [-]  of the life of that bearing; NaN where it is not known
  double modified_damage_share = 0.0;  // [-]  the same of L10mh; NaN without an oil
  std::optional<bool> skid_risk{};     // of any set's bearing; none: the load is not known
};

/// Bins of one record, or all of them. NaN where a bin that takes time is not known.
struct BinSums {
  double share = 0.0;                  // [-]  of the time
  double damage_share = 0.0;           // [-]
  double modified_damage_share = 0.0;  // [-]
  double skid_risk_share = 0.0;        // [-]  of the time of the whole spectrum
};
BinSums sums_of(const std::vector<SpectrumBin>& bins, const std::string& file = {});

/// The spectrum at one combination of the other swept values.
struct SpectrumResult {
  std::vector<double> axis_values;  // as in the rows
  std::vector<SpectrumBin> bins;    // as stated
  std::vector<std::pair<std::string, double>>
      lives;               // by name of the column; NaN where not known, infinite without load
  WorstBearing worst{};    // its life that results go by; of several sets in the limiting one
  std::size_t failed = 0;  // bins without result: then no life is known
};

/// All combinations, in the order of the sweep; none where the case states no spectrum or `entries` lack a
/// point, as those of a shard do.
std::vector<SpectrumResult> spectrum_results(const ManifestHeader& header,
                                             const std::map<std::size_t, ManifestEntry>& entries);

/// Life called `name`; NaN where there is none of that name.
double life_of(const SpectrumResult& result, const std::string& name);

/// An object with lives, that of the worst bearing, `hours` where they were stated, `used_up` of them, time
/// in skid risk, `files` where rows name such, and `bins`; a list of such objects, each with the values of
/// its other axes first, where there are such.
nlohmann::ordered_json spectrum_json(const ManifestHeader& header,
                                     const std::vector<SpectrumResult>& results);

/// The same as a table for files: one row for each bin.
std::string spectrum_csv(const ManifestHeader& header, const std::vector<SpectrumResult>& results);

/// The same for terminals.
std::string spectrum_text(const ManifestHeader& header, const std::vector<SpectrumResult>& results);

}  // namespace orbearing::app
