// What takes part in a co-simulation: five verbs.
#pragma once

#include <string>
#include <vector>

#include "coupling/cosim/port.hpp"

namespace orbearing::cosim {

/// One side of a co-simulation. Order of calls: initialize, then for each window set_input, advance, output;
/// save and restore at any time after initialize.
///
/// Errors are thrown as std::runtime_error with the reason; the participant is then in the state in which it
/// began the window.
class Participant {
 public:
  virtual ~Participant() = default;

  virtual std::string name() const = 0;
  /// Ports in a fixed order; inputs and outputs below have the same order and number.
  virtual const std::vector<Port>& ports() const = 0;

  /// To the state at `time` [s], with the inputs of that instant (constant courses). Called again before the
  /// first window, with what the others answered, it comes nearer to the state in which all are in balance.
  virtual void initialize(double time, const std::vector<PortInput>& inputs) = 0;
  /// Inputs over the window that is advanced next; courses count from its beginning.
  virtual void set_input(const std::vector<PortInput>& inputs) = 0;
  /// From the beginning of the window, where it stands, to its end.
  virtual void advance(const Window& window) = 0;
  /// At the present time, under the inputs that were set last: those of the window that has ended, or after
  /// set_input() those of the next one, at its beginning.
  virtual void output(std::vector<PortOutput>& outputs) const = 0;

  /// Complete and exact: save, advance, restore, advance gives the same bits.
  virtual void save(SavedState& state) const = 0;
  virtual void restore(const SavedState& state) = 0;
  /// False where the two above always throw: then no window can be done again.
  virtual bool can_restore() const { return true; }
};

}  // namespace orbearing::cosim
