// Cases that are read into types: fields, choices and uses follow from the structures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/case/case_file.hpp"
#include "app/case/field_table.hpp"
#include "app/case/machine_of.hpp"
#include "app/case/machines.hpp"
#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "coupling/analysis/contact_film.hpp"
#include "coupling/analysis/duplex_run.hpp"
#include "coupling/analysis/pair_meshes.hpp"

namespace orbearing::app::machines_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string pair = R"(name: pair
model: gear-pair
pair:
  teeth: [20, 61]
  module: 2 mm
  face_width: 11 mm
  bore: 13 mm
)";
const std::string film = R"(name: film
model: spin-film
contact:
  rolling_radius: 5 mm
  ellipticity: 3
  modulus: 226 GPa
points: [[100 N, 2 m/s, 30 rad/s], [200 N, 4 m/s, 50 rad/s]]
)";

const std::string duplex = R"(name: duplex
model: duplex-pair
arrangement: face-to-face
preload: 540 N
bearing:
  balls: 20
  ball_diameter: 14 mm
  pitch_diameter: 125 mm
  contact_angle: 20 deg
  radial_clearance: 0 um
spindle:
  mass: 10 kg
  first_lever: 29 mm
  second_lever: 28 mm
  diameter: 100 mm
)";

ResolvedCase read(const std::string& text, const std::vector<std::string>& settings = {}) {
  return parse_case(text, "case.yaml", settings);
}

std::string refusal_of(const std::string& text, const std::vector<std::string>& settings = {}) {
  try {
    read(text, settings);
  } catch (const BadInput& refusal) {
    return refusal.what();
  }
  return "nothing";
}

TEST(MachineOf, GivesEachMemberItsValueInSi) {
  const auto in = machine_of<analysis::PairOfGears>(
      read(pair, {"pair.profile_shift=[0.1, -0.2]", "pair.helix_angle=18 deg", "pair.addendum=0.9",
                  "pair.web.thickness=0.3", "material.density=7000 kg/m3"}));
  EXPECT_EQ(in.pair.teeth, (std::array{20, 61}));
  EXPECT_EQ(in.pair.shift, (std::array{0.1, -0.2}));
  EXPECT_DOUBLE_EQ(in.pair.module, 2e-3);
  EXPECT_DOUBLE_EQ(in.pair.face_width, 11e-3);
  EXPECT_DOUBLE_EQ(in.pair.bore, 13e-3);
  EXPECT_NEAR(in.pair.helix_angle, 0.3141592653589793, 1e-15);
  EXPECT_EQ(in.pair.rack.addendum, 0.9);
  EXPECT_EQ(in.pair.web.thickness, 0.3);
  EXPECT_EQ(in.material.density, 7000.0);
  EXPECT_EQ(in.material.youngs_modulus, 206e9);
}

TEST(MachineOf, HasRowsOfAListInTheirOrder) {
  const auto in = machine_of<analysis::SpinFilm>(read(film));
  ASSERT_EQ(in.points.size(), 2u);
  EXPECT_EQ(in.points[1].load, 200.0);
  EXPECT_EQ(in.points[1].rolling, 4.0);
  EXPECT_EQ(in.points[1].spin, 50.0);
  EXPECT_EQ(in.lubricant.viscosity, bearing::warm_gear_oil.viscosity);
}

TEST(MachineOf, HoldsTheAlternativeThatAKeyChooses) {
  const auto external = machine_of<analysis::PairOfGears>(read(pair, {"pair.driven_bore=31 mm"}));
  EXPECT_DOUBLE_EQ(std::get<gearset::ExternalPair>(external.pair.kind).driven_bore.value(), 31e-3);
  const auto internal =
      machine_of<analysis::PairOfGears>(read(pair, {"pair.kind=internal", "pair.ring_outside_ratio=1.3"}));
  EXPECT_EQ(std::get<gearset::InternalPair>(internal.pair.kind).ring_outside, 1.3);
}

TEST(MachineOf, HoldsTheAlternativeWhoseInputsAreStated) {
  EXPECT_EQ(std::get<analysis::EllipseOfContact>(machine_of<analysis::SpinFilm>(read(film)).contact.shape).ellipticity,
            3.0);
  std::string line = film;
  line.replace(line.find("ellipticity: 3"), 14, "length: 7 mm");
  const std::vector<std::string> solved{"film.solver=reynolds", "points=[[100 N, 2 m/s, 0 rad/s]]"};
  EXPECT_DOUBLE_EQ(
      std::get<analysis::LineOfContact>(machine_of<analysis::SpinFilm>(read(line, solved)).contact.shape).length, 7e-3);
}

// Rows of a bearing, which other models share: those of a duplex pair alone.
TEST(MachineOf, HoldsPartsOfOtherModelsByTheirRows) {
  const auto in = machine_of<analysis::DuplexPair>(
      read(duplex, {"bearing.outer_osculation=0.53", "bearing.dynamic_capacity=70 kN",
                    "operation.speeds=[0 rpm, 60 rpm]", "equilibrium.gyroscopic_moment=none"}));
  EXPECT_EQ(in.preloaded.bearing.balls().count, 20);
  EXPECT_DOUBLE_EQ(in.preloaded.bearing.pitch_diameter, 125e-3);
  EXPECT_EQ(in.preloaded.bearing.outer.osculation, 0.53);
  EXPECT_DOUBLE_EQ(in.capacities.dynamic_capacity.value(), 70e3);
  ASSERT_EQ(in.preloaded.operation.speeds.size(), 2u);
  EXPECT_NEAR(in.preloaded.operation.speeds[1], 6.283185307179586, 1e-14);
  EXPECT_EQ(in.preloaded.ball_inertia.gyroscopic_moment, bearing::equilibrium::GyroscopicMoment::none);
  EXPECT_THAT(paths_of<analysis::DuplexPair>(),
              AllOf(Contains("bearing.balls"), Contains("material.density"), Not(Contains("bearing.rollers")),
                    Not(Contains("bearing.cage.width")), Not(Contains("bearing.profile"))));
  EXPECT_THAT(refusal_of(duplex, {"bearing.balls=null"}), HasSubstr("bearing.balls: missing"));
  EXPECT_FALSE(read(duplex).has("operation.speeds"));
}

TEST(MachineOf, HoldsTheShaftAndTheHousingThatAreStated) {
  const auto pair_of = [](const std::vector<std::string>& settings) {
    return machine_of<analysis::PreloadedPair>(read(duplex, settings));
  };
  const bearing::duplex::Shaft cylinder = pair_of({}).spindle.shaft();
  EXPECT_DOUBLE_EQ(cylinder.inertia_x, bearing::duplex::cylinder_inertia(10.0, 0.1, 7850.0));
  const bearing::duplex::Shaft other =
      pair_of({"spindle.diameter=null", "spindle.inertia_x=0.2 kg.m2", "spindle.inertia_y=0.3 kg.m2"})
          .spindle.shaft();
  EXPECT_EQ(other.inertia_x, 0.2);
  EXPECT_EQ(other.inertia_y, 0.3);
  EXPECT_FALSE(pair_of({}).free_housing());
  EXPECT_EQ(pair_of({"housing.mass=3 kg", "housing.inertia=0.1 kg.m2"}).free_housing()->inertia, 0.1);
  const bearing::duplex::Shaft linear = pair_of({"linear.mass=9 kg"}).linear_shaft();
  EXPECT_EQ(linear.mass, 9.0);
  EXPECT_DOUBLE_EQ(linear.levers.second, 28e-3);
}

TEST(Alternatives, AnInputOfAnotherOneIsRefused) {
  EXPECT_THAT(refusal_of(duplex, {"spindle.inertia_x=0.2 kg.m2", "spindle.inertia_y=0.3 kg.m2"}),
              HasSubstr("spindle.inertia_x: '0.2 kg.m2' together with spindle.diameter or spindle.density; one of "
                        "both is required"));
  EXPECT_THAT(refusal_of(pair, {"pair.kind=internal", "pair.driven_bore=31 mm"}),
              HasSubstr("pair.driven_bore: an input of pair.kind: external, and here it is internal; a case without "
                        "it, or pair.kind: external, is required"));
  EXPECT_THAT(refusal_of(pair + "  ring_outside_ratio: 1.2\n"),
              AllOf(HasSubstr("case.yaml:8:23"), HasSubstr("an input of pair.kind: internal")));
  EXPECT_THAT(refusal_of(film, {"contact.length=3 mm"}), HasSubstr("together with contact."));
}

TEST(Alternatives, OneOfThemIsRequired) {
  EXPECT_THAT(refusal_of(duplex, {"spindle.diameter=null"}),
              AllOf(HasSubstr("spindle.diameter: missing"), HasSubstr("or spindle.inertia_x or spindle.inertia_y instead")));
  EXPECT_THAT(refusal_of(duplex, {"housing.mass=3 kg"}),
              AllOf(HasSubstr("housing.inertia: missing"), Not(HasSubstr("instead"))));
  std::string neither = film;
  neither.erase(neither.find("  ellipticity: 3\n"), 17);
  EXPECT_THAT(refusal_of(neither), AllOf(HasSubstr("contact.ellipticity: missing"), HasSubstr("or contact.length instead")));
}

TEST(Alternatives, DefaultsAreThoseOfTheChosenOne) {
  EXPECT_FALSE(read(pair).has("pair.ring_outside_ratio"));
  const ResolvedCase internal = read(pair, {"pair.kind=internal"});
  EXPECT_EQ(internal.given("pair.ring_outside_ratio"), "1.15");
  EXPECT_THAT(internal.assumed().at("pair.ring_outside_ratio"), HasSubstr("five modules"));
  const ResolvedCase changed = read(pair).with("pair.kind", "internal");
  EXPECT_EQ(changed, internal);
  EXPECT_EQ(changed.with("pair.kind", "external"), read(pair, {"pair.kind=external"}));
  EXPECT_THROW(read(pair, {"pair.driven_bore=31 mm"}).with("pair.kind", "internal"), BadInput);
}

TEST(Machines, ArraysHaveAsManyValuesAsTheirMember) {
  EXPECT_THAT(refusal_of(pair, {"pair.teeth=[20, 61, 30]"}), HasSubstr("pair.teeth: a list of 3; 2 values are required"));
}

TEST(Machines, AreReadAgainAsTheyWereWritten) {
  for (const std::string& text : {pair, film, duplex}) {
    const ResolvedCase in = read(text);
    EXPECT_EQ(write_resolved(parse_case(write_resolved(in), "again.yaml", {})), write_resolved(in));
  }
}

// The type of its parameter determines the inputs of an analysis: a mesh has no mass.
TEST(MachineAnalyses, UseWhatTheirParameterHolds) {
  const MachineAnalysis* mesh = machine_analysis(described::gear_pair, "mesh");
  ASSERT_NE(mesh, nullptr);
  EXPECT_THAT(paths_of<analysis::ElasticPair>(), AllOf(Contains("pair.bore"), Contains("pair.driven_bore"), Contains("pair.kind"),
                                  Contains("material.poisson_ratio"), Not(Contains("material.density"))));
  EXPECT_THAT(require_used(read(pair, {"material.density=7000 kg/m3"}), mesh->used),
              Contains(HasSubstr("material.density: 7000 kg/m3 has no effect on mesh")));
  EXPECT_THAT(require_used(read(pair, {"pair.driven_bore=31 mm"}), mesh->used), IsEmpty());
  EXPECT_EQ(machine_analysis(described::gear_pair, "run"), nullptr);
}

// The type of one analysis holds more than that of the other, and some inputs depend on others.
TEST(MachineAnalyses, UseSomeInputsUnderAConditionOnOthers) {
  const use::Analysis modes = machine_analysis(described::duplex_pair, "modes")->used,
                      run = machine_analysis(described::duplex_pair, "run")->used;
  const auto warnings_of = [](const std::vector<std::string>& settings, use::Analysis analysis) {
    return require_used(read(duplex, settings), analysis);
  };
  const std::vector<std::string> loss{"response.loss_factor=0.01"};
  EXPECT_THAT(warnings_of(loss, modes), Contains(HasSubstr("used by run of a duplex pair")));
  EXPECT_THAT(warnings_of(loss, run), IsEmpty());
  EXPECT_THAT(require_used(read(duplex + "response: {loss_factor: 0.01}\n"), modes), IsEmpty());
  const std::vector<std::string> linear{"linear.mass=9 kg"}, back{"linear.mass=9 kg", "arrangement=back-to-back"};
  EXPECT_THAT(warnings_of(linear, run), IsEmpty());
  EXPECT_THAT(warnings_of(back, run),
              Contains("linear.mass: 9 kg has no effect: it counts only where arrangement is face-to-face or "
                       "tandem, and operation.shaft_speed is 0"));
  const std::string density = "material.density=7000 kg/m3", rotating = "operation.shaft_speed=900 rpm",
                    massless = "equilibrium.ball_inertia=false";
  EXPECT_THAT(warnings_of({density}, run), Contains(HasSubstr("it counts only together with operation.shaft_speed")));
  EXPECT_THAT(warnings_of({density, rotating}, run), IsEmpty());
  EXPECT_THAT(warnings_of({density, rotating, massless}, run), Contains(HasSubstr("material.density")));
  EXPECT_THAT(warnings_of({rotating, massless}, run), IsEmpty());  // hours of life follow from the speed
  EXPECT_THAT(warnings_of({rotating, massless}, modes),
              Contains(HasSubstr("operation.shaft_speed: 900 rpm has no effect on modes of a duplex pair")));
}

TEST(MachineAnalyses, FailuresNameTheCase) {
  const MachineAnalysis* modes = machine_analysis(described::duplex_pair, "modes");
  try {
    modes->compute(read(duplex, {"arrangement=tandem", "operation.shaft_speed=900000 rpm"}), {});
    FAIL() << "an equilibrium at any speed";
  } catch (const ComputationFailed& failure) {
    EXPECT_THAT(failure.what(), testing::StartsWith("duplex: "));
  }
}

TEST(MachineQuantities, AreListedInTheirUnits) {
  const std::vector<Derived> of_duplex = machine_quantities(read(duplex));
  ASSERT_FALSE(of_duplex.empty());
  EXPECT_EQ(of_duplex.front().path, "pair.approach");
  EXPECT_EQ(of_duplex.front().unit, "um");
  EXPECT_GT(of_duplex.front().value, 1.0);
  EXPECT_EQ(of_duplex.back().path, "pair.inertia_y");
  EXPECT_EQ(of_duplex.back().unit, "kg.m2");
  const std::vector<Derived> rows = machine_quantities(read(pair));
  const auto value = [&](const std::string& path) {
    const auto found = std::ranges::find(rows, path, &Derived::path);
    return found == rows.end() ? std::pair(0.0, std::string("none")) : std::pair(found->value, found->unit);
  };
  EXPECT_NEAR(value("pair.centre_distance").first, 81.0, 1e-9);
  EXPECT_EQ(value("pair.centre_distance").second, "mm");
  EXPECT_NEAR(value("pair.working_pressure_angle").first, 20.0, 1e-9);
  EXPECT_NEAR(value("pair.second_gear.reference_diameter").first, 122.0, 1e-9);
  EXPECT_EQ(value("pair.mass.second").second, "kg");
  EXPECT_GT(value("pair.mass.second").first, value("pair.mass.first").first);
  EXPECT_EQ(value("pair.mesh_stiffness").second, "N/m");
}

}  // namespace
}  // namespace orbearing::app::machines_test
