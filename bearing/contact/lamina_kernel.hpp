// Sums over the laminae of one contact, one version for each instruction set. No header of a library here,
// since files compiled for special instruction sets include it.
#pragma once

namespace orbearing::bearing::vectorised {

/// Laminae are padded to a multiple of this, whatever the instruction set; padding has a drop of kNoLamina.
inline constexpr int kLaminaPadding = 16;
inline constexpr double kNoLamina = 1e9;  // [m]  a drop that no approach reaches

/// With d = (approach + position * end displacement - drop) where that is positive, else 0:
struct LaminaSums {
  double load = 0.0;                 // [m^(10/9)]  sum of d^(10/9)
  double end_load = 0.0;             // [m^(10/9)]  sum of d^(10/9) position
  double by_approach = 0.0;          // [m^(1/9)]  sum of d^(1/9)
  double mixed = 0.0;                // [m^(1/9)]  sum of d^(1/9) position
  double by_end_displacement = 0.0;  // [m^(1/9)]  sum of d^(1/9) position^2
};

/// Positions are fractions of half the length, -1 to 1; `count` is a multiple of kLaminaPadding.
struct LaminaKernel {
  LaminaSums (*sums)(const double* position, const double* drop, int count, double approach,
                     double end_displacement);
  /// Load of each lamina: d^(10/9) [m^(10/9)].
  void (*loads)(const double* position, const double* drop, int count, double approach,
                double end_displacement, double* load);
};

/// One for each instruction set. All give the same bits, so that a point at rest does not name its set.
const LaminaKernel& baseline_laminae();
const LaminaKernel& avx2_laminae();
const LaminaKernel& avx512_laminae();

}  // namespace orbearing::bearing::vectorised
