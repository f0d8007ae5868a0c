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
#include "coupling/analysis/single_bearing.hpp"

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
  EXPECT_EQ(std::get<analysis::EllipseOfContact>(machine_of<analysis::SpinFilm>(read(film)).contact.shape)
                .ellipticity,
            3.0);
  std::string line = film;
  line.replace(line.find("ellipticity: 3"), 14, "length: 7 mm");
  const std::vector<std::string> solved{"film.solver=reynolds", "points=[[100 N, 2 m/s, 0 rad/s]]"};
  EXPECT_DOUBLE_EQ(
      std::get<analysis::LineOfContact>(machine_of<analysis::SpinFilm>(read(line, solved)).contact.shape)
          .length,
      7e-3);
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

const std::string rollers = R"(name: rollers
model: roller-bearing
load: {radial: 3 kN}
operation: {shaft_speed: 3000 rpm, turning_race: outer}
bearing:
  type: cylindrical-roller
  rollers: 12
  roller_diameter: 10 mm
  roller_length: 12 mm
  pitch_diameter: 60 mm
  radial_clearance: 5 um
)";

TEST(MachineOf, HasWhatACaseStatesBySeveralInputs) {
  const auto plain = machine_of<analysis::RollersUnderLoad>(read(rollers));
  EXPECT_EQ(plain.loaded.rotation.turning_race, bearing::Race::outer);
  EXPECT_EQ(plain.loaded.bearing.rollers().laminae, analysis::default_laminae);
  EXPECT_EQ(plain.loaded.profile.kind, bearing::profile::Kind::iso16281);
  EXPECT_FALSE(plain.loaded.oil.stated.grade || plain.loaded.size || plain.loaded.life.cleanliness);
  const auto stated = machine_of<analysis::RollersUnderLoad>(
      read(rollers, {"bearing.profile.kind=straight", "bearing.laminae=12", "lubricant.grade=ISO VG 68",
                     "lubricant.temperature=60 degC", "life.cleanliness=-/17/14", "bearing.bore=40 mm",
                     "bearing.outside_diameter=80 mm", "bearing.width=18 mm"}));
  EXPECT_EQ(stated.loaded.bearing.rollers().laminae, 12);
  EXPECT_EQ(stated.loaded.profile.kind, bearing::profile::Kind::straight);
  ASSERT_TRUE(stated.loaded.oil.kinematic_viscosity && stated.loaded.size);
  EXPECT_EQ(stated.loaded.oil.stated.grade, bearing::ViscosityGrade::vg68);
  EXPECT_EQ(stated.loaded.oil.stated.temperature, 60.0);
  EXPECT_EQ(stated.loaded.life.cleanliness, bearing::rating::Cleanliness::medium);
  EXPECT_DOUBLE_EQ(stated.loaded.size->outside, 80e-3);
}

TEST(MachineOf, LeavesOutTheCageOfAFullComplement) {
  const std::vector<std::string> cage{"bearing.cage.inner_diameter=57 mm",
                                      "bearing.cage.outer_diameter=63 mm", "bearing.cage.width=14 mm",
                                      "bearing.cage.density=7850 kg/m3"};
  std::vector<std::string> full = cage;
  full.insert(full.end(), {"bearing.complement=full", "bearing.rollers=18"});
  EXPECT_GT(machine_of<analysis::RollerBearing>(read(rollers, cage)).motion.cage.width, 0.0);
  EXPECT_EQ(machine_of<analysis::RollerBearing>(read(rollers, full)).motion.cage.width, 0.0);
}

TEST(Alternatives, AnInputOfAnotherOneIsRefused) {
  EXPECT_THAT(
      refusal_of(duplex, {"spindle.inertia_x=0.2 kg.m2", "spindle.inertia_y=0.3 kg.m2"}),
      HasSubstr("spindle.inertia_x: '0.2 kg.m2' together with spindle.diameter or spindle.density; one of "
                "both is required"));
  EXPECT_THAT(
      refusal_of(pair, {"pair.kind=internal", "pair.driven_bore=31 mm"}),
      HasSubstr("pair.driven_bore: an input of pair.kind: external, and here it is internal; a case without "
                "it, or pair.kind: external, is required"));
  EXPECT_THAT(refusal_of(pair + "  ring_outside_ratio: 1.2\n"),
              AllOf(HasSubstr("case.yaml:8:23"), HasSubstr("an input of pair.kind: internal")));
  EXPECT_THAT(refusal_of(film, {"contact.length=3 mm"}), HasSubstr("together with contact."));
}

TEST(Alternatives, OneOfThemIsRequired) {
  EXPECT_THAT(refusal_of(duplex, {"spindle.diameter=null"}),
              AllOf(HasSubstr("spindle.diameter: missing"),
                    HasSubstr("or spindle.inertia_x or spindle.inertia_y instead")));
  EXPECT_THAT(refusal_of(duplex, {"housing.mass=3 kg"}),
              AllOf(HasSubstr("housing.inertia: missing"), Not(HasSubstr("instead"))));
  std::string neither = film;
  neither.erase(neither.find("  ellipticity: 3\n"), 17);
  EXPECT_THAT(refusal_of(neither),
              AllOf(HasSubstr("contact.ellipticity: missing"), HasSubstr("or contact.length instead")));
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
  EXPECT_THAT(refusal_of(pair, {"pair.teeth=[20, 61, 30]"}),
              HasSubstr("pair.teeth: a list of 3; 2 values are required"));
}

// Rows that other models share name a model only where its machine has them.
TEST(Machines, HoldAllInputsOfTheirModels) {
  Machines::each([]<class Row>(Row, std::size_t) {
    for (const Field* field : fields_of(Row::model))
      EXPECT_TRUE(std::ranges::count(field->of_machines, Row::model, &std::pair<Model, Use>::first) == 1)
          << field->path << " of " << model_name(Row::model);
  });
}

TEST(Machines, AreReadAgainAsTheyWereWritten) {
  for (const std::string& text : {pair, film, duplex}) {
    const ResolvedCase in = read(text);
    EXPECT_EQ(write_resolved(parse_case(write_resolved(in), "again.yaml", {})), write_resolved(in));
  }
}

// The type of its parameter determines the inputs of an analysis: a mesh has no mass.
TEST(MachineAnalyses, UseWhatTheirParameterHolds) {
  const MachineAnalysis* mesh = machine_analysis(gear_pair, "mesh");
  ASSERT_NE(mesh, nullptr);
  EXPECT_THAT(paths_of<analysis::ElasticPair>(),
              AllOf(Contains("pair.bore"), Contains("pair.driven_bore"), Contains("pair.kind"),
                    Contains("material.poisson_ratio"), Not(Contains("material.density"))));
  EXPECT_THAT(require_used(read(pair, {"material.density=7000 kg/m3"}), mesh->used),
              Contains(HasSubstr("material.density: 7000 kg/m3 has no effect on mesh")));
  EXPECT_THAT(require_used(read(pair, {"pair.driven_bore=31 mm"}), mesh->used), IsEmpty());
  EXPECT_EQ(machine_analysis(gear_pair, "run"), nullptr);
}

// The type of one analysis holds more than that of the other, and some inputs depend on others.
TEST(MachineAnalyses, UseSomeInputsUnderAConditionOnOthers) {
  const AnalysisId modes = machine_analysis(duplex_pair, "modes")->used,
                   run = machine_analysis(duplex_pair, "run")->used;
  const auto warnings_of = [](const std::vector<std::string>& settings, AnalysisId analysis) {
    return require_used(read(duplex, settings), analysis);
  };
  const std::vector<std::string> loss{"response.loss_factor=0.01"};
  EXPECT_THAT(warnings_of(loss, modes), Contains(HasSubstr("used by run of a duplex pair")));
  EXPECT_THAT(warnings_of(loss, run), IsEmpty());
  EXPECT_THAT(require_used(read(duplex + "response: {loss_factor: 0.01}\n"), modes), IsEmpty());
  const std::vector<std::string> linear{"linear.mass=9 kg"},
      back{"linear.mass=9 kg", "arrangement=back-to-back"};
  EXPECT_THAT(warnings_of(linear, run), IsEmpty());
  EXPECT_THAT(warnings_of(back, run),
              Contains("linear.mass: 9 kg has no effect: it counts only where arrangement is face-to-face or "
                       "tandem, and operation.shaft_speed is 0"));
  const std::string density = "material.density=7000 kg/m3", rotating = "operation.shaft_speed=900 rpm",
                    massless = "equilibrium.ball_inertia=false";
  EXPECT_THAT(warnings_of({density}, run),
              Contains(HasSubstr("it counts only together with operation.shaft_speed")));
  EXPECT_THAT(warnings_of({density, rotating}, run), IsEmpty());
  EXPECT_THAT(warnings_of({density, rotating, massless}, run), Contains(HasSubstr("material.density")));
  EXPECT_THAT(warnings_of({rotating, massless}, run), IsEmpty());  // hours of life follow from the speed
  EXPECT_THAT(warnings_of({rotating, massless}, modes),
              Contains(HasSubstr("operation.shaft_speed: 900 rpm has no effect on modes of a duplex pair")));
}

AnalysisId used_by(Model model, const char* command) {
  return machine_analysis(model, command)->used;
}

// The stiffness of a bearing takes what is between its rings.
TEST(MachineAnalyses, TakeAPartOfABearing) {
  EXPECT_THAT(paths_of<analysis::RollerSupport>(),
              AllOf(Contains("bearing.profile.kind"), Contains("bearing.laminae"),
                    Not(Contains("bearing.bore")), Not(Contains("bearing.cage.width")),
                    Not(Contains("material.density")), Not(Contains("operation.shaft_speed"))));
  EXPECT_THAT(paths_of<analysis::BallSupport>(),
              AllOf(Contains("material.density"), Contains("operation.outer_speed"),
                    Not(Contains("operation.turning_race")), Not(Contains("lubricant.kinematic_viscosity"))));
  EXPECT_THAT(paths_of<analysis::BallsInTime>(),
              AllOf(Contains("bearing.cage.width"), Contains("bearing.bore"), Contains("heat.inlet")));
}

// Inputs of profile and oil have the uses of the member that they state.
TEST(MachineAnalyses, UseInputsByTheMemberThatTheyState) {
  const AnalysisId run = used_by(roller_bearing, "run"), stiffness = used_by(roller_bearing, "stiffness");
  const std::vector<std::string> crown{"bearing.profile.kind=circular", "bearing.profile.drop=5 um"};
  EXPECT_THAT(require_used(read(rollers, crown), run), IsEmpty());
  EXPECT_THAT(require_used(read(rollers, crown), stiffness), IsEmpty());
  EXPECT_THAT(require_used(read(rollers, {"bearing.profile.chamfer_length=1 mm"}), run),
              Contains(HasSubstr("it counts only where bearing.profile.kind is chamfer")));
  const std::vector<std::string> oil{"lubricant.grade=ISO VG 68", "life.cleanliness=high"};
  EXPECT_THAT(require_used(read(rollers, oil), run), IsEmpty());
  EXPECT_THAT(require_used(read(rollers, oil), stiffness),
              Contains(HasSubstr("lubricant.grade: ISO VG 68 has no effect on stiffness")));
}

// Friction by a stated oil takes a grade beside a stated kappa.
TEST(MachineAnalyses, UseAnOilForFriction) {
  const AnalysisId run = used_by(roller_bearing, "run");
  const std::vector<std::string> kappa{"lubricant.grade=ISO VG 68", "life.viscosity_ratio=2",
                                       "life.contamination_factor=0.4"};
  std::vector<std::string> at_rest = kappa;
  at_rest.emplace_back("operation.shaft_speed=0 rpm");
  EXPECT_THAT(require_used(read(rollers, kappa), run), IsEmpty());
  EXPECT_THAT(require_used(read(rollers, at_rest), run), Contains(HasSubstr("lubricant.grade")));
  // Data that belong to other conditions are no mistake of a file.
  EXPECT_THAT(require_used(read(rollers + "  bore: 40 mm\n  width: 18 mm\n"), run), IsEmpty());
}

const std::string balls_in_time = R"(name: balls
model: ball-bearing
load: {radial: 400 N}
operation: {shaft_speed: 6000 rpm}
bearing:
  balls: 9
  ball_diameter: 7 mm
  pitch_diameter: 36 mm
  radial_clearance: 5 um
  bore: 25 mm
  width: 12 mm
  cage: {inner_diameter: 33.44 mm, outer_diameter: 38.54 mm, width: 9 mm, density: 1310 kg/m3}
simulation: {duration: 0.01 s}
)";

TEST(MachineAnalyses, RefuseWhatTheyCannotInclude) {
  const AnalysisId run = used_by(ball_motion, "run");
  EXPECT_THAT(require_used(read(balls_in_time), run), IsEmpty());
  EXPECT_THROW(require_used(read(balls_in_time, {"load.tilt=1 mrad"}), run), BadInput);
  EXPECT_THAT(
      require_used(read(balls_in_time, {"traction.law=ree-eyring", "traction.sliding_scale=0.2 m/s"}), run),
      IsEmpty());  // of the cage's friction
  EXPECT_THAT(require_used(read(balls_in_time,
                                {"traction.law=ree-eyring", "traction.sliding_scale=0.2 m/s",
                                 "bearing.cage.pocket_friction=0", "bearing.cage.guide_land_diameter=0 mm"}),
                           run),
              Contains(HasSubstr("traction.sliding_scale")));
}

TEST(Machines, AreCheckedByParts) {
  const std::string of_oil = "lubricant.kinematic_viscosity: a viscosity without cleanliness";
  EXPECT_THAT(refusal_of(rollers, {"lubricant.kinematic_viscosity=20 mm2/s", "bearing.rollers=null"}),
              AllOf(HasSubstr("bearing.rollers: missing"), HasSubstr(of_oil)));
  EXPECT_THAT(refusal_of(rollers, {"load.moment=2 N.m", "load.tilt=1 mrad"}),
              HasSubstr("load.tilt: a tilt together with"));
  EXPECT_THAT(
      refusal_of(rollers, {"bearing.laminae=1", "load.moment=2 N.m"}),
      HasSubstr("bearing.laminae: a single lamina, which holds no moment; at least 2 laminae are required"));
  EXPECT_THAT(refusal_of(rollers, {"lubricant.viscosity_40=68 mm2/s", "operation.shaft_speed=0 rpm"}),
              HasSubstr("lubricant.viscosity_40: a viscosity for rings that do not rotate"));
  EXPECT_THAT(refusal_of(balls_in_time, {"load.radial=0 N"}), HasSubstr("load.radial: no load"));
}

TEST(MachineAnalyses, FailuresNameTheCase) {
  const MachineAnalysis* modes = machine_analysis(duplex_pair, "modes");
  try {
    modes->compute(read(duplex, {"arrangement=tandem", "operation.shaft_speed=900000 rpm"}), {});
    FAIL() << "an equilibrium at any speed";
  } catch (const ComputationFailed& failure) {
    EXPECT_THAT(failure.what(), testing::StartsWith("duplex: "));
  }
}

TEST(MachineQuantities, AreListedInTheirUnits) {
  const std::vector<Derived> of_duplex = machine_quantities(read(duplex)).rows;
  ASSERT_FALSE(of_duplex.empty());
  EXPECT_EQ(of_duplex.front().path, "pair.approach");
  EXPECT_EQ(of_duplex.front().unit, "um");
  EXPECT_GT(of_duplex.front().value, 1.0);
  EXPECT_EQ(of_duplex.back().path, "pair.inertia_y");
  EXPECT_EQ(of_duplex.back().unit, "kg.m2");
  const std::vector<Derived> rows = machine_quantities(read(pair)).rows;
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
