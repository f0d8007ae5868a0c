// Whether the shaft of a pair turns, at its speed or at one of several.
#include <gtest/gtest.h>

#include "coupling/analysis/duplex_pair.hpp"

namespace orbearing::analysis::duplex_operation_test {
namespace {

bool rotates(double speed, const std::vector<double>& speeds) {
  PreloadedPair pair;
  pair.operation.shaft_speed = speed;
  pair.operation.speeds = speeds;
  return pair.rotates();
}

TEST(PreloadedPair, RotatesAtOneOfItsSpeeds) {
  EXPECT_FALSE(rotates(0.0, {}));
  EXPECT_TRUE(rotates(-100.0, {}));
  EXPECT_FALSE(rotates(0.0, {0.0, 0.0}));
  EXPECT_TRUE(rotates(0.0, {100.0}));
  EXPECT_TRUE(rotates(0.0, {0.0, -100.0}));
}

TEST(PreloadedPair, HasLinearFormulasWhereItStandsAndNoRowSeparates) {
  using bearing::duplex::Arrangement;
  PreloadedPair pair;
  for (const Arrangement arrangement :
       {Arrangement::face_to_face, Arrangement::tandem, Arrangement::back_to_back}) {
    pair.arrangement = arrangement;
    pair.operation.shaft_speed = 0.0;
    EXPECT_EQ(pair.has_linear_formulas(), arrangement != Arrangement::back_to_back);
    pair.operation.shaft_speed = 1.0;
    EXPECT_FALSE(pair.has_linear_formulas());
  }
}

}  // namespace
}  // namespace orbearing::analysis::duplex_operation_test
