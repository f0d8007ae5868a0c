#include "app/case/common_units.hpp"

#include "mechanics/described.hpp"

namespace orbearing::app {

namespace {

constexpr double kDegree = described::dimension::kRadian, kDegrees = 57.29577951308232;
constexpr double kTurn = described::dimension::kTurn, kTurns = 9.549296585513721;
constexpr double kMinute = 60.0, kHour = 3600.0;

constexpr CommonUnit kUnits[] = {
    {"mm", "m", 1e-3, 1e3},
    {"um", "m", 1e-6, 1e6},
    {"nm", "m", 1e-9, 1e9},
    {"deg", "rad", kDegree, kDegrees},
    {"mrad", "rad", 1e-3, 1e3},
    {"rpm", "rad/s", kTurn, kTurns},
    {"rpm/s", "rad/s2", kTurn, kTurns},
    {"kW", "W", 1e3, 1e-3},
    {"MW", "W", 1e6, 1e-6},
    {"kN", "N", 1e3, 1e-3},
    {"MN", "N", 1e6, 1e-6},
    {"N.mm", "N.m", 1e-3, 1e3},
    {"kN.m", "N.m", 1e3, 1e-3},
    {"MN.m", "N.m", 1e6, 1e-6},
    {"us", "s", 1e-6, 1e6},
    {"ms", "s", 1e-3, 1e3},
    {"min", "s", kMinute, 1.0 / kMinute},
    {"h", "s", kHour, 1.0 / kHour},
    {"GPa", "Pa", 1e9, 1e-9},
    {"MPa", "Pa", 1e6, 1e-6},
    {"GPa-1", "Pa-1", 1e-9, 1e9},
    {"mPa.s", "Pa.s", 1e-3, 1e3},
    {"mm2/s", "m2/s", 1e-6, 1e6},
    {"N/um", "N/m", 1e6, 1e-6},
    {"N/mm", "N/m", 1e3, 1e-3},
    {"kN/mm", "N/m", 1e6, 1e-6},
    {"mm/s", "m/s", 1e-3, 1e3},
    {"kHz", "Hz", 1e3, 1e-3},
    {"g/cm3", "kg/m3", 1e3, 1e-3},
    {"L/min", "m3/s", 1e-3 / kMinute, kMinute * 1e3},
};

}  // namespace

std::span<const CommonUnit> common_units() {
  return kUnits;
}

}  // namespace orbearing::app
