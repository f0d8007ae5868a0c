// What is made of a case is made once, and anew for each changed copy.
#include <gtest/gtest.h>

#include <stdexcept>

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

TEST(ReadOnce, NothingIsKeptOfAFailure) {
  const ResolvedCase in = reducer();
  EXPECT_THROW((void)in.once<int>([]() -> int { throw std::runtime_error("no"); }), std::runtime_error);
  EXPECT_EQ(in.once<int>([] { return 7; }), 7);
}

TEST(ReadOnce, OfASweepAndOfItsPoint) {
  const ResolvedCase in =
      read_case(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml", {"sweep.input.speed=[1000 rpm]"});
  EXPECT_EQ(&stated_drivetrain(in), [&] {
    const ResolvedCase point = in.without_sweep();
    EXPECT_TRUE(point.axes().empty());
    return &stated_drivetrain(point);
  }());
  const ResolvedCase whole = in.without_sweep(), same = whole.without_sweep();
  EXPECT_EQ(&whole.data(), &same.data());
}

// What is not stated yet may be missing in one and not in the other.
TEST(ReadOnce, AsFarAsStatedIsAnother) {
  const ResolvedCase in = reducer();
  EXPECT_NE(&stated_drivetrain(in), &stated_drivetrain(in, Missing::left_out));
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
