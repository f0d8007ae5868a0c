// Parts of the C++20 library that Debian's emscripten 3.1.6 does not have and the sources use. Included
// before each of them by the compiler (engine.cmake); nothing is added where the library has it.
#pragma once

#include <version>

#include "elliptic_integrals.hpp"

#if !defined(__cpp_lib_to_chars)
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace std {

inline to_chars_result to_chars(char* first, char* last, double value, chars_format form, int digits) {
  const size_t room = static_cast<size_t>(last - first) + 1;  // and the zero that ends a string of C
  string text(room, '\0');
  const char* const pattern = form == chars_format::fixed     ? "%.*f"
                              : form == chars_format::general ? "%.*g"
                                                              : "%.*e";
  const int length = snprintf(text.data(), room, pattern, digits, value);
  if (length < 0 || length > last - first) return {last, errc::value_too_large};
  return {copy_n(text.data(), length, first), errc{}};
}

/// A decimal number: of what strtod takes besides (blanks, plus, hexadecimal, inf, nan) there is none in it.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const auto digit = [&](const char* at) { return at != last && *at >= '0' && *at <= '9'; };
  const auto behind_digits = [&](const char* at) {
    while (digit(at)) ++at;
    return at;
  };
  const char* const whole = first != last && *first == '-' ? first + 1 : first;
  const char* end = behind_digits(whole);
  if (end != last && *end == '.' && (end != whole || digit(end + 1))) end = behind_digits(end + 1);
  if (end == whole) return {first, errc::invalid_argument};
  if (end != last && (*end == 'e' || *end == 'E')) {
    const char* const power = end + 1 != last && (end[1] == '+' || end[1] == '-') ? end + 2 : end + 1;
    if (digit(power)) end = behind_digits(power);
  }
  errno = 0;
  const double read = strtod(string(first, end).c_str(), nullptr);
  if (errno == ERANGE) return {end, errc::result_out_of_range};
  value = read;
  return {end, errc{}};
}

}  // namespace std
#endif

#if !defined(__cpp_lib_ranges)
#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace std::ranges {

struct Same {
  template <class T>
  constexpr T&& operator()(T&& value) const {
    return std::forward<T>(value);
  }
};

template <class Range, class Holds, class Part = Same>
constexpr auto find_if(Range&& range, Holds holds, Part part = {}) {
  return std::find_if(std::begin(range), std::end(range),
                      [&](auto&& one) -> bool { return std::invoke(holds, std::invoke(part, one)); });
}
template <class Range, class Value, class Part = Same>
constexpr auto find(Range&& range, const Value& value, Part part = {}) {
  return ranges::find_if(
      range, [&](const auto& one) { return one == value; }, part);
}
template <class Range, class Holds, class Part = Same>
constexpr bool any_of(Range&& range, Holds holds, Part part = {}) {
  return ranges::find_if(range, holds, part) != std::end(range);
}
template <class Range, class Holds, class Part = Same>
constexpr bool none_of(Range&& range, Holds holds, Part part = {}) {
  return !ranges::any_of(range, holds, part);
}

template <class Range, class Holds, class Part = Same>
constexpr bool all_of(Range&& range, Holds holds, Part part = {}) {
  return ranges::none_of(range, std::not_fn(holds), part);
}
template <class Range, class Holds, class Part = Same>
constexpr auto find_if_not(Range&& range, Holds holds, Part part = {}) {
  return ranges::find_if(range, std::not_fn(holds), part);
}
template <class Range, class Holds, class Part = Same>
constexpr auto count_if(Range&& range, Holds holds, Part part = {}) {
  return std::count_if(std::begin(range), std::end(range),
                       [&](auto&& one) -> bool { return std::invoke(holds, std::invoke(part, one)); });
}

struct Before {
  template <class A, class B>
  constexpr bool operator()(const A& a, const B& b) const {
    return a < b;
  }
};
template <class Range, class Less = Before, class Part = Same>
constexpr auto min_element(Range&& range, Less less = {}, Part part = {}) {
  return std::min_element(std::begin(range), std::end(range), [&](const auto& a, const auto& b) {
    return std::invoke(less, std::invoke(part, a), std::invoke(part, b));
  });
}
template <class Range, class Less = Before, class Part = Same>
constexpr auto max_element(Range&& range, Less less = {}, Part part = {}) {
  return std::max_element(std::begin(range), std::end(range), [&](const auto& a, const auto& b) {
    return std::invoke(less, std::invoke(part, a), std::invoke(part, b));
  });
}
template <class Range>
constexpr auto min(Range&& range) {
  return *ranges::min_element(range);
}
template <class Range, class Less = Before, class Part = Same>
constexpr auto max(Range&& range, Less less = {}, Part part = {}) {
  return *ranges::max_element(range, less, part);
}
template <class Value>
struct MinMax {
  Value min, max;
};
template <class Range>
constexpr auto minmax(Range&& range) {
  const auto [least, most] = std::minmax_element(std::begin(range), std::end(range));
  return MinMax<std::decay_t<decltype(*least)>>{*least, *most};
}
template <class First, class Second>
struct FirstApart {
  First in1;
  Second in2;
};
template <class Range, class Other>
constexpr auto mismatch(Range&& range, Other&& other) {
  const auto [one, two] =
      std::mismatch(std::begin(range), std::end(range), std::begin(other), std::end(other));
  return FirstApart<std::decay_t<decltype(one)>, std::decay_t<decltype(two)>>{one, two};
}
template <class Range, class Less = Before, class Part = Same>
void stable_sort(Range&& range, Less less = {}, Part part = {}) {
  std::stable_sort(std::begin(range), std::end(range), [&](const auto& a, const auto& b) {
    return std::invoke(less, std::invoke(part, a), std::invoke(part, b));
  });
}
template <class Range, class Less = Before, class Part = Same>
void sort(Range&& range, Less less = {}, Part part = {}) {
  std::sort(std::begin(range), std::end(range), [&](const auto& a, const auto& b) {
    return std::invoke(less, std::invoke(part, a), std::invoke(part, b));
  });
}
template <class Range, class Other, class Alike = std::equal_to<>>
constexpr bool equal(Range&& range, Other&& other, Alike same = {}) {
  return std::equal(std::begin(range), std::end(range), std::begin(other), std::end(other), same);
}
template <class Range, class Other>
constexpr bool is_permutation(Range&& range, Other&& other) {
  return std::is_permutation(std::begin(range), std::end(range), std::begin(other), std::end(other));
}
template <class Range, class Act>
constexpr void for_each(Range&& range, Act act) {
  std::for_each(std::begin(range), std::end(range), act);
}
template <class Range, class Out, class Change, class Part = Same>
constexpr void transform(Range&& range, Out out, Change change, Part part = {}) {
  for (auto&& one : range) *out++ = std::invoke(change, std::invoke(part, one));
}
template <class Iterator>
struct Stretch {
  Iterator first, last;
  constexpr Iterator begin() const { return first; }
  constexpr Iterator end() const { return last; }
};
template <class Range, class Value, class Less = Before, class Part = Same>
constexpr auto lower_bound(Range&& range, const Value& value, Less less = {}, Part part = {}) {
  return std::partition_point(std::begin(range), std::end(range), [&](const auto& one) {
    return std::invoke(less, std::invoke(part, one), value);
  });
}
template <class Range, class Value, class Less = Before, class Part = Same>
constexpr auto equal_range(Range&& range, const Value& value, Less less = {}, Part part = {}) {
  const auto first = ranges::lower_bound(range, value, less, part);
  return Stretch<std::decay_t<decltype(first)>>{
      first, std::partition_point(first, std::end(range), [&](const auto& one) {
        return !std::invoke(less, value, std::invoke(part, one));
      })};
}
template <class Range, class Value>
constexpr void replace(Range&& range, const Value& former, const Value& later) {
  std::replace(std::begin(range), std::end(range), former, later);
}

}  // namespace std::ranges
#endif

#if !defined(__cpp_lib_jthread)
#include <utility>

namespace std {

/// There is one thread: what is begun is done at once.
class jthread {
 public:
  template <class Work, class... Arguments>
  explicit jthread(Work&& work, Arguments&&... arguments) {
    std::forward<Work>(work)(std::forward<Arguments>(arguments)...);
  }
  void join() {}
};

}  // namespace std
#endif

#if !defined(__cpp_lib_three_way_comparison)
#include <compare>
#include <optional>
#include <string>

namespace std {

template <class Letter, class Traits, class Memory>
strong_ordering operator<=>(const basic_string<Letter, Traits, Memory>& a,
                            const basic_string<Letter, Traits, Memory>& b) {
  return a.compare(b) <=> 0;
}
template <class Value>
auto operator<=>(const optional<Value>& a, const optional<Value>& b) -> decltype(*a <=> *b) {
  if (a && b) return *a <=> *b;
  return a.has_value() <=> b.has_value();
}

}  // namespace std
#endif

#if !defined(__cpp_lib_bit_cast)
namespace std {
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
}  // namespace std
#endif
