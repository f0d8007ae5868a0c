#include "gearset/mesh/loaded/tooth_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gearset/involute.hpp"
#include "gearset/root.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset {

namespace {

using constants::pi;

constexpr double kReach = 0.1;          // [module]  gap up to which a pair is looked at: tenfold usual loads
constexpr int kSamplesPerPeriod = 128;  // error of the tables below 1e-6 of their values

struct Window {
  double begin = 0.0;  // [mesh period]
  double end = 0.0;
};

double position_of(const MeshingGears& gears, double progress) {
  return contact_begin(gears) + contact_direction(gears) * gears.base_pitch * progress;
}

double pair_stiffness(const MeshingGears& gears, double progress, double shared) {
  const FlankGap touch = flank_gap(gears, position_of(gears, progress));
  const double hertz =
      hertz_compliance(gears.face_width, gears.second.material) / std::cos(gears.base_helix_angle);
  const double all = hertz + gear_compliance(gears.first, touch.first).sum() +
                     gear_compliance(gears.second, touch.second).sum();
  if (!(all > shared))
    throw std::domain_error(
        "the bodies of a pair of gears turn by more than their teeth give way in all; widen a bore that is "
        "narrow, or take gearset.tooth_contact: stepped");
  return 1.0 / (all - shared);
}

// Progress beyond an end of the path at which the gap grows to `reach`, at most one base pitch.
double beyond(const MeshingGears& gears, double end, double sense, double reach) {
  const auto excess = [&](double distance) {
    return flank_gap(gears, position_of(gears, end + sense * distance)).gap - reach;
  };
  return excess(1.0) > 0.0 ? bracketed_root(excess, 0.0, 1.0) : 1.0;
}

double gap_with_relief(const MeshingGears& gears, const MeshModifications& by, double progress) {
  const FlankGap touch = flank_gap(gears, position_of(gears, progress));
  return touch.gap + relief_at(gears.first, by.first, touch.first) +
         relief_at(gears.second, by.second, touch.second);
}

double tip_tangent(const MeshGear& gear) {
  return std::visit(
      [](const auto& tooth) {
        return tangent_length(tooth.base_radius, std::max(tooth.tip_radius, tooth.base_radius));
      },
      gear.tooth);
}

// Where the curves have corners, as shares of the window, ascending from 0 on.
std::vector<double> corners(const MeshingGears& gears, const MeshModifications& by, const Window& window) {
  std::vector<double> positions{window.begin};
  const auto add_position = [&](double position) {
    positions.push_back((position - contact_begin(gears)) * contact_direction(gears) / gears.base_pitch);
  };
  for (const double position : {gears.path.begin, gears.path.end, tip_takes_over(gears, PathEnd::begin),
                                tip_takes_over(gears, PathEnd::end)})
    add_position(position);
  const auto add = [&](const MeshGear& gear, const TipRelief& relief, bool first) {
    if (relief.amount == 0.0) return;
    const bool ring = std::holds_alternative<RingTooth>(gear.tooth);
    const double own = tip_tangent(gear) + (ring ? relief.length : -relief.length);
    const double position = !first ? own : ring ? own - gears.line_length : gears.line_length - own;
    add_position(position);
  };
  add(gears.first, by.first, true);
  add(gears.second, by.second, false);
  std::vector<double> shares;
  for (const double position : positions)
    shares.push_back((position - window.begin) / (window.end - window.begin));
  std::sort(shares.begin(), shares.end());
  std::vector<double> apart;
  for (const double share : shares)
    if (share >= 0.0 && share < 1.0 - 1e-6 && (apart.empty() || share > apart.back() + 1e-6))
      apart.push_back(share);
  return apart;
}

std::vector<FaceSlice> slices_of(const MeshingGears& gears, const MeshModifications& by, int slices) {
  if (gears.overlap_ratio == 0.0 && by.crown == 0.0 && by.slope == 0.0) return {FaceSlice{}};
  std::vector<FaceSlice> all;
  for (int i = 0; i < slices; ++i) {
    const double z = (i + 0.5) / slices - 0.5;  // [face width]
    all.push_back(
        {z * gears.overlap_ratio, 4.0 * by.crown * z * z + by.slope * z + 0.5 * std::abs(by.slope)});
  }
  return all;
}

double sound_deflection(const MeshingGears& gears, const MeshModifications& by, const Window& window) {
  constexpr int samples = 200;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= samples; ++i) {
    const double progress = std::lerp(window.begin, window.end, double(i) / samples);
    if (!flank_gap(gears, position_of(gears, progress)).on_involute)
      least = std::min(least, gap_with_relief(gears, by, progress));
  }
  return least;
}

// Of a planet and its mate.
MeshModifications with_planet(const FlankModifications& set, double module, double relief, double crown,
                              double slope) {
  const double length = set.relief_length * module;
  return {{relief, length, set.relief_form},
          {set.planet_relief, length, set.relief_form},
          crown + set.planet_crown,
          slope};
}

}  // namespace

MeshModifications sun_mesh_modifications(const FlankModifications& set, double module) {
  return with_planet(set, module, set.sun_relief, set.sun_crown, set.sun_slope);
}

MeshModifications ring_mesh_modifications(const FlankModifications& set, double module) {
  return with_planet(set, module, set.ring_relief, set.ring_crown, set.ring_slope);
}

double body_torsion(const MeshGear& gear) {
  const double base = base_radius(gear), root = gear.body.root_radius, held = gear.body.body_radius;
  const double between = std::abs(1.0 / (held * held) - 1.0 / (root * root));
  return base * base * between / (4.0 * pi * gear.material.shear_modulus() * gear.face_width);
}

double relief_at(const MeshGear& gear, const TipRelief& relief, double tangent) {
  if (relief.amount == 0.0) return 0.0;
  const double inward = std::holds_alternative<RingTooth>(gear.tooth) ? -1.0 : 1.0;
  const double from_tip = inward * (tip_tangent(gear) - tangent);
  const double share = std::clamp(1.0 - from_tip / relief.length, 0.0, 1.0);
  return relief.amount * (relief.form == ReliefForm::linear ? share : share * share);
}

ToothPairs tooth_pairs(const MeshingGears& gears, const MeshModifications& by, int slices) {
  const double shared = body_torsion(gears.first) + body_torsion(gears.second);
  const double ratio = gears.path.length() / gears.base_pitch;
  const double reach = kReach * std::get<ExternalTooth>(gears.second.tooth).module;
  const Window window{-beyond(gears, 0.0, -1.0, reach), ratio + beyond(gears, ratio, 1.0, reach)};
  const std::vector<double> jumps = corners(gears, by, window);
  const double width = window.end - window.begin;
  const int samples = static_cast<int>(std::ceil(kSamplesPerPeriod * width));
  // Both curves are continuous at their corners, beside which the table takes its samples.
  const auto at_corner = [&](double share) {
    constexpr double beside = 2e-9;  // [window]
    for (const double corner : jumps)
      if (std::abs(share - corner) < beside) return corner;
    return share > 1.0 - beside ? 1.0 : share;
  };
  const auto over_window = [&](const auto& function) {
    return PeriodicCurve([&](double share) { return function(window.begin + width * at_corner(share)); },
                         jumps, samples);
  };
  return {LoadedTeeth(over_window([&](double progress) { return pair_stiffness(gears, progress, shared); }),
                      over_window([&](double progress) { return gap_with_relief(gears, by, progress); }),
                      window.begin, window.end, shared, slices_of(gears, by, slices)),
          sound_deflection(gears, by, window)};
}

}  // namespace orbearing::gearset
