// Text with a unit -> SI, by the udunits2 library. The only place where units are converted.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace orbearing::app {

/// What a quantity measures: its coherent SI unit, the unit people write it in, and an example for messages.
struct Dimension {
  std::string_view name;       // "length"
  std::string_view si;         // "m"        unit of every number inside the program
  std::string_view customary;  // "mm"       unit of ranges and messages
  std::string_view example;    // "3 mm"
};

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

/// Reads "150 kW" as SI [dimension.si]. A bare number is refused, with the remedy.
Reading<double> read_quantity(std::string_view text, const Dimension& dimension);

namespace dimension {
inline constexpr Dimension length{"length", "m", "mm", "3 mm"};
inline constexpr Dimension small_length{"length", "m", "um", "37 um"};
inline constexpr Dimension angle{"angle", "rad", "deg", "20 deg"};
inline constexpr Dimension angular_speed{"angular speed", "rad/s", "rpm", "6000 rpm"};
inline constexpr Dimension angular_acceleration{"angular acceleration", "rad/s2", "rpm/s", "5000 rpm/s"};
inline constexpr Dimension power{"power", "W", "kW", "150 kW"};
inline constexpr Dimension force{"force", "N", "N", "4450 N"};
inline constexpr Dimension torque{"torque", "N.m", "N.m", "240 N.m"};
inline constexpr Dimension mass{"mass", "kg", "kg", "2 kg"};
inline constexpr Dimension time{"time", "s", "s", "0.5 s"};
inline constexpr Dimension density{"density", "kg/m3", "kg/m3", "7850 kg/m3"};
inline constexpr Dimension stress{"stress", "Pa", "GPa", "206 GPa"};
inline constexpr Dimension viscosity{"dynamic viscosity", "Pa.s", "Pa.s", "0.01 Pa.s"};
inline constexpr Dimension kinematic_viscosity{"kinematic viscosity", "m2/s", "mm2/s", "20 mm2/s"};
inline constexpr Dimension pressure_viscosity{"pressure-viscosity coefficient", "Pa-1", "GPa-1", "15 GPa-1"};
inline constexpr Dimension stiffness{"stiffness", "N/m", "N/m", "1e8 N/m"};
inline constexpr Dimension speed{"speed", "m/s", "m/s", "0.1 m/s"};
inline constexpr Dimension inverse_speed{"inverse speed", "s/m", "s/m", "0.1 s/m"};
inline constexpr Dimension damping{"damping", "N.s/m", "N.s/m", "200 N.s/m"};
}  // namespace dimension

}  // namespace orbearing::app
