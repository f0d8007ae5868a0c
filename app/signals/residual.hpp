// What is left of a signal without the lines of teeth, which stand where they stand while those of bearings slip.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace orbearing::app::signals {

/// `signal` without its lines at `frequencies` [Hz] and the `beside` lines on either side of each. A signal of whole
/// periods of all of them loses these alone.
Eigen::ArrayXd without_lines(const Eigen::ArrayXd& signal, double rate, const std::vector<double>& frequencies,
                             int beside = 1);

}  // namespace orbearing::app::signals
