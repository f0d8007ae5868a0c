// Films of the printed rows of [Guo2013]. The contact and the oil are not printed: four constants were fitted
// to these rows.
#include <gtest/gtest.h>

#include "bearing/film/spin_film.hpp"

namespace orbearing::bearing::film::guo2013_film_test {
namespace {

constexpr double kPublished = 0.015;  // required of the rows; the fit leaves 0.2 %

struct Row {
  double load, rolling, spin;              // [N], [m/s], [rad/s]
  double central_hamrock_dowson, central;  // [um]
  double least_hamrock_dowson, least;      // [um]
};

constexpr EllipticalContact contact{.rolling_radius = 5.240e-3, .ellipticity = 8.813, .modulus = 2.26e11};
constexpr Lubricant oil{.viscosity = 0.01988, .pressure_viscosity = 19.75e-9};

TEST(Guo2013Film, PrintedRows) {
  for (const Row& row :
       {Row{500, 5, 200, 0.4040, 0.4041, 0.3268, 0.3210}, Row{500, 10, 300, 0.6428, 0.6429, 0.5236, 0.4891},
        Row{500, 15, 400, 0.8435, 0.8436, 0.6898, 0.6015}}) {
    const Films films =
        spin_films(contact, oil, {.load = row.load, .rolling = row.rolling, .spin = row.spin});
    EXPECT_NEAR(1e6 * films.central_hamrock_dowson / row.central_hamrock_dowson, 1.0, kPublished);
    EXPECT_NEAR(1e6 * films.central / row.central, 1.0, kPublished);
    EXPECT_NEAR(1e6 * films.least_hamrock_dowson / row.least_hamrock_dowson, 1.0, kPublished);
    EXPECT_NEAR(1e6 * films.least / row.least, 1.0, kPublished);
  }
}

// Eq. (10) solved for the load returns the load of its approach.
TEST(Guo2013Film, LoadByApproach) {
  const ApproachLaw law = approach_law(contact, oil);
  for (const double load : {200.0, 3000.0, 10000.0})
    for (const double spin : {0.0, 450.0}) {
      const Films films = spin_films(contact, oil, {.load = load, .rolling = 20.0, .spin = spin});
      EXPECT_NEAR(load_at(law, films.rigid, 20.0, spin) / load, 1.0, 1e-12);
    }
  EXPECT_EQ(load_at(law, -1e-6, 20.0, 0.0), 0.0);
}

TEST(Guo2013Film, RangesAreReported) {
  EXPECT_TRUE(outside_of_range(contact, {.load = 500.0, .rolling = 5.0, .spin = 200.0}).empty());
  EXPECT_EQ(outside_of_range(contact, {.load = 100.0, .rolling = 50.0, .spin = 900.0}).size(), 3u);
}

}  // namespace
}  // namespace orbearing::bearing::film::guo2013_film_test
