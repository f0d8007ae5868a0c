#include "app/case/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <array>
#include <cassert>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "app/case/printable.hpp"

namespace orbearing::app {

namespace {

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;
using Converter = std::unique_ptr<cv_converter, FreeConverter>;

// udunits2 keeps state of its own (status, parser): one caller at a time.
std::mutex& udunits_mutex() {
  static std::mutex mutex;
  return mutex;
}

ut_system* open_unit_system() {
  ut_set_error_message_handler(ut_ignore);
  ut_system* system = ut_read_xml(nullptr);
  if (system == nullptr) return nullptr;
  // udunits2 knows "degree" only.
  const Unit degree(ut_parse(system, "degree", UT_UTF8));
  ut_map_name_to_unit("deg", UT_UTF8, degree.get());
  return system;
}

// Lives as long as the program: units refer to it.
ut_system* unit_system() {
  static ut_system* const system = open_unit_system();
  return system;
}

Unit parse_unit(std::string_view text) {
  return Unit(ut_parse(unit_system(), std::string(text).c_str(), UT_UTF8));
}

std::string_view trim(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// udunits2 multiplies by bare numbers and shifts origins inside a unit ("mm 10", "K @ 5"); a slip of the
// keyboard must not do so. Digits may only be exponents, and a leading "1/" is allowed.
bool is_plain_unit(std::string_view unit) {
  if (unit.starts_with("1/")) unit.remove_prefix(2);
  if (unit.empty() || unit.find('@') != std::string_view::npos) return false;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (!is_digit(unit[i])) continue;
    std::size_t base = i;
    while (base > 0 && (unit[base - 1] == '^' || unit[base - 1] == '-' || is_digit(unit[base - 1]))) --base;
    if (base == 0 || std::isalpha(static_cast<unsigned char>(unit[base - 1])) == 0) return false;
  }
  return true;
}

// udunits2 converts a unit to its reciprocal too: m-1 to m.
bool same_dimension(const ut_unit* unit, const ut_unit* target) {
  const Unit ratio(ut_divide(unit, target));
  return ratio && ut_is_dimensionless(ratio.get()) != 0;
}

// Counts radians, which udunits2 takes for 1: Hz / (rad/s) leaves some over.
bool same_angle_content(const ut_unit* unit, const ut_unit* target) {
  const Unit ratio(ut_divide(unit, target));
  if (!ratio) return false;
  std::array<char, 256> text{};
  const int length = ut_format(ratio.get(), text.data(), text.size(), UT_ASCII | UT_DEFINITION);
  return length >= 0 && std::string_view(text.data()).find("rad") == std::string_view::npos;
}

Reading<double> fault(std::string text) {
  return {std::nullopt, std::move(text)};
}

// How numbers of one unit become those of another, or why they cannot.
struct Conversion {
  Converter converter{};
  std::string fault{};
};

Conversion no_conversion(std::string text) {
  return {nullptr, std::move(text)};
}

Conversion make_conversion(std::string_view unit, std::string_view target_unit) {
  const std::lock_guard lock(udunits_mutex());
  if (unit_system() == nullptr) return no_conversion("the unit database of udunits2 cannot be read");
  const Unit target = parse_unit(target_unit);
  assert(target && "unit of the field table");
  const Unit parsed = is_plain_unit(unit) ? parse_unit(unit) : nullptr;
  if (!parsed) return no_conversion(fmt::format("its unit {} is not known", quote(unit)));
  if (!same_dimension(parsed.get(), target.get()))
    return no_conversion(
        fmt::format("its unit {} does not measure the same as '{}'", quote(unit), target_unit));
  if (!same_angle_content(parsed.get(), target.get()))
    return no_conversion(fmt::format("its unit {} does not say how much angle one unit is, as '{}' does",
                                     quote(unit), target_unit));
  Converter converter(ut_get_converter(parsed.get(), target.get()));
  if (!converter || cv_convert_double(converter.get(), 0.0) != 0.0)
    return no_conversion(fmt::format("its unit {} has a zero point of its own", quote(unit)));
  return {std::move(converter), {}};
}

Reading<double> converted(double value, const Conversion& conversion) {
  if (!conversion.converter) return fault(conversion.fault);
  const double result = cv_convert_double(conversion.converter.get(), value);
  if (!std::isfinite(result)) return fault("its value is too large");
  return {result, {}};
}

}  // namespace

Reading<double> read_number(std::string_view text) {
  const Reading<WrittenQuantity> written = split_quantity(text);
  if (!written.value) return fault(written.fault);
  if (!written.value->unit.empty()) return fault("it is not a number alone");
  return {written.value->value, {}};
}

Reading<WrittenQuantity> split_quantity(std::string_view text) {
  text = trim(text);
  std::string_view digits = text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  const std::string_view magnitude = digits.substr(text.starts_with('-') ? 1 : 0);
  // from_chars would take "inf" and "nan", and "+-3" after the plus is gone.
  if (magnitude.empty() || !(is_digit(magnitude[0]) || magnitude[0] == '.'))
    return {std::nullopt, "it does not begin with a finite number"};
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) return {std::nullopt, "its number is too large or too small"};
  if (error != std::errc{}) return {std::nullopt, "it does not begin with a finite number"};
  const std::string_view rest(end, static_cast<std::size_t>(digits.data() + digits.size() - end));
  if (rest.starts_with(',')) return {std::nullopt, "a number has a decimal point and no commas"};
  return {WrittenQuantity{value, std::string(trim(rest))}, {}};
}

// A study converts the same few units in every variant: those that are known are kept, each thread its own.
Reading<double> convert(double value, std::string_view unit, std::string_view target_unit) {
  if (unit == target_unit) return {value, {}};
  thread_local std::map<std::pair<std::string, std::string>, Conversion> known;
  std::pair<std::string, std::string> units(unit, target_unit);
  const auto found = known.find(units);
  if (found != known.end()) return converted(value, found->second);
  Conversion conversion = make_conversion(unit, target_unit);
  const Reading<double> result = converted(value, conversion);
  if (conversion.converter) known.emplace(std::move(units), std::move(conversion));
  return result;
}

Reading<double> read_quantity(std::string_view text, const Dimension& dimension) {
  const Reading<WrittenQuantity> written = split_quantity(text);
  if (!written.value) return fault(written.fault);
  if (written.value->unit.empty())
    return fault(
        fmt::format("it has no unit, write it as in '{} {}'", shortened(trim(text)), dimension.customary));
  return convert(written.value->value, written.value->unit, dimension.si);
}

}  // namespace orbearing::app
