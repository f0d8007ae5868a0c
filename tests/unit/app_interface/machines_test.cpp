// Machines of cases as structures: what is read, and what a changed member changes.
#include "orbearing/machines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "app/case/member_values.hpp"
#include "orbearing/errors.hpp"
#include "tests/messages.hpp"
#include "tests/unit/app_interface/shipped_case.hpp"

namespace orbearing {
namespace {

std::vector<std::string> shipped_cases() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(ORBEARING_SOURCE_DIR "/cases"))
    if (entry.path().filename() == "case.yaml") files.push_back(entry.path().string());
  std::ranges::sort(files);
  return files;
}

// Changes the member of one number among those that have a row, or follow from others.
class Change {
 public:
  explicit Change(int number) : number_(number) {}

  template <class Member>
  void operator()(Member& member, const described::Facts& facts) {
    if (seen_++ != number_) return;
    path = facts.path;
    done = change(member);
  }
  template <class Self, class Variant>
  void choose(Self& self, Variant& member, const described::Facts&) {
    choose_by_inputs(self, member);
  }
  template <class Self, class Variant>
  void choose_by_inputs(Self& self, Variant& member) {
    std::visit([&](auto& chosen) { describe(self, chosen); }, member);
  }
  template <class Member>
  void apart(Member& member) {
    if constexpr (requires { describe(*this, member); })
      describe(*this, member);
    else if constexpr (std::is_arithmetic_v<Member>)
      (*this)(member, described::Facts{});
  }

  int seen() const { return seen_; }
  std::string path{};
  bool done = false;

 private:
  static bool change(bool& value) {
    value = !value;
    return true;
  }
  static bool change(double& value) {
    const double before = value;
    value = value == 0.0 ? 1e-6 : value * (1.0 + 1e-9);
    return value != before;  // else it is infinite, or none
  }
  template <std::integral Count>
  static bool change(Count& value) {
    ++value;
    return true;
  }
  template <class Choice>
  requires std::is_enum_v<Choice>
  static bool change(Choice& value) {
    const auto names = names_of(value);
    const auto own = std::ranges::find(names, value, [](const auto& name) { return name.value; });
    value = names[static_cast<std::size_t>(own - names.begin() + 1) % names.size()].value;
    return true;
  }
  static bool change(std::string& text) {
    text = text == "NU 205" ? "NU 206" : "NU 205";
    return true;
  }
  template <class Value>
  static bool change(std::optional<Value>& value) {
    if (!value) value.emplace();
    return change(*value);
  }
  template <class Value>
  static bool change(std::vector<Value>& values) {
    return !values.empty() && change(values.front());
  }
  template <class Value, std::size_t n>
  static bool change(std::array<Value, n>& values) {
    return change(values.front());
  }
  static bool change(bearing::Lubricant& oil) { return change(oil.viscosity); }
  static bool change(bearing::friction::BearingSize& size) { return change(size.bore); }
  static bool change(bearing::RaceHarmonic& wave) { return change(wave.amplitude); }
  static bool change(bearing::profile::Profile& profile) {
    profile = bearing::profile::CircularCrown{0.012, 1.23e-6};
    return true;
  }
  template <class Part>
  requires requires(Part part, int visitor) { describe(visitor, part); }
  static bool change(Part& part) {
    Change first(0);
    describe(first, part);
    return first.done;
  }

  int number_, seen_ = 0;
};

struct Tried {
  int set = 0, refused = 0;
};

// Every member, one at a time: a changed one is in the changed case, or is refused.
template <class Struct, class Put, class Read>
Tried try_all(const Case& stated, const Struct& own, const Put& put, const Read& read) {
  Tried tried;
  for (int number = 0;; ++number) {
    Struct other = own;
    Change change(number);
    describe(change, other);
    if (number >= change.seen()) return tried;
    if (!change.done) continue;
    const auto before = app::member_values(own), expected = app::member_values(other);
    try {
      const auto found = app::member_values(read(changed(stated, put(other))));
      ++tried.set;
      for (const auto& [place, value] : expected) {
        if (value == before.at(place)) continue;
        EXPECT_EQ(found.at(place).text, value.text) << place.first << " " << place.second;
      }
    } catch (const BadInput&) {
      ++tried.refused;
    }
  }
}

TEST(MachinesOfCases, OfEveryCaseAreThatCaseAgain) {
  for (const std::string& file : shipped_cases()) {
    SCOPED_TRACE(file);
    const Case stated = Case::read(file);
    EXPECT_EQ(changed(stated, machine_of(stated)).resolved(), stated.resolved());
  }
}

TEST(MachinesOfCases, HaveNumbersInSi) {
  const PlanetaryDrivetrain reducer = drivetrain_of(shipped("reducer_150kW"));
  EXPECT_EQ(reducer.drive.power, 150e3);
  EXPECT_EQ(reducer.single().planets.bearing.element_count(), 15);
}

TEST(MachinesOfCases, ChangeWhatFollowsToo) {
  const Case stated = shipped("reducer_150kW");
  PlanetaryDrivetrain reducer = drivetrain_of(stated);
  reducer.drive.power = 120e3;
  reducer.sets.front().set.planets.bearing.radial_clearance = 25e-6;
  const Case half = changed(stated, reducer);
  EXPECT_EQ(half.number("input.power"), 120e3);
  EXPECT_EQ(half.number("bearing.radial_clearance"), 25e-6);
  EXPECT_EQ(half.resolved(),
            stated.with("input.power", "120000 W").with("bearing.radial_clearance", "2.5e-05 m").resolved());
}

TEST(MachinesOfCases, OfOtherModelsAreRefused) {
  const Case bearing = parsed("harris_209"), reducer = parsed("reducer_150kW");
  EXPECT_REFUSED(BadInput, "machines model", drivetrain_of(bearing));
  EXPECT_REFUSED(BadInput, "machines other", changed(reducer, machine_of(bearing)));
}

// Another structure is chosen by its inputs, unless inputs of the former one are in the case.
TEST(MachinesOfCases, ChoicesAreMadeOrRefused) {
  const Case stated = shipped("duplex_7020");
  DuplexPair pair = std::get<DuplexPair>(machine_of(stated));
  pair.preloaded.housing = bearing::duplex::Housing{.mass = 40.0, .inertia = 0.5};
  const Case free = changed(stated, pair);
  EXPECT_EQ(free.number("housing.mass"), 40.0);
  EXPECT_EQ(free.number("housing.inertia"), 0.5);
  EXPECT_REFUSED(BadInput, "machines housing", changed(free, machine_of(stated)));
}

// Of the one set of a drivetrain.
template <class Change>
void change_set(const Case& stated, const Change& change) {
  PlanetaryDrivetrain other = drivetrain_of(stated);
  change(other.sets.front().set);
  changed(stated, other);
}

TEST(MachinesOfCases, WhatNoInputStatesIsRefused) {
  const Case stated = parsed("reducer_150kW", {"life.cleanliness=high"});
  EXPECT_REFUSED(BadInput, "machines absent",
                 change_set(stated, [](analysis::StatedSet& set) { set.rating.life.cleanliness.reset(); }));
  EXPECT_REFUSED(BadInput, "machines profile", change_set(stated, [](analysis::StatedSet& set) {
                   set.planets.bearing.rollers().profile = bearing::profile::CircularCrown{0.012, 1e-6};
                 }));
  EXPECT_REFUSED(BadInput, "machines no key",
                 change_set(stated, [](analysis::StatedSet& set) { set.planets.uneven_planets = true; }));
  EXPECT_REFUSED(BadInput, "machines twice", change_set(stated, [](analysis::StatedSet& set) {
                   set.planets.bearing.material.youngs_modulus = 200e9;
                   set.gears.material.youngs_modulus = 190e9;
                 }));
}

// In the one set of a drivetrain, and in a single bearing.
TEST(MachinesOfCases, ProfilesAreSet) {
  using bearing::profile::Kind;
  const bearing::profile::StatedProfile crown{.kind = Kind::circular, .drop = 7e-6},
      table{.kind = Kind::table, .x = {-3e-3, 0.0, 3e-3}, .drops = {6e-6, 0.0, 4e-6}};
  const Case of_planets = parsed("reducer_150kW", {"bearing.laminae=40"});
  PlanetaryDrivetrain reducer = drivetrain_of(of_planets);
  for (const auto& profile : {crown, table}) {
    reducer.sets.front().set.profile = profile;
    EXPECT_EQ(drivetrain_of(changed(of_planets, reducer)).single().profile, profile);
  }
  const Case of_bearing = parsed("harris_209");
  RollerBearing single = std::get<RollerBearing>(machine_of(of_bearing));
  single.run.loaded.profile = crown;
  EXPECT_EQ(
      changed(of_bearing, single).resolved(),
      of_bearing.with("bearing.profile.kind", "circular").with("bearing.profile.drop", "7e-06 m").resolved());
  single.run.loaded.profile = {.kind = Kind::straight, .drop = 7e-6};
  EXPECT_REFUSED(BadInput, "machines no profile", changed(of_bearing, single));
}

// The viscosities follow.
TEST(MachinesOfCases, OilsAreSet) {
  using bearing::ViscosityGrade;
  const Case stated =
      parsed("reducer_150kW", {"lubricant.grade=ISO VG 220", "lubricant.temperature=70 degC"});
  PlanetaryDrivetrain reducer = drivetrain_of(stated);
  bearing::GradedOil& oil = reducer.sets.front().set.rating.oil.stated;
  oil.grade = ViscosityGrade::vg32;
  oil.temperature = 55.0;
  EXPECT_EQ(changed(stated, reducer).resolved(),
            stated.with("lubricant.grade", "ISO VG 32").with("lubricant.temperature", "55 degC").resolved());
  oil = {.grade = ViscosityGrade::stated, .viscosity_40 = 200e-6, .viscosity_100 = 16e-6};
  EXPECT_EQ(drivetrain_of(changed(stated, reducer)).single().rating.oil.stated, oil);
  oil.viscosity_100 = 300e-6;
  EXPECT_REFUSED(BadInput, "machines no oil", changed(stated, reducer));
}

// Its dimensions and its clearance follow.
TEST(MachinesOfCases, BearingsOfTheCatalogueAreSet) {
  const Case stated = parsed("reducer_nu204", {"bearing.per_planet=1"});
  PlanetaryDrivetrain reducer = drivetrain_of(stated);
  bearing::catalogue::CatalogueBearing& bearing = reducer.sets.front().set.catalogue;
  ASSERT_EQ(bearing.designation, "NU 204");
  bearing = {.designation = "NU 205", .clearance_class = bearing::catalogue::ClearanceClass::c3};
  const Case larger = changed(stated, reducer);
  EXPECT_EQ(larger.resolved(),
            stated.with("bearing.designation", "NU 205").with("bearing.clearance_class", "C3").resolved());
  EXPECT_EQ(drivetrain_of(larger).single().planets.bearing.inner.seat_diameter, 25e-3);
  bearing.designation = "NU 99";
  EXPECT_REFUSED(BadInput, "machines no designation", changed(stated, reducer));
}

// A viscosity beside a grade would have no effect.
TEST(MachinesOfCases, ReplacedInputsAreRefused) {
  const Case stated =
      parsed("reducer_150kW", {"lubricant.grade=ISO VG 220", "lubricant.temperature=70 degC"});
  PlanetaryDrivetrain other = drivetrain_of(stated);
  other.sets.front().set.planets.dynamics.lubricant.viscosity = 0.02;
  EXPECT_REFUSED(BadInput, "machines replaced", changed(stated, other));
}

TEST(MachinesOfCases, OtherSetsAndShaftsAreRefused) {
  const Case stated = shipped("reducer_150kW");
  PlanetaryDrivetrain twice = drivetrain_of(stated);
  twice.sets.push_back(twice.sets.front());
  EXPECT_REFUSED(BadInput, "machines sets", changed(stated, twice));
  PlanetaryDrivetrain with_shaft = drivetrain_of(stated);
  with_shaft.shafts.push_back({.name = "motor", .motor = true});
  EXPECT_REFUSED(BadInput, "machines shafts", changed(stated, with_shaft));
}

TEST(MachinesOfCases, EveryMemberOfADrivetrainIsSetOrRefused) {
  const Case stated = shipped("reducer_150kW");
  const PlanetaryDrivetrain own = drivetrain_of(stated);
  const auto as_set = [&](const analysis::StatedSet& set) {
    PlanetaryDrivetrain other = own;
    other.sets.front().set = set;
    return Machine(other);
  };
  const Tried of_set =
      try_all(stated, own.single(), as_set, [](const Case& read) { return drivetrain_of(read).single(); });
  EXPECT_GT(of_set.set, 100);
  EXPECT_GT(of_set.refused, 20);
  const auto as_drive = [&](const gearset::Drive& drive) {
    PlanetaryDrivetrain other = own;
    other.drive = drive;
    return Machine(other);
  };
  const Tried of_drive =
      try_all(stated, own.drive, as_drive, [](const Case& read) { return drivetrain_of(read).drive; });
  EXPECT_GT(of_drive.set, 2);
}

template <class Single>
void try_single(const std::string& name) {
  SCOPED_TRACE(name);
  const Case stated = shipped(name);
  const auto own = std::get<Single>(machine_of(stated));
  const Tried tried = try_all(
      stated, own, [](const Single& other) { return Machine(other); },
      [](const Case& read) { return std::get<Single>(machine_of(read)); });
  EXPECT_GT(tried.set, 4);
}

TEST(MachinesOfCases, EveryMemberOfTheOthersIsSetOrRefused) {
  try_single<RollerBearing>("harris_209");
  try_single<BallBearing>("jones_218");
  try_single<MovingBallBearing>("nasa_35mm");
  try_single<DuplexPair>("duplex_7020");
  try_single<GearPair>("mesh_62_62");
  try_single<ScratchedBallBearing>("scratch_defect");
  try_single<ScratchedRollerBearing>("scratched_rollers");
  try_single<SpinFilm>("reynolds_point");
}

}  // namespace
}  // namespace orbearing
