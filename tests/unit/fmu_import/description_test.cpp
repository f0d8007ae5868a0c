#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coupling/fmu/import/errors.hpp"
#include "coupling/fmu/import/foreign_setup.hpp"
#include "tests/foreign/archive.hpp"

namespace orbearing::fmu::description_test {
namespace {

using cosim::Gives;
using cosim::PortKind;
using testing::HasSubstr;
using testing::ThrowsMessage;

ForeignDescription description_of(const std::string& xml) {
  const tests::Folder folder;
  std::ofstream{folder.path / "modelDescription.xml"} << xml;
  return read_description(folder.path / "modelDescription.xml");
}

std::string replaced(std::string text, const std::string& old, const std::string& now) {
  const auto place = text.find(old);
  if (place == std::string::npos) throw std::logic_error("no " + old);
  return text.replace(place, old.size(), now);
}

class Descriptions : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Versions, Descriptions, testing::Values(2, 3));

TEST_P(Descriptions, AreReadInBothVersions) {
  const auto description =
      description_of(tests::spring_mass_description({.version = GetParam(), .serialises = false}));
  EXPECT_EQ(description.version, GetParam());
  EXPECT_EQ(description.identifier, "spring_mass");
  EXPECT_EQ(description.token, "the token");
  EXPECT_TRUE(description.keeps_state);
  EXPECT_FALSE(description.serialises_state);
  EXPECT_EQ(description.interpolates_inputs, GetParam() == 2) << "3.0 has no such thing";
  EXPECT_EQ(description.units.at("mm").factor, 1e-3);
  ASSERT_NE(description.find("displacement"), nullptr);
  EXPECT_EQ(description.find("displacement")->reference, 4U);
  EXPECT_EQ(description.find("displacement")->unit, "mm");
  EXPECT_EQ(description.find("fault")->type, GetParam() == 2 ? "Integer" : "Int32");
  EXPECT_EQ(description.find("none"), nullptr);
}

TEST(Descriptions2, TakeUnitsFromDeclaredTypes) {
  auto xml =
      replaced(tests::spring_mass_description(), "<ModelVariables>",
               "<TypeDefinitions><SimpleType name=\"Way\"><Real unit=\"mm\"/></SimpleType></TypeDefinitions>"
               "<ModelVariables>");
  xml =
      replaced(xml, "<Real unit=\"mm\"/></ScalarVariable>", "<Real declaredType=\"Way\"/></ScalarVariable>");
  EXPECT_EQ(description_of(xml).find("displacement")->unit, "mm");
}

TEST(Descriptions2, ThatCannotBeUsedAreRefused) {
  const std::string xml = tests::spring_mass_description();
  const auto refused = [](const std::string& text, const char* reason) {
    EXPECT_THAT([&] { description_of(text); }, ThrowsMessage<ForeignFmuError>(HasSubstr(reason)));
  };
  refused("<a", "modelDescription.xml cannot be read");
  refused("<a/>", "no element fmiModelDescription");
  refused(replaced(xml, "\"2.0\"", "\"1.0\""), "FMI version 1.0; required is 2.0 or 3.0");
  refused(replaced(xml, "<CoSimulation", "<ModelExchange"), "not for co-simulation");
  refused(replaced(xml, "modelIdentifier=\"spring_mass\"", ""), "no attribute 'modelIdentifier'");
  refused(replaced(xml, "=\"spring_mass\"", "=\"../../x\""), "not a name of the language C");
  refused(replaced(xml, "guid=\"the token\"", ""), "no attribute 'guid'");
}

ForeignPort body(ForeignQuantity displacement, ForeignQuantity velocity, ForeignQuantity force) {
  return {{"planet.x", PortKind::translation, Gives::motion}, displacement, velocity, force};
}

TEST(ForeignPorts, ConvertUnitsThatTheFmuStates) {
  const auto description = description_of(tests::spring_mass_description());
  const auto channels =
      find_channels(description, {body({"displacement", -1.0, 0.5}, {"velocity"}, {"force", -2.0})});
  ASSERT_EQ(channels.size(), 1U);
  EXPECT_EQ(channels[0].displacement->factor, -1e-3);
  EXPECT_EQ(channels[0].displacement->offset, 0.5);
  EXPECT_EQ(channels[0].force->factor, -2.0);
  EXPECT_EQ(channels[0].force->held, Held::mean);
}

TEST(ForeignPorts, ThatDoNotFitAreRefusedWithWhatTheFmuHas) {
  const auto description = description_of(tests::spring_mass_description());
  const auto refused = [&](const ForeignPort& port, const char* reason) {
    EXPECT_THAT([&] { find_channels(description, {port}); },
                ThrowsMessage<ForeignFmuError>(HasSubstr(reason)));
  };
  refused(body({"position"}, {"velocity"}, {"force"}),
          "port planet.x: variable 'position' is missing; outputs of the FMU: displacement, velocity, "
          "spring.force");
  refused(body({"displacement"}, {"velocity"}, {"spring.force"}), "is output, required is input");
  refused(body({"velocity"}, {"displacement"}, {"force"}),
          "has the unit 'mm', required is one of the kind of m/s");
  refused(body({"displacement"}, {}, {"force"}), "displacement, velocity and force are required");
  refused(body({"displacement", 0.0}, {"velocity"}, {"force"}), "a factor of zero");
  ForeignPort rotation = body({"displacement"}, {"velocity"}, {"force"});
  rotation.port.kind = PortKind::rotation;
  refused(rotation, "required is one of the kind of rad");
  ForeignPort spring{{"pin.x", PortKind::translation, Gives::force}, {}, {}, {"spring.force"}};
  refused(spring, "force and for displacement or velocity are required");
  EXPECT_THAT(
      [&] {
        find_start_values(description, {{"fault", std::string("x")}});
      },
      ThrowsMessage<ForeignFmuError>(HasSubstr("is of type Integer, to which a text cannot be set")));
  EXPECT_THAT(
      [&] {
        find_start_values(description, {{"weight", 1.0}});
      },
      ThrowsMessage<ForeignFmuError>(HasSubstr("no variable 'weight'; parameters of the FMU: mass")));
}

}  // namespace
}  // namespace orbearing::fmu::description_test
