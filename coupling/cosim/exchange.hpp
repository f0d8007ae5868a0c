// One pass of all sides over a window: order and times of the exchange.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "coupling/system/input_polynomial.hpp"
#include "coupling/system/participant.hpp"
#include "mechanics/described.hpp"

namespace orbearing::cosim {

// Ports: power-conjugate pairs of a motion and a force, at which participants meet, and which of them are one
// joint.
//
// A port is one freedom of a body. The displacement counts from the position in which the joint is neither
// pressed nor turned; the force acts on the body whose motion it is, so that force x velocity [W] is the
// power that flows into that body. One participant gives the motion and takes the force; all others that are
// connected give forces, which add up.

// Types of the system in time that the exchange uses.
using system::hermite;
using system::Input;
using system::InputPolynomial;
using system::kNone;
using system::Output;
using system::Participant;
using system::SavedState;
using system::Window;

/// Fixes the units of a pair: m, m/s and N, or rad, rad/s and N m.
enum class PortKind { translation, rotation };

/// The half of the pair that a participant gives; it takes the other.
enum class PortOutput { motion, force };

/// Inputs and outputs of a participant that belong together: the motion among its outputs and the force among
/// its inputs where it gives the motion, else the other way round.
struct Port {
  std::string name;  // e.g. "planet_1.y"; unique within a participant
  PortKind kind = PortKind::translation;
  PortOutput output = PortOutput::motion;
  std::size_t displacement = kNone;  // may be missing where the motion is taken
  std::size_t velocity = kNone;      // slope of the displacement
  std::size_t force = kNone;
};

/// Nominal course of an input or output without motion at the ports. A port's velocity adds to it.
struct Nominal {
  std::size_t position = kNone;
  std::function<InputPolynomial(double time)> polynomial;  // from `time` [s] on
};

/// One side of a co-simulation.
struct Side {
  Participant* participant = nullptr;  // not owned
  std::vector<Port> ports;
  std::vector<Nominal> inputs = {};
  std::vector<Nominal> outputs = {};
};
using Sides = std::vector<Side>;

/// A port of a side, both counted from 0.
struct PortPosition {
  std::size_t side = 0;
  std::size_t port = 0;
};

/// One joint: a side gives the motion; one or more give forces, which add up.
struct Connection {
  PortPosition motion;
  std::vector<PortPosition> forces;
};

/// Joins ports of one name, in the order in which their motion is given. Throws std::invalid_argument where a
/// name has not one giver of motion and at least one of force, or ports of different kinds.
std::vector<Connection> connect_by_name(const Sides& sides);

// Known values at the joints, and polynomials through them.

// Polynomials through known values: how one participant's outputs become the inputs of another over a window.

/// A value and the time at which it holds.
struct TimedValue {
  double time = 0.0;   // [s]
  double value = 0.0;  // [unit]
};

/// The polynomial of least degree through one to four points; it counts from `begin` [s].
/// Throws std::invalid_argument for another number of points, or two at one time.
InputPolynomial through(const std::vector<TimedValue>& points, double begin);

/// At one joint and instant.
struct JointValue {
  double displacement = 0.0;  // [m] or [rad]
  double velocity = 0.0;      // [m/s] or [rad/s]
  double force = 0.0;         // [N] or [N m]  sum of all givers
};

/// At one joint over a window; one half, the other is zero.
struct JointPolynomial {
  InputPolynomial displacement = {};  // [m] or [rad]
  InputPolynomial velocity = {};      // [m/s] or [rad/s]
  InputPolynomial force = {};         // [N] or [N m]
};

/// All joints at one instant.
struct InterfaceValues {
  double time = 0.0;  // [s]
  std::vector<JointValue> joints;
};

/// Accepted values at the ends of windows, the newest last.
using InterfaceHistory = std::deque<InterfaceValues>;

/// Prediction for the end of `window`: velocities and forces by the polynomial of degree `order` (0 to 2,
/// less where the history is short) through the last ends; displacements by integrating the velocity from the
/// last one. Eqs. (3) and (4) of coupling/cosim/README.md.
InterfaceValues extrapolated(const InterfaceHistory& history, int order, const Window& window);

enum class ExchangeOrder {
  jacobi,        // all at once, each under the expected values of the others
  gauss_seidel,  // in the order of the sides, each under the output of those before it
};

/// Those that a case may choose.
constexpr described::Names<ExchangeOrder, 2> names_of(ExchangeOrder) {
  return {{{ExchangeOrder::gauss_seidel, "gauss-seidel"}, {ExchangeOrder::jacobi, "jacobi"}}};
}

/// Result of a pass.
struct PassResult {
  InterfaceValues end;    // the sides' output
  InterfaceValues input;  // their input for the end of the window
};

/// The sides at their joints, which are their ports of one name.
class Exchange {
 public:
  /// Throws std::invalid_argument as connect_by_name().
  Exchange(const Sides& sides, ExchangeOrder order);

  /// All sides to the equilibrium in which each is under the others' output: `rounds` times in turn, less
  /// where forces change by less than `allowed_change` of the largest of their kind. Returns the values
  /// there.
  InterfaceValues initialize(double time, int rounds, double allowed_change);

  /// Over `window`, under polynomials that end with `expected` where nothing newer is known.
  /// @param force_order degree of the force's polynomial less 1
  PassResult pass(const InterfaceHistory& history, const InterfaceValues& expected, int force_order,
                  const Window& window);

  /// Forces that belong to the motion in `values`, into `values`: an output under expected motion is
  /// taken anew under the true one. Changes no state.
  void renew_forces(InterfaceValues& values);

  /// Whether the motion, or the force, of a joint is used in a pass before it is computed.
  bool motion_is_expected(std::size_t joint) const;
  bool force_is_expected(std::size_t joint) const;

  const Sides& sides() const { return sides_; }
  /// Inputs of a side that gives forces, when they were renewed last.
  const std::vector<double>& inputs(std::size_t side) const { return inputs_[side]; }
  const Port& port(std::size_t joint) const;
  std::size_t joints() const { return connections_.size(); }

 private:
  template <class PolynomialOf>
  std::vector<InputPolynomial> inputs_from(std::size_t side, double begin,
                                           const PolynomialOf& polynomial_of) const;
  std::vector<double> inputs_under(const InterfaceValues& values, std::size_t side) const;
  void read(std::size_t side, double time, const std::vector<double>& inputs);
  void read_motion(std::size_t side, InterfaceValues& values) const;
  double force_of(std::size_t joint) const;
  void read_forces(InterfaceValues& values) const;
  void learn(std::size_t side, std::vector<std::size_t>& still_to_come, InterfaceValues& known) const;
  InterfaceValues input(const InterfaceValues& expected, const InterfaceValues& output) const;
  void advance(std::size_t side, const InterfaceHistory& history, const InterfaceValues& known,
               int force_order, const Window& window);

  Sides sides_;
  std::vector<Connection> connections_;
  ExchangeOrder order_;
  std::vector<std::vector<double>> inputs_;   // (sides)(inputs)
  std::vector<std::vector<double>> outputs_;  // (sides)(outputs as far as ports ask for them)
};

}  // namespace orbearing::cosim
