// Sets of the items of an enumeration whose values are numbers from 0 on.
#pragma once

#include <cassert>
#include <cstdint>
#include <initializer_list>

namespace orbearing::mechanics {

/// Up to 64 items. An item converts to the set of itself.
template <class Item>
class ItemSet {
 public:
  constexpr ItemSet() = default;
  constexpr ItemSet(Item one) : bits_(bit_of(one)) {}
  constexpr ItemSet(std::initializer_list<Item> items) {
    for (const Item item : items) bits_ |= bit_of(item);
  }
  /// Also numbers that no item has.
  static constexpr ItemSet all() {
    ItemSet set;
    set.bits_ = ~std::uint64_t{0};
    return set;
  }

  constexpr bool has(Item item) const { return (bits_ & bit_of(item)) != 0; }
  constexpr bool has_some_of(ItemSet others) const { return (bits_ & others.bits_) != 0; }
  constexpr bool is_empty() const { return bits_ == 0; }
  constexpr ItemSet without(ItemSet others) const { return of_bits(bits_ & ~others.bits_); }

  constexpr ItemSet& operator|=(ItemSet others) {
    bits_ |= others.bits_;
    return *this;
  }
  friend constexpr ItemSet operator|(ItemSet some, ItemSet others) {
    return of_bits(some.bits_ | others.bits_);
  }
  friend constexpr ItemSet operator&(ItemSet some, ItemSet others) {
    return of_bits(some.bits_ & others.bits_);
  }
  bool operator==(const ItemSet&) const = default;

 private:
  static constexpr ItemSet of_bits(std::uint64_t bits) {
    ItemSet set;
    set.bits_ = bits;
    return set;
  }
  static constexpr std::uint64_t bit_of(Item item) {
    assert(static_cast<unsigned>(item) < 64u);
    return std::uint64_t{1} << static_cast<unsigned>(item);
  }

  std::uint64_t bits_ = 0;
};

}  // namespace orbearing::mechanics
