#include "app/case/units.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <locale>
#include <numbers>
#include <thread>
#include <vector>

#include "app/case/common_units.hpp"

namespace orbearing::app::units_test {
namespace {

// A conversion multiplies by one factor, itself rounded: a few units in the last place.
constexpr double few_ulps = 4e-16;

void expect_quantity(const char* text, const Dimension& dimension, double expected) {
  const Reading<double> reading = read_quantity(text, dimension);
  ASSERT_TRUE(reading.value) << text << ": " << reading.fault;
  EXPECT_NEAR(*reading.value, expected, few_ulps * std::abs(expected)) << text;
}

void expect_fault(const char* text, const Dimension& dimension, const char* part) {
  const Reading<double> reading = read_quantity(text, dimension);
  ASSERT_FALSE(reading.value) << text;
  EXPECT_NE(reading.fault.find(part), std::string::npos) << text << ": " << reading.fault;
}

TEST(Units, ConvertToSi) {
  expect_quantity("150 kW", dimension::power, 150e3);
  expect_quantity("3 mm", dimension::length, 3e-3);
  expect_quantity("-5um", dimension::small_length, -5e-6);
  expect_quantity("+.5 \xC2\xB5m", dimension::small_length, 0.5e-6);
  expect_quantity("20 deg", dimension::angle, 20 * std::numbers::pi / 180);
  expect_quantity("6000 rpm", dimension::angular_speed, 6000 * 2 * std::numbers::pi / 60);
  expect_quantity("1e3 N.mm", dimension::torque, 1.0);
  expect_quantity("15 1/GPa", dimension::pressure_viscosity, 15e-9);
  expect_quantity("7.85 g/cm^3", dimension::density, 7850);
  expect_quantity("10 mPa.s", dimension::viscosity, 0.01);
}

// With the table or without, in both directions.
TEST(Units, OfTheTableAreThoseOfTheLibrary) {
  const auto same = [](std::string_view unit, std::string_view target) {
    for (const double value : {1.0, 3.0, 0.1, -37.0, 6000.0, 1.0 / 3.0}) {
      const Reading<double> quick = convert(value, unit, target);
      const Reading<double> slow = convert_by_library(value, unit, target);
      ASSERT_TRUE(quick.value && slow.value) << unit << ": " << slow.fault;
      EXPECT_EQ(*quick.value, *slow.value) << value << " " << unit << " in " << target;
    }
  };
  ASSERT_FALSE(common_units().empty());
  for (const CommonUnit& one : common_units()) {
    same(one.unit, one.si);
    same(one.si, one.unit);
  }
}

TEST(Units, KeepBitsOfTheTargetUnit) {
  EXPECT_EQ(*read_quantity("0.1 m", dimension::length).value, 0.1);
}

TEST(Units, RefuseCyclesForRadians) {
  expect_fault("100 Hz", dimension::angular_speed, "states no angle");
  expect_fault("100 1/s", dimension::angular_speed, "states no angle");
  expect_fault("0.3 1", dimension::angle, "not known");
  expect_fault("3 mm.rad", dimension::length, "states no angle");
}

TEST(Units, RefuseBareNumbersWithRemedy) {
  expect_fault("3", dimension::length, "as in '3 mm'");
}

TEST(Units, RefuseWrongAndUnknownUnits) {
  expect_fault("3 kg", dimension::length, "does not measure the same");
  expect_fault("3 mmm", dimension::length, "not known");
  expect_fault("20 degC", dimension::mass, "does not measure");
}

// By powers of ten a value is the double nearest to the written number, not a neighbour of it.
TEST(Units, AreRoundByPowersOfTen) {
  EXPECT_EQ(*read_quantity("80 um", dimension::small_length).value, 8e-5);
  EXPECT_EQ(*read_quantity("37 um", dimension::small_length).value, 3.7e-5);
  EXPECT_EQ(*read_quantity("5.24 mm", dimension::length).value, 0.00524);
  EXPECT_EQ(*read_quantity("206 GPa", dimension::stress).value, 206e9);
  EXPECT_EQ(*read_quantity("15 GPa-1", dimension::pressure_viscosity).value, 15e-9);
  EXPECT_EQ(*read_quantity("0.7 kW", dimension::power).value, 700.0);
}

// Units as data sheets write them, where the quantity leaves one meaning.
TEST(Units, TakeThoseOfDataSheets) {
  const double rpm = *read_quantity("20 rpm", dimension::angular_speed).value;
  for (const char* text : {"20 1/min", "20 min-1", "20 min^-1", "20 /min", "20 r/min", "20 min\u207b\u00b9"})
    EXPECT_EQ(read_quantity(text, dimension::angular_speed).value, rpm) << text;
  EXPECT_EQ(read_quantity("10 cP", dimension::viscosity).value, 0.01);
  EXPECT_EQ(read_quantity("80 C", dimension::temperature).value, 80.0);
  EXPECT_EQ(read_quantity("4\u00a0mm", dimension::length).value, 4e-3);
  EXPECT_EQ(read_quantity("4\u202fmm", dimension::length).value, 4e-3);
  expect_fault("80 C", dimension::length, "does not measure the same");
  expect_fault("1 C/K", dimension::temperature, "does not measure the same");
  expect_fault("20 1/s", dimension::angular_speed, "states no angle");
  expect_fault("\u22127.5 deg", dimension::angle, "U+2212");
}

// A host's locale with a decimal comma, in both of the libraries' ways.
class DecimalComma {
 public:
  DecimalComma() : before_(std::locale::global(std::locale(std::locale::classic(), new Comma))) {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "nl_NL.UTF-8"})
      if (!of_process_ && setlocale(LC_ALL, name) != nullptr) of_process_ = true;
  }
  ~DecimalComma() {
    setlocale(LC_ALL, "C");
    std::locale::global(before_);
  }
  bool of_process() const { return of_process_; }

 private:
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  std::locale before_;
  bool of_process_ = false;
};

TEST(Units, AreTheSameUnderADecimalComma) {
  const DecimalComma comma;
  EXPECT_EQ(read_number("74.45").value, 74.45);
  // Units that no earlier test has read, so that the library reads their definitions now.
  EXPECT_EQ(*read_quantity("2.5 inch", dimension::length).value, 2.5 * 25.4 / 1000.0);
  EXPECT_NEAR(*read_quantity("1.5 lbf", dimension::force).value, 1.5 * 4.4482216152605, 1e-12);
  if (!comma.of_process())
    GTEST_SKIP() << "no locale with a decimal comma is installed: the facet alone was tested";
}

TEST(Units, RefuseReciprocalsAsAnotherDimension) {
  expect_fault("333 m-1", dimension::length, "unit 'm-1' does not measure the same as 'm'");
  expect_fault("1 m3/kg", dimension::density, "does not measure the same");
  expect_fault("1.5e-8 Pa", dimension::pressure_viscosity, "does not measure the same");
  expect_fault("1 s/rad", dimension::angular_speed, "does not measure the same");
  expect_fault("3 dBm", dimension::power, "does not measure the same");
}

TEST(Units, NameTheQuantityOfAnotherUnit) {
  expect_fault("160 Nm", dimension::power,
               "its unit 'Nm' does not measure the same as 'W' (it is one of torque)");
  expect_fault("160 kN.m", dimension::power, "(it is one of torque)");
  expect_fault("150 kW", dimension::torque, "(it is one of power)");
  expect_fault("6000 1/min", dimension::power, "(it is one of angular speed)");
  expect_fault("20 cSt", dimension::viscosity, "(it is one of kinematic viscosity)");
  expect_fault("80 C", dimension::length, "(it is one of temperature)");
  expect_fault("3 kg", dimension::length, "(it is one of mass)");
  expect_fault("3 mol", dimension::length, "its unit 'mol' does not measure the same as 'm'");
}

TEST(Units, ShowLongTextsCut) {
  const std::string unit(500, 'm');
  expect_fault(("3 " + unit).c_str(), dimension::length, "mmm...' is not known");
  expect_fault(std::string(300, '1').c_str(), dimension::length, "write number and unit");
}

TEST(Units, RefuseNumbersHiddenInUnits) {
  for (const char* text : {"3 mm 10", "3 10 mm", "3 mm.4", "3 mm/2", "3 mm @ 5", "3 2", "3 1/"})
    expect_fault(text, dimension::length, "not known");
}

TEST(Units, RefuseUnitsWithAZeroOfTheirOwn) {
  constexpr Dimension temperature{"temperature", "K", "K", "300 K"};
  expect_fault("20 degC", temperature, "zero point");
}

TEST(Units, StateTemperaturesInKelvinAnew) {
  expect_fault("343 K", dimension::temperature, "temperatures are stated in degC: 343 K as 69.85 degC");
  expect_fault("5 K", dimension::temperature, "a difference of 5 K as 5 degC");
  EXPECT_NEAR(*read_quantity("2 1/K", dimension::per_kelvin).value, 2.0, 0.0);
}

TEST(Units, TakeMetricHorsepower) {
  // DIN 66036: 75 kgf m/s.
  EXPECT_DOUBLE_EQ(*read_quantity("245 PS", dimension::power).value, 245.0 * 75.0 * 9.80665);
  expect_fault("245 PS", dimension::torque, "(it is one of power)");
}

TEST(Units, RefuseDigitsInGroups) {
  expect_fault("20 000 h", dimension::time, "a number is written without spaces: 20000 h");
  expect_fault("1 234 567.5 h", dimension::time, "a number is written without spaces: 1234567.5 h");
  expect_fault("20\u00a0000 h", dimension::time, "a number is written without spaces: 20000 h");
  EXPECT_DOUBLE_EQ(*read_quantity("600 1/min", dimension::angular_speed).value,
                   *read_quantity("600 rpm", dimension::angular_speed).value);
  EXPECT_EQ(read_number("20 000").fault, "a number is written without spaces: 20000");
}

TEST(Units, RefusePerCentWithTheFraction) {
  EXPECT_EQ(read_number("95 %").fault, "state 0.95 instead of 95 %");
  EXPECT_EQ(read_number("0.5%").fault, "state 0.005 instead of 0.5 %");
}

TEST(Units, RefuseNumbersThatAreNotFinite) {
  for (const char* text : {".inf mm", "inf mm", "nan mm", "-.nan mm", "--3 mm", "+-3 mm", "mm", ""})
    expect_fault(text, dimension::length, "finite number");
  expect_fault("1e999 mm", dimension::length, "too large");
  expect_fault("1e308 Tm", dimension::length, "too large");
  expect_fault("1,000 mm", dimension::length, "commas");
}

TEST(Units, ReadPlainNumbers) {
  EXPECT_EQ(*read_number("0.83").value, 0.83);
  EXPECT_FALSE(read_number("0.83 mm").value);
  EXPECT_FALSE(read_number("0x10").value);
}

TEST(Units, ConvertInSeveralThreads) {
  std::vector<std::thread> threads;
  std::vector<int> good(4, 0);
  for (std::size_t t = 0; t < good.size(); ++t)
    threads.emplace_back([&good, t] {
      for (int i = 0; i < 200; ++i) good[t] += read_quantity("3 cm", dimension::length).value == 0.03 ? 1 : 0;
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(good, std::vector<int>(4, 200));
}

}  // namespace
}  // namespace orbearing::app::units_test
