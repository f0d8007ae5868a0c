#include "app/results/point_file.hpp"

#include <gtest/gtest.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <cmath>

#include "app/errors.hpp"
#include "tests/messages.hpp"
#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app::point_file_test {
namespace {

/// A netCDF file read from its bytes.
class ReadFile {
 public:
  explicit ReadFile(std::string bytes) : bytes_(std::move(bytes)) {
    EXPECT_EQ(nc_open_mem("read", NC_NOWRITE, bytes_.size(), bytes_.data(), &number_), NC_NOERR);
  }
  ReadFile(const ReadFile&) = delete;
  ReadFile& operator=(const ReadFile&) = delete;
  ~ReadFile() { nc_close(number_); }

  int variable(const std::string& name) const {
    int id = -1;
    EXPECT_EQ(nc_inq_varid(number_, name.c_str(), &id), NC_NOERR) << name;
    return id;
  }
  bool has(const std::string& name) const {
    int id = -1;
    return nc_inq_varid(number_, name.c_str(), &id) == NC_NOERR;
  }
  std::vector<double> values(const std::string& name, std::size_t count) const {
    std::vector<double> values(count);
    EXPECT_EQ(nc_get_var_double(number_, variable(name), values.data()), NC_NOERR);
    return values;
  }
  std::string attribute(int variable, const char* name) const {
    std::size_t length = 0;
    EXPECT_EQ(nc_inq_attlen(number_, variable, name, &length), NC_NOERR) << name;
    std::string text(length, ' ');
    EXPECT_EQ(nc_get_att_text(number_, variable, name, text.data()), NC_NOERR) << name;
    return text;
  }
  std::size_t dimension(const char* name) const {
    int id = -1;
    std::size_t length = 0;
    EXPECT_EQ(nc_inq_dimid(number_, name, &id), NC_NOERR) << name;
    nc_inq_dimlen(number_, id, &length);
    return length;
  }
  int number() const { return number_; }

 private:
  std::string bytes_;
  int number_ = -1;
};

analysis::PointResult failed_result() {
  analysis::PointResult result;
  result.input_speed = fake_sweep::input_speed_of(3);
  result.status = "no balance";
  return result;
}

TEST(PointFile, HoldsScalarsInSiAndLoadsByLocation) {
  const analysis::PointResult result = fake_sweep::fake_result(3);
  const ReadFile file(netcdf_bytes(point_content(fake_sweep::fake_header(5), 3, {}, result)));
  EXPECT_EQ(file.values("input_speed", 1).front(), result.input_speed);
  EXPECT_EQ(file.values("inner_life", 1).front(), result.inner.life);
  EXPECT_EQ(file.attribute(file.variable("input_speed"), "units"), "rad s-1");
  EXPECT_EQ(file.attribute(file.variable("inner_life"), "units"), "revolution");
  EXPECT_EQ(file.dimension("place"), 3U);
  EXPECT_EQ(file.values("angle", 3), result.distribution.angle);
  EXPECT_EQ(file.values("inner_load", 3), result.distribution.inner_load);
  EXPECT_EQ(file.values("outer_load", 3), result.distribution.outer_load);
  EXPECT_EQ(file.attribute(NC_GLOBAL, "case_hash"), "0123456789abcdef");
  EXPECT_EQ(file.attribute(NC_GLOBAL, "status"), "ok");
}

// Each variable holds its own number.
TEST(PointFile, HoldsBearingsPlanetsAndLaminaeUnderTheirNames) {
  using Values = std::vector<double>;
  analysis::PointResult result = fake_sweep::fake_result(3);
  result.seats = {{-0.01, 11.0, {1e-3, 2e-3}, 21.0}, {0.01, 12.0, {3e-3, 4e-3}, 22.0}};
  result.planets = {{0.9, 101.0, 201.0}, {1.1, 102.0, 202.0}};
  result.laminae = analysis::LaminaRecord{.lamina_position = {-2e-3, 2e-3},
                                          .inner_load = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0},
                                          .outer_load = {7.0, 8.0, 9.0, 10.0, 11.0, 12.0},
                                          .roller_tilt = {0.1, 0.2, 0.3}};
  const ReadFile file(netcdf_bytes(point_content(fake_sweep::fake_header(5), 3, {}, result)));
  EXPECT_EQ(file.values("bearing_place", 2), (Values{-0.01, 0.01}));
  EXPECT_EQ(file.values("bearing_load", 2), (Values{11.0, 12.0}));
  EXPECT_EQ(file.values("bearing_tilt_x", 2), (Values{1e-3, 3e-3}));
  EXPECT_EQ(file.values("bearing_tilt_y", 2), (Values{2e-3, 4e-3}));
  EXPECT_EQ(file.values("bearing_life", 2), (Values{21.0, 22.0}));
  EXPECT_EQ(file.values("planet_load_share", 2), (Values{0.9, 1.1}));
  EXPECT_EQ(file.values("planet_bearing_load", 2), (Values{101.0, 102.0}));
  EXPECT_EQ(file.values("planet_life", 2), (Values{201.0, 202.0}));
  EXPECT_EQ(file.values("lamina_place", 2), result.laminae->lamina_position);
  EXPECT_EQ(file.values("inner_lamina_load", 6), result.laminae->inner_load);
  EXPECT_EQ(file.values("outer_lamina_load", 6), result.laminae->outer_load);
  EXPECT_EQ(file.values("roller_tilt", 3), result.laminae->roller_tilt);
}

TEST(PointFile, EveryVariableStatesItsUnitAndMeaning) {
  const ReadFile file(
      netcdf_bytes(point_content(fake_sweep::fake_header(5), 3, {}, fake_sweep::fake_result(3))));
  int count = 0;
  nc_inq_nvars(file.number(), &count);
  const std::size_t texts = 2;  // status and refined
  ASSERT_EQ(static_cast<std::size_t>(count),
            record_of(ManifestHeader{}, SweepRow{}).entries().size() - texts + 3);
  for (int variable = 0; variable < count; ++variable) {
    EXPECT_FALSE(file.attribute(variable, "units").empty());
    EXPECT_FALSE(file.attribute(variable, "long_name").empty());
  }
}

TEST(PointFile, FailedPointHasSpeedAxesAndReason) {
  ManifestHeader header = fake_sweep::fake_header(5);
  header.axes = {{"bearing.radial_clearance_um", "um", "clearance"}};
  const ReadFile file(netcdf_bytes(point_content(header, 3, {37.0}, failed_result())));
  EXPECT_EQ(file.attribute(NC_GLOBAL, "status"), "no balance");
  EXPECT_EQ(file.values("input_speed", 1).front(), fake_sweep::input_speed_of(3));
  EXPECT_EQ(file.values("bearing_radial_clearance_um", 1).front(), 37.0);
  EXPECT_TRUE(std::isnan(file.values("life", 1).front()));
  EXPECT_FALSE(file.has("inner_load"));
}

TEST(PointFile, TakesSeriesOverSeveralDimensions) {
  constexpr std::size_t times = 500;
  constexpr std::size_t rollers = 15;
  NamedArray series{"load", {"time", "roller"}, "N", "load of a roller", {}};
  for (std::size_t i = 0; i < times * rollers; ++i)
    series.values.push_back(std::sqrt(static_cast<double>(i)));
  const ReadFile file(netcdf_bytes({{{"time", times}, {"roller", rollers}}, {series}, {}}));
  EXPECT_EQ(file.dimension("time"), times);
  EXPECT_EQ(file.values("load", times * rollers), series.values);
}

TEST(PointFile, SameContentGivesTheSameBytes) {
  const PointContent content = point_content(fake_sweep::fake_header(5), 3, {}, fake_sweep::fake_result(3));
  EXPECT_EQ(netcdf_bytes(content), netcdf_bytes(content));
}

TEST(PointFile, TwoVariablesOfOneNameAreAnErrorOfTheLibrary) {
  const NamedArray array{"load", {}, "N", "load", {1.0}};
  EXPECT_REFUSED(ComputationFailed, "point file", netcdf_bytes({{}, {array, array}, {}}));
}

}  // namespace
}  // namespace orbearing::app::point_file_test
