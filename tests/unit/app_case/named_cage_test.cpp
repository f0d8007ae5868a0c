// The material of a cage by the suffix of a designation, or by the line of a catalogue.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>
#include <vector>

#include "app/case/catalogue_warnings.hpp"
#include "bearing/default_design.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::named_cage_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

ResolvedCase planet(const std::string& bearing) {
  return parse_case(fmt::format(R"(name: planet
model: planetary-drivetrain
input: {{power: 55 kW, speed: 1480 rpm}}
gearset: {{planets: 3, teeth: {{sun: 18, planet: 33, ring: 84}}, module: 3 mm, face_width: 40 mm}}
bearing: {{per_planet: 1, {}}}
)",
                                bearing),
                    "case.yaml", {});
}

struct Named {
  std::string designation, material, reason;
};

TEST(NamedCage, IsThatOfTheSuffixElseThatOfTheCatalogue) {
  for (const Named& one : std::vector<Named>{
           {"NJ 2206 ECP", "polyamide", "default: the suffix P (cage of polyamide) of 'NJ 2206 ECP'"},
           {"NJ 2206 ECML", "brass", "default: the suffix ML (cage of brass) of 'NJ 2206 ECML'"},
           {"NU 2206 J", "steel", "default: the suffix J (cage of sheet steel) of 'NU 2206 J'"},
           {"NU 206", "steel",
            "default: the suffix EW (reinforced inside, cage of sheet steel) of NSK NU 206 EW"},
           {"NU 2206", "polyamide", "default: the suffix ET (reinforced inside, cage of polyamide)"},
           {"K 20x26x12, radial_clearance: 20 um", "steel", "default: a cage of steel in NTN K 20x26x12"}}) {
    const ResolvedCase in = planet("designation: " + one.designation);
    EXPECT_EQ(in.choice("bearing.cage.material"), one.material) << one.designation;
    EXPECT_THAT(in.assumed().at("bearing.cage.material"), HasSubstr(one.reason));
    EXPECT_DOUBLE_EQ(in.quantity("bearing.cage.density"), bearing::cage_material(one.material).density);
  }
}

TEST(NamedCage, StandsBackBehindWhatIsStated) {
  const ResolvedCase brass = planet("designation: NJ 2206 ECP, cage: {material: brass}"),
                     dense = planet("designation: NJ 2206 ECP, cage: {density: 2000 kg/m3}"),
                     none = planet("designation: NJ 2206 ECP, complement: full");
  EXPECT_EQ(brass.choice("bearing.cage.material"), "brass");
  EXPECT_DOUBLE_EQ(dense.quantity("bearing.cage.density"), 2000.0);
  for (const ResolvedCase* in : {&dense, &none}) EXPECT_FALSE(in->has("bearing.cage.material"));
}

TEST(NamedCage, WarnsOfAnotherMaterialThanTheSuffixHas) {
  EXPECT_THAT(
      inferred_warnings(planet("designation: NJ 2206 ECML, cage: {material: polyamide}")),
      Contains(HasSubstr("bearing.cage.material: polyamide as stated contradicts the suffix ML (cage of "
                         "brass) of 'NJ 2206 ECML'")));
  for (const char* agrees : {"designation: NJ 2206 ECML, cage: {material: brass}",
                             "designation: NJ 2206, cage: {material: brass}", "designation: NJ 2206 ECML"})
    EXPECT_THAT(inferred_warnings(planet(agrees)), Not(Contains(HasSubstr("contradicts")))) << agrees;
}

TEST(NamedCage, IsAColumnOfAUsersOwnCatalogue) {
  const std::string table =
      "designation: X 1, catalogue: \"designation, family, bore [mm], outside_diameter [mm], width [mm], "
      "inner_raceway [mm], dynamic_capacity [kN], static_capacity [kN], cage\\nX 1, cylindrical-roller, 30, "
      "62, "
      "20, 37.5, 49, 50, {}\\n\"";
  EXPECT_EQ(planet(fmt::format(fmt::runtime(table), "brass")).choice("bearing.cage.material"), "brass");
  try {
    (void)planet(fmt::format(fmt::runtime(table), "bronze"));
    ADD_FAILURE();
  } catch (const BadInput& error) {
    EXPECT_THAT(error.messages, Contains(HasSubstr("cage: 'bronze' is none of the choices")));
  }
}

}  // namespace
}  // namespace orbearing::app::named_cage_test
