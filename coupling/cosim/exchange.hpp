// One pass of all sides over a window: who hears of whom, and when.
#pragma once

#include <deque>
#include <vector>

#include "coupling/cosim/port.hpp"
#include "coupling/system/input_polynomial.hpp"
#include "mechanics/described.hpp"

namespace orbearing::cosim {

// What is known at the joints, and the polynomials that follow from it.

// Polynomials through known values: how one participant's outputs become the inputs of another over a window.

using system::InputPolynomial;

/// A value and the time at which it holds.
struct TimedValue {
  double time = 0.0;   // [s]
  double value = 0.0;  // [unit]
};

/// The polynomial of least degree through one to four points; it counts from `begin` [s].
/// Throws std::invalid_argument for another number of points, or two at one time.
InputPolynomial through(const std::vector<TimedValue>& points, double begin);

/// The cubic with the given values and slopes at both ends of a window of `length` [s].
InputPolynomial hermite(double value, double slope, double end_value, double end_slope, double length);

/// The slope of a polynomial.
inline InputPolynomial slope_of(const InputPolynomial& polynomial) {
  const auto& c = polynomial.coefficient;
  return {{c[1], 2.0 * c[2], 3.0 * c[3], 0.0}};
}

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

/// What the values at the end of `window` will be: velocities and forces by the polynomial of degree `order`
/// (0 to 2, less where the history is short) through the last ends; displacements by integrating the velocity
/// from the last one. Eqs. (3) and (4) of coupling/cosim/README.md.
InterfaceValues extrapolated(const InterfaceHistory& history, int order, const Window& window);

/// Polynomials of `joint` over `window` that end with `end`: the displacement as a cubic with both values and
/// velocities, the force as the polynomial through `end` and the last order + 1 ends. Eqs. (5) and (6). Where
/// `end` is what extrapolated() says, these are the extrapolated polynomials.
InputPolynomial motion_polynomial(const InterfaceHistory& history, std::size_t joint, const JointValue& end,
                                  const Window& window);
InputPolynomial force_polynomial(const InterfaceHistory& history, std::size_t joint, double end, int order,
                                 const Window& window);

enum class ExchangeOrder {
  jacobi,        // all at once, each under what is expected of the others
  gauss_seidel,  // in the order of the sides, each under the output of those before it
};

/// Those that a case may choose.
constexpr described::Names<ExchangeOrder, 2> names_of(ExchangeOrder) {
  return {{{ExchangeOrder::gauss_seidel, "gauss-seidel"}, {ExchangeOrder::jacobi, "jacobi"}}};
}

/// What a pass gave.
struct PassResult {
  InterfaceValues end;    // the sides' output
  InterfaceValues input;  // their input for the end of the window
};

/// The sides at their joints, which are their ports of one name.
class Exchange {
 public:
  /// Throws std::invalid_argument as connect_by_name().
  Exchange(const Sides& sides, ExchangeOrder order);

  /// All sides to the balance in which each is under the others' output: `rounds` times in turn, less where
  /// forces change by less than `allowed_change` of the largest of their kind. Returns the values there.
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
