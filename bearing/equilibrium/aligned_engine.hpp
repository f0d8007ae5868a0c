// Interface of a solver of aligned rollers' equilibria for one instruction set: a block of cage angles at a
// time. No header of a library here, since files compiled for special instruction sets include it.
#pragma once

namespace orbearing::bearing::vectorised {

/// Cage angles in one block, whatever the instruction set.
inline constexpr int kBlock = 16;

/// Constants of all cage angles of a bearing. Lengths are divided by the approach of one whole contact under
/// 1 N, so that it carries Q = x^(10/9) with Q in [N]. Laminae of equal drop are one, a whole contact is one
/// lamina; drops count from the least, and the clearance includes twice that. The arrays pointed to must
/// outlive the engine.
struct AlignedConstants {
  int rollers = 0;
  double half_clearance = 0.0;            // [N^0.9]
  const double* pocket_cosine = nullptr;  // [-]  of each roller's angle from the first
  const double* pocket_sine = nullptr;    // [-]
  int laminae = 0;                        // of unlike drops
  const double* drop = nullptr;           // [N^0.9]  (laminae)  rising from 0
  const double* share = nullptr;          // [-]      (laminae)  of the contact's length
};

/// Inputs of each cage angle, one entry for each. The inertial load of the roller at angle a is steady +
/// cosine cos a + sine sin a, outward positive.
struct AlignedInput {
  double force_x[kBlock];       // [N]  on the outer ring
  double force_y[kBlock];       // [N]
  double steady[kBlock];        // [N]
  double cosine[kBlock];        // [N]
  double sine[kBlock];          // [N]
  double first_roller[kBlock];  // [rad]  position of the first roller, below 1e8
  // Optional start of the search: the output of a neighbouring search, and the position of the outer ring.
  const double* near_rollers = nullptr;
  double near_x[kBlock], near_y[kBlock];    // [N^0.9]
  double start_x[kBlock], start_y[kBlock];  // [N^0.9]
};

/// `lamina_loads` on request: loads [N] per share of the length, of the laminae at the inner race, then at
/// the outer one, kBlock entries for each roller of each of them.
struct AlignedOutput {
  double displacement_x[kBlock];  // [N^0.9]  outer ring relative to inner ring
  double displacement_y[kBlock];  // [N^0.9]
  double residual[kBlock];        // [N]  unbalanced force on the outer ring
  double iterations[kBlock];      // [-]
  double converged[kBlock];       // [-]  1 or 0
  double stiffness_xx[kBlock];    // [N^0.1]  of the outer ring against its displacement
  double stiffness_xy[kBlock];    // [N^0.1]
  double stiffness_yy[kBlock];    // [N^0.1]
  double* lamina_loads = nullptr;
  double* rollers = nullptr;  // on request: start values of each roller for a neighbouring search, twice
                              // kBlock entries
};

/// Not for use by two threads at once; nothing is allocated after construction.
class AlignedEngine {
 public:
  virtual ~AlignedEngine() = default;
  /// Solves a block. `inner_load` and `outer_load` [N] hold kBlock entries for each roller.
  virtual void solve(const AlignedInput& input, AlignedOutput& output, double* inner_load,
                     double* outer_load) = 0;
};

/// One for each instruction set, each in its own file with its own compiler options: the same bits in all.
AlignedEngine* baseline_aligned_engine(const AlignedConstants& constants);
AlignedEngine* avx2_aligned_engine(const AlignedConstants& constants);
AlignedEngine* avx512_aligned_engine(const AlignedConstants& constants);

}  // namespace orbearing::bearing::vectorised
