// Functions of udunits2 that app/case/units.cpp calls, over a table of the units that udunits2 itself has
// (units_table.py): the library reads its database with an XML reader, which a browser build does not have.
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace {

constexpr std::size_t kBase = 8;  // m, kg, s, A, K, mol, cd, rad
constexpr std::size_t kRadian = kBase - 1;

struct TableUnit {
  const char* text;
  double factor;  // value in base units = factor x value + zero
  double zero;
  std::array<signed char, kBase> powers;
};
struct TablePrefix {
  const char* text;
  double factor;
};

#include "units_table.hpp"

}  // namespace

union ut_unit {
  TableUnit of;
};
struct ut_system {
  std::map<std::string, TableUnit> added;
};
union cv_converter {
  struct {
    double factor, zero;
  } by;
};

namespace {

TableUnit product(const TableUnit& a, const TableUnit& b, int sign) {
  TableUnit all{"", sign > 0 ? a.factor * b.factor : a.factor * (1.0 / b.factor), 0.0, a.powers};
  for (std::size_t i = 0; i < kBase; ++i)
    all.powers[i] = static_cast<signed char>(all.powers[i] + sign * b.powers[i]);
  return all;
}

TableUnit power(const TableUnit& base, int exponent) {
  if (exponent == 1) return base;
  TableUnit all{"", std::pow(base.factor, exponent), 0.0, base.powers};
  for (signed char& one : all.powers) one = static_cast<signed char>(one * exponent);
  return all;
}

bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  });
}

// Names in any letters, symbols as they are.
std::optional<TableUnit> known(const ut_system& system, std::string_view text) {
  if (const auto added = system.added.find(std::string(text)); added != system.added.end())
    return added->second;
  for (const TableUnit& one : kNames)
    if (same_letters(text, one.text)) return one;
  for (const TableUnit& one : kSymbols)
    if (text == one.text) return one;
  return std::nullopt;
}

// The longest that the text begins with.
template <class Table>
const TablePrefix* prefix_of(const Table& table, std::string_view text) {
  const TablePrefix* found = nullptr;
  for (const TablePrefix& one : table)
    if (text.starts_with(one.text) && (found == nullptr || std::strlen(one.text) > std::strlen(found->text)))
      found = &one;
  return found;
}

std::optional<TableUnit> with_prefixes(const ut_system& system, std::string_view text) {
  double factor = 1.0;
  bool symbol_seen = false;
  while (!text.empty()) {
    if (std::optional<TableUnit> unit = known(system, text)) {
      unit->factor = factor * unit->factor;
      return unit;
    }
    const TablePrefix* prefix = prefix_of(kPrefixNames, text);
    if (prefix == nullptr && !std::exchange(symbol_seen, true)) prefix = prefix_of(kPrefixSymbols, text);
    if (prefix == nullptr) return std::nullopt;
    factor *= prefix->factor;
    text.remove_prefix(std::strlen(prefix->text));
  }
  return std::nullopt;
}

/// Products, quotients and powers of units: "kg.m2", "N m/rad", "min-1", "(N.m)/s", "m²".
class Reader {
 public:
  Reader(const ut_system& system, std::string_view text) : system_(system), left_(text) {}

  std::optional<TableUnit> all() {
    const std::optional<TableUnit> unit = products();
    return left_.empty() ? unit : std::nullopt;
  }

 private:
  static constexpr std::string_view kPowers[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

  bool take(std::string_view word) {
    if (!left_.starts_with(word)) return false;
    left_.remove_prefix(word.size());
    return true;
  }
  bool blanks() {
    const std::size_t before = left_.size();
    while (take(" ") || take("\t") || take("\u00a0")) continue;
    return left_.size() < before;
  }
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  // Whether the byte may be in a name: letters, bytes beyond ASCII except signs, and _ % ' ".
  static bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '%' || c == '\'' ||
           c == '"' || static_cast<unsigned char>(c) >= 0x80;
  }
  bool at_sign() const {
    for (const std::string_view sign : {"·", "\u00a0", "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"})
      if (left_.starts_with(sign)) return true;
    return false;
  }

  std::optional<TableUnit> products() {
    blanks();
    std::optional<TableUnit> all = powered();
    while (all) {
      const bool apart = blanks();
      int sign = 1;
      if (take("/") || (apart && (take("per ") || take("PER "))))
        sign = -1;
      else if (!take(".") && !take("*") && !take("·") && !take("-") &&
               (!apart || left_.empty() || left_.front() == ')'))
        break;
      blanks();
      const std::optional<TableUnit> next = powered();
      if (!next) return std::nullopt;
      all = product(*all, *next, sign);
    }
    return all;
  }

  std::optional<TableUnit> powered() {
    const std::optional<TableUnit> base = basic();
    if (!base) return std::nullopt;
    const std::optional<int> exponent = read_exponent();
    return exponent ? power(*base, *exponent) : base;
  }

  std::optional<TableUnit> basic() {
    if (take("(")) {
      const std::optional<TableUnit> inner = products();
      return take(")") ? inner : std::nullopt;
    }
    if (take("1")) return TableUnit{"1", 1.0, 0.0, {}};
    const std::string_view begin = left_;
    while (!left_.empty() && is_letter(left_.front()) && !at_sign()) left_.remove_prefix(1);
    return with_prefixes(system_, begin.substr(0, begin.size() - left_.size()));
  }

  std::optional<int> read_exponent() {
    if (std::optional<int> raised = superscript()) return raised;
    const std::string_view before = left_;
    if (!take("^")) take("**");
    const int sign = take("-") ? -1 : 1;
    if (left_.empty() || !is_digit(left_.front())) {
      left_ = before;
      return std::nullopt;
    }
    int value = 0;
    for (; !left_.empty() && is_digit(left_.front()) && value < 100; left_.remove_prefix(1))
      value = 10 * value + (left_.front() - '0');
    return sign * value;
  }

  std::optional<int> superscript() {
    std::optional<int> value;
    for (bool more = true; more;) {
      more = false;
      for (int digit = 0; digit < 10; ++digit)
        if (take(kPowers[digit])) {
          value = 10 * value.value_or(0) + digit;
          more = true;
        }
    }
    return value;
  }

  const ut_system& system_;
  std::string_view left_;
};

ut_system& the_system() {
  static ut_system system;
  return system;
}

ut_unit* made(const std::optional<TableUnit>& unit) {
  return unit ? new ut_unit{*unit} : nullptr;
}

}  // namespace

extern "C" {

ut_error_message_handler ut_set_error_message_handler(ut_error_message_handler) {
  return nullptr;
}
int ut_ignore(const char*, va_list) {
  return 0;
}
ut_system* ut_read_xml(const char*) {
  return &the_system();
}
ut_unit* ut_parse(const ut_system* system, const char* text, ut_encoding) {
  return made(Reader(*system, text).all());
}
void ut_free(ut_unit* unit) {
  delete unit;
}
ut_status ut_map_name_to_unit(const char* name, ut_encoding, const ut_unit* unit) {
  the_system().added[name] = unit->of;
  return UT_SUCCESS;
}
ut_unit* ut_scale(double factor, const ut_unit* unit) {
  return made(TableUnit{"", factor * unit->of.factor, unit->of.zero, unit->of.powers});
}
ut_unit* ut_divide(const ut_unit* a, const ut_unit* b) {
  return made(product(a->of, b->of, -1));
}
int ut_is_dimensionless(const ut_unit* unit) {
  return std::all_of(unit->of.powers.begin(), unit->of.powers.begin() + kRadian,
                     [](int one) { return one == 0; });
}
// The only purpose here: whether the unit has radians.
int ut_format(const ut_unit* unit, char* into, std::size_t size, unsigned) {
  const std::string_view text = unit->of.powers[kRadian] != 0 ? "rad" : "1";
  if (size <= text.size()) return -1;
  std::memcpy(into, text.data(), text.size());
  into[text.size()] = '\0';
  return static_cast<int>(text.size());
}
cv_converter* ut_get_converter(ut_unit* from, ut_unit* to) {
  cv_converter* converter = new cv_converter;
  const double inverse = 1.0 / to->of.factor;
  converter->by = {from->of.factor * inverse, (from->of.zero - to->of.zero) * inverse};
  return converter;
}
double cv_convert_double(const cv_converter* converter, double value) {
  return converter->by.factor * value + converter->by.zero;
}
void cv_free(cv_converter* converter) {
  delete converter;
}
}
