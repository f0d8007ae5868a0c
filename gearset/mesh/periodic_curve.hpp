// A function of period 1, smooth between given jumps: mesh stiffness or transmission error over a mesh
// period.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace orbearing::gearset {

/// Value and derivative of a curve at one point.
struct CurvePoint {
  double value = 0.0;  // [unit of the curve]
  double slope = 0.0;  // [unit of the curve per period]  exact derivative of `value`
};

/// Piecewise cubic, continuous with its slope inside each piece, on a uniform grid of its own in each piece;
/// looked up in a few nanoseconds. At a jump the curve has its right limit.
class PeriodicCurve {
 public:
  /// Samples `function` at `samples` points a period or somewhat more. It is called with fractions in [0, 1),
  /// beside a jump at a billionth of the period off it. Error: fourth power of 1 / samples.
  /// @param jumps fractions in [0, 1) where value or slope are not continuous, ascending
  /// @throws std::invalid_argument if the jumps are not ascending in [0, 1), or a sample is not finite
  PeriodicCurve(const std::function<double(double fraction)>& function, std::vector<double> jumps,
                int samples);

  /// Zero everywhere.
  PeriodicCurve() : PeriodicCurve(constant(0.0)) {}

  static PeriodicCurve constant(double value);

  /// The curve as numbers, of which `from_numbers` makes the same again, bit by bit.
  std::vector<double> numbers() const;
  /// @throws std::invalid_argument where `numbers` are not those of a curve
  static PeriodicCurve from_numbers(const std::vector<double>& numbers);

  /// Value and slope at any real fraction.
  CurvePoint at(double fraction) const {
    if (cubics_.size() == 1) return {mean_, 0.0};
    const Cubic& c = cubic_at(fraction);
    const double s = fraction;
    return {c.value + s * (c.slope + s * (c.square + s * c.cube)),
            c.per_fraction * (c.slope + s * (2.0 * c.square + 3.0 * s * c.cube))};
  }
  double value(double fraction) const { return at(fraction).value; }
  double slope(double fraction) const { return at(fraction).slope; }

  /// The curve times a factor.
  PeriodicCurve times(double factor) const;

  /// Mean over a period.
  double mean() const { return mean_; }
  /// Integral over the fraction [unit of the curve]: exact to round-off, over short ways too.
  /// @param to not less than `from`
  double integral(double from, double to) const;
  double least() const;
  double largest() const;

  /// Fractions in [0, 1), ascending; value() there is the limit from the right.
  const std::vector<double>& jumps() const { return jumps_; }

 private:
  // value + slope s + square s^2 + cube s^3 over its interval, s from 0 to 1.
  struct Cubic {
    double value = 0.0, slope = 0.0, square = 0.0, cube = 0.0;
    double per_fraction = 1.0;  // intervals per period in this piece
  };
  struct Piece {
    double begin = 0.0;
    double end = 1.0;
    double per_fraction = 1.0;
    std::size_t first = 0;
    std::size_t intervals = 1;
  };

  explicit PeriodicCurve(const Cubic& all) : pieces_(1), cubics_(1, all), mean_(all.value) {}

  void add_piece(double begin, double end, const std::vector<double>& samples, bool closed);

  // The cubic that holds at `fraction`, which becomes the position s in its interval.
  const Cubic& cubic_at(double& fraction) const {
    const double begin = pieces_.front().begin;
    // Rounding towards zero by a conversion costs a third of std::floor without its own instruction.
    double wrapped = fraction - static_cast<double>(static_cast<long long>(fraction - begin));
    if (wrapped < begin) wrapped += 1.0;
    if (wrapped >= begin + 1.0) wrapped = begin;  // the sum rounds up to a whole period
    const Piece* piece = pieces_.data();
    while (wrapped >= piece->end && piece != &pieces_.back()) ++piece;
    const double position = std::fmax(0.0, (wrapped - piece->begin) * piece->per_fraction);
    std::size_t interval = static_cast<std::size_t>(position);
    if (interval >= piece->intervals) interval = piece->intervals - 1;
    fraction = position - static_cast<double>(interval);
    return cubics_[piece->first + interval];
  }

  std::vector<double> jumps_;
  std::vector<Piece> pieces_;
  std::vector<Cubic> cubics_;
  double mean_ = 0.0;
};

}  // namespace orbearing::gearset
