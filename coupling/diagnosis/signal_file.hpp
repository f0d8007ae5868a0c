// A signal as the contents of a file.
#pragma once

#include <Eigen/Core>
#include <string>

namespace orbearing::diagnosis {

/// Time and acceleration [m/s^2] as rows of text, with the angle [rad] of the shaft if there is one.
std::string signal_csv(const Eigen::ArrayXd& signal, double rate, const Eigen::ArrayXd* shaft_angle);

/// The signal as a sound: one channel of 32-bit numbers, largest magnitude 1. Players require a rate in whole
/// Hz.
std::string signal_wav(const Eigen::ArrayXd& signal, double rate);

}  // namespace orbearing::diagnosis
