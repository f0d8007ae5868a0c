// Keys of the members of a structure: a member is named in code, which the compiler checks, and the text that
// a case has for it follows from its row (mechanics/described.hpp).
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <typeinfo>
#include <variant>
#include <vector>

#include "mechanics/append.hpp"
#include "mechanics/described.hpp"

namespace orbearing::mechanics {

/// Keys of all members that have a row, by their addresses in `of`, which has to outlive it.
template <class Struct>
class MemberKeys {
 public:
  explicit MemberKeys(const Struct& of) : of_(of) {}

  /// Throws std::logic_error for a member without a row.
  template <class Member>
  const std::string& operator()(const Member& member) const {
    if (keys_.empty()) collect();
    const auto there =
        std::ranges::equal_range(keys_, static_cast<const void*>(&member), std::less<>(), &Key::address);
    const auto found =
        std::ranges::find_if(there, [](const Key& one) { return *one.type == typeid(Member); });
    if (found == there.end()) throw std::logic_error("a member without a row was asked for its key");
    return found->text;
  }

  /// Keys of those of the members that have a row.
  template <class... Members>
  std::vector<std::string> of(const Members&... members) const {
    std::vector<std::string> found;
    (append(within(members), found), ...);
    return found;
  }

  /// Keys of all members within a part.
  template <class Part>
  std::vector<std::string> within(const Part& part) const {
    if (keys_.empty()) collect();
    const void *begin = &part, *end = &part + 1;
    std::vector<std::string> found;
    const auto from = std::ranges::lower_bound(keys_, begin, std::less<>(), &Key::address);
    const auto to = std::ranges::lower_bound(keys_, end, std::less<>(), &Key::address);
    std::transform(from, to, std::back_inserter(found), [](const Key& one) { return one.text; });
    return found;
  }

 private:
  struct Key {
    const void* address;
    const std::type_info* type;  // a structure and its first member have one address
    std::string text;
  };

  /// A visitor that keeps addresses.
  struct Collector {
    std::vector<Key>& keys;
    template <class Member>
    void operator()(Member& member, const described::Facts& facts) {
      keys.push_back({&member, &typeid(Member), facts.path});
    }
    template <class Self, class Variant>
    void choose(Self& self, Variant& member, const described::Facts& facts) {
      keys.push_back({&member, &typeid(Variant), facts.path});
      choose_by_inputs(self, member);
    }
    template <class Self, class Variant>
    void choose_by_inputs(Self& self, Variant& member) {
      std::visit([&](auto& chosen) { describe(self, chosen); }, member);
    }
  };

  void collect() const {
    Collector visit{keys_};
    describe(visit, const_cast<Struct&>(of_));  // a visitor may change members, and this one does not
    std::ranges::stable_sort(keys_, std::less<>(), &Key::address);
  }

  const Struct& of_;
  mutable std::vector<Key> keys_;
};

/// The key of one member, by a function from the structure to it.
template <class Struct, class Member>
std::string key_of(const Member& member) {
  const Struct structure{};
  return MemberKeys(structure)(member(structure));
}

}  // namespace orbearing::mechanics
