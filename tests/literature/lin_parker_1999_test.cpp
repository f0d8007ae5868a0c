// Natural frequencies of [LinParker1999] for three and four planets; the frequencies to a tenth of a hertz
// are recomputed from the paper's parameters, those of three planets agree with its table.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gearset/dynamics/modes.hpp"
#include "tests/gear_sets.hpp"

namespace orbearing::gearset::dynamics::lin_parker_1999_test {
namespace {

constexpr double kPrintedDigits = 0.1;  // [Hz]

struct Published {
  int planets;
  ModeKind kind;
  int multiplicity;
  std::vector<double> frequencies;  // [Hz]
};

class LinParker1999 : public testing::TestWithParam<Published> {};

TEST_P(LinParker1999, NaturalFrequencies) {
  const Published& published = GetParam();
  std::vector<double> ours;
  for (const Mode& mode : modes_at_rest(test::lin_parker_model(published.planets))) {
    if (mode.kind != published.kind) continue;
    EXPECT_EQ(mode.multiplicity, published.multiplicity) << mode.frequency << " Hz";
    ours.push_back(mode.frequency);
  }
  EXPECT_THAT(ours, testing::Pointwise(testing::DoubleNear(kPrintedDigits), published.frequencies));
}

INSTANTIATE_TEST_SUITE_P(
    Table, LinParker1999,
    testing::Values(Published{3, ModeKind::rotational, 1, {0.0, 1475.7, 1930.3, 2658.3, 7462.8, 11775.3}},
                    Published{3, ModeKind::translational, 2, {743.2, 1102.4, 1896.0, 2276.4, 6986.3, 9647.9}},
                    Published{3, ModeKind::planet, 0, {}},
                    Published{4, ModeKind::rotational, 1, {0.0, 1536.5, 1970.6, 2625.7, 7773.6, 13071.1}},
                    Published{
                        4, ModeKind::translational, 2, {727.3, 1091.2, 1892.8, 2342.5, 7189.9, 10437.6}},
                    Published{4, ModeKind::planet, 1, {1808.2, 5963.8, 6981.7}}));

}  // namespace
}  // namespace orbearing::gearset::dynamics::lin_parker_1999_test
