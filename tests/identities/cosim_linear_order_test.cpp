// Every scheme of co-simulation against the closed form of a linear pair: orders, stability, energy residual.
// Derivations: coupling/cosim/README.md.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "tests/linear_halves.hpp"

namespace orbearing::cosim::cosim_linear_order_test {
namespace {

using linear_halves::LinearPair;
using linear_halves::LinearRun;

constexpr double kEnd = 4.0;    // [s]  two thirds of a period
constexpr double kOrder = 0.2;  // of a measured order: the next term is smaller by h w, a tenth or less

struct Errors {
  double state = 0.0;     // norm over both halves
  double residual = 0.0;  // [J]  sum of absolute values
};

// History before the start, as if the pair had always been as it is.
InterfaceHistory past(const LinearPair& pair, double window) {
  InterfaceHistory history;
  for (int k = -2; k <= 0; ++k) {
    const Eigen::Vector4d x = linear_halves::exact(pair, k * window);
    history.push_back(
        {k * window,
         {{x[0], x[1], pair.joint_stiffness * (x[2] - x[0]) + pair.joint_damping * (x[3] - x[1])}}});
  }
  return history;
}

Errors errors_of(const CoupledOptions& options, bool force_first, bool with_past) {
  const LinearPair pair;
  LinearRun linear(pair, options, force_first);
  if (with_past) linear.run.start_from(past(pair, options.window));
  const CoupledReport report = linear.run.advance(std::lround(kEnd / options.window));
  EXPECT_TRUE(report.completed) << report.message;
  EXPECT_EQ(report.not_converged, 0);
  const Eigen::Vector4d exact = linear_halves::exact(pair, kEnd);
  return {std::hypot((linear.mass.state() - exact.head<2>()).norm(),
                     (linear.force.state() - exact.tail<2>()).norm()),
          report.absolute_residual};
}

struct Scheme {
  const char* name;
  ExchangeOrder order;
  bool force_first;
  int extrapolation;
  bool iterated;
  bool with_past = false;
};

class CosimOrder : public testing::TestWithParam<Scheme> {
 protected:
  Errors errors(double window) const {
    CoupledOptions options{
        .order = GetParam().order, .extrapolation = GetParam().extrapolation, .window = window};
    if (GetParam().iterated) options.iteration = {.most_passes = 50, .allowed_change = 1e-13};
    return errors_of(options, GetParam().force_first, GetParam().with_past);
  }
};

TEST_P(CosimOrder, IsTheDerivedOne) {
  const Errors coarse = errors(kEnd / 80.0), fine = errors(kEnd / 160.0);
  const int p = GetParam().extrapolation;
  // Without a past the first window holds the force straight, which leaves order 3.
  const double expected = !GetParam().iterated   ? p + 1.0
                          : GetParam().with_past ? p + 2.0
                                                 : std::min(p + 2.0, 3.0);
  EXPECT_NEAR(std::log2(coarse.state / fine.state), expected, kOrder);
  EXPECT_GT(coarse.state, 1e-11);  // not round-off
}

// The residual of all windows together decreases with the error; iterated windows have only that of the
// iteration.
TEST_P(CosimOrder, IsThatOfTheEnergyResidualToo) {
  const Errors coarse = errors(kEnd / 80.0), fine = errors(kEnd / 160.0);
  if (GetParam().iterated) {
    EXPECT_LT(coarse.residual, 1e-11);
    return;
  }
  EXPECT_NEAR(std::log2(coarse.residual / fine.residual), GetParam().extrapolation + 1.0, kOrder);
}

INSTANTIATE_TEST_SUITE_P(
    Schemes, CosimOrder,
    testing::Values(Scheme{"jacobi_0", ExchangeOrder::jacobi, false, 0, false},
                    Scheme{"jacobi_1", ExchangeOrder::jacobi, false, 1, false},
                    Scheme{"jacobi_2", ExchangeOrder::jacobi, false, 2, false},
                    Scheme{"motion_first_0", ExchangeOrder::gauss_seidel, false, 0, false},
                    Scheme{"motion_first_1", ExchangeOrder::gauss_seidel, false, 1, false},
                    Scheme{"motion_first_2", ExchangeOrder::gauss_seidel, false, 2, false},
                    Scheme{"force_first_0", ExchangeOrder::gauss_seidel, true, 0, false},
                    Scheme{"force_first_1", ExchangeOrder::gauss_seidel, true, 1, false},
                    Scheme{"force_first_2", ExchangeOrder::gauss_seidel, true, 2, false},
                    Scheme{"iterated_jacobi_0", ExchangeOrder::jacobi, false, 0, true},
                    Scheme{"iterated_jacobi_1", ExchangeOrder::jacobi, false, 1, true},
                    Scheme{"iterated_jacobi_2", ExchangeOrder::jacobi, false, 2, true},
                    Scheme{"iterated_0", ExchangeOrder::gauss_seidel, false, 0, true},
                    Scheme{"iterated_1", ExchangeOrder::gauss_seidel, false, 1, true},
                    Scheme{"iterated_2", ExchangeOrder::gauss_seidel, false, 2, true},
                    Scheme{"iterated_jacobi_2_with_past", ExchangeOrder::jacobi, false, 2, true, true},
                    Scheme{"iterated_2_with_past", ExchangeOrder::gauss_seidel, false, 2, true, true},
                    Scheme{"iterated_force_first_2_with_past", ExchangeOrder::gauss_seidel, true, 2, true,
                           true}),
    [](const testing::TestParamInfo<Scheme>& scheme) { return scheme.param.name; });

}  // namespace
}  // namespace orbearing::cosim::cosim_linear_order_test
