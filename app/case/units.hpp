// Text with a unit -> SI: common units by a table, others by udunits2. The only place where units are
// converted.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mechanics/described.hpp"

namespace orbearing::app {

using described::Dimension;
namespace dimension = described::dimension;

/// A number and its unit as written, not yet converted.
struct WrittenQuantity {
  double value = 0.0;  // [unit]
  std::string unit;    // as written; empty for a bare number
};

/// Result of reading a text: either a value or what is wrong with the text.
template <class Value>
struct Reading {
  std::optional<Value> value;
  std::string fault;  // why there is no value; continues a sentence: "'3 mmm' has no known unit"
};

/// Reads a finite decimal number that takes up all of the text.
Reading<double> read_number(std::string_view text);

/// Splits "3 mm" into 3 and "mm". The unit may be empty; it is not checked.
Reading<WrittenQuantity> split_quantity(std::string_view text);

/// Converts a value in `unit` to `target_unit`; refuses other dimensions, units with an offset, and cycles
/// (Hz) for radians. Equal unit texts leave the bits of the value alone. May be called from several threads.
Reading<double> convert(double value, std::string_view unit, std::string_view target_unit);

/// By udunits2 alone: without the table of common units, each of which must give the same bits, and without
/// spellings of data sheets.
Reading<double> convert_by_library(double value, std::string_view unit, std::string_view target_unit);

/// Reads "150 kW" as SI [dimension.si]. A bare number is refused, with the remedy.
Reading<double> read_quantity(std::string_view text, const Dimension& dimension);

}  // namespace orbearing::app
