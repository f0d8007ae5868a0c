// Vibrations of scratched bearings as results: what those of one bearing and of a gear set have in common.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "bearing/defect/scratch.hpp"
#include "coupling/diagnosis/defect_view.hpp"
#include "coupling/diagnosis/spectrum.hpp"
#include "mechanics/described.hpp"
#include "mechanics/problem.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

/// Lower and upper end [Hz] of the band whose envelope is taken; none: the band of largest spectral kurtosis.
struct EnvelopeBand {
  std::vector<double> ends;

  std::optional<diagnosis::Band> stated() const {
    if (ends.size() != 2) return std::nullopt;
    return diagnosis::Band{ends[0], ends[1]};
  }
};
template <class Visitor>
void describe(Visitor& visit, EnvelopeBand& m) {
  using namespace described;
  members(visit, m,
          input(m.ends, "signal.band",
                "lower and upper end of the band whose envelope is taken; left out: the band of largest "
                "spectral kurtosis",
                {.dimension = dimension::frequency, .range = positive(1e5)}));
}
/// `rate` [Hz] of the samples.
mechanics::Problems problems(const EnvelopeBand& band, double rate);

/// Inconsistencies of a scratch in a bearing of balls or rollers, whose diameter is not known where it is 0.
mechanics::Problems problems(const bearing::defect::Scratch& scratch, bool rollers, double element_diameter);

/// Time [s] in which a shaft of `speed` [rad/s] makes `turns`; a run-up begins at the share `run_up_from` of
/// that speed.
double time_of_turns(double turns, double speed, double run_up_from);

double root_mean_square(const Eigen::ArrayXd& signal);  // about its mean

/// 0, `step` and so on.
Eigen::ArrayXd evenly_spaced(Eigen::Index count, double step);

/// Time of a signal of so many `samples`, `rate` [Hz] of them a second.
void describe_time(described::Record& record, Eigen::Index samples, double rate);

/// Peaks as rows; in a run-up they are given at orders.
void describe_peaks(described::Record& record, const std::string& name, const std::string& along,
                    const std::vector<diagnosis::NamedPeak>& peaks, bool run_up,
                    const described::Dimension& amplitude);
/// First entries of every vibration result, with the acceleration that `view` shows.
void describe_vibration(described::Record& record, double shaft_frequency, double cage_frequency,
                        const std::optional<double>& defect_frequency, const diagnosis::InstrumentView& view,
                        bool run_up);
/// Peaks of one spectrum: lines, or `orders` in a run-up.
void describe_lines(described::Record& record, const std::string& lines, const std::string& orders,
                    const std::string& along, const std::vector<diagnosis::NamedPeak>& peaks, bool run_up);
void describe_band(described::Record& record, const diagnosis::InstrumentView& view, bool run_up);

}  // namespace orbearing::analysis
