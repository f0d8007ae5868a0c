// Contact of teeth over a mesh period, and deviations of their flanks from involutes.
#pragma once

#include "mechanics/described.hpp"

namespace orbearing::gearset {

/// When the stiffness of a mesh changes as pairs of teeth come and go.
enum class ToothContact {
  stepped,  // at the ends of the path of contact, all at once, whatever the load
  loaded,   // as deflection closes the gaps before and after them (gearset/mesh/loaded)
};

constexpr described::Names<ToothContact, 2> names_of(ToothContact) {
  return {{{ToothContact::stepped, "stepped"}, {ToothContact::loaded, "loaded"}}};
}

/// Form of tip relief, from its beginning to the tip.
enum class ReliefForm { linear, parabolic };

constexpr described::Names<ReliefForm, 2> names_of(ReliefForm) {
  return {{{ReliefForm::linear, "linear"}, {ReliefForm::parabolic, "parabolic"}}};
}

/// Flanks of a set, all teeth of a gear alike.
struct FlankModifications {
  ToothContact contact = ToothContact::stepped;
  double sun_relief = 0.0;     // [m]  taken off at the tip, normal to the flank
  double planet_relief = 0.0;  // [m]
  double ring_relief = 0.0;    // [m]
  double relief_length = 1.0;  // [module]  along the line of action, from where it begins to the tip
  ReliefForm relief_form = ReliefForm::linear;
  double sun_crown = 0.0;     // [m]  taken off at both ends of the face, a parabola along it
  double planet_crown = 0.0;  // [m]
  double ring_crown = 0.0;    // [m]
  double sun_slope = 0.0;   // [m]  additional distance of the flanks of sun and planet at one end of the face
  double ring_slope = 0.0;  // [m]  of ring and planet
};

template <class Visitor>
void describe(Visitor& visit, FlankModifications& m) {
  using namespace described;
  constexpr Where loaded{"gearset.tooth_contact", "loaded"};
  const auto removed = [&](double& member, const std::string& path, const std::string& meaning) {
    return input(member, "gearset." + path, meaning,
                 {.dimension = dimension::small_length,
                  .range = {0.0, 500.0},
                  .reason = "none is stated",
                  .where = loaded});
  };
  const auto slope = [&](double& member, const std::string& gear) {
    return input(member, "gearset.lead_slope." + gear,
                 "additional distance of the flanks of " + gear + " and planet at one end of the face",
                 {.dimension = dimension::small_length,
                  .range = {-500.0, 500.0},
                  .reason = "none is stated",
                  .where = loaded});
  };
  const std::string relief = "tip relief of the ", crown = "lead crown of the ";
  members(visit, m,
          input(m.contact, "gearset.tooth_contact",
                "stepped: tooth pairs enter and leave contact at the ends of the path of contact, at any "
                "load; loaded: deflection also closes the gaps before and after",
                {.reason = "as published models have it; loaded teeth are smoother"}),
          removed(m.sun_relief, "tip_relief.sun", relief + "sun, normal to its flank at the tip"),
          removed(m.planet_relief, "tip_relief.planet", relief + "planet"),
          removed(m.ring_relief, "tip_relief.ring", relief + "ring"),
          input(m.relief_length, "gearset.tip_relief.length",
                "length of the relief along the line of action, in modules",
                {.range = {0.05, 5.0},
                 .reason = "within the part of the path where two pairs carry",
                 .where = loaded}),
          input(m.relief_form, "gearset.tip_relief.form", "shape of the relief towards the tip",
                {.reason = "straight in the diagram of the profile, as drawings have it", .where = loaded}),
          removed(m.sun_crown, "lead_crown.sun", crown + "sun, taken off at both ends of the face"),
          removed(m.planet_crown, "lead_crown.planet", crown + "planet"),
          removed(m.ring_crown, "lead_crown.ring", crown + "ring"), slope(m.sun_slope, "sun"),
          slope(m.ring_slope, "ring"));
}

}  // namespace orbearing::gearset
