#include "gearset/mesh/iso6336.hpp"

#include <gtest/gtest.h>

namespace orbearing::gearset::iso6336_test {
namespace {

constexpr Iso6336Pair standard{.first_teeth = 30, .second_teeth = 45, .contact_ratio = 1.6};

TEST(Iso6336Stiffness, TakesARingForInfinitelyManyTeeth) {
  Iso6336Pair ring = standard;
  ring.second_teeth = 0;
  EXPECT_NEAR(1e9 / iso6336_stiffness(ring).theoretical_single, 0.04723 + 0.15551 / 30.0, 1e-12);
}

TEST(Iso6336Stiffness, FollowsTheModulus) {
  Iso6336Pair soft = standard;
  soft.material.youngs_modulus = 103e9;
  EXPECT_NEAR(iso6336_stiffness(soft).mesh, 0.5 * iso6336_stiffness(standard).mesh, 1.0);
  EXPECT_EQ(iso6336_stiffness(soft).theoretical_single, iso6336_stiffness(standard).theoretical_single);
}

TEST(Iso6336Stiffness, IsThatOfOnePairAtContactRatioOne) {
  Iso6336Pair one = standard;
  one.contact_ratio = 1.0;
  EXPECT_NEAR(iso6336_stiffness(one).mesh, iso6336_stiffness(one).single, 1.0);
}

TEST(Iso6336Stiffness, TakesTheGearWithFewerTeethForThePinion) {
  for (const auto& [first, second] : {std::pair{19, 17}, {30, 20}, {62, 62}}) {
    const Iso6336Pair pair{first, second, 0.1, 0.4, {}, 1.6, {}};
    const Iso6336Pair turned{second, first, 0.4, 0.1, {}, 1.6, {}};
    EXPECT_EQ(iso6336_stiffness(pair).theoretical_single, iso6336_stiffness(turned).theoretical_single);
    EXPECT_TRUE(iso6336_stiffness(pair).in_range);
  }
  const Iso6336Pair pair{30, 20, 0.0, 0.0, {}, 1.6, {}};
  EXPECT_NEAR(1e9 / iso6336_stiffness(pair).theoretical_single, 0.04723 + 0.15551 / 20.0 + 0.25791 / 30.0,
              1e-12);
}

// The wheel is a ring: only x_2 of its terms is left.
TEST(Iso6336Stiffness, KeepsTheShiftOfARing) {
  Iso6336Pair ring = standard;
  ring.second_teeth = 0;
  ring.second_shift = -0.5;
  EXPECT_NEAR(1e9 / iso6336_stiffness(ring).theoretical_single,
              0.04723 + 0.15551 / 30.0 + 0.00193 * 0.5 + 0.00182 * 0.25, 1e-12);
}

TEST(Iso6336Stiffness, KnowsItsRange) {
  Iso6336Pair pair = standard;
  EXPECT_TRUE(iso6336_stiffness(pair).in_range);
  pair.first_shift = -0.1;
  EXPECT_FALSE(iso6336_stiffness(pair).in_range);
  pair.second_shift = -0.5;
  EXPECT_FALSE(iso6336_stiffness(pair).in_range);
}

}  // namespace
}  // namespace orbearing::gearset::iso6336_test
