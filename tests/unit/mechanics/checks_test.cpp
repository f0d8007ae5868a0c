#include "mechanics/checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/messages.hpp"

namespace orbearing::mechanics::checks_test {
namespace {

using ::testing::ThrowsMessage;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(Checks, SayWhatWasFoundAndWhatIsRequired) {
  EXPECT_THAT([] { require(false, "gap [m]", 0.25, "0 or more"); },
              ThrowsMessage<std::invalid_argument>("gap [m]: found 0.25; required: 0 or more"));
  EXPECT_THAT([] { refuse("rollers", 1, "at least 2"); },
              ThrowsMessage<std::invalid_argument>("rollers: found 1; required: at least 2"));
  EXPECT_NO_THROW(require(true, "gap [m]", 0.25, "0 or more"));
}

TEST(Checks, NothingThatIsNoNumberPasses) {
  for (const double value : {kNaN, kInfinite, -kInfinite, -1.0}) {
    EXPECT_REFUSED(std::invalid_argument, "checks 1", require_positive(value, "a")) << value;
    EXPECT_REFUSED(std::invalid_argument, "checks 2", require_not_negative(value, "a")) << value;
  }
  EXPECT_REFUSED(std::invalid_argument, "checks 3", require_positive(0.0, "a"));
  EXPECT_NO_THROW(require_not_negative(0.0, "a"));
  EXPECT_NO_THROW(require_positive(std::numeric_limits<double>::min(), "a"));
}

}  // namespace
}  // namespace orbearing::mechanics::checks_test
