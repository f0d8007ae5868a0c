// Depth of a rolling element on a scratch. Written once for plain numbers and packs; no header of a library
// here, since files compiled for special instruction sets include it.
//
//        ------.          .------   race
//               \__o  o__/          o: the element rests on both edges, or on the bottom
//                |<- w ->|          s: from the middle, rising with the angle of the element
#pragma once

#include "mechanics/numbers.hpp"

namespace orbearing::bearing {

/// Depth of an element between the edges of a scratch, over its position: s from the middle, width w.
enum class ScratchForm {
  raised_cosine,       // depth (1 + cos(2 pi s/w))/2: level where it begins and ends
  half_cosine,         // depth cos(pi s/w): steep edges
  edges,               // depth (1 - 2|s|/w)^2: a rigid ball that rolls over two sharp edges
  literature_variant,  // depth cos(2 pi s/w), eq. 3 of [ScratchVibration]: jumps at both edges
  profile              // a table, of a scratch that was measured
};

/// Sinking and its slope along the track.
template <class Number>
struct DefectDepth {
  Number depth{};  // [m]
  Number slope{};  // [-]
  Number bend{};   // [1/m]  slope of the slope
};

/// Depths at equal distances from one edge to the other; between them cubics that share value and slope.
struct DefectDepthTable {
  static constexpr int kPoints = 65;

  double depth[kPoints]{};  // [m]
  double slope[kPoints]{};  // [-]
};

struct ScratchLaw {
  ScratchForm form = ScratchForm::raised_cosine;
  double width = 0.0;      // [m]  along the track
  double bottom = 0.0;     // [m]  depth of the scratch: no element sinks further
  double deepest = 0.0;    // [m]  sinking of an element that rests on both edges
  DefectDepthTable table;  // of a profile: what an element sinks, whatever `bottom` and `deepest` say
};

/// Depth of a scratch of depth 1 and width 1, at `s` widths from the middle.
template <class Number>
DefectDepth<Number> unit_depth(ScratchForm form, const Number& s) {
  using namespace mechanics;
  constexpr double kPi = 3.14159265358979323846;
  if (form == ScratchForm::edges) {
    const Number inside = 1.0 - 2.0 * absolute(s);
    return {inside * inside, 4.0 * select(s > Number{}, -inside, inside), Number{} + 8.0};
  }
  const double waves = form == ScratchForm::half_cosine ? kPi : 2.0 * kPi;
  const auto at = sine_cosine(waves * s);
  if (form == ScratchForm::raised_cosine)
    return {0.5 + 0.5 * at.cosine, (-0.5 * waves) * at.sine, (-0.5 * waves * waves) * at.cosine};
  return {at.cosine, -waves * at.sine, (-waves * waves) * at.cosine};
}

/// By the table, at `from_middle` [m] from the middle.
[[gnu::always_inline]] inline DefectDepth<double> tabulated_depth(const ScratchLaw& law, double from_middle) {
  const double spacing = law.width / (DefectDepthTable::kPoints - 1);  // [m]
  const double position = (from_middle + 0.5 * law.width) / spacing;
  if (!(position >= 0.0 && position <= DefectDepthTable::kPoints - 1)) return {};
  const int last = DefectDepthTable::kPoints - 2, whole = static_cast<int>(position);
  const int i = whole < last ? whole : last;
  const double t = position - i, mean = (law.table.depth[i + 1] - law.table.depth[i]) / spacing;
  const double a = law.table.slope[i], b = law.table.slope[i + 1];
  const double bend = 3.0 * mean - 2.0 * a - b, twist = a + b - 2.0 * mean;
  return {law.table.depth[i] + spacing * t * (a + t * (bend + t * twist)),
          a + t * (2.0 * bend + 3.0 * t * twist), (2.0 * bend + 6.0 * t * twist) / spacing};
}

/// The same for a pack, number by number: few are on a scratch at a time.
template <class Number>
DefectDepth<Number> tabulated_depths(const ScratchLaw& law, const Number& from_middle) {
  constexpr int kNumbers = sizeof(Number) / sizeof(double);
  double at[kNumbers], depth[kNumbers], slope[kNumbers], bend[kNumbers];
  __builtin_memcpy(at, &from_middle, sizeof at);
  for (int i = 0; i < kNumbers; ++i) {
    const DefectDepth<double> one = tabulated_depth(law, at[i]);
    depth[i] = one.depth;
    slope[i] = one.slope;
    bend[i] = one.bend;
  }
  DefectDepth<Number> all;
  __builtin_memcpy(&all.depth, depth, sizeof depth);
  __builtin_memcpy(&all.slope, slope, sizeof slope);
  __builtin_memcpy(&all.bend, bend, sizeof bend);
  return all;
}

/// At `from_middle` [m] from the middle; the form goes on beyond the edges, where a caller must not ask it to
/// count.
template <class Number>
DefectDepth<Number> defect_depth(const ScratchLaw& law, const Number& from_middle) {
  using namespace mechanics;
  if (law.form == ScratchForm::profile) return tabulated_depths(law, from_middle);
  const DefectDepth<Number> unit = unit_depth(law.form, Number(from_middle * (1.0 / law.width)));
  const Number depth = law.deepest * unit.depth;
  const auto hanging = depth < Number{} + law.bottom;
  return {select(hanging, depth, Number{} + law.bottom),
          only(hanging, (law.deepest / law.width) * unit.slope),
          only(hanging, (law.deepest / (law.width * law.width)) * unit.bend)};
}

/// Sinking of an element on a round track, and its slopes by the element's angle.
template <class Number>
struct TrackDepth {
  Number depth{};     // [m]
  Number by_angle{};  // [m/rad]
  Number bend{};      // [m/rad^2]
};

/// On a track of radius `radius` [m] whose scratch lies at the angle of which `ahead` and `towards` are sine
/// and cosine from the element's; the sine approximates the angle. Zero off the scratch.
template <class Number>
TrackDepth<Number> track_depth(const ScratchLaw& law, double radius, const Number& ahead,
                               const Number& towards) {
  using namespace mechanics;
  const Number from_middle = radius * ahead;
  const auto inside = (towards > Number{}) & (absolute(from_middle) < Number{} + 0.5 * law.width);
  if (!any(inside)) return {};
  const DefectDepth<Number> one = defect_depth(law, from_middle);
  const Number along = radius * towards;
  return {only(inside, one.depth), only(inside, along * one.slope),
          only(inside, along * along * one.bend - from_middle * one.slope)};
}

// Scratches of the bearing as a motion meets them. No header of a library here, since files compiled for
// special instruction sets include it.

/// A scratch across a race, which turns with it.
struct RaceScratch {
  double radius = 0.0;  // [m]    of the race
  double angle = 0.0;   // [rad]  of its middle when the race has turned by nothing
  ScratchLaw law;
};

/// A scratch along a roller, which turns with it and meets both races. One roller may have several.
struct RollerScratch {
  int roller = 0;
  int followed = 0;     // which of the rollers that are followed in their turning
  double radius = 0.0;  // [m]    of the roller
  double angle = 0.0;   // [rad]  of its middle when the roller has turned by nothing
  ScratchLaw on_inner;
  ScratchLaw on_outer;
};

/// Depth of a scratch at the angle `scratch` [rad], in a contact whose normal is at the angle with `cosine`
/// and `sine`.
template <class Number>
TrackDepth<Number> depth_at(const ScratchLaw& law, double radius, double scratch, const Number& cosine,
                            const Number& sine) {
  const auto at = mechanics::sine_cosine(scratch);
  return track_depth(law, radius, Number(sine * at.cosine - cosine * at.sine),
                     Number(cosine * at.cosine + sine * at.sine));
}

}  // namespace orbearing::bearing
