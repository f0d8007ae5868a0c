#include "mechanics/item_set.hpp"

#include <gtest/gtest.h>

namespace orbearing::mechanics {
namespace {

enum class Letter : unsigned { a, b, c, last = 63 };
using Letters = ItemSet<Letter>;

TEST(ItemSet, HoldsTheItemsThatItWasMadeOf) {
  const Letters set{Letter::a, Letter::last};
  EXPECT_TRUE(set.has(Letter::a));
  EXPECT_FALSE(set.has(Letter::b));
  EXPECT_TRUE(set.has(Letter::last));
  EXPECT_TRUE(Letters().is_empty());
  EXPECT_FALSE(Letters(Letter::a).is_empty());
  EXPECT_TRUE(Letters::all().has(Letter::c));
}

TEST(ItemSet, IsJoinedAndCut) {
  const Letters ab{Letter::a, Letter::b}, bc{Letter::b, Letter::c};
  EXPECT_EQ(ab | bc, (Letters{Letter::a, Letter::b, Letter::c}));
  EXPECT_EQ(ab & bc, Letters(Letter::b));
  EXPECT_EQ(ab.without(bc), Letters(Letter::a));
  EXPECT_TRUE(ab.has_some_of(bc));
  EXPECT_FALSE(ab.has_some_of(Letter::c));
  Letters grown;
  grown |= Letter::c;
  EXPECT_EQ(grown, Letters(Letter::c));
}

}  // namespace
}  // namespace orbearing::mechanics
