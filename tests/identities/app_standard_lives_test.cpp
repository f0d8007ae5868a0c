// Lives by the standards of planet bearings, compared with numbers by hand and with the same bearing as a
// single one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/case/case_file.hpp"
#include "app/case/machine_of.hpp"
#include "app/case/static_case.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/life_peak.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/sweep_study.hpp"
#include "app/study/sweep_warnings.hpp"
#include "bearing/life/rating_lives.hpp"
#include "coupling/analysis/multi_stage.hpp"
#include "tests/identities/app_fields/field_bases.hpp"

namespace orbearing::app::app_standard_lives_test {
namespace {

using bearing::rating::RatedHours;
using bearing::rating::RatingLives;

ResolvedCase reducer(const std::vector<std::string>& settings) {
  return read_point(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml", settings);
}

analysis::PointResult point(const ResolvedCase& in,
                            analysis::Fidelity fidelity = analysis::Fidelity::quasi_static) {
  return analysis::evaluate(bearing_sets(in), fidelity);
}

// By hand, in N and mm: 15 rollers of 5.24 x 5.7 on 35.64: C0 = 44 (1 - gamma) Z l D = 16,815 N, C_u = C0/8.2
// = 2,051 N, C = 16,929 N; P = 2,781 N; kappa 5.5 counts as 4: e_C = 0.0432 4^0.68 35.64^0.55 (1 -
// 0.9987/35.64^(1/3)) = 0.551; a_ISO = 0.1 [1 - (1.5859 - 1.2348/4^0.071739)(0.551 * 2051/2781)^0.4]^-9.185
// = 3.77.
TEST(StandardLives, OfTheReducerByHand) {
  const analysis::PointResult at =
      point(reducer({"input.speed=12000 rpm", "lubricant.grade=ISO VG 220", "lubricant.temperature=80 degC",
                     "life.cleanliness=-/15/12"}));
  const RatingLives& lives = at.rating.lives;
  EXPECT_NEAR(lives.static_capacity, 16815.0, 1.0);
  EXPECT_NEAR(lives.fatigue_load_limit, 2051.0, 1.0);
  EXPECT_NEAR(lives.dynamic_load, 2781.0, 1.0);
  EXPECT_EQ(lives.dynamic_load, at.planet_load);
  EXPECT_EQ(lives.static_load, at.planet_load);
  EXPECT_NEAR(lives.oil->contamination_factor, 0.551, 5e-4);
  EXPECT_NEAR(lives.life_modification, 3.77, 5e-3);
  EXPECT_NEAR(at.rating.hours.basic, 500.0, 1.0);
  EXPECT_NEAR(at.rating.hours.modified, 1883.0, 0.005 * 1883.0);
  // The planet turns (37/22)(79/116) times the sun's speed against the carrier.
  const double relative_rpm = 12000.0 * 37.0 / 22.0 * 79.0 / 116.0;
  EXPECT_NEAR(at.rating.hours.basic, lives.basic / (60.0 * relative_rpm), 1e-9 * at.rating.hours.basic);
}

constexpr const char* kPlanet = R"(
name: of_a_planet
source: "a full complement of 16 rollers, 34 x 34 on 175 mm"
model: planetary-drivetrain
input: {member: sun, power: 100 kW, speed: 60 rpm}
gearset:
  fixed: ring
  planets: 3
  teeth: {sun: 26, planet: 31, ring: 88}
  module: 12 mm
  face_width: 200 mm
  profile_shift: {sun: 0.2, ring: 0.2}
bearing:
  type: cylindrical-roller
  complement: full
  per_planet: 1
  roller_diameter: 34 mm
  roller_length: 34 mm
  pitch_diameter: 175 mm
  radial_clearance: 0 um
  bore: 110 mm
  outside_diameter: 240 mm
  width: 50 mm
  laminae: 30
  profile: {kind: johns-gohar}
numerics: {cage_positions: 1}
life: {viscosity_ratio: 1, contamination_factor: 0.8}
inertia: {carrier_centrifugal: false, own_orbit: false, coriolis: false}
)";

constexpr const char* kSingle = R"(
name: single
source: "the same bearing"
model: roller-bearing
load: {radial: 67.5 kN}
bearing:
  type: cylindrical-roller
  complement: full
  roller_diameter: 34 mm
  roller_length: 34 mm
  pitch_diameter: 175 mm
  radial_clearance: 0 um
  laminae: 30
  profile: {kind: johns-gohar}
operation: {turning_race: outer}
life: {viscosity_ratio: 1, contamination_factor: 0.8}
)";

// The same bearing under the same load: as a planet's, and as a single one by its own loads.
TEST(StandardLives, OfAPlanetBearingAreThoseOfTheSingleOne) {
  const analysis::PointResult planet = point(parse_case(kPlanet, "planet.yaml", {}));
  const double load = planet.planet_load;
  const ResolvedCase in = parse_case(kSingle, "single.yaml", {"load.radial=" + std::to_string(load) + " N"});
  const auto inputs = machine_of<analysis::RollersUnderLoad>(in);
  const analysis::BearingUnderLoad study = rollers_under_load(inputs);
  const RatingLives single = bearing::rating::rating_lives(
      bearing::rating::bearing_rating(rotating_bearing(inputs.loaded), stated_ratings(inputs)),
      {.dynamic_load = load, .static_load = load, .oil = bearing::rating::OilCondition{1.0, 0.8}},
      {study.state.contact_load, study.state.lamina_load},
      {study.state.contact_load, study.state.lamina_load});
  const RatingLives& lives = planet.rating.lives;
  for (const auto member :
       {&RatingLives::dynamic_capacity, &RatingLives::static_capacity, &RatingLives::fatigue_load_limit,
        &RatingLives::dynamic_load, &RatingLives::static_load, &RatingLives::life_modification,
        &RatingLives::basic, &RatingLives::modified})
    EXPECT_NEAR(lives.*member / single.*member, 1.0, 1e-9);
  // ISO 281 by hand: C0 = 44 (1 - 34/175) 16 34^2 = 655,710 N, C_u = C0/8.2 (100/175)^0.3 = 67,606 N.
  EXPECT_NEAR(lives.static_capacity, 655710.0, 1.0);
  EXPECT_NEAR(lives.fatigue_load_limit, 67606.0, 5.0);
  EXPECT_NEAR(lives.life_modification, 3.51, 0.005);
  // The planet's load is a little off the line through its rollers: their positions count.
  constexpr double positions = 5e-3;
  EXPECT_NEAR(lives.reference.bearing / single.reference.bearing, 1.0, positions);
  EXPECT_NEAR(lives.modified_reference.bearing / single.modified_reference.bearing, 1.0, 2.0 * positions);
  EXPECT_NEAR(lives.reference_modification / single.reference_modification, 1.0, positions);
}

// Whole contacts are straight level rollers: laminae of such give the same lives, thirty of them L10r too.
TEST(StandardLives, OfWholeContactsAreThoseOfThirtyLaminae) {
  const std::vector<std::string> oil{"lubricant.grade=ISO VG 220", "lubricant.temperature=80 degC"};
  std::vector<std::string> cut = oil;
  cut.insert(cut.end(), {"bearing.laminae=30", "bearing.profile.kind=straight"});
  const analysis::PointResult whole = point(reducer(oil)), laminae = point(reducer(cut));
  for (const auto life : bearing::rating::kRatedHours)
    EXPECT_NEAR(laminae.rating.hours.*life / whole.rating.hours.*life, 1.0, 1e-6);
}

// All lives are of one bearing of eight equal ones.
TEST(StandardLives, OfEightBearingsByTheProductLaw) {
  const analysis::PointResult at = point(reducer({}));
  for (const auto life : {&RatedHours::basic, &RatedHours::reference})
    EXPECT_NEAR(at.rating.system_hours.*life, at.rating.hours.*life * std::pow(8.0, -8.0 / 9.0),
                1e-9 * at.rating.hours.*life);
}

// One planet carries more: each planet has a load and lives of its own, and the system all of them.
TEST(StandardLives, OfPlanetsThatLoadUnevenly) {
  const analysis::PointResult at =
      point(reducer({"gearset.dynamics.pin_error.tangential=[10 um, 0 um, 0 um, 0 um]"}));
  ASSERT_EQ(at.planets.size(), 4u);
  double damage = 0.0, mean_power = 0.0, largest = 0.0;
  for (const analysis::PlanetResult& planet : at.planets) {
    // P of each from its L10: C (L10 in Mrev)^(-3/10).
    const double ratio = planet.rated_hours.basic / at.rating.hours.basic;
    const double load = at.rating.lives.dynamic_load * std::pow(ratio, -0.3);
    mean_power += std::pow(load, 10.0 / 3.0) / 4.0;
    largest = std::max(largest, load);
    damage += 2.0 * std::pow(planet.rated_hours.basic, -9.0 / 8.0);
    EXPECT_NEAR(load / planet.load, 1.0,
                0.02);  // the rollers' load and what reaches the bore through the cage
  }
  EXPECT_NEAR(at.rating.lives.dynamic_load / std::pow(mean_power, 0.3), 1.0, 1e-10);
  EXPECT_NEAR(at.rating.lives.static_load / largest, 1.0, 1e-10);
  EXPECT_GT(at.rating.lives.static_load, 1.05 * at.planet_load);
  EXPECT_NEAR(at.rating.system_hours.basic, std::pow(damage, -8.0 / 9.0),
              1e-9 * at.rating.system_hours.basic);
}

// Two bearings of a planet whose tilt is computed, one with more clearance: each is rated by its own share.
TEST(StandardLives, OfBearingsThatShareAPlanetUnevenly) {
  const analysis::PointResult at =
      point(reducer({"bearing.laminae=30", "bearing.profile.kind=straight", "bearing.tilt_state=computed",
                     "bearing.clearance_differences=[0 um, 10 um]"}));
  ASSERT_EQ(at.seats.size(), 2u);
  EXPECT_GT(at.seats[0].load, 1.05 * at.seats[1].load);
  for (const auto life : {&RatedHours::basic, &RatedHours::reference}) {
    const double damage = 4.0 * (std::pow(at.seats[0].rated_hours.*life, -9.0 / 8.0) +
                                 std::pow(at.seats[1].rated_hours.*life, -9.0 / 8.0));
    EXPECT_NEAR(at.rating.system_hours.*life / std::pow(damage, -8.0 / 9.0), 1.0, 1e-10);
  }
  double power = 0.0;
  for (const analysis::SeatResult& seat : at.seats) {
    const double load = seat.load;
    const double by_hand = at.rating.hours.basic * std::pow(at.rating.lives.dynamic_load / load, 10.0 / 3.0);
    EXPECT_NEAR(seat.rated_hours.basic / by_hand, 1.0, 1e-9);
    power += 0.5 * std::pow(load, 10.0 / 3.0);
  }
  EXPECT_NEAR(at.rating.lives.dynamic_load / std::pow(power, 0.3), 1.0, 1e-10);
  EXPECT_NEAR(at.rating.lives.static_load / at.seats[0].load, 1.0, 1e-12);
  // Forces that lean to both sides: together somewhat more than what they hold.
  EXPECT_NEAR(0.5 * (at.seats[0].load + at.seats[1].load) / at.planet_load, 1.0, 0.02);
}

// At every fidelity of motion ISO 281 uses the mean load, and the reference life the means of powers that the
// life of Lundberg and Palmgren uses. Both have capacities of the races in the ratio ((1 - gamma)/(1 +
// gamma))^(143/108), to the four digits of the standard's constants: for whole contacts the lives have one
// ratio, quasi-static and in motion.
TEST(StandardLives, OfEveryRungOfMotion) {
  const auto small = [](const std::vector<std::string>& settings) {
    return parse_case(fields_test::bases().front().text, "small.yaml", settings);
  };
  const ResolvedCase in = small({"lubricant.grade=ISO VG 220"});
  const analysis::PointResult rest = point(in);
  for (const analysis::Fidelity fidelity :
       {analysis::Fidelity::dynamic, analysis::Fidelity::co_simulated, analysis::Fidelity::monolithic}) {
    const analysis::PointResult moving = point(in, fidelity);
    const int rung = static_cast<int>(fidelity);
    constexpr double unlike_planets = 1e-2;  // of a run of a few passages
    EXPECT_NEAR(moving.rating.hours.basic / rest.rating.hours.basic, 1.0, unlike_planets) << rung;
    EXPECT_NEAR(moving.rating.hours.modified / rest.rating.hours.modified, 1.0, 3.0 * unlike_planets) << rung;
    EXPECT_NEAR(
        (moving.rating.hours.reference / rest.rating.hours.reference) / (moving.life_hours / rest.life_hours),
        1.0, 5e-2)
        << rung;
    EXPECT_NEAR(moving.rating.hours.modified_reference,
                moving.rating.lives.reference_modification * moving.rating.hours.reference,
                1e-9 * moving.rating.hours.modified_reference)
        << rung;
    EXPECT_LT(moving.rating.system_hours.reference, moving.rating.hours.reference) << rung;
  }
}

// Stated ratings take the place of those of the standards: L10 by C and P of a published gearbox.
TEST(StandardLives, WithTheMakersRatings) {
  const analysis::PointResult plain = point(reducer({}));
  const analysis::PointResult stated =
      point(reducer({"bearing.dynamic_capacity=20 kN", "bearing.static_capacity=30 kN",
                     "bearing.fatigue_load_limit=4 kN"}));
  EXPECT_EQ(stated.rating.lives.dynamic_capacity, 20e3);
  EXPECT_EQ(stated.rating.lives.static_capacity, 30e3);
  EXPECT_EQ(stated.rating.lives.fatigue_load_limit, 4e3);
  EXPECT_NEAR(stated.rating.hours.basic / plain.rating.hours.basic,
              std::pow(20e3 / plain.rating.lives.dynamic_capacity, 10.0 / 3.0), 1e-9);
  // Capacities of contacts follow from C: the reference life is proportional to its fourth power.
  EXPECT_NEAR(stated.rating.hours.reference / plain.rating.hours.reference,
              std::pow(20e3 / plain.rating.lives.dynamic_capacity, 4.0), 1e-8);
  EXPECT_EQ(stated.life_hours, plain.life_hours);  // Lundberg and Palmgren's own capacities
  const analysis::PointResult half = point(reducer({"bearing.static_capacity=8.2 kN"}));
  EXPECT_NEAR(half.rating.lives.fatigue_load_limit, 1e3, 1e-9);  // C0/8.2
}

TEST(StandardLives, TheLifeToGoByIsChosen) {
  const std::string oil = "lubricant.grade=ISO VG 220";
  const auto at = [](std::vector<std::string> settings, const char* method) {
    settings.push_back(std::string("life.method=") + method);
    return reducer(settings);
  };
  EXPECT_EQ(governing_life_key(reducer({})), "life_h");
  EXPECT_EQ(governing_life_key(at({}, "iso-281")), "L10h");
  EXPECT_EQ(governing_life_key(at({}, "iso-16281")), "L10rh");
  EXPECT_EQ(governing_life_key(at({oil}, "lundberg-palmgren")), "life_h");
  EXPECT_EQ(governing_life_key(at({oil}, "iso-281")), "L10mh");
  EXPECT_EQ(governing_life_key(at({oil}, "iso-16281")), "L10mrh");
  for (const char* method : {"lundberg-palmgren", "iso-281", "iso-16281"})
    for (const std::vector<std::string>& settings : {std::vector<std::string>{}, {oil}}) {
      const ResolvedCase in = at(settings, method);
      const analysis::PointResult one = point(in);
      const ManifestHeader header = sweep_request(in, "quasi-static").header;
      EXPECT_EQ(in_table_unit(analysis::governing_hours(one), 1.0),
                governing_hours(header, sweep_row(one, header).point))
          << method;
    }
}

// The peak is that of the chosen life: by ISO 281 with its own oil it is at another speed.
TEST(StandardLives, PeaksGoByTheLifeChosen) {
  const std::vector<std::string> common{"lubricant.grade=ISO VG 220", "lubricant.temperature=80 degC",
                                        "sweep.input.speed={from: 4000 rpm, to: 9000 rpm, step: 1000 rpm}"};
  for (const char* method : {"lundberg-palmgren", "iso-281", "iso-16281"}) {
    std::vector<std::string> settings = common;
    settings.push_back(std::string("life.method=") + method);
    const ResolvedCase in = read_case(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml", settings);
    SweepRequest request = sweep_request(in, "quasi-static");
    request.quiet = true;
    refine_peak_of(in, request);
    const SweepOutcome outcome = run_sweep(request);
    const LifePeak peak = find_peak(outcome).peak;
    EXPECT_EQ(peak.life, governing_life_key(in));
    double longest = 0.0, speed = 0.0;
    for (const SweepRow& row : outcome.rows) {
      const double life = number_named(outcome.header, row, peak.life);
      if (life <= longest) continue;
      longest = life;
      speed = speed_in_rpm(row.point.input_speed);
    }
    EXPECT_EQ(peak.refined_life_h, longest) << method;
    EXPECT_EQ(peak.refined_speed_rpm, speed) << method;
  }
}

// Straight rollers on fewer laminae than the standard allows: refused where its life governs, elsewhere the
// two lives are left out.
TEST(StandardLives, TooFewLaminaeOfStraightRollers) {
  const auto warnings = [](const std::vector<std::string>& settings) {
    const ResolvedCase in = reducer(settings);
    SweepRequest request = sweep_request(in, "quasi-static");
    request.quiet = true;
    const SweepOutcome outcome = run_sweep(request);
    return sweep_warnings(in, outcome, find_peak(outcome));
  };
  EXPECT_THROW(reducer({"bearing.laminae=20", "life.method=iso-16281"}), BadInput);
  EXPECT_NO_THROW(reducer({"bearing.laminae=20", "life.method=iso-16281", "bearing.profile.kind=iso16281"}));
  const std::string text =
      "bearing.laminae: 20 laminae of straight rollers; L10rh and L10mrh are left out, for which ISO/TS "
      "16281 "
      "requires at least 30";
  EXPECT_THAT(warnings({"bearing.laminae=20"}), testing::Contains(text));
  EXPECT_TRUE(std::isnan(point(reducer({"bearing.laminae=20"})).rating.hours.reference));
  EXPECT_THAT(warnings({"bearing.laminae=30"}),
              Not(testing::Contains(testing::HasSubstr("ISO/TS 16281 requires"))));
}

// A requirement or a known C brings the standard's life; a stated method stays.
TEST(StandardLives, TheGoverningLifeWithoutAStatedMethod) {
  EXPECT_EQ(governing_life_key(reducer({"bearing.dynamic_capacity=20 kN"})), "L10rh");
  EXPECT_EQ(governing_life_key(reducer({"requirements.S0=2"})), "L10rh");
  EXPECT_EQ(governing_life_key(reducer({"requirements.S0=2", "lubricant.grade=ISO VG 220"})), "L10mrh");
  EXPECT_EQ(governing_life_key(reducer({"requirements.S0=2", "life.method=lundberg-palmgren"})), "life_h");
  const ResolvedCase required = reducer({"requirements.life=1000 h", "life.method=iso-281"});
  EXPECT_EQ(required.choice("requirements.life_key"), "L10h");
  EXPECT_THAT(rating_warnings(required), testing::IsEmpty());
  EXPECT_THAT(
      rating_warnings(reducer({"requirements.life=1000 h", "requirements.life_key=life_h"})),
      testing::ElementsAre("requirements.life_key: life_h is judged; the governing life of this case is "
                           "L10rh (life.method: iso-16281)"));
}

}  // namespace
}  // namespace orbearing::app::app_standard_lives_test
