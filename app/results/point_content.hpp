// What a file of results holds: named dimensions and arrays, units on every variable.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace orbearing::app {

struct NamedDimension {
  std::string name;
  std::size_t size = 0;  // at least 1
};

/// Values in the order of the dimensions, the last fastest; no dimension: a single value.
struct NamedArray {
  std::string name;
  std::vector<std::string> dimensions;
  std::string units;  // as udunits reads it
  std::string meaning;
  std::vector<double> values;  // NaN where there is none
};

/// Those of a range, or of a matrix row by row: Eigen keeps columns together.
template <class Values>
std::vector<double> values_in_order(const Values& values) {
  if constexpr (requires { values.rowwise(); }) {
    std::vector<double> list;
    list.reserve(static_cast<std::size_t>(values.size()));
    using Index = decltype(values.rows());
    for (Index row = 0; row < values.rows(); ++row)
      for (Index column = 0; column < values.cols(); ++column) list.push_back(values.coeff(row, column));
    return list;
  } else {
    return {values.begin(), values.end()};
  }
}

/// All that a file holds; a new series is one more array here.
struct PointContent {
  std::vector<NamedDimension> dimensions;
  std::vector<NamedArray> arrays;
  std::vector<std::pair<std::string, std::string>> attributes;

  template <class Size>
  void add_dimension(std::string name, Size size) {
    dimensions.push_back({std::move(name), static_cast<std::size_t>(size)});
  }
  void add(std::string name, std::string units, std::string meaning, double value) {
    arrays.push_back({std::move(name), {}, std::move(units), std::move(meaning), {value}});
  }
  /// `values` as values_in_order() takes them.
  template <class Values>
  void add(std::string name, std::vector<std::string> along, std::string units, std::string meaning,
           const Values& values) {
    arrays.push_back(
        {std::move(name), std::move(along), std::move(units), std::move(meaning), values_in_order(values)});
  }
  /// `value` of each of `items`: a number, or several that follow each other; a member or a function.
  template <class Items, class Value>
  void add_each(std::string name, std::vector<std::string> along, std::string units, std::string meaning,
                const Items& items, const Value& value) {
    std::vector<double> values;
    for (const auto& item : items) {
      const auto& of_item = std::invoke(value, item);
      if constexpr (requires { of_item.begin(); })
        values.insert(values.end(), of_item.begin(), of_item.end());
      else
        values.push_back(static_cast<double>(of_item));
    }
    arrays.push_back(
        {std::move(name), std::move(along), std::move(units), std::move(meaning), std::move(values)});
  }
};

}  // namespace orbearing::app
