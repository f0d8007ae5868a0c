#include "coupling/cosim/coupled_run.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace orbearing::cosim::acceleration_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// An affine answer; number of passes until it is the expected one.
int passes(QuasiNewton& accelerator, const MatrixXd& law, const VectorXd& offset, int most) {
  VectorXd expected = VectorXd::Zero(offset.size());
  accelerator.begin();
  for (int pass = 1; pass <= most; ++pass) {
    const VectorXd answer = law * expected + offset;
    if ((answer - expected).norm() < 1e-9) return pass;  // far above round-off, far below the offset
    expected = accelerator.next(expected, answer, VectorXd::Ones(offset.size()));
  }
  return most + 1;
}

MatrixXd expanding(Eigen::Index n) {
  MatrixXd law = MatrixXd::Constant(n, n, 0.1);
  law.diagonal() = VectorXd::LinSpaced(n, -2.0, -1.2);  // the plain iteration runs away
  return law;
}

// One unknown: the secant is exact.
TEST(QuasiNewton, SolvesOneUnknownInThree) {
  QuasiNewton secant(0);
  EXPECT_EQ(passes(secant, MatrixXd::Constant(1, 1, -3.0), VectorXd::Ones(1), 50), 3);
}

// As many differences as unknowns are exact: n + 1 passes for them, one to check it.
TEST(QuasiNewton, SolvesAsManyUnknownsAsItHasDifferences) {
  QuasiNewton secants(0);
  EXPECT_LE(passes(secants, expanding(6), VectorXd::LinSpaced(6, 1.0, 2.0), 50), 8);
}

// The next window has the law already.
TEST(QuasiNewton, RemembersWindows) {
  QuasiNewton forgetful(0), mindful(3);
  const MatrixXd law = expanding(6);
  for (QuasiNewton* each : {&forgetful, &mindful}) passes(*each, law, VectorXd::Ones(6), 50);
  const VectorXd other = VectorXd::LinSpaced(6, -1.0, 2.0);
  EXPECT_LE(passes(mindful, law, other, 50), 3);
  EXPECT_GT(passes(forgetful, law, other, 50), 5);
}

// Units do not matter: what is expected in other ones is the same.
TEST(QuasiNewton, IsTheSameInOtherUnits) {
  const VectorXd unit = VectorXd::LinSpaced(4, 1.0, 1e6);
  QuasiNewton plain(2), scaled(2);
  VectorXd expected = VectorXd::Zero(4), other = VectorXd::Zero(4);
  for (int pass = 0; pass < 4; ++pass) {
    expected = plain.next(expected, expanding(4) * expected + VectorXd::Ones(4), VectorXd::Ones(4));
    const VectorXd answer = unit.cwiseProduct(expanding(4) * other.cwiseQuotient(unit) + VectorXd::Ones(4));
    other = scaled.next(other, answer, unit.cwiseInverse());
  }
  EXPECT_LT((other.cwiseQuotient(unit) - expected).norm(), 1e-9 * expected.norm());
}

// A difference twice over must not blow up the least squares.
TEST(QuasiNewton, BearsAnAnswerThatDoesNotChange) {
  QuasiNewton secants(2);
  secants.begin();
  const VectorXd expected = VectorXd::Zero(3), answer = VectorXd::Ones(3);
  for (int pass = 0; pass < 4; ++pass) {
    const VectorXd next = secants.next(expected, answer, VectorXd::Ones(3));
    EXPECT_TRUE(next.allFinite());
    EXPECT_LT(next.norm(), 10.0);
  }
}

}  // namespace
}  // namespace orbearing::cosim::acceleration_test
