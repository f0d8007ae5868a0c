// Structures of single values, listed once: described as a record, and read back from named numbers.
//
//     void list(described::Columns& columns, Shaft& shaft) {
//       columns.value("mass_kg", dimension::mass, "of the shaft with all that moves with it", shaft.mass);
//     }
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "mechanics/record.hpp"

namespace orbearing::described {

/// Goes through the values of a structure in their order.
class Columns {
 public:
  /// Receives a number [SI] by its name and may change it; not a number: there is none.
  using TakeNumber = std::function<void(std::string_view name, const Dimension& dimension, double& value)>;
  using TakeText = std::function<void(std::string_view name, std::string& text)>;

  /// Appends the values to `record`.
  explicit Columns(Record& record) : record_(&record) {}
  /// Passes them to functions. A part all of whose listed numbers a function takes away is removed; one that
  /// gets a number exists.
  explicit Columns(TakeNumber number, TakeText text = {})
      : number_(std::move(number)), text_(std::move(text)) {}

  /// A number [SI]: double, int, bool as 0 or 1, or an optional of these.
  template <class Number>
  Entry& value(std::string_view name, const Dimension& dimension, std::string_view meaning, Number& member) {
    double number = known_ ? number_of(member) : kAbsent;
    if (record_ != nullptr)
      return record_->value(prefix_ + std::string(name), dimension, std::string(meaning), number);
    pass(name, dimension, number);
    put(number, member);
    return unused_;
  }
  /// A number that follows from others of the structure.
  Entry& derived(std::string_view name, const Dimension& dimension, std::string_view meaning, double value) {
    return this->value(name, dimension, meaning, value);
  }
  /// A yes or no, which results show as such.
  void flag(std::string_view name, std::string_view meaning, bool& member) {
    if (record_ != nullptr)
      record_->value(prefix_ + std::string(name), std::string(meaning), member);
    else
      value(name, {}, meaning, member);
  }
  void text(std::string_view name, std::string_view meaning, std::string& member) {
    if (record_ != nullptr)
      record_->value(prefix_ + std::string(name), std::string(meaning), known_ ? member : std::string());
    else if (text_)
      text_(with_prefix(name), member);
  }

  /// A structure that may be missing: `list(part)` lists all or some of it.
  template <class Part, class List>
  void part(std::optional<Part>& part, const List& list) {
    Part values = part.value_or(Part{});
    const bool known = std::exchange(known_, known_ && part.has_value());
    const Numbers others = std::exchange(numbers_, {});
    list(values);
    if (record_ == nullptr) {
      if (numbers_.after)
        part = std::move(values);
      else if (numbers_.before)
        part.reset();
    }
    known_ = known;
    numbers_ = {numbers_.before || others.before, numbers_.after || others.after};
  }

  /// Names of what `list()` lists begin with `prefix`.
  template <class List>
  void within(std::string prefix, const List& list) {
    std::swap(prefix, prefix_);
    list();
    prefix_ = std::move(prefix);
  }

 private:
  template <class Number>
  static double number_of(const Number& member) {
    if constexpr (is_optional<Number>)
      return member ? static_cast<double>(*member) : kAbsent;
    else
      return static_cast<double>(member);
  }

  template <class Number>
  static void put(double number, Number& member) {
    if constexpr (std::is_same_v<Number, double>)
      member = number;
    else if constexpr (is_optional<Number>)
      member = std::isfinite(number) ? Number(number) : std::nullopt;
    else if (std::isfinite(number))
      member = static_cast<Number>(number);
  }

  std::string_view with_prefix(std::string_view name) {
    if (prefix_.empty()) return name;
    whole_name_ = prefix_;
    whole_name_ += name;
    return whole_name_;
  }

  void pass(std::string_view name, const Dimension& dimension, double& number) {
    numbers_.before = numbers_.before || std::isfinite(number);
    number_(with_prefix(name), dimension, number);
    numbers_.after = numbers_.after || std::isfinite(number);
  }

  // Whether values of the present part are numbers, before a function had them and after.
  struct Numbers {
    bool before = false;
    bool after = false;
  };

  Record* record_ = nullptr;
  TakeNumber number_;
  TakeText text_;
  std::string prefix_;
  std::string whole_name_;
  bool known_ = true;  // false within a part that is missing
  Numbers numbers_;
  Entry unused_{};
};

/// A record of the values that `list` of a structure lists.
template <class Listed>
void describe_listed(Record& record, Listed values) {
  Columns columns(record);
  list(columns, values);
}

}  // namespace orbearing::described
