#include "bearing/film/oil_grade.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "mechanics/checks.hpp"

namespace orbearing::bearing {

namespace {

constexpr double kAbsoluteZero = -273.15;   // [degC]
constexpr double kSquareMillimetres = 1e6;  // [mm^2/m^2]

// Viscosities at 40 degC of oils of index 0 (L) and 100 (H) that have Y mm^2/s at 100 degC: a Y^2 + b Y + c
// from `from` on.
struct ReferenceOils {
  double from;  // [mm^2/s]
  double l[3];
  double h[3];
};
constexpr ReferenceOils kReferenceOils[] = {
    {2.0, {1.14673, 1.7576, -0.109}, {0.84155, 1.5521, -0.077}},
    {3.8, {3.38095, -15.4952, 33.196}, {0.78571, 1.7929, -0.183}},
    {4.4, {2.5, -7.2143, 13.812}, {0.82143, 1.5679, 0.119}},
    {5.0, {0.101, 16.635, -45.469}, {0.04985, 9.1613, -18.557}},
    {6.4, {3.35714, -23.5643, 78.466}, {0.22619, 7.7369, -16.656}},
    {7.0, {0.01191, 21.475, -72.87}, {0.79762, -0.7321, 14.61}},
    {7.7, {0.41858, 16.1558, -56.04}, {0.05794, 10.5156, -28.24}},
    {9.0, {0.88779, 7.5527, -16.6}, {0.26665, 6.7015, -10.81}},
    {12.0, {0.7672, 10.7972, -38.18}, {0.20073, 8.4658, -22.49}},
    {15.0, {0.97305, 5.3135, -2.2}, {0.28889, 5.9741, -4.93}},
    {18.0, {0.97256, 5.25, -0.98}, {0.24504, 7.416, -16.73}},
    {22.0, {0.91413, 7.4759, -21.82}, {0.20323, 9.1267, -34.23}},
    {28.0, {0.87031, 9.7157, -50.77}, {0.18411, 10.1015, -46.75}},
    {40.0, {0.84703, 12.6752, -133.31}, {0.17029, 11.4866, -80.62}},
    {55.0, {0.85921, 11.1009, -83.19}, {0.17314, 11.3680, -76.94}},
    {70.0, {0.83531, 14.6731, -216.246}, {0.16841, 11.8493, -96.947}}};

double polynomial(const double (&c)[3], double y) {
  return (c[0] * y + c[1]) * y + c[2];
}

// Viscosity at 40 degC [mm^2/s] of an oil of `index` with `y` at 100 degC.
double viscosity_40_of(double y, double index) {
  const auto after =
      std::upper_bound(std::begin(kReferenceOils), std::end(kReferenceOils), y,
                       [](double value, const ReferenceOils& oils) { return value < oils.from; });
  const ReferenceOils& oils = *std::prev(std::max(after, std::next(std::begin(kReferenceOils))));
  const double low = polynomial(oils.l, y);
  return low - 0.01 * index * (low - polynomial(oils.h, y));
}

double double_logarithm(double mm2_per_s) {
  return std::log10(std::log10(mm2_per_s + 0.7));
}

}  // namespace

double viscosity_at_100(double viscosity_40, double viscosity_index) {
  mechanics::require(viscosity_index >= 0.0 && viscosity_index <= 100.0, "viscosity index", viscosity_index,
                     "0 to 100");
  const double wanted = kSquareMillimetres * viscosity_40;
  constexpr double thinnest = 2.0, thickest = 1000.0;  // [mm^2/s]
  const auto miss = [&](double y) { return viscosity_40_of(y, viscosity_index) - wanted; };
  mechanics::require(miss(thinnest) <= 0.0 && miss(thickest) >= 0.0, "kinematic viscosity at 40 degC [mm2/s]",
                     wanted, "that of an oil with at least 2 mm2/s at 100 degC, where ASTM D2270 begins");
  std::uintmax_t steps = 100;
  const auto found = boost::math::tools::toms748_solve(miss, thinnest, thickest,
                                                       boost::math::tools::eps_tolerance<double>(40), steps);
  return 0.5 * (found.first + found.second) / kSquareMillimetres;
}

namespace {

// The line (1) of an oil: A - B lg T at a temperature, and B.
struct ViscosityLine {
  double value, slope;
};

ViscosityLine viscosity_line(const OilGrade& oil, double temperature) {
  const double cold = std::log10(40.0 - kAbsoluteZero), hot = std::log10(100.0 - kAbsoluteZero);
  const double at_40 = double_logarithm(kSquareMillimetres * oil.viscosity_40);
  const double viscosity_100 =
      oil.viscosity_100 ? *oil.viscosity_100 : viscosity_at_100(oil.viscosity_40, oil.viscosity_index);
  const double at_100 = double_logarithm(kSquareMillimetres * viscosity_100);
  const double slope = (at_40 - at_100) / (hot - cold);
  return {at_40 - slope * (std::log10(temperature - kAbsoluteZero) - cold), slope};
}

}  // namespace

double kinematic_viscosity(const OilGrade& oil, double temperature) {
  return (std::pow(10.0, std::pow(10.0, viscosity_line(oil, temperature).value)) - 0.7) / kSquareMillimetres;
}

double viscosity_slope(const OilGrade& oil, double temperature) {
  const ViscosityLine line = viscosity_line(oil, temperature);
  const double logarithm = std::pow(10.0, line.value), shifted = std::pow(10.0, logarithm);
  return std::log(shifted) * line.slope * shifted / ((shifted - 0.7) * (temperature - kAbsoluteZero));
}

Lubricant lubricant_at(const OilGrade& oil, double temperature) {
  const double warm = 38.0;  // [degC]
  const double viscosity_38 = kinematic_viscosity(oil, warm) * oil.density;
  const double by_temperature =
      1.0 + 516.0 * (1.0 / (temperature - kAbsoluteZero) - 1.0 / (warm - kAbsoluteZero));
  return {.viscosity = kinematic_viscosity(oil, temperature) * oil.density,
          .pressure_viscosity = 2.657e-8 * std::pow(viscosity_38, 0.1348) * by_temperature};
}

}  // namespace orbearing::bearing
