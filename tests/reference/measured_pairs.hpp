// [FangDuplex], Table 3: natural frequencies measured on two kinds of bearings under three preloads each, the
// second column of the table, whose two columns have each other's heads.
#pragma once

#include <array>

namespace orbearing::fang_duplex {

struct MeasuredPair {
  const char* contact_angle;        // as a case states it
  const char* preload;              // the same
  std::array<double, 5> frequency;  // [Hz]  tilt_x, tilt_y, axial_z, radial_x, radial_y
};

/// Bearings 7020C, from which the shaft of the case was identified.
inline constexpr std::array<MeasuredPair, 3> measured_7020C{
    {{"15 deg", "540 N", {235.57, 242.13, 454.09, 1175.48, 1225.96}},
     {"15 deg", "1270 N", {305.29, 350.96, 699.52, 1384.62, 1399.04}},
     {"15 deg", "2550 N", {326.14, 348.69, 806.37, 1617.89, 1646.63}}}};
/// Bearings 7020A, which identify nothing.
inline constexpr std::array<MeasuredPair, 3> measured_7020A{
    {{"30 deg", "840 N", {215.28, 221.43, 783.65, 1144.23, 1247.59}},
     {"30 deg", "2750 N", {257.81, 249.65, 1043.73, 1421.93, 1417.19}},
     {"30 deg", "4310 N", {273.44, 285.94, 1187.50, 1739.06, 1784.37}}}};

}  // namespace orbearing::fang_duplex
