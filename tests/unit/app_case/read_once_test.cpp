// What is made of a case is made once, and anew for each changed copy.
#include <gtest/gtest.h>

#include "app/case/case_file.hpp"
#include "app/case/drivetrain_reader.hpp"
#include "app/case/resolved_case.hpp"

namespace orbearing::app {
namespace {

ResolvedCase reducer() {
  return read_point(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml", {});
}

TEST(ReadOnce, CopiesShareWhatWasMade) {
  const ResolvedCase in = reducer(), copy = in;
  int made = 0;
  const auto make = [&] { return ++made; };
  EXPECT_EQ(in.once<int>(make), 1);
  EXPECT_EQ(copy.once<int>(make), 1);
  EXPECT_EQ(&stated_drivetrain(in), &stated_drivetrain(copy));
  EXPECT_EQ(made, 1);
}

TEST(ReadOnce, AChangedCopyIsReadAnew) {
  const ResolvedCase in = reducer();
  const double power = stated_drivetrain(in).drive.power;
  const ResolvedCase half = in.with("input.power", 0.5 * power);
  EXPECT_EQ(stated_drivetrain(half).drive.power, 0.5 * power);
  EXPECT_EQ(stated_drivetrain(in).drive.power, power);
}

TEST(ReadOnce, NothingChangedIsTheSameCase) {
  const ResolvedCase in = reducer(), same = in.with(std::vector<Setting>{});
  EXPECT_EQ(&same.data(), &in.data());
}

}  // namespace
}  // namespace orbearing::app
