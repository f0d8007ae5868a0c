#include "app/case/units.hpp"

#include <fmt/format.h>
#include <locale.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "app/case/common_units.hpp"
#include "orbearing/text.hpp"

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

/// The calling thread reads and writes numbers with a decimal point for as long as this lives: udunits2 reads
/// its database by the C library, which follows the locale that a host of the library has set.
class DecimalPoint {
 public:
  DecimalPoint() : point_(newlocale(LC_ALL_MASK, "C", nullptr)), before_(uselocale(point_)) {}
  ~DecimalPoint() {
    uselocale(before_);
    freelocale(point_);
  }
  DecimalPoint(const DecimalPoint&) = delete;
  DecimalPoint& operator=(const DecimalPoint&) = delete;

 private:
  locale_t point_;
  locale_t before_;
};

ut_system* open_unit_system() {
  ut_set_error_message_handler(ut_ignore);
  ut_system* system = ut_read_xml(nullptr);
  if (system == nullptr) return nullptr;
  // udunits2 has only "degree".
  const Unit degree(ut_parse(system, "degree", UT_UTF8));
  ut_map_name_to_unit("deg", UT_UTF8, degree.get());
  constexpr double metric_horsepower = 735.49875;  // [W]  75 kgf m/s
  const Unit watt(ut_parse(system, "W", UT_UTF8)), horsepower(ut_scale(metric_horsepower, watt.get()));
  ut_map_name_to_unit("pferdestaerke", UT_UTF8, horsepower.get());  // udunits2 has it rounded to 735.499 W
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

// Blanks, and those that word processors and PDF files put between number and unit.
constexpr std::string_view kBlanks[] = {" ", "\t", "\r", "\n", "\u00a0", "\u2007", "\u2009", "\u202f"};

std::string_view trim(std::string_view text) {
  const auto begins = [&](std::string_view blank) { return text.starts_with(blank); };
  const auto ends = [&](std::string_view blank) { return text.ends_with(blank); };
  for (const auto* blank = std::begin(kBlanks);
       (blank = std::find_if(std::begin(kBlanks), std::end(kBlanks), begins)) != std::end(kBlanks);)
    text.remove_prefix(blank->size());
  for (const auto* blank = std::begin(kBlanks);
       (blank = std::find_if(std::begin(kBlanks), std::end(kBlanks), ends)) != std::end(kBlanks);)
    text.remove_suffix(blank->size());
  return text;
}

/// Units of data sheets that udunits2 does not have, or reads as another unit, and their meaning where a
/// quantity of that SI unit is required: C is a coulomb elsewhere, 1/min a frequency, PS a petasiemens.
struct DataSheetUnit {
  std::string_view target;
  std::string_view written;
  std::string_view meant;
};
constexpr DataSheetUnit kDataSheetUnits[] = {{"rad/s", "1/min", "rpm"},
                                             {"rad/s", "min-1", "rpm"},
                                             {"rad/s", "min^-1", "rpm"},
                                             {"rad/s", "/min", "rpm"},
                                             {"rad/s", "r/min", "rpm"},
                                             {"rad/s", "rev/min", "rpm"},
                                             {"rad/s", "min\u207b\u00b9", "rpm"},
                                             {"degC", "C", "degC"},
                                             {"W", "PS", "pferdestaerke"},
                                             {"Pa.s", "cP", "mPa.s"},
                                             {"m2/s", "cSt", "mm2/s"},
                                             {"m", "mum", "um"},
                                             {"rad/s", "U/min", "rpm"},
                                             {"N.m", "Nm", "N.m"},
                                             {"N.m", "kNm", "kN.m"},
                                             {"N.m", "MNm", "MN.m"}};

std::string_view meant_unit(std::string_view unit, std::string_view target) {
  const auto found =
      std::find_if(std::begin(kDataSheetUnits), std::end(kDataSheetUnits),
                   [&](const DataSheetUnit& one) { return one.target == target && one.written == unit; });
  return found == std::end(kDataSheetUnits) ? unit : found->meant;
}

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// A temperature, or the difference of two, that is written in kelvin: no value of either is the other's.
std::optional<std::string> fault_of_kelvin(double value, std::string_view unit, std::string_view target) {
  if (target != dimension::temperature.si || (unit != "K" && unit != "kelvin")) return std::nullopt;
  constexpr double zero = 273.15, coldest = 100.0;  // [K]  of temperatures; less is a difference
  if (value < coldest)
    return fmt::format("temperatures are stated in degC: a difference of {:g} K as {:g} degC", value, value);
  return fmt::format("temperatures are stated in degC: {:g} K as {:.9g} degC", value, value - zero);
}

// "20 000": digits in groups of three behind the first blank, as tables print them.
std::optional<std::string> joined_groups(std::string_view number, std::string_view rest) {
  std::string joined(number);
  const auto begins_group = [&] {
    constexpr std::size_t group = 3;
    return rest.size() >= group && std::ranges::all_of(rest.substr(0, group), is_digit) &&
           (rest.size() == group || (!is_digit(rest[group]) && rest[group] != '/'));
  };
  if (!begins_group()) return std::nullopt;
  while (begins_group()) {
    joined += rest.substr(0, 3);
    rest = trim(rest.substr(3));
  }
  const char* between = rest.empty() || rest.starts_with('.') ? "" : " ";
  return fmt::format("{}{}{}", joined, between, rest);
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

// How numbers of one unit become those of another, or why they cannot: times `factor`, over `divisor`.
struct Conversion {
  double factor = 0.0;
  double divisor = 1.0;
  std::string fault{};
};

Conversion no_conversion(std::string text) {
  return {0.0, 1.0, std::move(text)};
}

// 80 um over 1e6 are 8e-05 m, times 1e-6 (which no double is) 7.999999999999999e-05 m.
Conversion round_conversion(double factor, double inverse) {
  constexpr double round_off = 1e-14, most = 1e15;  // whole numbers that a double holds
  const auto whole = [&](double value) {
    return value >= 1.0 && value < most && std::abs(value - std::round(value)) < round_off * value;
  };
  if (whole(factor)) return {std::round(factor), 1.0, {}};
  if (whole(inverse)) return {1.0, std::round(inverse), {}};
  return {factor, 1.0, {}};
}

// Quantities of inputs and records.
constexpr std::array kQuantities{dimension::length,
                                 dimension::angle,
                                 dimension::angular_speed,
                                 dimension::power,
                                 dimension::force,
                                 dimension::torque,
                                 dimension::mass,
                                 dimension::inertia,
                                 dimension::time,
                                 dimension::density,
                                 dimension::stress,
                                 dimension::viscosity,
                                 dimension::kinematic_viscosity,
                                 dimension::stiffness,
                                 dimension::speed,
                                 dimension::temperature,
                                 dimension::frequency,
                                 dimension::flow,
                                 dimension::conductance};

// " (it is one of torque)"; empty of a unit that measures none of them.
std::string quantity_of(std::string_view unit) {
  for (const Dimension& one : kQuantities) {
    const std::string_view meant = meant_unit(unit, one.si);
    const Unit parsed = is_plain_unit(meant) ? parse_unit(meant) : nullptr, si = parse_unit(one.si);
    if (parsed && si && same_dimension(parsed.get(), si.get()) && same_angle_content(parsed.get(), si.get()))
      return fmt::format(" (it is one of {})", one.name);
  }
  return "";
}

Conversion make_conversion(std::string_view unit, std::string_view target_unit) {
  const std::lock_guard lock(udunits_mutex());
  const DecimalPoint point;
  if (unit_system() == nullptr)
    return no_conversion(
        "the unit database of udunits2 cannot be read (Debian: libudunits2-data; UDUNITS2_XML_PATH may name "
        "another)");
  // Target unit: that of a field, which may be a number alone, or one that a page requests.
  const bool sound = is_plain_unit(target_unit) || read_number(target_unit).value.has_value();
  const Unit target = sound ? parse_unit(target_unit) : nullptr;
  if (!target) return no_conversion(fmt::format("the unit {} is not known", quote(target_unit)));
  const Unit parsed = is_plain_unit(unit) ? parse_unit(unit) : nullptr;
  const std::string other =
      parsed && same_dimension(parsed.get(), target.get()) ? std::string() : quantity_of(unit);
  if (!parsed && other.empty()) return no_conversion(fmt::format("its unit {} is not known", quote(unit)));
  if (!parsed || !same_dimension(parsed.get(), target.get()))
    return no_conversion(
        fmt::format("its unit {} does not measure the same as '{}'{}", quote(unit), target_unit, other));
  if (!same_angle_content(parsed.get(), target.get()))
    return no_conversion(fmt::format("its unit {} states no angle, as '{}' does", quote(unit), target_unit));
  const Converter converter(ut_get_converter(parsed.get(), target.get()));
  const Converter inverse(ut_get_converter(target.get(), parsed.get()));
  if (!converter || !inverse || cv_convert_double(converter.get(), 0.0) != 0.0)
    return no_conversion(fmt::format("its unit {} has an offset zero point", quote(unit)));
  return round_conversion(cv_convert_double(converter.get(), 1.0), cv_convert_double(inverse.get(), 1.0));
}

std::optional<Conversion> common_conversion(std::string_view unit, std::string_view target) {
  for (const CommonUnit& one : common_units()) {
    if (one.unit == unit && one.si == target) return round_conversion(one.factor, 1.0 / one.factor);
    if (one.unit == target && one.si == unit) return round_conversion(1.0 / one.factor, one.factor);
  }
  return std::nullopt;
}

Reading<double> converted(double value, const Conversion& conversion) {
  if (!conversion.fault.empty()) return fault(conversion.fault);
  const double result = value * conversion.factor / conversion.divisor;
  if (!std::isfinite(result)) return fault("its value is too large");
  return {result, {}};
}

}  // namespace

Reading<double> read_number(std::string_view text) {
  const Reading<WrittenQuantity> written = split_quantity(text);
  if (!written.value) return fault(written.fault);
  if (written.value->unit == "%")
    return fault(
        fmt::format("state {:.9g} instead of {:g} %", written.value->value / 100.0, written.value->value));
  if (!written.value->unit.empty()) return fault("it is not a number alone");
  return {written.value->value, {}};
}

Reading<WrittenQuantity> split_quantity(std::string_view text) {
  text = trim(text);
  std::string_view digits = text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  const std::string_view magnitude = digits.substr(text.starts_with('-') ? 1 : 0);
  if (text.starts_with("\u2212"))
    return {std::nullopt,
            "it begins with the sign U+2212, a minus of typeset text; the minus of numbers is '-'"};
  // from_chars would accept "inf" and "nan", and "+-3" after the plus is removed.
  if (magnitude.empty() || !(is_digit(magnitude[0]) || magnitude[0] == '.'))
    return {std::nullopt, "it does not begin with a finite number"};
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) return {std::nullopt, "its number is too large or too small"};
  if (error != std::errc{}) return {std::nullopt, "it does not begin with a finite number"};
  const std::string_view rest(end, static_cast<std::size_t>(digits.data() + digits.size() - end));
  if (rest.starts_with(',')) return {std::nullopt, "a number has a decimal point and no commas"};
  const std::string_view number = digits.substr(0, digits.size() - rest.size());
  if (const auto joined = joined_groups(number, trim(rest)))
    return {std::nullopt, fmt::format("a number is written without spaces: {}", *joined)};
  return {WrittenQuantity{value, std::string(trim(rest))}, {}};
}

Reading<double> convert(double value, std::string_view unit, std::string_view target_unit) {
  unit = meant_unit(unit, target_unit);
  if (unit == target_unit) return {value, {}};
  if (const std::optional<Conversion> common = common_conversion(unit, target_unit))
    return converted(value, *common);
  return convert_by_library(value, unit, target_unit);
}

// A study converts the same few units in every variant: those that are known are kept, each thread its own.
Reading<double> convert_by_library(double value, std::string_view unit, std::string_view target_unit) {
  if (auto kelvin = fault_of_kelvin(value, unit, target_unit)) return fault(std::move(*kelvin));
  thread_local std::map<std::pair<std::string, std::string>, Conversion> known;
  std::pair<std::string, std::string> units(unit, target_unit);
  const auto found = known.find(units);
  if (found != known.end()) return converted(value, found->second);
  Conversion conversion = make_conversion(unit, target_unit);
  const Reading<double> result = converted(value, conversion);
  if (conversion.fault.empty()) known.emplace(std::move(units), std::move(conversion));
  return result;
}

Reading<double> read_quantity(std::string_view text, const Dimension& dimension) {
  const Reading<WrittenQuantity> written = split_quantity(text);
  if (!written.value) return fault(written.fault);
  if (written.value->unit.empty())
    return fault(fmt::format("it has no unit; write number and unit, as in '{}'", dimension.example));
  return convert(written.value->value, written.value->unit, dimension.si);
}

}  // namespace orbearing::app
