// Gears and all their planet bearings in motion together, whoever integrates them and however they exchange.
#pragma once

#include <string>
#include <vector>

#include "bearing/motion/snapshot.hpp"
#include "bearing/motion/statistics.hpp"

namespace orbearing::cosim {

/// What the exchange cost and how well it kept the energy. All sums since the start.
struct CouplingReport {
  long windows = 0;              // exchanges; steps of a monolithic solution
  long iterations = 0;           // of windows that are repeated until both sides agree
  long rejected = 0;             // windows, or steps of a monolithic solution
  double energy_residual = 0.0;  // [J]  sum over windows of |what one side gives less what the other takes|
  double energy_passed = 0.0;    // [J]  sum of |work| at all ports
};

/// A gear set and its bearings at steady speed. Bearing b sits in planet b / bearings_per_planet, counted
/// from 0.
class CoupledMotion {
 public:
  virtual ~CoupledMotion() = default;

  virtual int planets() const = 0;
  virtual int bearings_per_planet() const = 0;
  int bearings() const { return planets() * bearings_per_planet(); }

  /// On to `time` [s], multiples of one interval from call to call. @throws std::runtime_error with the
  /// reason; the state is then not to be used
  virtual void advance(double time) = 0;
  /// Bearing `b` at the present time.
  virtual void take_snapshot(int b, bearing::dynamics::Snapshot& into) const = 0;
  /// From now on loads of every step of bearing `b` go to `collectors[b]`, which outlive this or are
  /// replaced.
  virtual void collect_loads(const std::vector<bearing::dynamics::StatisticsCollector*>& collectors) = 0;
  virtual CouplingReport report() const = 0;
};

}  // namespace orbearing::cosim
