#include "coupling/integration/rosenbrock2.hpp"

#include <cmath>

// Loops over the state, in the widest instructions of the machine. Clang 15 and later has versions of a
// function only where each of its declarations names them.
#if defined(__x86_64__) && defined(__linux__) && !(defined(__clang__) && __clang_major__ >= 15)
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

using Eight = double __attribute__((vector_size(64)));
using EightBits = long long __attribute__((vector_size(64)));

// Inlined, so that it has the register width of the calling function.
template <int kStages>
[[gnu::always_inline]] inline double finish_stages(const double* x, double h,
                                                   const double* const (&k)[kStages],
                                                   const double (&forward)[kStages],
                                                   const double (&error)[kStages], const double* weight,
                                                   double* next, std::size_t n) {
  Eight largest{}, poison{};  // the latter is zero unless a share is infinite or not a number
  for (std::size_t i = 0; i < n; i += 8) {
    Eight old, scale, ahead{}, off{};
    __builtin_memcpy(&old, x + i, sizeof old);
    __builtin_memcpy(&scale, weight + i, sizeof scale);
    for (int m = 0; m < kStages; ++m) {
      Eight stage;
      __builtin_memcpy(&stage, k[m] + i, sizeof stage);
      ahead += forward[m] * stage;
      off += error[m] * stage;
    }
    const Eight state = old + h * ahead;
    __builtin_memcpy(next + i, &state, sizeof state);
    const Eight share = h * off * scale;
    const Eight size = (Eight)((EightBits)share & 0x7fffffffffffffffLL);
    largest = size > largest ? size : largest;
    poison += 0.0 * share;
  }
  double total = 0.0;
  for (int j = 0; j < 8; ++j) {
    if (poison[j] != 0.0) return INFINITY;
    total = total > largest[j] ? total : largest[j];
  }
  return total;
}

ORBEARING_EVERY_WIDTH
double finish(const double* x, double h, const double* k1, const double* k2, const double* weight,
              double* next, std::size_t n) {
  return finish_stages<2>(x, h, {k1, k2}, {1.5, 0.5}, {0.5, 0.5}, weight, next, n);
}

ORBEARING_EVERY_WIDTH
double largest_share(double h, const double* k1, const double* k2, const double* weight, std::size_t n) {
  Eight largest{};
  for (std::size_t i = 0; i < n; i += 8) {
    Eight first, second, scale;
    __builtin_memcpy(&first, k1 + i, sizeof first);
    __builtin_memcpy(&second, k2 + i, sizeof second);
    __builtin_memcpy(&scale, weight + i, sizeof scale);
    const Eight share = (0.5 * h) * (first + second) * scale;
    const Eight size = (Eight)((EightBits)share & 0x7fffffffffffffffLL);
    largest = size > largest ? size : largest;
  }
  double total = 0.0;
  for (int j = 0; j < 8; ++j) total = total > largest[j] ? total : largest[j];
  return total;
}

ORBEARING_EVERY_WIDTH
void add_terms(const double* first, Term a, Term b, double* z, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) z[i] = first[i] + (a.factor * a.of[i] + b.factor * b.of[i]);
}

ORBEARING_EVERY_WIDTH
void add_terms(const double* first, Term a, Term b, Term c, double* z, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i)
    z[i] = first[i] + (a.factor * a.of[i] + b.factor * b.of[i] + c.factor * c.of[i]);
}

ORBEARING_EVERY_WIDTH
double finish(const double* x, double h, const double* const (&k)[3], const double (&forward)[3],
              const double (&error)[3], const double* weight, double* next, std::size_t n) {
  return finish_stages(x, h, k, forward, error, weight, next, n);
}

ORBEARING_EVERY_WIDTH
double finish(const double* x, double h, const double* const (&k)[5], const double (&forward)[5],
              const double (&error)[5], const double* weight, double* next, std::size_t n) {
  return finish_stages(x, h, k, forward, error, weight, next, n);
}

}  // namespace orbearing::integration::detail
