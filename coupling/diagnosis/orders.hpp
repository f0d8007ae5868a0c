// Order tracking: a signal of a machine whose speed changes, sampled anew at even angles of one of its shafts, so
// that what turns with it stands still in the spectrum.
#pragma once

#include <Eigen/Core>

#include "coupling/diagnosis/spectrum.hpp"

namespace orbearing::diagnosis {

/// A signal at even angles.
struct AngleSignal {
  double per_revolution = 0.0;  // [-]  samples of a revolution: the rate, in orders
  Eigen::ArrayXd value;         // [unit of the signal]
};

/// `signal`, sampled at even times, at even angles in place of these; `angle` [rad] is that of the shaft at each
/// sample and grows or falls throughout. Between samples by a sine over its argument under Blackman's window, which
/// keeps what lies below 0.4 of the rate to 1e-4. As many samples to a revolution as the slowest part of the signal
/// has in time, so that nothing is folded back. Throws std::invalid_argument where the shaft stands or turns back.
AngleSignal resampled(const Eigen::ArrayXd& signal, const Eigen::ArrayXd& angle);

/// Lines over orders: revolutions of the shaft take the place of seconds, orders that of hertz.
Spectrum order_spectrum(const AngleSignal& signal, Window window);

}  // namespace orbearing::diagnosis
