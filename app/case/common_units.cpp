#include "app/case/common_units.hpp"

#include "mechanics/described.hpp"

namespace orbearing::app {

namespace {

constexpr double kDegree = described::dimension::kRadian, kTurn = described::dimension::kTurn;
constexpr double kMinute = 60.0, kHour = 3600.0;

constexpr CommonUnit kUnits[] = {
    {"mm", "m", 1e-3},
    {"um", "m", 1e-6},
    {"nm", "m", 1e-9},
    {"deg", "rad", kDegree},
    {"mrad", "rad", 1e-3},
    {"rpm", "rad/s", kTurn},
    {"rpm/s", "rad/s2", kTurn},
    {"kW", "W", 1e3},
    {"MW", "W", 1e6},
    {"kN", "N", 1e3},
    {"MN", "N", 1e6},
    {"N.mm", "N.m", 1e-3},
    {"kN.m", "N.m", 1e3},
    {"MN.m", "N.m", 1e6},
    {"us", "s", 1e-6},
    {"ms", "s", 1e-3},
    {"min", "s", kMinute},
    {"h", "s", kHour},
    {"GPa", "Pa", 1e9},
    {"MPa", "Pa", 1e6},
    {"GPa-1", "Pa-1", 1e-9},
    {"mPa.s", "Pa.s", 1e-3},
    {"mm2/s", "m2/s", 1e-6},
    {"N/um", "N/m", 1e6},
    {"N/mm", "N/m", 1e3},
    {"kN/mm", "N/m", 1e6},
    {"mm/s", "m/s", 1e-3},
    {"kHz", "Hz", 1e3},
    {"g/cm3", "kg/m3", 1e3},
    {"L/min", "m3/s", 1e-3 / kMinute},
};

}  // namespace

std::span<const CommonUnit> common_units() {
  return kUnits;
}

}  // namespace orbearing::app
