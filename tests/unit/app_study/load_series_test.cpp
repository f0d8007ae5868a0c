// Records over time made into spectra: conserved sums, constant loads, rest, and messages on wrong records.
#include "app/study/load_series.hpp"

#include <gmock/gmock.h>
#include <netcdf.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <map>

#include "app/errors.hpp"
#include "app/results/point_file.hpp"
#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app::load_series_test {
namespace {

using fake_sweep::TemporaryFolder;
using testing::HasSubstr;

constexpr double kExponent = 4.0;    // of lives by Lundberg and Palmgren, which sweeps and spectra go by
constexpr double kRoundOff = 1e-12;  // relative, of sums over some hundred samples

// Uneven times, torque and speed that vary by themselves.
LoadSeries wavy(int samples) {
  LoadSeries series;
  double time = 3.0;
  for (int i = 0; i < samples; ++i) {
    series.time.push_back(time);
    series.torque.push_back(200.0 + 80.0 * std::sin(0.7 * i));
    series.speed.push_back(500.0 + 300.0 * std::sin(0.31 * i));
    time += 0.1 + 0.05 * std::sin(1.3 * i);
  }
  return series;
}

BinnedSeries binned(const LoadSeries& series, const BinCounts& counts, double exponent = kLineExponent) {
  return app::binned({{series}}, counts, exponent);
}

struct Sums {
  double share = 0.0, speed = 0.0, damage = 0.0;
};

Sums sums_of(const LoadSpectrum& spectrum) {
  Sums sums;
  for (const LoadBin& bin : spectrum.bins) {
    sums.share += bin.share;
    sums.speed += bin.share * bin.speed;
    if (bin.turns()) sums.damage += bin.share * bin.speed * std::pow(bin.power / bin.speed, kExponent);
  }
  return sums;
}

TEST(LoadSeries, BinsKeepTimeTurnsAndDamageHoweverWideTheyAre) {
  const LoadSeries series = wavy(500);
  Sums own;
  const double duration = series.time.back() - series.time.front();
  for (std::size_t i = 0; i + 1 < series.time.size(); ++i) {
    const double part = (series.time[i + 1] - series.time[i]) / duration;
    own.speed += part * series.speed[i];
    own.damage += part * series.speed[i] * std::pow(series.torque[i], kExponent);
  }
  for (const BinCounts counts : {BinCounts{1, 1}, BinCounts{8, 8}, BinCounts{3, 20}}) {
    const Sums found = sums_of(binned(series, counts).spectrum);
    EXPECT_NEAR(found.share, 1.0, kRoundOff);
    EXPECT_NEAR(found.speed, own.speed, kRoundOff * own.speed);
    EXPECT_NEAR(found.damage, own.damage, kRoundOff * own.damage);
  }
  EXPECT_EQ(binned(series, {1, 1}).spectrum.bins.size(), 1U);
  EXPECT_GT(binned(series, {8, 8}).spectrum.bins.size(), 20U);
}

// Life divided by that of the record for a bearing whose life is proportional to torque^-p: above 1 it is too
// long.
double life_over_that_of_record(const LoadSeries& series, const BinCounts& counts, double kept, double p) {
  double record = 0.0;
  const double duration = series.time.back() - series.time.front();
  for (std::size_t i = 0; i + 1 < series.time.size(); ++i)
    record +=
        (series.time[i + 1] - series.time[i]) / duration * series.speed[i] * std::pow(series.torque[i], p);
  double bins = 0.0;
  for (const LoadBin& bin : binned(series, counts, kept).spectrum.bins)
    if (bin.turns()) bins += bin.share * bin.speed * std::pow(bin.power / bin.speed, p);
  return record / bins;
}

// Bins by 10/3 made lives by Lundberg and Palmgren too long, 12 % in one bin.
TEST(LoadSeries, FewBinsNeverLengthenALife) {
  const LoadSeries series = wavy(500);
  for (const BinCounts counts : {BinCounts{1, 1}, BinCounts{2, 3}, BinCounts{8, 8}, BinCounts{64, 8}}) {
    EXPECT_NEAR(life_over_that_of_record(series, counts, kLineExponent, 4.0), 1.0, 1e-12);
    for (const double p : {10.0 / 3.0, 3.0})  // ISO 281 of rollers, balls: on the safe side
      EXPECT_LE(life_over_that_of_record(series, counts, kLineExponent, p), 1.0 + 1e-12) << p;
    EXPECT_NEAR(life_over_that_of_record(series, counts, 3.0, 3.0), 1.0, 1e-12);
    for (const double p : {7.6, 6.0, 4.0, 10.0 / 3.0, 3.0})
      EXPECT_LE(life_over_that_of_record(series, counts, kSteepestExponent, p), 1.0 + 1e-12) << p;
  }
  // By hand: torques 1 and 3 for equal times: (1 + 81)/2 = 41 by the power 4; 36.4 by 10/3: 13 % too long.
  const LoadSeries two{{0.0, 1.0, 2.0}, {1.0, 3.0, 3.0}, {100.0, 100.0, 100.0}};
  const double mean = (1.0 + std::pow(3.0, 10.0 / 3.0)) / 2.0;
  EXPECT_NEAR(life_over_that_of_record(two, {1, 1}, 10.0 / 3.0, 4.0), 41.0 / std::pow(mean, 1.2), 1e-12);
  EXPECT_GT(life_over_that_of_record(two, {1, 1}, 10.0 / 3.0, 4.0), 1.12);
}

TEST(LoadSeries, WhatAModifiedLifeCanGainByWideBinsIsTheDamageByItsSteepestPower) {
  const LoadSeries two{{0.0, 1.0, 2.0}, {1.0, 3.0, 3.0}, {100.0, 100.0, 100.0}};
  EXPECT_NEAR(binned(two, {1, 1}).excess.back(), (1.0 + 6561.0) / 2.0 / (41.0 * 41.0) - 1.0, 1e-12);
  EXPECT_NEAR(binned(two, {2, 1}).excess.back(), 0.0, 1e-12);
  EXPECT_NEAR(binned(two, {1, 1}, kSteepestExponent).excess.back(), 0.0, 1e-12);
}

// A table of design load cases.
TEST(LoadSeries, OfSeveralCountByTheirShareAndNotByTheirLength) {
  const LoadSeries brief{{0.0, 1.0, 2.0}, {1.0, 3.0, 3.0}, {100.0, 100.0, 100.0}};
  const LoadSeries lengthy{{0.0, 1000.0, 2000.0}, {3.0, 3.0, 3.0}, {100.0, 0.0, 0.0}};
  const BinnedSeries found = app::binned({{brief, 0.9, "brief"}, {lengthy, 0.1, "lengthy"}}, {2, 1});
  const std::vector<LoadBin> right{{100.0, 100.0, 0.45, "brief"},
                                   {300.0, 100.0, 0.45, "brief"},
                                   {300.0, 100.0, 0.05, "lengthy"},
                                   {0.0, 0.0, 0.05, "lengthy"}};
  ASSERT_EQ(found.spectrum.bins.size(), right.size());
  for (std::size_t i = 0; i < right.size(); ++i) {
    EXPECT_NEAR(found.spectrum.bins[i].power, right[i].power, kRoundOff * 300.0);
    EXPECT_NEAR(found.spectrum.bins[i].share, right[i].share, kRoundOff);
    EXPECT_EQ(found.spectrum.bins[i].file, right[i].file);
  }
  EXPECT_EQ(found.duration, 2002.0);
  EXPECT_NEAR(found.loaded_rest_share, 0.05, kRoundOff);
  EXPECT_EQ(found.spectrum.files(), (std::vector<std::string>{"brief", "lengthy"}));
}

TEST(LoadSeries, OfAConstantLoadGivesOneBin) {
  LoadSeries series = wavy(50);
  for (double& torque : series.torque) torque = 240.0 * (1.0 + 1e-15);
  for (double& speed : series.speed) speed = 600.0;
  series.torque[3] = 240.0;  // round-off of the writing program
  const BinnedSeries found = binned(series, {8, 8});
  ASSERT_EQ(found.spectrum.bins.size(), 1U);
  EXPECT_NEAR(found.spectrum.bins[0].power, 240.0 * 600.0, kRoundOff * 240.0 * 600.0);
  EXPECT_NEAR(found.spectrum.bins[0].share, 1.0, kRoundOff);
}

TEST(LoadSeries, RestIsABinOfItsOwnAndSignsAreReported) {
  const LoadSeries series{{0.0, 1.0, 2.0, 4.0}, {100.0, 50.0, -100.0, 7e9}, {300.0, 0.0, 300.0, 7e9}};
  const BinnedSeries found = binned(series, {4, 4});
  ASSERT_EQ(found.spectrum.bins.size(), 2U);
  EXPECT_EQ(found.spectrum.bins[0].speed, 300.0);
  EXPECT_DOUBLE_EQ(found.spectrum.bins[0].share, 0.75);
  EXPECT_FALSE(found.spectrum.bins[1].turns());
  EXPECT_DOUBLE_EQ(found.spectrum.bins[1].share, 0.25);
  EXPECT_DOUBLE_EQ(found.reversed_share, 0.5);
  EXPECT_THROW(binned({{0.0, 1.0}, {1.0, 1.0}, {0.0, 0.0}}, {1, 1}), BadInput);
}

TEST(LoadSeries, IsReadFromCsvAndNetcdfAlike) {
  const TemporaryFolder position;
  fake_sweep::write(position / "a.csv",
                    "time_s,speed_rpm,torque_N_m,other\n0,6000,100,x\n1,3000,200,y\n3,3000,200,z\n");
  fake_sweep::write(
      position / "b.csv",
      "time_h,power_kW,speed_rpm\n0,31.41592653589793,3000\n0.5,62.83185307179586,3000\n1,1,3000\n");
  const LoadSeries one = read_load_series(position / "a.csv");
  EXPECT_EQ(one.time, (std::vector<double>{0.0, 1.0, 3.0}));
  EXPECT_EQ(one.torque[1], 200.0);
  const LoadSeries by_power = read_load_series(position / "b.csv");
  EXPECT_EQ(by_power.time[1], 1800.0);
  EXPECT_NEAR(by_power.torque[1], 200.0, 1e-10);
  PointContent content;
  content.dimensions = {{"time", 3}};
  content.arrays = {{"time", {"time"}, "seconds since 2026-01-01", "", one.time},
                    {"torque", {"time"}, "N m", "", one.torque},
                    {"speed", {"time"}, "rad s-1", "", one.speed}};
  fake_sweep::write(position / "c.nc", netcdf_bytes(content));
  const LoadSeries netcdf = read_load_series(position / "c.nc");
  EXPECT_EQ(netcdf.time, one.time);
  EXPECT_EQ(netcdf.torque, one.torque);
  EXPECT_EQ(netcdf.speed, one.speed);
}

TEST(LoadSeries, WrongOnesAreReportedByLine) {
  const TemporaryFolder position;
  const auto fault = [&](const std::string& text) -> std::string {
    fake_sweep::write(position / "a.csv", text);
    try {
      read_load_series(position / "a.csv");
    } catch (const BadInput& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(fault("time_s,speed_rpm\n0,1\n1,1\n"),
              HasSubstr("no torque among the columns time_s, speed_rpm"));
  EXPECT_THAT(fault("time_s,torque_N_m\n0,1\n1,1\n"), HasSubstr("no speed"));
  EXPECT_THAT(fault("time,speed_rpm,torque_N_m\n0,1,1\n"), HasSubstr("a.csv:1:1: found time without a unit"));
  EXPECT_THAT(fault("time_s,speed_rpm,torque_mm\n0,1,1\n"), HasSubstr("torque"));
  EXPECT_THAT(fault("time_s,speed_rpm,torque_N_m\n0,1,1\n1,one,1\n"),
              HasSubstr("a.csv:3:3: found 'one' as speed"));
  EXPECT_THAT(fault("time_s,speed_rpm,torque_N_m\n0,1,1\n1,1\n"), HasSubstr("a.csv:3"));
  EXPECT_THAT(fault("time_s,speed_rpm,torque_N_m\n0,1,1\n0,1,1\n"),
              HasSubstr("a.csv:3: found a time that is not later"));
  EXPECT_THAT(fault("time_s,speed_rpm,torque_N_m\n0,1,1\n"), HasSubstr("1 samples"));
  EXPECT_THAT(fault("a,b\n0,1\n"),
              HasSubstr("a.csv:1:1: found no time, no speed, no torque among the columns a, b"));
}

std::string fault_of(const std::filesystem::path& file) {
  try {
    read_load_series(file);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

// A decimal comma splits a number in two, and the row is longer than its head.
TEST(LoadSeries, RowsMustFitTheirHead) {
  const TemporaryFolder position;
  const auto fault = [&](const std::string& rows) {
    fake_sweep::write(position / "a.csv", "time_s,speed_rpm,torque_N_m\n" + rows);
    return fault_of(position / "a.csv");
  };
  EXPECT_THAT(fault("0,1500,5,1591,25\n1,1500,5,1592,25\n"),
              testing::AllOf(HasSubstr("a.csv:2:10: found 5 values"), HasSubstr("decimal comma"),
                             HasSubstr("required: a row of 3 values")));
  EXPECT_THAT(
      fault("0,1500,1591\n1,1500,1592,7.5\n"),
      testing::AllOf(HasSubstr("a.csv:3:13: found 4 values"), testing::Not(HasSubstr("decimal comma"))));
  EXPECT_THAT(fault("0,1500,1591\n1,1500\n"), HasSubstr("a.csv:3:1: found 2 values"));
  EXPECT_EQ(fault("\"0,0\",\"1500,5\",\"1591,25\"\n\"1,0\",\"1500,5\",\"1591,25\"\n"), "");
}

// The content of a file that is no table is not shown.
TEST(LoadSeries, ContentThatIsNoTableIsNotShown) {
  const TemporaryFolder position;
  fake_sweep::write(position / "secret", "token=hunter2\nmore\n");
  const std::string fault = fault_of(position / "secret");
  EXPECT_THAT(fault, HasSubstr("names none of these columns"));
  EXPECT_THAT(fault, testing::Not(HasSubstr("hunter2")));
  fake_sweep::write(position / "a.csv", "Zeit_s;Drehzahl_rpm\n0,0;1\n");
  EXPECT_THAT(fault_of(position / "a.csv"), HasSubstr("among the columns Zeit_s, Drehzahl_rpm"));
  fake_sweep::write(position / "b.csv", "\xff\xfet\x00i\x00");
  EXPECT_THAT(fault_of(position / "b.csv"), HasSubstr("UTF-16"));
  fake_sweep::write(position / "c.csv", "time_s,speed_rpm,torque_N_m,f\xfcr\n0,1,1,x\n1,1,1,\xc3\xbc\n");
  EXPECT_THAT(fault_of(position / "c.csv"),
              HasSubstr("c.csv:3:7: found UTF-8 in a file whose line 1 holds bytes that are not"));
}

// A power at zero speed belongs to no torque.
TEST(LoadSeries, PowersAtRestAreRefused) {
  const TemporaryFolder position;
  const auto fault = [&](const std::string& rows) {
    fake_sweep::write(position / "a.csv", "time_s,speed_rpm,power_kW\n" + rows);
    return fault_of(position / "a.csv");
  };
  EXPECT_THAT(fault("0,6000,100\n1,0,5\n2,6000,100\n"),
              HasSubstr("a.csv:3: found a power of 5000 W at speed 0"));
  EXPECT_EQ(fault("0,6000,100\n1,0,0.05\n2,6000,100\n"), "") << "noise of a record at rest";
}

// A netCDF variable of a record, packed or with marks of what is missing.
class Packed {
 public:
  explicit Packed(const std::filesystem::path& file) {
    check(nc_create(file.c_str(), NC_NETCDF4 | NC_CLOBBER, &file_));
    check(nc_def_dim(file_, "time", 3, &time_));
    put("time", NC_DOUBLE, "s", {0.0, 1.0, 2.0});
  }
  ~Packed() { nc_close(file_); }
  Packed(const Packed&) = delete;
  Packed& operator=(const Packed&) = delete;

  int put(const char* name, nc_type type, const char* units, const std::vector<double>& values,
          const std::map<std::string, std::vector<double>>& attributes = {}) {
    int variable = 0;
    check(nc_def_var(file_, name, type, 1, &time_, &variable));
    check(nc_put_att_text(file_, variable, "units", std::strlen(units), units));
    for (const auto& [key, numbers] : attributes)
      check(nc_put_att_double(file_, variable, key.c_str(), key == "_FillValue" ? type : NC_DOUBLE,
                              numbers.size(), numbers.data()));
    check(nc_put_var_double(file_, variable, values.data()));
    return variable;
  }

 private:
  static void check(int code) { ASSERT_EQ(code, NC_NOERR) << nc_strerror(code); }
  int file_ = 0;
  int time_ = 0;
};

// Packed values are unpacked [CF], and values that the file marks as missing are refused.
TEST(LoadSeries, NetcdfIsUnpackedAndNothingMissingIsTaken) {
  const TemporaryFolder position;
  {
    Packed file(position / "packed.nc");
    file.put("speed", NC_SHORT, "rpm", {1000, 1100, 1200},
             {{"scale_factor", {0.5}}, {"add_offset", {1000.0}}});
    file.put("torque", NC_SHORT, "kN m", {100, 110, 120}, {{"scale_factor", {0.1}}});
  }
  const LoadSeries series = read_load_series(position / "packed.nc");
  EXPECT_NEAR(series.torque[1], 11e3, 1e-9);
  EXPECT_NEAR(series.speed[1], 1550.0 * 2.0 * M_PI / 60.0, 1e-9);
  const auto fault = [&](const std::vector<double>& torque,
                         const std::map<std::string, std::vector<double>>& with) {
    {
      Packed file(position / "masked.nc");
      file.put("speed", NC_DOUBLE, "rpm", {1000, 1100, 1200});
      file.put("torque", NC_DOUBLE, "N m", torque, with);
    }
    return fault_of(position / "masked.nc");
  };
  EXPECT_THAT(fault({1, -9999, 3}, {{"_FillValue", {-9999}}}),
              testing::AllOf(HasSubstr("torque: sample 2"), HasSubstr("missing")));
  EXPECT_THAT(fault({1, 2, 9999}, {{"missing_value", {9999}}}), HasSubstr("torque: sample 3"));
  EXPECT_THAT(fault({1, 2, 500}, {{"valid_range", {0, 100}}}), HasSubstr("outside the valid range"));
  EXPECT_THAT(fault({-1, 2, 5}, {{"valid_min", {0}}}), HasSubstr("sample 1"));
  EXPECT_THAT(fault({1, NC_FILL_DOUBLE, 5}, {}), HasSubstr("sample 2"));
  EXPECT_EQ(fault({1, 2, 5}, {{"valid_range", {0, 100}}, {"_FillValue", {-9999}}}), "");
}

TEST(LoadSeries, BinsAreTwoCounts) {
  EXPECT_EQ(parse_bins("12x4").torque, 12);
  EXPECT_EQ(parse_bins("12x4").speed, 4);
  for (const char* wrong : {"8", "0x4", "4x", "x", "4x4x4", "1.5x2", "101x1", "-1x1"})
    EXPECT_THROW(parse_bins(wrong), BadInput) << wrong;
}

}  // namespace
}  // namespace orbearing::app::load_series_test
