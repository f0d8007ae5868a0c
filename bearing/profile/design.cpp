#include "bearing/profile/design.hpp"
#include "mechanics/constants.hpp"

#include <cmath>

namespace orbearing::bearing::profile {

using constants::pi;

double amplitude(const DesignLoad& design) {
  return 2.0 * design.load / (pi * design.material.plane_strain_modulus() * design.length);
}

double width_ratio(const DesignLoad& design) {
  const double half_width = std::sqrt(8.0 * design.load * design.equivalent_radius /
                                      (pi * design.material.plane_strain_modulus() * design.length));
  return 2.0 * half_width / design.length;
}

Lundberg lundberg_for(const DesignLoad& design) {
  return {design.length, amplitude(design), width_ratio(design)};
}

JohnsGohar johns_gohar_for(const DesignLoad& design) {
  return {design.length, amplitude(design), width_ratio(design)};
}

FujiwaraKawase fujiwara_kawase_for(const DesignLoad& design, double k1, double k2, double end_drop) {
  return {design.length, end_drop, end_drop / (k1 * amplitude(design)), k2};
}

// The end's width changes the logarithm little, so that each step of the iteration loses most of the error.
double design_load_of_drop(DesignLoad design, double drop) {
  constexpr int kSteps = 60;
  const double station = kDropPosition * 0.5 * design.length;
  design.load = drop * design.material.plane_strain_modulus() * design.length;
  for (int i = 0; i < kSteps; ++i) {
    const double now = profile::drop(johns_gohar_for(design), station);
    if (!(now > 0.0)) break;
    design.load *= drop / now;
  }
  return design.load;
}

}  // namespace orbearing::bearing::profile
