// Zero of a function between two places of opposite sign.
#pragma once

#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <limits>

namespace orbearing::gearset {

/// Zero of a continuous function that changes sign on [low, high], to round-off.
template <typename Function>
double bracketed_root(const Function& function, double low, double high) {
  std::uintmax_t iterations = 200;
  const boost::math::tools::eps_tolerance<double> tolerance(std::numeric_limits<double>::digits - 2);
  const auto [below, above] = boost::math::tools::toms748_solve(function, low, high, tolerance, iterations);
  return 0.5 * (below + above);
}

}  // namespace orbearing::gearset
