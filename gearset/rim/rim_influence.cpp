#include "gearset/rim/rim_influence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "gearset/rim/sector_body.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset::rim {

namespace {

using constants::pi;
using constants::two_pi;
using Complex = std::complex<double>;
constexpr Complex kI(0.0, 1.0);

// A force of a mesh on a tooth at its pitch point.
struct ToothForce {
  NodalLoad load;         // on the sector whose tooth it is
  double position = 0.0;  // [rad]  of the middle of that tooth, in the planet's frame
};

ToothForce tooth_force(const SectorBody& body, const WorkingGeometry& geometry, const MeshGeometry& mesh,
                       double pitch_position, int flank) {
  const double radius = geometry.planet.base_radius / std::cos(mesh.working_pressure_angle);
  const double half = half_thickness_angle(geometry.planet, radius);
  const double position = pitch_position + (flank == 0 ? half : -half);
  return {body.flank_force(flank, radius, mesh.working_pressure_angle), position};
}

// A wave of the race as cosine and sine; both waves of order n and -n.
void put_wave(int order, Complex wave, RaceForm& form) {
  form.cosine[order] = (order == 0 ? 1.0 : 2.0) * wave.real();
  form.sine[order] = order == 0 ? 0.0 : -2.0 * wave.imag();
}

// Eq. (2): deflection of the half-space under the force, its wave of one order.
double half_space_wave(const mechanics::Material& material, double width, int order) {
  return 2.0 / (pi * material.plane_strain_modulus() * width * order);
}

// Under a ring narrower than the face the compliance to short waves can be less than that of the half-space
// under that ring: it is then set to a small positive value.
void keep_positive(Eigen::ArrayXd& race) {
  constexpr double least = 1e-6;  // of the largest
  const double floor = least * race.maxCoeff();
  for (Eigen::Index n = 0; n < race.size(); ++n)
    if (n != 1) race[n] = std::max(race[n], floor);
}

}  // namespace

RimSection rim_section(const PlanetarySet& set, const WorkingGeometry& geometry, double race_radius,
                       double ring_width) {
  const double seat = 0.5 * set.planet_bore;
  const bool has_ring = seat > race_radius * (1.0 + 1e-6);  // else rollers run in the bore itself
  return {.tooth = geometry.planet,
          .race_radius = race_radius,
          .seat_radius = has_ring ? seat : race_radius,
          .ring_width = ring_width,
          .face_width = set.face_width};
}

RimInfluence rim_influence(const RimSection& section, const WorkingGeometry& geometry,
                           const mechanics::Material& material, int most_order, const Fineness& fineness) {
  const SectorBody body(sector_mesh(section, fineness), material, section.tooth.teeth);
  const double width = section.seat_radius > section.race_radius ? section.ring_width : section.face_width;
  const std::array<ToothForce, 2> teeth{tooth_force(body, geometry, geometry.sun_mesh, pi, 1),
                                        tooth_force(body, geometry, geometry.ring_mesh, 0.0, 0)};
  RimInfluence influence;
  influence.race = Eigen::ArrayXd::Zero(most_order + 1);
  for (RaceForm* form : {&influence.by_sun, &influence.by_ring})
    *form = {Eigen::ArrayXd::Zero(most_order + 1), Eigen::ArrayXd::Zero(most_order + 1)};
  const int most_of_teeth = (body.sectors() - 1) / 2;
  for (int n = 0; n <= std::max(most_order, most_of_teeth); ++n) {
    const std::vector<NodalLoad> loads{body.race_wave(n), teeth[0].load, teeth[1].load};
    const Eigen::MatrixXcd free = body.works(n, loads, RaceConstraint::on_average);
    const auto turned = [&](int tooth) {
      return std::exp(-kI * (n * teeth[static_cast<std::size_t>(tooth)].position));
    };
    if (n <= most_order && n != 1) {
      const double sides = n == 0 ? 1.0 : 2.0;
      influence.race[n] = sides * free(0, 0).real() * body.sectors() / (two_pi * two_pi) -
                          (n == 0 ? 0.0 : half_space_wave(material, width, n));
      put_wave(n, free(0, 1) / two_pi * turned(0), influence.by_sun);
      put_wave(n, free(0, 2) / two_pi * turned(1), influence.by_ring);
    }
    if (n > most_of_teeth) continue;
    const Eigen::MatrixXcd beyond = free - body.works(n, loads, RaceConstraint::rigidly);
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        influence.meshes(i, j) += (n == 0 ? 1.0 : 2.0) / body.sectors() *
                                  (beyond(1 + i, 1 + j) * std::conj(turned(i)) * turned(j)).real();
  }
  keep_positive(influence.race);
  return influence;
}

}  // namespace orbearing::gearset::rim
