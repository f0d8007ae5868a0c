#include "bearing/life/life_modification.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/constants.hpp"
#include "tests/messages.hpp"

namespace orbearing::bearing::rating::life_modification_test {
namespace {

constexpr double kRoundOff = 1e-12;
constexpr double kRpm = constants::pi / 30.0;  // [rad/s]
constexpr RollingElement kBoth[] = {RollingElement::ball, RollingElement::roller};

// 4500/sqrt(2500 * 81) = 10 mm^2/s;  45000 * 100^-0.83/sqrt(100) = 98.4...
TEST(RequiredViscosity, ByHand) {
  EXPECT_NEAR(required_viscosity(2500.0 * kRpm, 81e-3), 10e-6, 10e-6 * kRoundOff);
  EXPECT_NEAR(required_viscosity(-100.0 * kRpm, 100e-3), 4.5e-3 * std::pow(100.0, -0.83), 1e-4 * kRoundOff);
  EXPECT_REFUSED(std::invalid_argument, "life_modification 1", required_viscosity(0.0, 0.1));
}

// The branches of a_ISO were fitted to meet; their coefficients carry five digits.
TEST(LifeModification, BranchesMeet) {
  constexpr double five_digits = 2e-3;  // a_ISO is a power 9.3 of a difference of such numbers
  for (const RollingElement element : kBoth)
    for (const double kappa : {0.4, 1.0}) {
      const double below = life_modification_factor(element, kappa * (1.0 - 1e-9), 0.3);
      EXPECT_NEAR(below / life_modification_factor(element, kappa, 0.3), 1.0, five_digits);
    }
}

// Without any fatigue limit a_ISO is 0.1; at kappa = 0.1 the film term all but vanishes.
TEST(LifeModification, LeastIsATenth) {
  constexpr double five_digits = 5e-3;
  for (const RollingElement element : kBoth) {
    EXPECT_NEAR(life_modification_factor(element, 1.0, 0.0), 0.1, kRoundOff);
    EXPECT_NEAR(life_modification_factor(element, 0.1, 1.0), 0.1, 0.1 * five_digits);
    // Rounded coefficients make the film term of rollers there -6e-5: no a_ISO below a tenth.
    for (const double ratio : {0.0, 5.0, 1e6, std::numeric_limits<double>::infinity()})
      EXPECT_GE(life_modification_factor(element, 0.1, ratio), 0.1) << ratio;
  }
}

// kappa = 1: ball 0.1 (1 - 0.5684^0.83 x^(1/3))^-9.3, roller 0.1 (1 - 0.3511 x^0.4)^-9.185.
TEST(LifeModification, ByHandAtKappaOne) {
  EXPECT_NEAR(life_modification_factor(RollingElement::ball, 1.0, 0.125),
              0.1 * std::pow(1.0 - 0.5 * std::pow(0.5684, 0.83), -9.3), kRoundOff * 100.0);
  EXPECT_NEAR(life_modification_factor(RollingElement::roller, 1.0, 1.0), 0.1 * std::pow(0.6489, -9.185),
              kRoundOff * 100.0);
}

TEST(LifeModification, GrowsWithFilmAndCleanlinessUpToFifty) {
  for (const RollingElement element : kBoth) {
    double last = 0.0;
    for (const double kappa : {0.1, 0.2, 0.5, 0.9, 1.5, 3.0, 4.0}) {
      const double factor = life_modification_factor(element, kappa, 0.2);
      EXPECT_GT(factor, last) << "kappa " << kappa;
      last = factor;
    }
    EXPECT_EQ(life_modification_factor(element, 7.0, 0.2), last);
    EXPECT_EQ(life_modification_factor(element, 2.0, 100.0), 50.0);
  }
}

TEST(LifeModification, OutsideItsRangeIsRefused) {
  for (const RollingElement element : kBoth) {
    EXPECT_REFUSED(std::invalid_argument, "life_modification 2",
                   life_modification_factor(element, 0.09, 0.5));
    EXPECT_REFUSED(std::invalid_argument, "life_modification 3",
                   life_modification_factor(element, 1.0, -0.5));
    EXPECT_REFUSED(std::invalid_argument, "life_modification 4",
                   life_modification_factor(element, std::nan(""), 0.5));
  }
}

TEST(FatigueLoadLimit, ShareOfTheStaticCapacity) {
  EXPECT_NEAR(fatigue_load_limit(RollingElement::ball, 22e3, 0.05), 1e3, 1e3 * kRoundOff);
  EXPECT_NEAR(fatigue_load_limit(RollingElement::roller, 8.2e3, 0.1), 1e3, 1e3 * kRoundOff);
  EXPECT_NEAR(fatigue_load_limit(RollingElement::ball, 22e3, 0.4), 500.0, 500.0 * kRoundOff);
}

// kappa = 1, d_m = 1000 mm: d_m^(1/3) = 10, d_m^0.55 = 44.67, so that a = 1 for clean oil.
TEST(Contamination, ByHandForALargeBearing) {
  EXPECT_NEAR(contamination_factor(Lubrication::circulating_oil, Cleanliness::highest, 1.0, 1.0), 0.94337,
              kRoundOff * 10.0);
  EXPECT_NEAR(contamination_factor(Lubrication::grease, Cleanliness::medium, 1.0, 1.0),
              0.0177 * std::pow(1000.0, 0.55) * (1.0 - 0.1677), kRoundOff);
}

// Kappa above 4 counts as 4, in e_C as in a_ISO. By hand for d_m = 35.64 mm: 0.0432 * 4^0.68 * 35.64^0.55 (1
// - 0.9987/35.64^(1/3)) = 0.5513.
TEST(Contamination, KappaAboveFourCountsAsFour) {
  const auto factor = [](double kappa, double pitch) {
    return contamination_factor(Lubrication::circulating_oil, Cleanliness::high, kappa, pitch);
  };
  EXPECT_NEAR(factor(4.0, 35.64e-3), 0.5513, 5e-5);
  for (const double kappa : {4.001, 5.48, 100.0}) EXPECT_EQ(factor(kappa, 35.64e-3), factor(4.0, 35.64e-3));
  EXPECT_LT(factor(3.99, 35.64e-3), factor(4.0, 35.64e-3));
  EXPECT_TRUE(std::isnan(factor(std::nan(""), 35.64e-3)));
}

// Every level is worse than the one before, and baths and greases are no better than filters.
TEST(Contamination, WorseLevelBySmallerFactor) {
  for (const Lubrication lubrication :
       {Lubrication::circulating_oil, Lubrication::oil_bath, Lubrication::grease}) {
    double last = 1.0;
    for (const Cleanliness level :
         {Cleanliness::highest, Cleanliness::high, Cleanliness::medium, Cleanliness::low}) {
      const double factor = contamination_factor(lubrication, level, 1.0, 0.08);
      EXPECT_LT(factor, last);
      EXPECT_GE(factor, 0.0);
      EXPECT_LE(factor, contamination_factor(Lubrication::circulating_oil, level, 1.0, 0.08));
      last = factor;
    }
  }
  EXPECT_REFUSED(std::invalid_argument, "life_modification 5",
                 contamination_factor(Lubrication::circulating_oil, Cleanliness::lowest, 1.0, 0.1));
}

}  // namespace
}  // namespace orbearing::bearing::rating::life_modification_test
