// Samples of the uncertain numbers of a case.
#pragma once

#include <cstdint>
#include <vector>

#include "app/case/uncertain_case.hpp"

namespace orbearing::app {

/// A Latin hypercube of the joint distribution: each number by its own distribution, joined by the normal
/// copula of the correlations. The same seed gives the same numbers on every machine.
/// @return [SI] (samples, inputs)
std::vector<std::vector<double>> uncertain_samples(const UncertainInputs& uncertain, int samples,
                                                   std::uint64_t seed);

}  // namespace orbearing::app
