// Parts of a structure that are listed once: they exist where a number is known.
#include "mechanics/columns.hpp"

#include <gtest/gtest.h>

#include <map>

namespace orbearing::described::columns_test {
namespace {

struct Motion {
  double slip = 0.0;
  int runs = 0;
  bool steady = false;
  std::optional<double> drag;
};

struct Point {
  double speed = 0.0;
  std::optional<Motion> motion;
  std::string status = "ok";
};

void list(Columns& columns, Point& point) {
  columns.value("speed_rpm", dimension::angular_speed, "of the shaft", point.speed);
  columns.part(point.motion, [&](Motion& motion) {
    columns.value("slip", dimension::ratio, "of the cage", motion.slip);
    columns.value("runs", dimension::ratio, "of the model", motion.runs);
  });
  columns.text("status", "why it failed", point.status);
  columns.part(point.motion, [&](Motion& motion) {
    columns.value("drag", dimension::ratio, "over traction", motion.drag);
  });
  columns.part(point.motion,
               [&](Motion& motion) { columns.value("steady", dimension::ratio, "or not", motion.steady); });
}

using Numbers = std::map<std::string, double, std::less<>>;

Numbers numbers_of(Point point) {
  Numbers numbers;
  Columns columns(
      [&](std::string_view name, const Dimension&, double& value) { numbers.emplace(name, value); });
  list(columns, point);
  return numbers;
}

void give(const Numbers& numbers, Point& point) {
  Columns columns([&](std::string_view name, const Dimension&, double& value) {
    const auto found = numbers.find(name);
    value = found == numbers.end() ? kAbsent : found->second;
  });
  list(columns, point);
}

TEST(Columns, GiveBackWhatTheyTook) {
  const Point point{.speed = 3.0, .motion = Motion{.slip = 0.25, .runs = 4, .steady = true, .drag = 2.0}};
  Point again;
  give(numbers_of(point), again);
  EXPECT_EQ(again.speed, 3.0);
  ASSERT_TRUE(again.motion);
  EXPECT_EQ(again.motion->slip, 0.25);
  EXPECT_EQ(again.motion->runs, 4);
  EXPECT_TRUE(again.motion->steady);
  EXPECT_EQ(again.motion->drag, 2.0);
}

TEST(Columns, APartOfWhichSomeNumbersAreMissingStays) {
  Point point{.motion = Motion{.slip = 0.25, .runs = 4, .steady = false}};
  numbers_of(point);
  give(numbers_of(point), point);
  ASSERT_TRUE(point.motion);
  EXPECT_EQ(point.motion->slip, 0.25);
  EXPECT_FALSE(point.motion->drag);
}

TEST(Columns, APartWithoutNumbersIsNone) {
  Point point{.motion = Motion{}};
  give({{"speed_rpm", 1.0}}, point);
  EXPECT_FALSE(point.motion);
  EXPECT_EQ(point.speed, 1.0);
}

TEST(Columns, DescribeAMissingPartByMissingNumbers) {
  Record record;
  describe_listed(record, Point{.speed = 1.0});
  EXPECT_EQ(each(record.entries(), &Entry::name),
            (std::vector<std::string>{"speed_rpm", "slip", "runs", "status", "drag", "steady"}));
  EXPECT_TRUE(std::isnan(std::get<described::Numbers>(record.entry("slip").content).values.front()));
  EXPECT_EQ(std::get<std::string>(record.entry("status").content), "ok");
}

TEST(Columns, NamesWithinAPartBeginWithItsPrefix) {
  Point point;
  std::vector<std::string> names;
  Columns columns([&](std::string_view name, const Dimension&, double&) { names.emplace_back(name); });
  columns.within("sets.a.", [&] { list(columns, point); });
  list(columns, point);
  EXPECT_EQ(names.front(), "sets.a.speed_rpm");
  EXPECT_EQ(names.back(), "steady");
}

}  // namespace
}  // namespace orbearing::described::columns_test
