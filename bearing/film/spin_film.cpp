#include "bearing/film/spin_film.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "bearing/contact/point_contact.hpp"

namespace orbearing::bearing::film {

namespace {

// h_0/R_x over F^0.678 and the share of the motion.
double rigid_factor(const EllipticalContact& contact, const Lubricant& oil) {
  const double g = oil.pressure_viscosity * contact.modulus, k = contact.ellipticity;
  return 1.397 * (1.0 + 0.155 * std::exp(-4.443e-5 * g)) * std::pow(k, -0.364) * (1.0 - std::exp(-2.628 * k));
}

void check(std::vector<std::string>& found, const char* what, double value, double least, double most) {
  if (value >= least && value <= most) return;
  std::ostringstream text;
  text << what << " is " << value << "; the regressions were made for " << least << " to " << most;
  found.push_back(text.str());
}

}  // namespace

EllipticalContact ball_contact(const Bearing& bearing, Race race) {
  const double diameter = bearing.balls().diameter;
  const double gamma = slenderness(bearing);
  const double along = race == Race::inner ? gamma / (1.0 - gamma) : -gamma / (1.0 + gamma);
  const PointContact contact =
      point_contact(ball_race_curvature(race, diameter, bearing.pitch_diameter,
                                        bearing.ring(race).osculation * diameter, bearing.contact_angle()),
                    bearing.material);
  return {.rolling_radius = 0.5 * diameter / (1.0 + along),
          .ellipticity = contact.ellipse.axis_ratio,
          .modulus = contact.modulus};
}

ApproachLaw approach_law(const EllipticalContact& contact, const Lubricant& oil) {
  const double radius = contact.rolling_radius;
  ApproachLaw law;
  law.constant =
      contact.modulus * radius * radius * std::pow(radius * rigid_factor(contact, oil), -1.0 / kLoadExponent);
  law.speed_scale = oil.viscosity / (contact.modulus * radius);
  law.spin_scale = oil.viscosity / contact.modulus;
  return law;
}

Films spin_films(const EllipticalContact& contact, const Lubricant& oil, const ContactMotion& motion) {
  const double r = contact.rolling_radius, e = contact.modulus, k = contact.ellipticity;
  const double g = oil.pressure_viscosity * e;
  const double f = motion.load / (e * r * r);
  const double v = std::abs(motion.rolling) * oil.viscosity / (e * r);
  const double s = std::abs(motion.spin) * oil.viscosity / e;
  const ApproachLaw law = approach_law(contact, oil);
  Films films;
  films.rigid = r * rigid_factor(contact, oil) * std::pow(f, kLoadExponent) *
                motion_share(law, motion.rolling, motion.spin);
  films.central = r * 0.769 * std::pow(v, 0.67) * std::pow(f, -0.067) * std::pow(g, 0.53) *
                  std::pow(k, 0.434) * (1.0 + 1.753 * std::exp(-0.179 * k));
  films.least = r * 8.9e-3 * std::pow(v, 0.72) * (1.0 + 1.043 * std::exp(-664.016 * f)) * std::pow(g, 0.801) *
                std::pow(k, 1.616) * (1.0 + 21.46 * std::exp(-0.3 * k)) *
                std::max(0.0, 1.0 - 1.31e10 * std::pow(s, 1.024));
  films.central_hamrock_dowson = r * 2.69 * std::pow(v, 0.67) * std::pow(g, 0.53) * std::pow(f, -0.067) *
                                 (1.0 - 0.61 * std::exp(-0.73 * k));
  films.least_hamrock_dowson =
      r * 3.63 * std::pow(v, 0.68) * std::pow(g, 0.49) * std::pow(f, -0.073) * (1.0 - std::exp(-0.68 * k));
  return films;
}

std::vector<std::string> outside_of_range(const EllipticalContact& contact, const ContactMotion& motion) {
  std::vector<std::string> found;
  check(found, "ellipticity", contact.ellipticity, 1.0, 9.5);
  check(found, "rolling speed [m/s]", std::abs(motion.rolling), 1.0, 40.0);
  check(found, "contact load [N]", motion.load, 200.0, 10000.0);
  check(found, "spin [rad/s]", std::abs(motion.spin), 0.0, 500.0);
  return found;
}

}  // namespace orbearing::bearing::film
