#include "coupling/fmu/export/units.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

namespace orbearing::fmu {

BaseUnit base_unit(std::string_view unit) {
  static constexpr std::array<std::pair<std::string_view, BaseUnit>, 18> table{{
      {"1", {}},
      {"s", {.s = 1}},
      {"m", {.m = 1}},
      {"m/s", {.m = 1, .s = -1}},
      {"s/m", {.m = -1, .s = 1}},
      {"rad", {.rad = 1}},
      {"rad/s", {.s = -1, .rad = 1}},
      {"rad/s2", {.s = -2, .rad = 1}},
      {"kg", {.kg = 1}},
      {"kg/m3", {.kg = 1, .m = -3}},
      {"N", {.kg = 1, .m = 1, .s = -2}},
      {"N.m", {.kg = 1, .m = 2, .s = -2}},
      {"N/m", {.kg = 1, .s = -2}},
      {"N.s/m", {.kg = 1, .s = -1}},
      {"W", {.kg = 1, .m = 2, .s = -3}},
      {"Pa", {.kg = 1, .m = -1, .s = -2}},
      {"Pa.s", {.kg = 1, .m = -1, .s = -1}},
      {"1/Pa", {.kg = -1, .m = 1, .s = 2}},
  }};
  for (const auto& [name, exponents] : table)
    if (name == unit) return exponents;
  throw std::logic_error("unit " + std::string(unit) + " has no base units");
}

}  // namespace orbearing::fmu
