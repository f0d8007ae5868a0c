// The vibration of a bearing with scratches as results, and its signal as files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/defect_study.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

double root_mean_square(const Eigen::ArrayXd& signal);  // about its mean

/// 0, `step` and so on.
Eigen::ArrayXd evenly_spaced(Eigen::Index count, double step);

/// Time of a signal of so many `samples`, `rate` [Hz] of them a second.
void describe_time(described::Record& record, Eigen::Index samples, double rate);

/// Peaks as rows; in a run-up they stand at orders.
void describe_peaks(described::Record& record, const std::string& name, const std::string& along,
                    const std::vector<diagnosis::NamedPeak>& peaks, bool run_up,
                    const described::Dimension& amplitude);
/// What every vibration tells first, with the acceleration that `view` shows.
void describe_vibration(described::Record& record, double shaft_frequency, double cage_frequency,
                        const std::optional<double>& defect_frequency, const diagnosis::InstrumentView& view,
                        bool run_up);
void describe_band(described::Record& record, const diagnosis::InstrumentView& view, bool run_up);

void describe(described::Record& record, const DefectStudy& study);

/// Time and acceleration, as rows of text.
std::string signal_csv(const DefectStudy& study);

/// The acceleration as a sound: one channel of 32-bit numbers, largest magnitude 1. Players want a rate in
/// whole Hz.
std::string signal_wav(const DefectStudy& study);

}  // namespace orbearing::app
