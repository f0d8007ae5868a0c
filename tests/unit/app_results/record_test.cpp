// A result that is described once, in each form in which it leaves the program.
#include "mechanics/record.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/results/record_writers.hpp"

namespace orbearing::app {
namespace {

using Json = nlohmann::ordered_json;

struct Race {
  double load = 0.0;          // [N]
  std::optional<double> film;  // [m]
};

void describe(Record& record, const Race& race) {
  using namespace described;
  record.value("load_max_N", dimension::force, "largest load", race.load);
  record.value("film_um", dimension::small_length, "least film", race.film);
}

struct Found {
  double speed = 0.0;  // [rad/s]
  Race inner;
  std::optional<Race> outer;
  std::vector<Race> rows;
  Eigen::Matrix2d stiffness;  // [N/m]
};

void describe(Record& record, const Found& found) {
  using namespace described;
  record.value("speed_rpm", dimension::angular_speed, "of the shaft", found.speed);
  record.value("status", "ok, or why it failed", "ok");
  record.value("steps", "of the search", 3);
  record.value("steady", "whether the means stood still", true);
  record.child("inner", "inner race", found.inner);
  record.child("outer", "outer race", found.outer);
  record.table("rows", "row", "races", found.rows).file = "rows.csv";
  record.array("stiffness_N_per_m", dimension::stiffness, "of the ring", {"freedom", "freedom_beside"},
               found.stiffness);
  record.array("tilt_mrad", dimension::small_angle, "of the ring", {{"plane", {"x", "y"}}},
               std::array{1e-3, 2e-3});
  record.series("time", dimension::time, "since the start", {"time"}, std::vector{0.0, 0.5, 1.0});
}

constexpr double kRpm6000 = 628.3185307179587;  // [rad/s]

Found found() {
  return {.speed = kRpm6000,
          .inner = {10.0, 2e-6},
          .outer = {},
          .rows = {{1.0, {}}, {2.5, 1e-6}},
          .stiffness = Eigen::Matrix2d{{1.0, 2.0}, {3.0, 4.0}}};
}

Record record_of(const Found& result) {
  Record record;
  describe(record, result);
  return record;
}

TEST(Record, IsJsonInTheUnitsOfItsKeys) {
  EXPECT_EQ(json_of(record_of(found())), Json::parse(R"({
    "speed_rpm": 6000.0, "status": "ok", "steps": 3, "steady": true, "inner": {"load_max_N": 10.0, "film_um": 2.0},
    "outer": null, "rows": [{"load_max_N": 1.0, "film_um": null}, {"load_max_N": 2.5, "film_um": 1.0}],
    "stiffness_N_per_m": [[1.0, 2.0], [3.0, 4.0]], "tilt_mrad": {"x": 1.0, "y": 2.0}})"));
  EXPECT_EQ(units_of(record_of(found())), Json::parse(R"({
    "speed_rpm": "rpm", "load_max_N": "N", "film_um": "um", "stiffness_N_per_m": "N/m", "tilt_mrad": "mrad"})"));
}

TEST(Record, HasNoNumberThatIsNotFinite) {
  Found lost = found();
  lost.speed = INFINITY;
  EXPECT_TRUE(json_of(record_of(lost))["speed_rpm"].is_null());
  EXPECT_TRUE(std::isnan(content_of(record_of(lost)).arrays.front().values.front()));
  EXPECT_NE(text_of(record_of(lost)).find("speed_rpm                - rpm"), std::string::npos);
}

const NamedArray& array_called(const PointContent& content, const std::string& name) {
  for (const NamedArray& array : content.arrays)
    if (array.name == name) return array;
  throw std::invalid_argument(name);
}

TEST(Record, IsArraysInSiUnderNamesWithoutUnits) {
  const PointContent content = content_of(record_of(found()));
  EXPECT_EQ(array_called(content, "speed").values, std::vector{kRpm6000});
  EXPECT_EQ(array_called(content, "speed").units, "rad s-1");
  EXPECT_EQ(array_called(content, "inner_film").values, std::vector{2e-6});
  EXPECT_EQ(array_called(content, "rows_load_max").dimensions, std::vector<std::string>{"row"});
  EXPECT_EQ(array_called(content, "rows_load_max").values, (std::vector{1.0, 2.5}));
  EXPECT_TRUE(std::isnan(array_called(content, "rows_film").values[0]));
  EXPECT_EQ(array_called(content, "stiffness").values, (std::vector{1.0, 2.0, 3.0, 4.0}));
  EXPECT_EQ(array_called(content, "time").values.size(), 3u);
  EXPECT_EQ(content.attributes,
            (std::vector<std::pair<std::string, std::string>>{{"status", "ok"}, {"plane", "x y"}}));
}

TEST(Record, RefusesTwoSizesOfOneDimension) {
  Record record;
  record.array("one", {}, "", {"ball"}, std::vector{1.0, 2.0});
  record.array("other", {}, "", {"ball"}, std::vector{1.0});
  EXPECT_THROW(content_of(record), std::logic_error);
}

// Readers of netCDF take a variable of a dimension's name for the coordinates along it.
TEST(Record, DimensionsHaveNoNameOfAVariableButThatOfCoordinates) {
  Record record;
  record.value("life_h", described::dimension::hours, "of one bearing", 3600.0);
  record.table("lives", "life", "rated", std::vector{3600.0, 7200.0},
               [](Record& row, double life) { row.value("h", described::dimension::hours, "", life); });
  record.series("x_mm", described::dimension::length, "", {"x"}, std::array{0.0, 1e-3});
  const PointContent content = content_of(record);
  EXPECT_EQ(array_called(content, "life").dimensions, std::vector<std::string>{});
  EXPECT_EQ(array_called(content, "lives_h").dimensions, std::vector<std::string>{"life_index"});
  EXPECT_EQ(array_called(content, "x").dimensions, std::vector<std::string>{"x"});
}

TEST(Record, FillsUpRowsOfUnlikeLists) {
  Record record;
  record.table("meshes", "mesh", "", std::vector{1, 2}, [](Record& row, int count) {
    row.array("harmonics", {}, "", {"harmonic"}, std::vector<double>(static_cast<std::size_t>(count), 5.0));
  });
  const std::vector<double> values = array_called(content_of(record), "meshes_harmonics").values;
  EXPECT_EQ(values[0], 5.0);
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_EQ(values[3], 5.0);
}

TEST(Record, HasTablesAsCsv) {
  Record record;
  record.table("rows", "row", "", found().rows, [](Record& row, const Race& race) {
    row.value("name", "", "a, b");
    describe(row, race);
    row.array("", described::dimension::cycles, "", {{"mode", {"x_Hz", "y_Hz"}}}, std::array{1.0, 2.0});
  });
  EXPECT_EQ(csv_of(record.entries().front()),
            "name,load_max_N,film_um,x_Hz,y_Hz\n\"a, b\",1,,1,2\n\"a, b\",2.5,1,1,2\n");
}

TEST(Record, HasArraysOfAGridAsCsv) {
  Record record;
  record.child("map", "", found(), [](Record& map, const Found& of) {
    map.series("x_mm", described::dimension::length, "", {"x"}, std::array{0.0, 1e-3});
    map.series("y_mm", described::dimension::length, "", {"y"}, std::array{0.0, 2e-3});
    map.series("k_N_per_m", described::dimension::stiffness, "", {"x", "y"}, of.stiffness);
  });
  EXPECT_EQ(csv_of(record.entries().front()), "x_mm,y_mm,k_N_per_m\n0,0,1\n0,2,2\n1,0,3\n1,2,4\n");
}

// Words of unlike length fill lines of at most 160 letters, each as far as the next word does not fit.
TEST(Record, HasLongListsInLinesThatAreFull) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < 60; ++i) words.push_back(std::string(3 + 7 * (i % 4), static_cast<char>('a' + i % 26)));
  Record record;
  record.value("words", "of unlike length", words);
  std::istringstream lines(text_of(record));
  std::vector<std::string> found;
  for (std::string line; std::getline(lines, line);)
    if (line.find(',') != std::string::npos || found.size() > 1) found.push_back(line);
  ASSERT_GT(found.size(), 3u);
  for (std::size_t i = 0; i + 1 < found.size(); ++i) {
    EXPECT_LE(found[i].size(), 160u) << found[i];
    const std::size_t next = found[i + 1].find(',', 2);
    if (next != std::string::npos) {
      EXPECT_GT(found[i].size() + next, 160u) << found[i];
    }
  }
}

TEST(Record, IsTextWithMeanings) {
  const std::string text = text_of(record_of(found()));
  EXPECT_NE(text.find("speed_rpm             6000 rpm   of the shaft\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\nrows: races\n  load_max_N  film_um\n           1        -\n         2.5        1\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("since the start"), std::string::npos);
}

}  // namespace
}  // namespace orbearing::app
