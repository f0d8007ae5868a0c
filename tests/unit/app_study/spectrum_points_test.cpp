// Points that a load spectrum adds to a sweep.
#include <gtest/gtest.h>

#include "app/case/case_file.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app::spectrum_points_test {
namespace {

// A setting that has both a text and a number states one value.
TEST(SpectrumPoints, HaveTextsThatAreTheirNumbers) {
  const ResolvedCase in = read_case(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml",
                                    {"spectrum=[{power: 150 kW, speed: 6000 rpm, share: 0.5}, {power: 120 "
                                     "kW, speed: 3000 rpm, share: 0.5}]",
                                     "sweep={bearing.radial_clearance: [0 um, 20 um]}"});
  const SweepRequest request = sweep_request(in, "quasi-static");
  ASSERT_EQ(request.points.size(), 6U);
  int compared = 0;
  for (const SweepPoint& point : request.points)
    for (const Setting& setting : point.settings) {
      if (!setting.number || setting.text.empty()) continue;
      const double by_text = in.with({Setting{setting.path, setting.text}}).quantity(setting.path);
      EXPECT_NEAR(by_text, *setting.number, 1e-9 * std::abs(*setting.number))
          << setting.path << "=" << setting.text;
      ++compared;
    }
  EXPECT_GE(compared, 4);
}

}  // namespace
}  // namespace orbearing::app::spectrum_points_test
