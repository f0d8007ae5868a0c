// What a file of results holds: named dimensions and arrays, units on every variable.
#pragma once

#include <cstddef>
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

/// All that a file holds; a new series is one more array here.
struct PointContent {
  std::vector<NamedDimension> dimensions;
  std::vector<NamedArray> arrays;
  std::vector<std::pair<std::string, std::string>> attributes;

  void add(std::string name, std::string units, std::string meaning, double value) {
    arrays.push_back({std::move(name), {}, std::move(units), std::move(meaning), {value}});
  }
};

}  // namespace orbearing::app
