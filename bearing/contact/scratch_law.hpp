// How far a rolling element sinks on a scratch. Written once for plain numbers and packs; no header of a
// library here, since files compiled for special instruction sets include it.
//
//        ------.          .------   race
//               \__o  o__/          o: the element rests on both edges, or on the bottom
//                |<- w ->|          s: from the middle, rising with the angle of the element
#pragma once

#include "mechanics/numbers.hpp"

namespace orbearing::bearing {

/// How far an element sinks between the edges of a scratch, over where it stands: s from the middle, width w.
enum class ScratchForm {
  raised_cosine,  // depth (1 + cos(2 pi s/w))/2: level where it begins and ends
  half_cosine,    // depth cos(pi s/w): steep edges
  edges,          // depth (1 - 2|s|/w)^2: a rigid ball that rolls over two sharp edges
  as_printed      // depth cos(2 pi s/w), eq. 3 of [ScratchVibration]: jumps at both edges
};

/// Sinking and its slope along the track.
template <class Number>
struct Sinking {
  Number depth{};  // [m]
  Number slope{};  // [-]
};

struct ScratchLaw {
  ScratchForm form = ScratchForm::raised_cosine;
  double width = 0.0;    // [m]  along the track
  double bottom = 0.0;   // [m]  depth of the scratch: no element sinks further
  double deepest = 0.0;  // [m]  sinking of an element that rests on both edges
};

/// Of depth 1 and width 1, at `s` widths from the middle.
template <class Number>
Sinking<Number> unit_sinking(ScratchForm form, const Number& s) {
  using namespace mechanics;
  constexpr double kPi = 3.14159265358979323846;
  if (form == ScratchForm::edges) {
    const Number inside = 1.0 - 2.0 * absolute(s);
    return {inside * inside, 4.0 * select(s > Number{}, -inside, inside)};
  }
  const double waves = form == ScratchForm::half_cosine ? kPi : 2.0 * kPi;
  const auto at = sine_cosine(waves * s);
  if (form == ScratchForm::raised_cosine) return {0.5 + 0.5 * at.cosine, (-0.5 * waves) * at.sine};
  return {at.cosine, -waves * at.sine};
}

/// At `from_middle` [m] from the middle; the form goes on beyond the edges, where a caller must not ask it to
/// count.
template <class Number>
Sinking<Number> sinking(const ScratchLaw& law, const Number& from_middle) {
  using namespace mechanics;
  const Sinking<Number> unit = unit_sinking(law.form, Number(from_middle * (1.0 / law.width)));
  const Number depth = law.deepest * unit.depth;
  const auto hanging = depth < Number{} + law.bottom;
  return {select(hanging, depth, Number{} + law.bottom), only(hanging, (law.deepest / law.width) * unit.slope)};
}

}  // namespace orbearing::bearing
