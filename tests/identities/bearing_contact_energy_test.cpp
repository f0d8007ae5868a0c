// Every contact force is the slope of the energy it stores: F = dU/d(approach).
#include <gtest/gtest.h>

#include <vector>

#include "bearing/contact/race_contact.hpp"

namespace orbearing::bearing::bearing_contact_energy_test {
namespace {

constexpr double kStep = 1e-4;             // of the load
constexpr double kDifferenceError = 1e-7;  // C kStep^2 of central differences, C of order 1, relative

LineContact elastic(ContactLaw law) {
  return roller_race_contact(law, 5.7e-3);
}

std::vector<Film> films() {
  const FilmContact contact{.equivalent_radius = 2.3e-3,
                            .length = 5.7e-3,
                            .reduced_modulus = 2.26e11,
                            .lubricant = {.viscosity = 0.01, .pressure_viscosity = 1.5e-8}};
  return {Film(), Film(contact, 0.5), Film(contact, 50.0)};
}

TEST(ContactEnergy, LineContactLoadIsTheSlopeOfItsEnergy) {
  for (const ContactLaw law : {ContactLaw::palmgren, ContactLaw::iso16281}) {
    const LineContact contact = elastic(law);
    for (double approach = 1e-10; approach < 1e-3; approach *= 10.0) {
      const double step = kStep * approach;
      const double slope = (contact.energy(approach + step) - contact.energy(approach - step)) / (2.0 * step);
      EXPECT_NEAR(contact.load(approach), slope, slope * kDifferenceError);
    }
  }
}

// Along the load Q, with approach a(Q) = elastic - film: dU = Q da.
TEST(ContactEnergy, OiledContactLoadIsTheSlopeOfItsEnergy) {
  for (const Film& film : films()) {
    const RaceContact contact(elastic(ContactLaw::palmgren), film);
    for (double load = 2.0 * film.cap_load() + 1e-3; load < 1e6; load *= 10.0) {
      const double step = kStep * load;
      const double energy = contact.energy(load + step) - contact.energy(load - step);
      const double approach = contact.approach(load + step) - contact.approach(load - step);
      EXPECT_NEAR(energy / approach, load, load * kDifferenceError);
    }
  }
}

TEST(ContactEnergy, ComplianceIsTheSlopeOfTheApproach) {
  for (const Film& film : films()) {
    const RaceContact contact(elastic(ContactLaw::palmgren), film);
    for (double load = 2.0 * film.cap_load() + 1e-3; load < 1e6; load *= 10.0) {
      const double step = kStep * load;
      const double slope = (contact.approach(load + step) - contact.approach(load - step)) / (2.0 * step);
      EXPECT_NEAR(contact.compliance(load), slope, slope * kDifferenceError);
    }
  }
}

// From the onset on, approach and energy start at their least and only grow; no jump where the film's cap
// ends.
TEST(ContactEnergy, ApproachAndEnergyGrowFromTheOnset) {
  for (const Film& film : films()) {
    const RaceContact contact(elastic(ContactLaw::iso16281), film);
    EXPECT_EQ(contact.approach(0.0), contact.onset());
    EXPECT_EQ(contact.energy(0.0), 0.0);
    double approach = contact.onset();
    double energy = 0.0;
    for (double load = 1e-6; load < 1e6; load *= 1.1) {
      EXPECT_GT(contact.approach(load), approach);
      EXPECT_GT(contact.energy(load), energy);
      approach = contact.approach(load);
      energy = contact.energy(load);
    }
  }
}

// The film fills a part of the gap, so that at one position of the bodies the elastic approach is the larger
// by it.
TEST(ContactEnergy, FilmAddsToTheElasticApproach) {
  const Film film = films().back();
  const RaceContact contact(elastic(ContactLaw::palmgren), film);
  const double load = 500.0;
  EXPECT_GT(film.central(load), 0.0);
  EXPECT_DOUBLE_EQ(contact.elastic().approach(load), contact.approach(load) + film.central(load));
}

}  // namespace
}  // namespace orbearing::bearing::bearing_contact_energy_test
