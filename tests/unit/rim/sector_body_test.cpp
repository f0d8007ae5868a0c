// The body behind the influence functions, against closed forms of rings.
#include "gearset/rim/sector_body.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "mechanics/constants.hpp"
#include "tests/messages.hpp"

namespace orbearing::gearset::rim::sector_body_test {
namespace {

using constants::pi;
using constants::two_pi;

const mechanics::Material kSteel;
constexpr double kWidth = 0.02;  // [m]

// One sector of a plain ring, columns along the circumference.
SectorMesh plain_sector(double inner, double outer, int sectors, int columns, int rows) {
  SectorMesh mesh;
  std::map<std::pair<int, int>, int> number;
  const auto node = [&](int column, int row) {
    const auto [entry, is_new] = number.try_emplace({column, row}, static_cast<int>(mesh.node.size()));
    const double angle = two_pi / sectors * (0.5 * column / columns - 0.5);
    const double radius = inner + (outer - inner) * 0.5 * row / rows;
    if (is_new) mesh.node.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    return entry->second;
  };
  for (int c = 0; c < 2 * columns; c += 2)
    for (int r = 0; r < 2 * rows; r += 2) {
      mesh.element.push_back({node(c, r), node(c, r + 2), node(c + 2, r + 2), node(c + 2, r), node(c, r + 1),
                              node(c + 1, r + 2), node(c + 2, r + 1), node(c + 1, r)});
      mesh.width.push_back(kWidth);
    }
  for (int row = 0; row <= 2 * rows; ++row) {
    mesh.first_side.push_back(node(0, row));
    mesh.last_side.push_back(node(2 * columns, row));
  }
  for (int column = 0; column <= 2 * columns; ++column) mesh.race.push_back(node(column, 0));
  return mesh;
}

// [m/N]  radial displacement of the race by a radial force, the share of order n: c_n of (1), with the
// half-space.
double wave_compliance(const SectorBody& body, int order) {
  const double work = body.works(order, {body.race_wave(order)}, RaceConstraint::on_average)(0, 0).real();
  return (order == 0 ? 1.0 : 2.0) * work * body.sectors() / (two_pi * two_pi);
}

// A force that is spread evenly is the pressure p = F/(2 pi a b) [TimoshenkoGoodier1970].
TEST(SectorBody, WaveOfOrderZeroIsAThickRingUnderPressure) {
  const double a = 0.020, b = 0.028;
  const SectorBody body(plain_sector(a, b, 10, 6, 4), kSteel, 10);
  const double nu = kSteel.poisson_ratio;
  const double per_pressure = (1.0 + nu) / kSteel.youngs_modulus * a / (b * b - a * a) *
                              ((1.0 - 2.0 * nu) * a * a + b * b);  // [m/Pa]
  EXPECT_NEAR(wave_compliance(body, 0) / (per_pressure / (two_pi * a * kWidth)), 1.0, 1e-4);
}

// Bending alone; shear and extension add (t/R)^2.
TEST(SectorBody, WavesOfAThinRingBendIt) {
  const double mean = 0.1, thickness = 0.002;
  const SectorBody body(plain_sector(mean - 0.5 * thickness, mean + 0.5 * thickness, 24, 6, 2), kSteel, 24);
  const double stiffness = kSteel.plane_strain_modulus() * kWidth * std::pow(thickness, 3) / 12.0;
  for (const int order : {2, 3, 5}) {
    const double bent = std::pow(mean, 3) / (pi * stiffness * std::pow(order * order - 1.0, 2));
    EXPECT_NEAR(wave_compliance(body, order) / bent, 1.0, 0.01) << order;
  }
}

TEST(SectorBody, CutOfAPlainRingDoesNotMatter) {
  const SectorBody coarse(plain_sector(0.02, 0.027, 8, 12, 3), kSteel, 8);
  const SectorBody fine(plain_sector(0.02, 0.027, 24, 4, 3), kSteel, 24);
  for (const int order : {0, 2, 3, 7, 9}) {
    const double first = wave_compliance(coarse, order);
    EXPECT_NEAR(first / wave_compliance(fine, order), 1.0, 1e-8) << order;
  }
}

// Waves of high order depend on the half-space alone: 2/(pi E' b n).
TEST(SectorBody, ShortWavesFeelTheHalfSpace) {
  const SectorBody body(plain_sector(0.02, 0.027, 12, 12, 10), kSteel, 12);
  const int order = 24;
  EXPECT_NEAR(wave_compliance(body, order) * pi * kSteel.plane_strain_modulus() * kWidth * order / 2.0, 1.0,
              0.06);
}

TEST(SectorBody, HeldRaceDoesNotMove) {
  const SectorBody body(plain_sector(0.02, 0.027, 8, 8, 3), kSteel, 8);
  for (const int order : {0, 1, 3})
    EXPECT_EQ(std::abs(body.works(order, {body.race_wave(order)}, RaceConstraint::rigidly)(0, 0)), 0.0);
}

TEST(SectorBody, MeanOfTheRaceStaysWhereABodyIsFree) {
  const SectorBody body(plain_sector(0.02, 0.027, 8, 8, 3), kSteel, 8);
  const Eigen::MatrixXcd works = body.works(1, {body.race_wave(1), body.race_shear(1)}, RaceConstraint::on_average);
  const double size = wave_compliance(body, 2);
  EXPECT_LT(std::abs(works(0, 0)), 1e-9 * size);
  EXPECT_LT(std::abs(works(0, 1)), 1e-9 * size);
}

TEST(SectorBody, RefusesLessThanThreeSectors) {
  EXPECT_REFUSED(std::invalid_argument, "sector_body 1",
                 SectorBody(plain_sector(0.02, 0.027, 8, 2, 1), kSteel, 2));
}

}  // namespace
}  // namespace orbearing::gearset::rim::sector_body_test
