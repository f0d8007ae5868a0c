// Load spectra in cases: rows, files of rows, and messages on wrong ones.
#include "app/case/spectrum_case.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>

#include "app/case/resolved_writer.hpp"
#include "app/case/rows_file.hpp"
#include "app/units.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::spectrum_case_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

const std::string kTwoRows =
    "spectrum=[{power: 150 kW, speed: 6000 rpm, share: 0.25}, {torque: 100 N.m, speed: 3000 rpm, share: "
    "0.75}]";

LoadSpectrum spectrum_of(const std::string& setting) {
  return *load_spectrum(shipped({setting}));
}

std::string message(const std::string& rows) {
  const std::vector<std::string> found = setting_mistakes({"spectrum=" + rows});
  return found.empty() ? "" : found.front();
}

TEST(SpectrumCase, RowsStatePowerOrTorque) {
  const LoadSpectrum found = spectrum_of(kTwoRows);
  ASSERT_EQ(found.bins.size(), 2U);
  EXPECT_EQ(found.bins[0].power, 150e3);
  EXPECT_EQ(found.bins[0].speed, shipped({"input.speed=6000 rpm"}).quantity("input.speed"));
  EXPECT_NEAR(found.bins[1].power, 100.0 * 3000.0 / kRpm, 1e-9);
  EXPECT_EQ(found.bins[1].share, 0.75);
  EXPECT_EQ(found.hours, 0.0);
  EXPECT_FALSE(load_spectrum(shipped()));
}

TEST(SpectrumCase, HoursNeedNoSum) {
  const LoadSpectrum found = spectrum_of(
      "spectrum=[{power: 150 kW, speed: 6000 rpm, hours: 300}, {power: 75 kW, speed: 3000 rpm, hours: 60000 "
      "min}]");
  EXPECT_NEAR(found.hours, 1300.0, 1e-9);
  EXPECT_NEAR(found.bins[0].share, 300.0 / 1300.0, 1e-15);
  EXPECT_NEAR(found.bins[1].share, 1000.0 / 1300.0, 1e-15);
}

// Rows may name the record that they come from.
TEST(SpectrumCase, RowsMayNameARecord) {
  const LoadSpectrum found = spectrum_of(
      "spectrum=[{power: 1 kW, speed: 60 rpm, share: 0.5, file: \"b: 1.csv\"}, {power: 1 kW, speed: 60 rpm, "
      "share: 0.25}, "
      "{power: 1 kW, speed: 60 rpm, share: 0.125, file: a}, {power: 1 kW, speed: 60 rpm, share: 0.125, file: "
      "'b: 1.csv'}]");
  const std::vector<std::string> right{"b: 1.csv", "", "a", "b: 1.csv"};
  for (std::size_t i = 0; i < right.size(); ++i) EXPECT_EQ(found.bins[i].file, right[i]);
  EXPECT_EQ(found.minimum_load, 0.02);
  EXPECT_THAT(message("[{power: 1 kW, speed: 60 rpm, share: 1, file: ''}]"),
              HasSubstr("file: an empty text"));
}

TEST(SpectrumCase, WrittenOutItIsReadAgain) {
  const ResolvedCase resolved = shipped({kTwoRows.substr(0, kTwoRows.size() - 2) + ", file: 'b: \"1.csv'}]"});
  const ResolvedCase again = parse_case(write_resolved(resolved), "again.yaml", {});
  EXPECT_EQ(again.list(kSpectrumPath), resolved.list(kSpectrumPath));
  EXPECT_EQ(write_resolved(again), write_resolved(resolved));
}

TEST(SpectrumCase, SharesMustAddUpToOne) {
  EXPECT_THAT(message("[{power: 150 kW, speed: 6000 rpm, share: 0.7}]"),
              AllOf(StartsWith("--set: spectrum: "), HasSubstr("add up to 0.7"), HasSubstr("1 is required")));
}

TEST(SpectrumCase, WrongRowsAreRefused) {
  EXPECT_THAT(message("[{power: 150 kW, torque: 3 N.m, speed: 6000 rpm, share: 1}]"),
              HasSubstr("more than one power or torque"));
  EXPECT_THAT(message("[{speed: 6000 rpm, share: 1}]"), HasSubstr("no power or torque"));
  EXPECT_THAT(message("[{power: 150 kW, speed: 6000 rpm}]"), HasSubstr("no share or hours"));
  EXPECT_THAT(message("[{power: 150 kW, share: 1}]"), HasSubstr("a row without 'speed'"));
  EXPECT_THAT(message("[{power: 150 kW, sped: 6000 rpm, share: 1}]"), HasSubstr("unknown key 'sped'"));
  EXPECT_THAT(message("[{power: 150, speed: 6000 rpm, share: 1}]"), HasSubstr("power: "));
  EXPECT_THAT(message("[{power: -150 kW, speed: 6000 rpm, share: 1}]"), HasSubstr("out of range"));
  EXPECT_THAT(message("[[150 kW, 6000 rpm, 1]]"), HasSubstr("as a row"));
  EXPECT_THAT(message("[{power: 0 kW, speed: 0 rpm, share: 1}]"), HasSubstr("a spectrum at rest"));
  EXPECT_THAT(message("[{power: 1 kW, speed: 9 rpm, share: 0.5}, {power: 1 kW, speed: 9 rpm, hours: 5}]"),
              HasSubstr("a share together with rows with hours"));
}

// A power at zero speed belongs to no torque.
TEST(SpectrumCase, PowersAtRestAreRefused) {
  const std::string rotating = ", {power: 150 kW, speed: 6000 rpm, share: 0.5}]";
  EXPECT_THAT(setting_mistakes({"spectrum=[{power: 5 kW, speed: 0 rpm, share: 0.5}" + rotating}),
              Contains(HasSubstr("row 1 with 5 kW at speed 0; power 0, or torque instead of power")));
  EXPECT_THAT(setting_mistakes({"spectrum=[{power: 0 kW, speed: 0 rpm, share: 0.5}" + rotating}), IsEmpty());
  EXPECT_THAT(setting_mistakes({"spectrum=[{torque: 5 N.m, speed: 0 rpm, share: 0.5}" + rotating}),
              IsEmpty());
}

TEST(SpectrumCase, ADrivetrainWithoutBearingHasNone) {
  const std::string gears = text_of(ORBEARING_SOURCE_DIR "/cases/lin_parker_1999/case.yaml");
  EXPECT_THAT(mistakes(gears, {kTwoRows}), Contains(HasSubstr("spectrum")));
}

TEST(HeaderCell, HoldsNameAndUnit) {
  const std::vector<std::string> names{"speed", "torque", "share"};
  const auto cell = [&](const std::string& text) {
    const HeaderCell found = header_cell(text, names);
    return found.name + "|" + found.unit;
  };
  EXPECT_EQ(cell("speed_rpm"), "speed|rpm");
  EXPECT_EQ(cell("torque_N_m"), "torque|N.m");
  EXPECT_EQ(cell("torque [N.m]"), "torque|N.m");
  EXPECT_EQ(cell("torque (kN m)"), "torque|kN.m");
  EXPECT_EQ(cell("speed_rad_per_s"), "speed|rad/s");
  EXPECT_EQ(cell("share"), "share|");
  EXPECT_EQ(cell("shares"), "|");
}

class SpectrumFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("orbearing_rows_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "case.yaml") << text_of(shipped_path()) << "\nspectrum: {file: loads.csv}\n";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  ResolvedCase with(const std::string& rows) {
    std::ofstream(folder_ / "loads.csv") << rows;
    return read_case((folder_ / "case.yaml").string());
  }
  std::string fault_of(const std::string& rows) {
    try {
      with(rows);
    } catch (const BadInput& error) {
      return error.messages.front();
    }
    return "";
  }

  std::filesystem::path folder_;
};

TEST_F(SpectrumFile, IsTheSameAsItsRows) {
  const LoadSpectrum rows = spectrum_of(kTwoRows);
  const ResolvedCase by_file = with(
      "# of a test\nspeed_rpm,torque [N.m],share\r\n6000, 238.73241463784300,0.25\n\n3000,100,\"0.75\"\n");
  const LoadSpectrum found = *load_spectrum(by_file);
  ASSERT_EQ(found.bins.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(found.bins[i].power, rows.bins[i].power, 1e-12 * rows.bins[i].power);
    EXPECT_EQ(found.bins[i].speed, rows.bins[i].speed);
    EXPECT_EQ(found.bins[i].share, rows.bins[i].share);
  }
  // The resolved case holds the rows: it needs the file no more.
  const ResolvedCase again = parse_case(write_resolved(by_file), "elsewhere.yaml", {});
  EXPECT_EQ(again.list(kSpectrumPath), by_file.list(kSpectrumPath));
}

TEST_F(SpectrumFile, CellsMayHaveUnitsOfTheirOwn) {
  const LoadSpectrum found =
      *load_spectrum(with("power,speed,hours\n150 kW,6000 rpm,12\n75 kW,300 rad/s,1 d\n"));
  EXPECT_EQ(found.bins.size(), 2U);
}

TEST_F(SpectrumFile, WrongOnesAreReportedByFileLineAndColumn) {
  const std::string file = (folder_ / "loads.csv").string();
  EXPECT_THAT(fault_of("speed_rpm,torque_N_m,share\n6000,238,0.25\n3000,ten,0.75\n"),
              AllOf(StartsWith(file + ":3:6: spectrum: "), HasSubstr("ten"), HasSubstr("required")));
  EXPECT_THAT(fault_of("speed_rpm,torque,share\n6000,238,1\n"),
              AllOf(StartsWith(file + ":2:6: "), HasSubstr("torque")));
  EXPECT_THAT(fault_of("speed_rpm,torque_N_m,part\n6000,238,1\n"),
              AllOf(StartsWith(file + ":1:22: "), HasSubstr("part")));
  EXPECT_THAT(fault_of("speed_rpm,torque_N_m,share\n6000,238\n"), StartsWith(file + ":2:1: "));
  EXPECT_THAT(fault_of("speed_rpm,torque_N_m,share\n"), HasSubstr("no rows"));
  EXPECT_THAT(fault_of("speed_rpm,torque_N_m\n6000,238\n"),
              AllOf(StartsWith(file + ":2:1: "), HasSubstr("no share or hours")));
  EXPECT_THAT(fault_of("speed_rpm,torque_N_m,share\n6000,238,0.9\n"), HasSubstr("add up to 0.9"));
  // Decimal commas in a file separated by commas, and a file that is no table.
  EXPECT_THAT(fault_of("speed_rpm,torque_N_m,share\n6000,238,5,0,25\n3000,100,5,0,75\n"),
              AllOf(StartsWith(file + ":2:12: "), HasSubstr("5 values"), HasSubstr("decimal comma")));
  EXPECT_THAT(fault_of("token=hunter2\n6000\n"),
              AllOf(StartsWith(file + ":1:1: "), HasSubstr("names none"), Not(HasSubstr("hunter2"))));
  // Decimal commas are read where they are unambiguous.
  EXPECT_EQ(fault_of("speed_rpm;torque_N_m;share\n6000;238,5;1\n"), "");
  EXPECT_THAT(fault_of("speed_rpm;torque_N_m;share\n6.000;238;1\n"),
              StartsWith(file + ":2:1: spectrum: '6.000', whose mark"));
  EXPECT_THAT(fault_of("speed_rpm,torque_N_m,share\n6000,238,\xff\n"), HasSubstr(":2:10: spectrum: share: "));
  EXPECT_THAT(setting_mistakes({"spectrum={file: nothing.csv}"}), Contains(HasSubstr("nothing.csv")));
  EXPECT_THAT(setting_mistakes({"spectrum={fil: loads.csv}"}),
              Contains(HasSubstr("{file: NAME.csv} is required")));
}

}  // namespace
}  // namespace orbearing::app::spectrum_case_test
