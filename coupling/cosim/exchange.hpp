// One pass of all sides over a window: who hears of whom, and when.
#pragma once

#include "coupling/cosim/interface_polynomial.hpp"
#include "coupling/cosim/port.hpp"
#include "mechanics/described.hpp"

namespace orbearing::cosim {

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
