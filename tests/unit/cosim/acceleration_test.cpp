#include "coupling/cosim/acceleration.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace orbearing::cosim::acceleration_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// An affine answer; how many are asked until it is what was expected.
int passes(Accelerator& accelerator, const MatrixXd& law, const VectorXd& offset, int most) {
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

TEST(Acceleration, FixedPointTakesTheAnswer) {
  const auto plain = make_accelerator(Acceleration::fixed_point, 0);
  EXPECT_EQ(passes(*plain, 0.1 * MatrixXd::Identity(3, 3), VectorXd::Ones(3), 50), 11);  // 0.1^10 < 1e-9
  EXPECT_GT(passes(*plain, expanding(4), VectorXd::Ones(4), 50), 50);
}

// One unknown: the second share is exact, as is the secant.
TEST(Acceleration, AitkenAndQuasiNewtonSolveOneUnknownInThree) {
  const MatrixXd law = MatrixXd::Constant(1, 1, -3.0);
  for (const Acceleration kind : {Acceleration::aitken, Acceleration::quasi_newton})
    EXPECT_EQ(passes(*make_accelerator(kind, 0), law, VectorXd::Ones(1), 50), 3);
}

// As many differences as unknowns are exact: n + 1 passes for them, one to see it.
TEST(Acceleration, QuasiNewtonSolvesAsManyUnknownsAsItHasDifferences) {
  const auto secants = make_accelerator(Acceleration::quasi_newton, 0);
  EXPECT_LE(passes(*secants, expanding(6), VectorXd::LinSpaced(6, 1.0, 2.0), 50), 8);
}

// The next window knows the law already.
TEST(Acceleration, QuasiNewtonRemembersWindows) {
  const auto forgetful = make_accelerator(Acceleration::quasi_newton, 0);
  const auto mindful = make_accelerator(Acceleration::quasi_newton, 3);
  const MatrixXd law = expanding(6);
  for (Accelerator* each : {forgetful.get(), mindful.get()}) passes(*each, law, VectorXd::Ones(6), 50);
  const VectorXd other = VectorXd::LinSpaced(6, -1.0, 2.0);
  EXPECT_LE(passes(*mindful, law, other, 50), 3);
  EXPECT_GT(passes(*forgetful, law, other, 50), 5);
}

// Units do not matter: what is expected in other ones is the same.
TEST(Acceleration, IsTheSameInOtherUnits) {
  const VectorXd unit = VectorXd::LinSpaced(4, 1.0, 1e6);
  for (const Acceleration kind : {Acceleration::aitken, Acceleration::quasi_newton}) {
    const auto plain = make_accelerator(kind, 2), scaled = make_accelerator(kind, 2);
    VectorXd expected = VectorXd::Zero(4), other = VectorXd::Zero(4);
    for (int pass = 0; pass < 4; ++pass) {
      expected = plain->next(expected, expanding(4) * expected + VectorXd::Ones(4), VectorXd::Ones(4));
      const VectorXd answer = unit.cwiseProduct(expanding(4) * other.cwiseQuotient(unit) + VectorXd::Ones(4));
      other = scaled->next(other, answer, unit.cwiseInverse());
    }
    EXPECT_LT((other.cwiseQuotient(unit) - expected).norm(), 1e-9 * expected.norm());
  }
}

// A difference twice over must not blow up the least squares.
TEST(Acceleration, QuasiNewtonBearsAnAnswerThatDoesNotChange) {
  const auto secants = make_accelerator(Acceleration::quasi_newton, 2);
  secants->begin();
  const VectorXd expected = VectorXd::Zero(3), answer = VectorXd::Ones(3);
  for (int pass = 0; pass < 4; ++pass) {
    const VectorXd next = secants->next(expected, answer, VectorXd::Ones(3));
    EXPECT_TRUE(next.allFinite());
    EXPECT_LT(next.norm(), 10.0);
  }
}

}  // namespace
}  // namespace orbearing::cosim::acceleration_test
