#include "bearing/contact/lamina_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "tests/messages.hpp"

namespace orbearing::bearing::laminae::lamina_contact_test {
namespace {

constexpr double kRoundOff = 1e-13;        // relative; sums of up to 200 laminae
constexpr double kDifferenceError = 1e-6;  // relative, central differences near laminae that just touch
constexpr double kLength = 5.7e-3;

const LineContact law = roller_race_contact(ContactLaw::palmgren, kLength);

struct Situation {
  std::vector<double> drops;
  double approach = 0.0, end_displacement = 0.0;
};

// Crowned contacts, from light touch to deep, tilted both ways.
std::vector<Situation> situations() {
  std::mt19937_64 engine(7);
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine);
  };
  std::vector<Situation> all;
  for (int i = 0; i < 200; ++i) {
    const int n = std::uniform_int_distribution<int>(1, 200)(engine);
    const profile::Profile roller = profile::CircularCrown{kLength, between(0.0, 20e-6)};
    const profile::Profile race = profile::Chamfer{kLength, 0.5e-3, between(0.0, 10e-6)};
    all.push_back({lamina_drops(roller, race, kLength, n), std::pow(10.0, between(-8.0, -4.0)),
                   between(-15e-6, 15e-6)});
  }
  return all;
}

double by_hand(const Situation& s, int k) {
  const double n = static_cast<double>(s.drops.size());
  const double position = (k + 0.5) / n * 2.0 - 1.0;
  const double depth = s.approach + position * s.end_displacement - s.drops[static_cast<std::size_t>(k)];
  return depth > 0.0 ? law.constant() / n * std::pow(depth, 10.0 / 9.0) : 0.0;
}

TEST(LaminaContact, PositionsAreTheMiddlesOfTheStandard) {
  // x_k = ((k - 1/2)/n - 1/2) l
  const std::vector<double> positions = lamina_positions(5);
  for (int k = 1; k <= 5; ++k)
    EXPECT_NEAR(0.5 * positions[static_cast<std::size_t>(k - 1)], (k - 0.5) / 5.0 - 0.5, kRoundOff);
}

TEST(LaminaContact, DropsOfBothBodiesAddUp) {
  const profile::Profile roller = profile::CircularCrown{kLength, 9e-6};
  const profile::Profile race = profile::Chamfer{kLength, 1e-3, 4e-6};
  const std::vector<double> drops = lamina_drops(roller, race, kLength, 40);
  const double x = -39.0 / 80.0 * kLength;
  EXPECT_NEAR(drops[0], profile::drop(roller, x) + profile::drop(race, x), 1e-20);
  EXPECT_NEAR(drops[39], drops[0], 1e-18);
}

TEST(LaminaContact, StraightWithoutTiltIsTheLineContactWhateverTheNumberOfLaminae) {
  for (const ContactLaw which : {ContactLaw::palmgren, ContactLaw::iso16281}) {
    const LineContact line = roller_race_contact(which, kLength);
    for (const int n : {1, 2, 7, 40, 200})
      for (const double approach : {1e-9, 3e-6, 1e-4}) {
        const std::vector<double> drops(static_cast<std::size_t>(n), 0.0);
        const LaminaForce force = LaminaContact(line, kLength, drops).evaluate(approach, 0.0);
        EXPECT_NEAR(force.load, line.load(approach), line.load(approach) * kRoundOff);
        EXPECT_NEAR(force.by_approach, line.stiffness(approach), line.stiffness(approach) * kRoundOff);
        EXPECT_NEAR(force.end_load, 0.0, line.load(approach) * kRoundOff);
      }
  }
}

TEST(LaminaContact, TwoInSeriesHaveTheConstantOfTheStandard) {
  // 1 mm of contact and 1 mm of approach of both contacts together: 35948 N.
  const LineContact line = roller_race_contact(ContactLaw::iso16281, 1e-3);
  const std::vector<double> drops(30, 0.0);
  constexpr double kPrintedDigits = 0.5;
  EXPECT_NEAR(LaminaContact(line, 1e-3, drops).evaluate(0.5e-3, 0.0).load, 35948.0, kPrintedDigits);
}

TEST(LaminaContact, EveryInstructionSetGivesTheLawByHand) {
  for (const mechanics::InstructionSet set : mechanics::instruction_sets())
    for (const Situation& s : situations()) {
      const LaminaContact contact(law, kLength, s.drops, set);
      const Eigen::ArrayXd loads = contact.loads(s.approach, s.end_displacement);
      ASSERT_EQ(loads.size(), static_cast<Eigen::Index>(s.drops.size()));
      double sum = 0.0;
      const double scale = law.constant() * std::pow(s.approach + std::abs(s.end_displacement), 10.0 / 9.0);
      for (int k = 0; k < contact.laminae(); ++k) {
        EXPECT_NEAR(loads[k], by_hand(s, k), kRoundOff * scale) << name_of(set);
        sum += by_hand(s, k);
      }
      EXPECT_NEAR(contact.evaluate(s.approach, s.end_displacement).load, sum, kRoundOff * scale)
          << name_of(set);
    }
}

TEST(LaminaContact, EveryInstructionSetGivesTheSameBits) {
  for (const Situation& s : situations()) {
    const LaminaContact reference(law, kLength, s.drops, mechanics::InstructionSet::baseline);
    const LaminaForce wanted = reference.evaluate(s.approach, s.end_displacement);
    for (const mechanics::InstructionSet set : mechanics::instruction_sets()) {
      const LaminaContact contact(law, kLength, s.drops, set);
      const LaminaForce force = contact.evaluate(s.approach, s.end_displacement);
      EXPECT_EQ(force.load, wanted.load) << name_of(set);
      EXPECT_EQ(force.end_load, wanted.end_load) << name_of(set);
      EXPECT_EQ(force.by_approach, wanted.by_approach) << name_of(set);
      EXPECT_TRUE(
          (contact.loads(s.approach, s.end_displacement) == reference.loads(s.approach, s.end_displacement))
              .all())
          << name_of(set);
    }
  }
}

TEST(LaminaContact, ForcesAreTheSlopesOfTheEnergy) {
  for (const Situation& s : situations()) {
    const LaminaContact contact(law, kLength, s.drops);
    const LaminaForce force = contact.evaluate(s.approach, s.end_displacement);
    const double step = 1e-4 * (s.approach + std::abs(s.end_displacement));
    const double by_approach = (contact.energy(s.approach + step, s.end_displacement) -
                                contact.energy(s.approach - step, s.end_displacement)) /
                               (2.0 * step);
    const double by_end_displacement = (contact.energy(s.approach, s.end_displacement + step) -
                                        contact.energy(s.approach, s.end_displacement - step)) /
                                       (2.0 * step);
    const double scale = contact.evaluate(s.approach + std::abs(s.end_displacement), 0.0).load;
    EXPECT_NEAR(force.load, by_approach, kDifferenceError * scale);
    EXPECT_NEAR(force.end_load, by_end_displacement, kDifferenceError * scale);
  }
}

TEST(LaminaContact, SlopesAreThoseOfLoadAndMoment) {
  constexpr double kTouching = 2e-3;  // a lamina that just touches bends the load most: step^(1/9)
  for (const Situation& s : situations()) {
    const LaminaContact contact(law, kLength, s.drops);
    const LaminaForce force = contact.evaluate(s.approach, s.end_displacement);
    const double step = 1e-6 * (s.approach + std::abs(s.end_displacement));
    const LaminaForce up = contact.evaluate(s.approach + step, s.end_displacement);
    const LaminaForce down = contact.evaluate(s.approach - step, s.end_displacement);
    const LaminaForce right = contact.evaluate(s.approach, s.end_displacement + step);
    const LaminaForce left = contact.evaluate(s.approach, s.end_displacement - step);
    const double scale = force.by_approach + 1.0;
    EXPECT_NEAR(force.by_approach, (up.load - down.load) / (2.0 * step), kTouching * scale);
    EXPECT_NEAR(force.mixed, (up.end_load - down.end_load) / (2.0 * step), kTouching * scale);
    EXPECT_NEAR(force.mixed, (right.load - left.load) / (2.0 * step), kTouching * scale);
    EXPECT_NEAR(force.by_end_displacement, (right.end_load - left.end_load) / (2.0 * step),
                kTouching * scale);
  }
}

TEST(LaminaContact, OneSidedContactHasAMomentAboutTheMiddle) {
  // All the load on the last of four laminae: its place is 3/4 of half the length.
  const std::vector<double> drops(4, 0.0);
  const LaminaForce force = LaminaContact(law, kLength, drops).evaluate(-7e-6, 10e-6);
  EXPECT_GT(force.load, 0.0);
  EXPECT_NEAR(force.end_load, 0.75 * force.load, kRoundOff * force.load);
}

TEST(LaminaContact, NeverPulls) {
  const std::vector<double> drops{3e-6, 0.0, 0.0, 3e-6};
  const LaminaContact contact(law, kLength, drops);
  EXPECT_EQ(contact.evaluate(-1e-6, 0.0).load, 0.0);
  EXPECT_EQ(contact.evaluate(-1e-6, 1e-6).by_end_displacement, 0.0);
  EXPECT_EQ(contact.energy(0.0, 0.0), 0.0);
  EXPECT_EQ(contact.loads(2e-6, 0.0)[0], 0.0);
}

TEST(LaminaContact, RefusesWhatIsNoContact) {
  EXPECT_REFUSED(std::invalid_argument, "lamina_contact 1",
                 LaminaContact(law, kLength, std::vector<double>{}));
  EXPECT_REFUSED(std::invalid_argument, "lamina_contact 2",
                 LaminaContact(law, kLength, std::vector<double>(1001, 0.0)));
  EXPECT_REFUSED(std::invalid_argument, "lamina_contact 3",
                 LaminaContact(law, kLength, std::vector<double>{0.0, std::nan("")}));
}

}  // namespace
}  // namespace orbearing::bearing::laminae::lamina_contact_test
