#include "coupling/integration/rosenbrock2.hpp"

#include <cmath>

// Loops over the state, in the widest instructions of the machine.
#if defined(__x86_64__)
#define ORBEARING_EVERY_WIDTH __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define ORBEARING_EVERY_WIDTH
#endif

namespace orbearing::integration::detail {

ORBEARING_EVERY_WIDTH
void add_scaled(const double* x, double a, const double* y, double* z, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) z[i] = x[i] + a * y[i];
}

ORBEARING_EVERY_WIDTH
void second_stage(const double* k1, double g, const double* time_slope, double* rhs, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) rhs[i] -= g * time_slope[i] + 2.0 * k1[i];
}

ORBEARING_EVERY_WIDTH
double finish(const double* x, double h, const double* k1, const double* k2, const double* weight,
              double* next, std::size_t n) {
  constexpr std::size_t kWidth = 8;
  double largest[kWidth] = {};
  double poison[kWidth] = {};  // zero unless a share is infinite or not a number
  for (std::size_t i = 0; i < n; i += kWidth) {
    for (std::size_t j = 0; j < kWidth; ++j) {
      const double first = h * k1[i + j], second = h * k2[i + j];
      next[i + j] = x[i + j] + (1.5 * first + 0.5 * second);
      const double share = std::fabs(0.5 * (first + second)) * weight[i + j];
      largest[j] = largest[j] > share ? largest[j] : share;
      poison[j] += 0.0 * share;
    }
  }
  double total = 0.0;
  for (std::size_t j = 0; j < kWidth; ++j) {
    if (poison[j] != 0.0) return INFINITY;
    total = total > largest[j] ? total : largest[j];
  }
  return total;
}

}  // namespace orbearing::integration::detail
