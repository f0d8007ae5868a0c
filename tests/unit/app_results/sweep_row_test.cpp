#include "app/results/sweep_row.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app::sweep_row_test {
namespace {

// The contract that scripts rely on, to the letter.
const std::vector<std::string> promised = {"input_speed_rpm",
                                           "carrier_speed_rpm",
                                           "planet_load_N",
                                           "tangential_load_N",
                                           "centrifugal_load_N",
                                           "inner_load_max_N",
                                           "inner_load_rms_N",
                                           "outer_load_max_N",
                                           "outer_load_rms_N",
                                           "inner_life_Mrev",
                                           "outer_life_Mrev",
                                           "life_h",
                                           "system_life_h",
                                           "cage_slip",
                                           "film_inner_um",
                                           "film_outer_um",
                                           "status",
                                           "radial_mesh_load_N",
                                           "axial_mesh_force_N",
                                           "overturning_moment_N_m",
                                           "sun_thrust_N",
                                           "contact_pressure_max_MPa",
                                           "operating_clearance_um",
                                           "rim_over_module",
                                           "rim_ovality_um",
                                           "life_Mrev",
                                           "L10h",
                                           "L10rh",
                                           "L10mh",
                                           "L10mrh",
                                           "system_L10h",
                                           "system_L10rh",
                                           "system_L10mh",
                                           "system_L10mrh",
                                           "L10_Mrev",
                                           "L10r_Mrev",
                                           "L10m_Mrev",
                                           "L10mr_Mrev",
                                           "inner_L10m_Mrev",
                                           "outer_L10m_Mrev",
                                           "C_N",
                                           "C0_N",
                                           "Cu_N",
                                           "P_N",
                                           "P0_N",
                                           "C_over_P",
                                           "S0",
                                           "kappa",
                                           "e_C",
                                           "a_ISO",
                                           "a_ISO_r",
                                           "static_safety",
                                           "roller_slip",
                                           "orbit_slip",
                                           "drag_over_traction",
                                           "drag_slip",
                                           "friction_moment_N_m",
                                           "vibration_power_W",
                                           "power_loss_W",
                                           "power_loss_race_damping_W",
                                           "power_loss_inner_traction_W",
                                           "power_loss_outer_traction_W",
                                           "power_loss_rolling_W",
                                           "power_loss_drag_W",
                                           "power_loss_pockets_W",
                                           "power_loss_guidance_W",
                                           "power_loss_neighbours_W",
                                           "power_loss_support_W",
                                           "steady",
                                           "shortest_life_h",
                                           "shortest_L10h",
                                           "shortest_L10rh",
                                           "shortest_L10mh",
                                           "shortest_L10mrh",
                                           "shortest_life_planet",
                                           "largest_load_share",
                                           "largest_bearing_tilt_mrad",
                                           "largest_bearing_share",
                                           "interface_energy_residual",
                                           "interface_window_us",
                                           "one_way_runs",
                                           "one_way_accepted",
                                           "one_way_residual",
                                           "one_way_stiffness_change",
                                           "one_way_damping_change",
                                           "one_way_load_difference",
                                           "one_way_stiffness_xx_N_per_m",
                                           "one_way_stiffness_xy_N_per_m",
                                           "one_way_stiffness_yx_N_per_m",
                                           "one_way_stiffness_yy_N_per_m",
                                           "one_way_damping_xx_N_s_per_m",
                                           "one_way_damping_xy_N_s_per_m",
                                           "one_way_damping_yx_N_s_per_m",
                                           "one_way_damping_yy_N_s_per_m",
                                           "one_way_force_x_N",
                                           "one_way_force_y_N",
                                           "carrier_load_share",
                                           "carrier_K_gamma",
                                           "carrier_K_Hbeta_sun",
                                           "carrier_K_Hbeta_ring",
                                           "carrier_back_flank_load_N",
                                           "carrier_life_h",
                                           "carrier_L10h",
                                           "carrier_L10rh",
                                           "carrier_L10mh",
                                           "carrier_L10mrh",
                                           "carrier_P0_N",
                                           "carrier_S0",
                                           "carrier_contact_pressure_max_MPa",
                                           "refined"};

analysis::PointResult at_6000_rpm() {
  analysis::PointResult result = fake_sweep::fake_result(0);
  result.input_speed = 6000.0 * std::numbers::pi / 30.0;
  return result;
}

std::uint64_t bits_of(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

std::vector<std::string> names_of(const ManifestHeader& header) {
  const Record record = record_of(header, row_of_numbers({}, header));
  return described::each(record.entries(), &described::Entry::name);
}

// Cells after the status of a failed point: empty ones, and that it was not added.
std::string cells_after_status() {
  const auto status = std::ranges::find(promised, "status");
  return std::string(static_cast<std::size_t>(promised.end() - status) - 1, ',') + "false";
}

const ManifestHeader kWithAxis{.axes = {{"axis", "1", ""}}};

TEST(SweepRow, ColumnsStandInThePromisedOrderAndAxesFollow) {
  EXPECT_EQ(names_of({}), promised);
  EXPECT_EQ(names_of(kWithAxis).back(), "axis");
}

TEST(SweepRow, SpeedsInRpmAreThoseOfTheCaseFile) {
  for (int step = 1; step <= 12000; ++step) {
    const double rpm = step;
    EXPECT_EQ(in_table_unit(rpm * std::numbers::pi / 30.0, 30.0 / std::numbers::pi), rpm);
  }
}

TEST(SweepRow, EveryNumberStandsUnderItsNameInItsUnit) {
  analysis::PointResult result;
  result.carrier_speed = 2.0 * std::numbers::pi / 60.0;
  result.planet_load = 2.0;
  result.tangential_load = 3.0;
  result.centrifugal_load = 4.0;
  result.radial_mesh_load = 5.0;
  result.axial_mesh_force = 72.0;
  result.overturning_moment = 73.0;
  result.sun_thrust = 74.0;
  result.inner = {6.0, 7.0, 8e6, 9e-6};
  result.outer = {10.0, 11.0, 12e6, 13e-6};
  result.life_hours = 14.0;
  result.system_life_hours = 15.0;
  result.cage_slip = 16.0;
  result.contact_pressure = 20e6;
  result.radial_clearance = 67e-6;
  result.rim_over_module = 68.0;
  result.distribution.race_form = {-1e-6, 2.5e-6, 0.0};
  result.life = 102e6;
  result.rating = {.lives = {.dynamic_capacity = 160.0,
                             .static_capacity = 243.0,
                             .fatigue_load_limit = 82.0,
                             .dynamic_load = 80.0,
                             .static_load = 81.0,
                             .oil = bearing::rating::OilCondition{60.0, 61.0},
                             .life_modification = 62.0,
                             .reference_modification = 62.5,
                             .basic = 90e6,
                             .reference = {1e6, 2e6, 91e6},
                             .modified = 92e6,
                             .modified_reference = {65e6, 66e6, 93e6}},
                   .hours = {94.0, 95.0, 96.0, 97.0},
                   .system_hours = {98.0, 99.0, 100.0, 101.0}};
  analysis::DynamicRecord& motion = result.dynamic.emplace();
  motion.steady = true;
  motion.roller_slip = 18.0;
  motion.orbit_slip = 75.0;
  motion.friction_moment = 19.0;
  motion.vibration_power = 78.0;
  motion.loss = {.race_damping = 1.0,
                 .inner_traction = 2.0,
                 .outer_traction = 4.0,
                 .rolling = 8.0,
                 .drag = 16.0,
                 .pockets = 32.0,
                 .neighbours = 256.0,
                 .guidance = 64.0,
                 .support = 128.0};
  result.dynamic->drag_over_traction = 77.0;
  result.dynamic->drag_slip = 76.0;
  result.dynamic->one_way_load_difference = 43.5;
  analysis::OneWayRecord fit{.fitted = {.residual = 41.0, .stiffness_change = 42.0, .damping_change = 43.0},
                             .runs = 40,
                             .load_difference = 43.5,
                             .accepted = true};
  fit.fitted.bearing.stiffness << 44.0, 45.0, 46.0, 47.0;
  fit.fitted.bearing.damping << 48.0, 49.0, 50.0, 51.0;
  fit.fitted.bearing.force << 52.0, 53.0;
  result.dynamic->one_way = fit;
  result.coupled = {.bearing_life_hours = {22.0, 21.0}, .energy_residual = 23.0, .window = 24e-6};
  result.planets = {{1.5, 26.0, 27.0}, {0.5, 28.0, 25.0}};
  result.seats = {
      {.load = 30.0, .tilt = {3e-3, -4e-3}, .life_hours = 70.0, .rated_hours = {114.0, 117.0, 116.0, 115.0}},
      {.load = 50.0, .life_hours = 71.0, .rated_hours = {118.0, 113.0, 119.0, 120.0}}};
  // Values that only a cage has, or only rollers without one, are absent otherwise.
  for (const bool caged : {true, false}) {
    result.caged = caged;
    const auto numbers = named_numbers(kWithAxis, sweep_row(result, kWithAxis, {17.0}));
    const double slip = caged ? 16.0 : not_given, pockets = caged ? 32.0 : not_given,
                 guidance = caged ? 64.0 : not_given, neighbours = caged ? not_given : 256.0;
    const std::vector<double> expected = {
        0,         1,         2,          3,         4,         6,         7,         10,        11,
        8,         12,        14,         15,        slip,      9,         13,        5,         72,
        73,        74,        20,         67,        68,        3.5,       102,       94,        95,
        96,        97,        98,         99,        100,       101,       90,        91,        92,
        93,        65,        66,         160,       243,       82,        80,        81,        2,
        3,         60,        61,         62,        62.5,      40000,     18,        75,        77,
        76,        19,        78,         511,       1,         2,         4,         8,         16,
        pockets,   guidance,  neighbours, 128,       1,         21,        114,       113,       116,
        115,       2,         1.5,        5,         1,         23,        24,        40,        1,
        41,        42,        43,         43.5,      44,        45,        46,        47,        48,
        49,        50,        51,         52,        53,        not_given, not_given, not_given, not_given,
        not_given, not_given, not_given,  not_given, not_given, not_given, not_given, not_given, not_given,
        0,         17};
    ASSERT_EQ(expected.size(), numbers.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_TRUE(numbers[i].second == expected[i] ||
                  (std::isnan(numbers[i].second) && std::isnan(expected[i])))
          << numbers[i].first << ": " << numbers[i].second;
  }
}

// The governing life, which determines the peak, is one of the columns.
TEST(SweepRow, TheGoverningLifeIsNamedByTheHeader) {
  analysis::PointResult result = at_6000_rpm();
  result.rating.hours = {94.0, 95.0, 96.0, 97.0};
  ManifestHeader header;
  const SweepRow row = sweep_row(result, header);
  EXPECT_EQ(governing_hours(header, row.point), result.life_hours);
  for (const auto& [name, life] :
       {std::pair{"L10h", 94.0}, {"L10rh", 95.0}, {"L10mh", 96.0}, {"L10mrh", 97.0}}) {
    header.life = name;
    EXPECT_EQ(governing_hours(header, row.point), life) << name;
    EXPECT_EQ(number_named(header, row, name), life);
  }
}

TEST(SweepRow, QuasiStaticPointHasNoDynamicNumbers) {
  const SweepRow row = sweep_row(at_6000_rpm(), {});
  EXPECT_FALSE(row.point.motion);
  for (const char* name : {"roller_slip", "friction_moment_N_m", "power_loss_W", "steady"})
    EXPECT_TRUE(std::isnan(number_named({}, row, name))) << name;
}

TEST(SweepRow, FailedPointKeepsSpeedAndAxesOnly) {
  analysis::PointResult result = at_6000_rpm();
  result.status = "no balance\nfound \xff";
  const SweepRow row = sweep_row(result, kWithAxis, {37.0});
  EXPECT_FALSE(row.ok());
  EXPECT_EQ(number_named(kWithAxis, row, "input_speed_rpm"), 6000.0);
  EXPECT_EQ(number_named(kWithAxis, row, "axis"), 37.0);
  EXPECT_EQ(axis_value(kWithAxis, row, "axis"), 37.0);
  EXPECT_TRUE(std::isnan(row.point.life_hours));
  EXPECT_TRUE(std::isnan(row.point.radial_mesh_load));
  EXPECT_EQ(row.point.status, "no balance found \xEF\xBF\xBD");  // the replacement character
}

TEST(SweepRow, InfiniteLifeIsNoNumber) {
  analysis::PointResult result = at_6000_rpm();
  result.life_hours = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(row_json({}, sweep_row(result, {}))["life_h"].is_null());
}

analysis::PointResult of_two_sets() {
  analysis::PointResult result = at_6000_rpm();
  result.limiting_set = "second";
  result.sets = {{.set = "first", .planet_load = 100.0, .life_hours = 5000.0},
                 {.set = "second", .planet_load = 200.0, .life_hours = 300.0}};
  return result;
}

TEST(SweepRow, OfSeveralSetsEndsWithTheLimitingOneAndEach) {
  ManifestHeader header = kWithAxis;
  header.sets = {"first", "second"};
  const SweepRow row = sweep_row(of_two_sets(), header, {17.0});
  const std::vector<std::string> names = names_of(header);
  EXPECT_EQ(names.at(promised.size()), "axis");
  EXPECT_EQ(names.at(promised.size() + 1), "limiting_set");
  EXPECT_EQ(number_named(header, row, "sets.first.planet_load_N"), 100.0);
  EXPECT_EQ(number_named(header, row, "sets.second.life_h"), 300.0);
  EXPECT_EQ(row_json(header, row)["limiting_set"], "second");
  EXPECT_NE(csv_line(header, row).find(",17,second,0,100,"), std::string::npos) << csv_line(header, row);
  const SweepRow again = row_from_json(header, row_json(header, row));
  EXPECT_EQ(csv_line(header, again), csv_line(header, row));
}

TEST(SweepRow, OfAFailedPointOfSeveralSetsHasNoneOfThem) {
  const ManifestHeader header{.sets = {"first", "second"}};
  analysis::PointResult result = of_two_sets();
  result.status = "second: no balance";
  const SweepRow row = sweep_row(result, header);
  EXPECT_EQ(row_json(header, row)["limiting_set"], "");
  EXPECT_TRUE(std::isnan(row.point.sets.at(0).life_hours));
  EXPECT_TRUE(row_json(header, row)["sets.second.life_h"].is_null());
}

TEST(SweepRow, OfNumbersHasThoseAlone) {
  const SweepRow row = row_of_numbers({{"inner_load_max_N", 12.0}, {"resonance", 1.0}}, {});
  EXPECT_EQ(row.point.inner.load_max, 12.0);
  EXPECT_TRUE(std::isnan(row.point.outer.load_max));
  EXPECT_EQ(row.point.status, "ok");
}

TEST(RowText, CsvQuotesTextAndLeavesMissingValuesEmpty) {
  analysis::PointResult result = at_6000_rpm();
  result.status = "no \"balance\", found";
  EXPECT_EQ(csv_line({}, sweep_row(result, {})),
            "6000,,,,,,,,,,,,,,,,\"no \"\"balance\"\", found\"" + cells_after_status() + "\n");
}

TEST(RowText, CsvGivesBackEveryBitInTheFewestDigits) {
  Record record;
  record.value("third", described::dimension::ratio, "", 1.0 / 3.0);
  record.value("tenth", described::dimension::force, "", 0.1);
  record.value("none", described::dimension::force, "", described::kAbsent);
  record.value("status", "", std::string("ok"));
  record.value("refined", "", true);
  EXPECT_EQ(csv_names(record), "third,tenth,none,status,refined\n");
  EXPECT_EQ(csv_values(record), "0.3333333333333333,0.1,,ok,true\n");
  EXPECT_EQ(bits_of(std::stod(csv_values(record))), bits_of(1.0 / 3.0));
}

// A row from a file is the row that was computed, to the last bit: each number of a member in SI, as a value
// in the unit of its column.
TEST(RowText, JsonGivesBackEveryBit) {
  ManifestHeader header = kWithAxis;
  header.sets = {"first"};
  header.resonances = true;
  std::uint64_t bits = 1;
  const auto random = [&bits] {  // 1e-9 to 1e9
    bits = bits * 6364136223846793005ULL + 1442695040888963407ULL;
    return std::pow(10.0, 18.0 * static_cast<double>(bits >> 11) / 9007199254740992.0 - 9.0);
  };
  for (int i = 0; i < 300; ++i) {
    analysis::PointResult result;
    result.sets.resize(1);
    result.dynamic.emplace().one_way.emplace();
    result.coupled.emplace().bearing_life_hours = {1.0};
    result.planets.resize(2);
    Resonance resonance{"planet", "P1", random(), 2, random(), random()};
    SweepRow whole = sweep_row(result, header, {random()}, resonance);
    described::Columns fill([&](std::string_view, const described::Dimension& dimension, double& value) {
      value = in_customary_unit(dimension, random()) * dimension.factor;
    });
    list(fill, whole.point);
    list(fill, whole.point.sets.front());
    const std::string text = row_json(header, whole).dump();
    const SweepRow again = row_from_json(header, nlohmann::ordered_json::parse(text));
    EXPECT_EQ(row_json(header, again).dump(), text);
    EXPECT_EQ(csv_line(header, again), csv_line(header, whole));
    std::vector<std::uint64_t> before, after;
    SweepRow one = whole, other = again;
    for (const auto& [row, all] : {std::pair{&one, &before}, std::pair{&other, &after}}) {
      described::Columns take([to = all](std::string_view, const described::Dimension&, double& value) {
        to->push_back(bits_of(value));
      });
      list(take, header, *row);
    }
    EXPECT_EQ(before, after);
  }
}

}  // namespace
}  // namespace orbearing::app::sweep_row_test
