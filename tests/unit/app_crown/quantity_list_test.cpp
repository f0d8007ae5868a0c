#include "app/study/crown/crown_options.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "app/case/case_file.hpp"

namespace orbearing::app::quantity_list_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<double> lengths(const std::string& text, std::vector<std::string>& mistakes) {
  return quantity_list("--drops", text, dimension::small_length, {0.0, 1.0, "lengths from 0 to 1 m"},
                       mistakes);
}

TEST(QuantityList, TakesSingleQuantitiesAndRanges) {
  std::vector<std::string> mistakes;
  const std::vector<double> found = lengths("2 um,0.01 mm , 0 um : 3 um : 1.5 um", mistakes);
  EXPECT_THAT(mistakes, IsEmpty());
  ASSERT_EQ(found.size(), 5u);
  const std::vector<double> expected{2e-6, 10e-6, 0.0, 1.5e-6, 3e-6};
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-18);
}

TEST(QuantityList, TellsEveryMistake) {
  std::vector<std::string> mistakes;
  lengths("2, 3 kg, , 1 um : 2 um, 0 um : 1 um : 0.3 um, 1 um : 0 um : 1 um", mistakes);
  EXPECT_THAT(mistakes, ElementsAre(HasSubstr("no unit"), HasSubstr("3 kg"), HasSubstr("--drops"),
                                    HasSubstr("FROM : TO : STEP"), HasSubstr("FROM : TO : STEP"),
                                    HasSubstr("FROM : TO : STEP")));
}

/// Messages repeat a value as it was written, in the user's unit.
TEST(QuantityList, RefusesWhatIsOutOfRangeAsItWasWritten) {
  for (const char* wrong : {"2000 mm", "-3 um", "0 m : 4 m : 2 m"}) {
    std::vector<std::string> mistakes;
    lengths(std::string("1 um, ") + wrong, mistakes);
    EXPECT_THAT(mistakes,
                ElementsAre("--drops: found '" + std::string(wrong) + "'; required: lengths from 0 to 1 m"));
  }
}

TEST(CrownChoices, GoThroughJsonUnchanged) {
  const CrownChoices choices{.profiles = "circular",
                             .tilts = "1 mrad",
                             .drops = "4 um",
                             .spectrum = true,
                             .shares = "0.5, 0.5",
                             .tolerance = "1 um",
                             .tilt_tolerance = "0.1 mrad",
                             .life = "iso16281",
                             .of_set = "second",
                             .starts = 3};
  EXPECT_EQ(choices_json(choices_from(choices_json(choices))), choices_json(choices));
  EXPECT_EQ(choices_text({}), "crown --starts 10");
}

// Crowns use life.method where no option states another life. C and P are the same for all crowns.
TEST(CrownChoices, LifeIsThatOfTheCase) {
  using analysis::crowning::LifeMethod;
  const auto measure = [](const std::string& method, const std::string& option) {
    CrownChoices choices;
    choices.life = option;
    const std::vector<std::string> settings{"life.method=" + method};
    return crown_request(read_case(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml", settings), choices)
        .method;
  };
  EXPECT_EQ(measure("lundberg-palmgren", ""), LifeMethod::lundberg_palmgren);
  EXPECT_EQ(measure("iso-16281", ""), LifeMethod::iso16281);
  EXPECT_EQ(measure("iso-281", ""), LifeMethod::lundberg_palmgren);
  EXPECT_EQ(measure("iso-16281", "lundberg-palmgren"), LifeMethod::lundberg_palmgren);
  EXPECT_EQ(measure("lundberg-palmgren", "iso16281"), LifeMethod::iso16281);
}

}  // namespace
}  // namespace orbearing::app::quantity_list_test
