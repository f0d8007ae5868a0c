#include "gearset/mesh/periodic_curve.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace orbearing::gearset {

namespace {

constexpr double beside_jump = 1e-9;      // [period]  where a limit is sampled
constexpr std::size_t least_samples = 5;  // the stencil of a piece's ends

void require_ascending(const std::vector<double>& jumps) {
  double last = -1.0;
  for (const double jump : jumps) {
    if (!(jump >= 0.0 && jump < 1.0 && jump > last)) {
      std::ostringstream text;
      text << "jumps of a periodic curve: found " << jump << "; required: ascending fractions in [0, 1)";
      throw std::invalid_argument(text.str());
    }
    last = jump;
  }
}

double sample(const std::function<double(double)>& function, double fraction) {
  const double value = function(fraction - std::floor(fraction));
  if (std::isfinite(value)) return value;
  std::ostringstream text;
  text << "periodic curve: found no finite value at the fraction " << fraction
       << "; required: a function that is finite everywhere";
  throw std::invalid_argument(text.str());
}

// Slopes per interval by differences of fourth order: central inside and round a closed piece, one-sided at
// the ends of an open one.
std::vector<double> slopes(const std::vector<double>& f, bool closed) {
  const std::size_t n = f.size() - 1;
  std::vector<double> slope(n + 1);
  const auto central = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return (f[a] - 8.0 * f[b] + 8.0 * f[c] - f[d]) / 12.0;
  };
  for (std::size_t i = 2; i + 2 <= n; ++i) slope[i] = central(i - 2, i - 1, i + 1, i + 2);
  if (closed) {
    slope[0] = slope[n] = central(n - 2, n - 1, 1, 2);
    slope[1] = central(n - 1, 0, 2, 3);
    slope[n - 1] = central(n - 3, n - 2, n, 1);
    return slope;
  }
  const auto at_end = [&](double f0, double f1, double f2, double f3, double f4) {
    return (-25.0 * f0 + 48.0 * f1 - 36.0 * f2 + 16.0 * f3 - 3.0 * f4) / 12.0;
  };
  const auto beside_end = [&](double f0, double f1, double f2, double f3, double f4) {
    return (-3.0 * f0 - 10.0 * f1 + 18.0 * f2 - 6.0 * f3 + f4) / 12.0;
  };
  slope[0] = at_end(f[0], f[1], f[2], f[3], f[4]);
  slope[1] = beside_end(f[0], f[1], f[2], f[3], f[4]);
  slope[n] = -at_end(f[n], f[n - 1], f[n - 2], f[n - 3], f[n - 4]);
  slope[n - 1] = -beside_end(f[n], f[n - 1], f[n - 2], f[n - 3], f[n - 4]);
  return slope;
}

}  // namespace

PeriodicCurve::PeriodicCurve(const std::function<double(double)>& function, std::vector<double> jumps,
                             int samples)
    : jumps_(std::move(jumps)) {
  require_ascending(jumps_);
  const bool closed = jumps_.empty();
  std::vector<double> ends = closed ? std::vector<double>{0.0} : jumps_;
  ends.push_back(ends.front() + 1.0);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double begin = ends[i], width = ends[i + 1] - ends[i];
    const double share = std::ceil(width * std::max(samples, 1));
    const std::size_t intervals = std::max(least_samples, static_cast<std::size_t>(share));
    const double beside = closed ? 0.0 : std::min(beside_jump, 1e-3 * width);
    std::vector<double> values(intervals + 1);
    for (std::size_t k = 0; k <= intervals; ++k) {
      const double inside = width * static_cast<double>(k) / static_cast<double>(intervals);
      values[k] = sample(function, begin + std::clamp(inside, beside, width - beside));
    }
    add_piece(begin, ends[i + 1], values, closed);
  }
}

PeriodicCurve PeriodicCurve::constant(double value) {
  return PeriodicCurve(Cubic{.value = value});
}

void PeriodicCurve::add_piece(double begin, double end, const std::vector<double>& f, bool closed) {
  const std::size_t intervals = f.size() - 1;
  const double per_fraction = static_cast<double>(intervals) / (end - begin);
  pieces_.push_back({begin, end, per_fraction, cubics_.size(), intervals});
  const std::vector<double> slope = slopes(f, closed);
  for (std::size_t i = 0; i < intervals; ++i) {
    const double rise = f[i + 1] - f[i];
    cubics_.push_back({f[i], slope[i], 3.0 * rise - 2.0 * slope[i] - slope[i + 1],
                       slope[i] + slope[i + 1] - 2.0 * rise, per_fraction});
    const Cubic& c = cubics_.back();
    mean_ += (c.value + c.slope / 2.0 + c.square / 3.0 + c.cube / 4.0) / per_fraction;
  }
}

PeriodicCurve PeriodicCurve::times(double factor) const {
  PeriodicCurve scaled = *this;
  scaled.mean_ *= factor;
  for (Cubic& c : scaled.cubics_)
    c = {factor * c.value, factor * c.slope, factor * c.square, factor * c.cube, c.per_fraction};
  return scaled;
}

double PeriodicCurve::integral(double from, double to) const {
  const double way = to - from, periods = std::floor(way);
  double sum = periods * mean_, rest = way - periods;
  if (cubics_.size() == 1) return way * mean_;
  double s = from;  // becomes the position in its interval
  const Cubic* c = &cubic_at(s);
  while (rest > 0.0) {
    const double step = std::min(rest, (1.0 - s) / c->per_fraction);  // [period]
    const double half = 0.5 * step * c->per_fraction, middle = s + half;
    const double gauss = half / std::sqrt(3.0);  // two points, exact for cubics and without differences
    const auto value = [&](double at) {
      return c->value + at * (c->slope + at * (c->square + at * c->cube));
    };
    sum += 0.5 * step * (value(middle - gauss) + value(middle + gauss));
    rest -= step;
    s = 0.0;
    if (++c == cubics_.data() + cubics_.size()) c = cubics_.data();
  }
  return sum;
}

double PeriodicCurve::least() const {
  double least = cubics_.front().value;
  for (const Cubic& c : cubics_) least = std::min({least, c.value, c.value + c.slope + c.square + c.cube});
  return least;
}

double PeriodicCurve::largest() const {
  double largest = cubics_.front().value;
  for (const Cubic& c : cubics_)
    largest = std::max({largest, c.value, c.value + c.slope + c.square + c.cube});
  return largest;
}

namespace {

// Reads a list from its beginning; a count or a value that is not there is an error.
struct NumberReader {
  const std::vector<double>& numbers;
  std::size_t position = 0;

  double next() {
    if (position == numbers.size())
      throw std::invalid_argument("numbers of a periodic curve: found " + std::to_string(numbers.size()) +
                                  "; required: more");
    return numbers[position++];
  }
  std::size_t count() {
    const double value = next();
    if (!(value >= 0.0 && value <= static_cast<double>(numbers.size())))
      throw std::invalid_argument("numbers of a periodic curve: found the count " + std::to_string(value) +
                                  "; required: not more than there are numbers");
    return static_cast<std::size_t>(value);
  }
};

}  // namespace

std::vector<double> PeriodicCurve::numbers() const {
  std::vector<double> out{mean_, static_cast<double>(jumps_.size())};
  out.insert(out.end(), jumps_.begin(), jumps_.end());
  out.push_back(static_cast<double>(pieces_.size()));
  for (const Piece& p : pieces_)
    out.insert(out.end(), {p.begin, p.end, p.per_fraction, static_cast<double>(p.intervals)});
  for (const Cubic& c : cubics_) out.insert(out.end(), {c.value, c.slope, c.square, c.cube, c.per_fraction});
  return out;
}

PeriodicCurve PeriodicCurve::from_numbers(const std::vector<double>& numbers) {
  NumberReader reader{numbers};
  PeriodicCurve curve{Cubic{.value = reader.next()}};
  curve.jumps_.resize(reader.count());
  for (double& jump : curve.jumps_) jump = reader.next();
  curve.pieces_.resize(reader.count());
  std::size_t first = 0;
  for (Piece& piece : curve.pieces_) {
    piece = {reader.next(), reader.next(), reader.next(), first, reader.count()};
    first += piece.intervals;
  }
  if (curve.pieces_.empty() || first == 0 || first > numbers.size() || curve.jumps_.size() > first)
    throw std::invalid_argument("numbers of a periodic curve: found no pieces, or more than their cubics");
  curve.cubics_.resize(first);
  for (Cubic& c : curve.cubics_)
    c = {reader.next(), reader.next(), reader.next(), reader.next(), reader.next()};
  if (reader.position != numbers.size())
    throw std::invalid_argument("numbers of a periodic curve: found more than those of its cubics");
  return curve;
}

}  // namespace orbearing::gearset
