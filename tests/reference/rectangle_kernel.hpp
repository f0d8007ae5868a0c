// Uniform pressure on rectangles: displacement of the half-space at a point and as a mean over another
// rectangle.
#pragma once

namespace orbearing::bearing::half_space {

/// Two aligned rectangles of equal width across, `along` [m] and `across` [m] between their middles.
struct RectanglePair {
  double along = 0.0;            // [m]
  double across = 0.0;           // [m]
  double length = 0.0;           // [m]  of the loaded one
  double receiver_length = 0.0;  // [m]
  double width = 0.0;            // [m]  of both
};

/// Integral of 1/r over the loaded rectangle [m], seen from the middle of the other; times p/(pi E*) it is
/// the displacement there. [Love1929]
double love_integral(const RectanglePair& pair);

/// Integral of 1/r over both rectangles [m^3]: Love's, integrated once more, so that loads do the same work
/// on each other both ways. Closed form near by, expansion to second order beyond.
double mutual_integral(const RectanglePair& pair);

}  // namespace orbearing::bearing::half_space
