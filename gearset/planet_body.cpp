#include "gearset/planet_body.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "gearset/involute.hpp"
#include "gearset/stepped_planet.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset {

namespace {

struct Strip {
  double radius;      // [m]
  double half_angle;  // [rad]
  double measure;     // [m^2 per unit of the parameter]  radius times its derivative
};

// A thin ring sector of half angle psi at radius r has area 2 psi r dr and polar moment 2 psi r^3 dr. Both in
// one integral, as a complex number: the second in units of `scale`^2 [m^2], so that neither is small beside
// the other.
template <typename StripAt>
SectionMoments integrate(const StripAt& strip_at, double begin, double end, double scale) {
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
  constexpr unsigned max_depth = 8;
  constexpr double tolerance = 1e-12;  // relative; the integrands are smooth
  const auto both = [&](double parameter) {
    const Strip strip = strip_at(parameter);
    const double area = 2.0 * strip.half_angle * strip.measure, reach = strip.radius / scale;
    return std::complex<double>(area, area * reach * reach);
  };
  const std::complex<double> sum = Quadrature::integrate(both, begin, end, max_depth, tolerance);
  return {sum.real(), scale * scale * sum.imag()};
}

// By the rack's normal angle, since the thickness has an infinite slope over the radius at the root circle.
SectionMoments trochoid_part(const ExternalTooth& tooth) {
  const auto strip = [&tooth](double normal_angle) {
    const TrochoidPoint point = trochoid_point(tooth, normal_angle);
    return Strip{point.radius, point.half_angle, point.radius * point.radius_slope};
  };
  return integrate(strip, 0.0, trochoid_normal_angle(tooth, tooth.form_radius), tooth.root_radius);
}

// By the tangent length t, since r dr = t dt stays smooth down to the base circle.
SectionMoments involute_part(const ExternalTooth& tooth) {
  const auto strip = [&tooth](double tangent) {
    const double radius = std::hypot(tooth.base_radius, tangent);
    return Strip{radius, half_thickness_angle(tooth, radius), tangent};
  };
  return integrate(strip, tangent_length(tooth.base_radius, tooth.form_radius),
                   tangent_length(tooth.base_radius, tooth.tip_radius), tooth.root_radius);
}

SectionMoments annulus(double inner_radius, double outer_radius) {
  return {constants::pi * (std::pow(outer_radius, 2) - std::pow(inner_radius, 2)),
          constants::pi / 2.0 * (std::pow(outer_radius, 4) - std::pow(inner_radius, 4))};
}

}  // namespace

SectionMoments section_moments(const ExternalTooth& tooth, double bore_radius) {
  const SectionMoments rim = annulus(bore_radius, tooth.root_radius);
  const SectionMoments fillet = trochoid_part(tooth);
  const SectionMoments flank = involute_part(tooth);
  return {rim.area + tooth.teeth * (fillet.area + flank.area),
          rim.polar_second_moment + tooth.teeth * (fillet.polar_second_moment + flank.polar_second_moment)};
}

SectionMoments section_moments(const RingTooth& tooth, double outside_radius) {
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
  const auto teeth = [&](int power) {
    const auto strip = [&](double radius) {
      return 2.0 * half_thickness_angle(tooth, radius) * std::pow(radius, power);
    };
    return tooth.teeth * Quadrature::integrate(strip, tooth.tip_radius, tooth.root_radius, 8, 1e-9);
  };
  const SectionMoments rim = annulus(tooth.root_radius, outside_radius);
  return {rim.area + teeth(1), rim.polar_second_moment + teeth(3)};
}

PlanetBody planet_body(const PlanetarySet& set, const WorkingGeometry& geometry) {
  const double bore_radius = 0.5 * set.planet_bore;
  if (bore_radius < 0.0 ||
      bore_radius >= std::min(geometry.planet.root_radius, geometry.at_ring().root_radius)) {
    throw std::domain_error("the planet's bore leaves no rim under its tooth root; choose a smaller bearing");
  }
  const SectionMoments section = section_moments(geometry.planet, bore_radius);
  const double mass_per_area = set.density * set.face_width;
  PlanetBody body{section.area, mass_per_area * section.area, mass_per_area * section.polar_second_moment};
  if (!geometry.second) return body;
  const SectionMoments other = section_moments(*geometry.second, bore_radius);
  const double per_area = set.density * ring_face(set);
  const GearPlanes planes = gear_planes(set);
  body.first_moment = planes.sun * body.mass + planes.ring * per_area * other.area;
  body.mass += per_area * other.area;
  body.inertia += per_area * other.polar_second_moment;
  return body;
}

}  // namespace orbearing::gearset
