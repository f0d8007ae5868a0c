// A periodic curve as a list of numbers: mean, number of jumps, jumps, number of pieces, pieces, cubics.
#include <stdexcept>

#include "gearset/mesh/periodic_curve.hpp"

namespace orbearing::gearset {

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
