// Setups as numbers and back.
#include <gtest/gtest.h>

#include <set>

#include "coupling/fmu/setup_numbers.hpp"
#include "tests/messages.hpp"
#include "tests/unit/fmu/fmu_model.hpp"

namespace orbearing::fmu::fields_test {
namespace {

bearing::profile::Profile profile_of(const std::vector<double>& numbers) {
  bearing::profile::Profile profile;
  from_numbers(numbers, profile);
  return profile;
}

// Changes one member after the other; what is no single number is left to the texts' test.
struct ChangeOne {
  template <class Member>
  void operator()(Member& member, const described::Facts& facts) {
    if (visited++ != which) return;
    name = facts.path;
    if constexpr (is_single<Member>) {
      const double before = static_cast<double>(member);
      member = static_cast<Member>(before == 0.0 ? 1 : 0);
      changed = static_cast<double>(member) != before;
    }
  }
  int which = 0;
  int visited = 0;
  bool changed = false;
  std::string name{};
};

template <class Setup>
void expect_every_field_has_its_own_position(const Setup& setup) {
  const NumberTable before = numbers_of(setup);
  for (int i = 0; i < static_cast<int>(before.rows.size()); ++i) {
    Setup other = setup;
    ChangeOne change{i};
    describe(change, other);
    const NumberTable after = numbers_of(other);
    for (int j = 0; j < static_cast<int>(before.rows.size()); ++j) {
      const auto row = static_cast<std::size_t>(j);
      EXPECT_EQ(after.rows[row].values != before.rows[row].values, change.changed && i == j)
          << change.name << " and " << before.rows[row].name;
    }
  }
}

TEST(FmuFields, EveryFieldHasItsOwnPositionInTheSetup) {
  expect_every_field_has_its_own_position(test::bearing_model());
  expect_every_field_has_its_own_position(test::gear_model());
}

TEST(FmuFields, NamesAreUnique) {
  for (const NumberTable& table : {numbers_of(test::bearing_model()), numbers_of(test::gear_model())}) {
    std::set<std::string> names;
    for (const NumberRow& row : table.rows) EXPECT_TRUE(names.insert(row.name).second) << row.name;
  }
}

TEST(FmuFields, TextKeepsEveryBit) {
  system::DrivenBearingSetup model = test::bearing_model();
  model.bearing.radial_clearance = 0.1e-6 / 3.0;
  model.bearing.inner.form = {{3, 1e-6 / 7.0, 0.2, true}, {2, -1e-6, 0.0, false}};
  model.bearing.rollers().diameter_deviation = {1e-7 / 3.0, 0.0, 4.9e-324};
  const std::string text = text_of(numbers_of(model));
  const system::DrivenBearingSetup again = setup_from<system::DrivenBearingSetup>(table_from(text));
  EXPECT_EQ(text_of(numbers_of(again)), text);
  EXPECT_EQ(again.bearing.radial_clearance, model.bearing.radial_clearance);
  EXPECT_EQ(again.bearing.rollers().diameter_deviation, model.bearing.rollers().diameter_deviation);
  EXPECT_EQ(again.bearing.inner.form[0].rotating, true);
  EXPECT_EQ(again.bearing.inner.form[1].amplitude, -1e-6);
}

TEST(FmuFields, MeshCurvesAreTheSameCurves) {
  const system::DrivenGearsSetup model = test::gear_model();
  const system::DrivenGearsSetup again =
      setup_from<system::DrivenGearsSetup>(table_from(text_of(numbers_of(model))));
  const gearset::PeriodicCurve& curve = model.set.sun_mesh.stiffness;
  ASSERT_EQ(again.set.sun_mesh.stiffness.jumps(), curve.jumps());
  for (double fraction = -1.0; fraction < 2.0; fraction += 0.00731) {
    EXPECT_EQ(again.set.sun_mesh.stiffness.at(fraction).value, curve.at(fraction).value);
    EXPECT_EQ(again.set.sun_mesh.stiffness.at(fraction).slope, curve.at(fraction).slope);
  }
}

// Teeth under load are part of the model in the file.
TEST(FmuFields, LoadedTeethAreTheSameTeeth) {
  system::DrivenGearsSetup model = test::gear_model();
  const gearset::PeriodicCurve gap([](double f) { return 1e-6 * f * f; }, {0.0, 0.4}, 30);
  model.set.sun_mesh.loaded = std::make_shared<const gearset::LoadedTeeth>(
      model.set.sun_mesh.stiffness, gap, -0.4, 2.1, 1e-10,
      std::vector<gearset::FaceSlice>{{-0.1, 1e-6}, {0.1, 2e-6}});
  const system::DrivenGearsSetup again =
      setup_from<system::DrivenGearsSetup>(table_from(text_of(numbers_of(model))));
  ASSERT_NE(again.set.sun_mesh.loaded, nullptr);
  EXPECT_EQ(again.set.ring_mesh.loaded, nullptr);
  for (double position = -1.0; position < 2.0; position += 0.0731)
    EXPECT_EQ(again.set.sun_mesh.loaded->at(position, 2e-5).force,
              model.set.sun_mesh.loaded->at(position, 2e-5).force);
  const std::vector<double> numbers = to_numbers(model.set.sun_mesh.loaded);
  for (std::size_t length = 1; length < 30; ++length)
    EXPECT_REFUSED(std::invalid_argument, "fields 1",
                   from_numbers({numbers.begin(), numbers.begin() + static_cast<long>(length)},
                                model.set.sun_mesh.loaded));
}

TEST(FmuFields, BrokenCurvesAreRefused) {
  const std::vector<double> numbers = test::gear_model().set.sun_mesh.stiffness.numbers();
  for (std::size_t length = 0; length < std::min<std::size_t>(numbers.size(), 40); ++length)
    EXPECT_REFUSED(
        std::invalid_argument, "fields 2",
        gearset::PeriodicCurve::from_numbers({numbers.begin(), numbers.begin() + static_cast<long>(length)}));
  std::vector<double> longer = numbers;
  longer.push_back(0.0);
  EXPECT_REFUSED(std::invalid_argument, "fields 3", gearset::PeriodicCurve::from_numbers(longer));
}

TEST(FmuFields, ProfilesOfEveryKindComeBack) {
  using namespace bearing::profile;
  const std::vector<Profile> profiles{Straight{},
                                      Chamfer{1, 2, 3},
                                      CircularCrown{1, 2},
                                      StraightCircular{1, 2, 3},
                                      Lundberg{1, 2, 3},
                                      JohnsGohar{1, 2, 3},
                                      Iso16281{1, 2, 3},
                                      FujiwaraKawase{1, 2, 3, 4},
                                      Table{{1, 2, 3}, {4, 5, 6}, 7}};
  ASSERT_EQ(profiles.size(), std::variant_size_v<Profile>);
  for (const Profile& profile : profiles) {
    const std::vector<double> numbers = to_numbers(profile);
    const Profile again = profile_of(numbers);
    EXPECT_EQ(again.index(), profile.index());
    EXPECT_EQ(to_numbers(again), numbers);
    std::vector<double> shorter(numbers.begin(), numbers.end() - 1);
    EXPECT_REFUSED(std::invalid_argument, "fields 4", profile_of(shorter));
  }
  EXPECT_EQ(std::get<Table>(profile_of(to_numbers(profiles.back()))).drop, (std::vector<double>{4, 5, 6}));
  EXPECT_REFUSED(std::invalid_argument, "fields 5", profile_of({9.0}));
  EXPECT_REFUSED(std::invalid_argument, "fields 6", profile_of({-1.0}));
}

TEST(FmuModelText, SaysWhatIsWrong) {
  const std::string text = text_of(numbers_of(test::bearing_model()));
  EXPECT_NO_THROW(table_from(text));
  for (const std::size_t length : {0ul, 5ul, 30ul, text.size() / 2, text.size() - 1})
    EXPECT_REFUSED(std::invalid_argument, "fields 7", table_from(text.substr(0, length))) << length;
  const std::string head = "orbearing-fmu-model 1 bearing\n";
  for (const char* row : {"a 1 nan", "a 1 inf", "a 1 zz", "a 2 1p+0", "a 1 1p+0 1p+0", "a x", "a", " 1 1p+0",
                          "a 99999999999999999999 1p+0", "a 1 1p+5000"})
    EXPECT_REFUSED(std::invalid_argument, "fields 8", table_from(head + row + "\nend\n")) << row;
  EXPECT_REFUSED(std::invalid_argument, "fields 12", table_from("orbearing-fmu-model 2 bearing\nend\n"));
  EXPECT_EQ(table_from(head + "a 1 -1.8p-1\nend\n").at("a"), std::vector<double>{-0.75});
}

TEST(FmuModelText, NumbersThatMakeNoSenseAreRefused) {
  NumberTable numbers = numbers_of(test::bearing_model());
  for (NumberRow& row : numbers.rows)
    if (row.name == "bearing.width") row.values = {-1.0};
  NumberTable twice = numbers;
  for (NumberRow& row : twice.rows)
    if (row.name == "bearing.radial_clearance") row.values.push_back(0.0);
  EXPECT_REFUSED(std::invalid_argument, "fields 13", setup_from<system::DrivenBearingSetup>(twice));
  EXPECT_REFUSED(std::invalid_argument, "fields 9", setup_from<system::DrivenBearingSetup>(numbers));
  EXPECT_REFUSED(std::invalid_argument, "fields 10",
                 setup_from<system::DrivenBearingSetup>(NumberTable{"bearing", {}}));
  EXPECT_REFUSED(std::invalid_argument, "fields 11", facts_of(NumberTable{"engine", {}}));
}

}  // namespace
}  // namespace orbearing::fmu::fields_test
