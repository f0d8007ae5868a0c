// Oils from what a case states of them.
#include "bearing/film/graded_oil.hpp"

#include <gtest/gtest.h>

#include <string>

#include "bearing/motion/parameters.hpp"

namespace orbearing::bearing::graded_oil_test {
namespace {

constexpr double kMm2 = 1e-6;  // [m^2/s]

// A grade has its number as its viscosity at 40 degC, and reaches a viscosity at 100 degC.
TEST(GradedOil, HasTheViscosityThatItsGradeNames) {
  for (const auto& [grade, text] : names_of(ViscosityGrade{})) {
    if (grade == ViscosityGrade::stated) continue;
    const OilGrade oil = oil_of({.grade = grade}).value();
    EXPECT_EQ(oil.viscosity_40, std::stoi(std::string(text.substr(text.rfind(' ')))) * kMm2) << text;
    EXPECT_GT(viscosity_at_100(oil.viscosity_40, oil.viscosity_index), 0.0) << text;
  }
}

TEST(GradedOil, HasTheViscositiesOfItsDataSheet) {
  const GradedOil sheet{
      .grade = ViscosityGrade::stated, .viscosity_40 = 200.0 * kMm2, .viscosity_100 = 16.0 * kMm2};
  EXPECT_EQ(oil_of(sheet, 870.0),
            (OilGrade{.viscosity_40 = 200.0 * kMm2, .density = 870.0, .viscosity_100 = 16.0 * kMm2}));
  // Beside a grade they have no effect.
  GradedOil graded = sheet;
  graded.grade = ViscosityGrade::vg68;
  graded.viscosity_index = 60.0;
  EXPECT_EQ(oil_of(graded), (OilGrade{.viscosity_40 = 68.0 * kMm2, .viscosity_index = 60.0}));
}

TEST(GradedOil, IsNoneWhereNothingStatesIt) {
  EXPECT_FALSE(oil_of({.viscosity_40 = 200.0 * kMm2}));
  EXPECT_FALSE(oil_of({.grade = ViscosityGrade::stated, .viscosity_100 = 16.0 * kMm2}));
}

TEST(OilDrag, DensityIsStatedOfOilThatIsStirred) {
  EXPECT_EQ(motion::density_of_oil({.on = true, .oil_density = 900.0}), 900.0);
  EXPECT_EQ(motion::density_of_oil({.on = false, .oil_density = 900.0}), OilGrade{}.density);
}

}  // namespace
}  // namespace orbearing::bearing::graded_oil_test
