#include "bearing/equilibrium/static_slopes.hpp"

#include <cmath>
#include <vector>

#include "bearing/contact/line_law.hpp"
#include "mechanics/sparse_dual.hpp"

namespace orbearing::bearing::equilibrium {

namespace {

using Eigen::Index;
using Slopes = mechanics::SparseDual<7u, double>;  // by both coordinates of an element, and along a change
using Change = Eigen::Ref<const Eigen::VectorXd>;

// Where the numbers stand: the load, ln of the elements' constant, the coordinates of all elements, how these
// follow the place; then the drops of rollers, or the distance of groove centres of balls that just touch.
constexpr Index kLoad = 0, kConstant = 5, kCoordinates = 6;
Index moves_at(Index count) {
  return kCoordinates + 2 * count;
}
Index shape_at(Index count) {
  return moves_at(count) + 10 * count;
}

struct Element {
  Slopes force[2];           // [N]  on its coordinates
  std::vector<Slopes> load;  // [N]  (laminae), of a ball its one
};

class Law {
 public:
  Law(const Eigen::VectorXd& numbers, const Eigen::ArrayXd& station, Index count)
      : numbers_(numbers), station_(station), count_(count) {}

  Element operator()(const Change& change, Index j) const {
    const auto along = [&](Index i) { return Slopes{numbers_[i], {0.0, 0.0, change[i]}}; };
    Slopes first = along(kCoordinates + 2 * j), second = along(kCoordinates + 2 * j + 1);
    first.slope[0] = second.slope[1] = 1.0;
    const Index shape = shape_at(count_);
    if (station_.size() == 0) return ball(along(kConstant), first, second, along(shape));
    Element element{{first * 0.0, first * 0.0}, {}};
    for (Index k = 0; k < station_.size(); ++k) {
      const Slopes approach = first + station_[k] * second - along(shape + k);
      const Slopes load =
          power_law(along(kConstant), approach, kLineExponent) * (1.0 / static_cast<double>(station_.size()));
      element.force[0] = element.force[0] + load;
      element.force[1] = element.force[1] + station_[k] * load;
      element.load.push_back(load);
    }
    return element;
  }

 private:
  static Slopes power_law(const Slopes& log_constant, const Slopes& approach, double exponent) {
    using mechanics::exponential, mechanics::logarithm;
    return approach.value > 0.0 ? exponential(exponent * logarithm(approach) + log_constant)
                                : Slopes{0.0, {0.0, 0.0, 0.0}};
  }
  static Element ball(const Slopes& log_constant, const Slopes& radial, const Slopes& axial,
                      const Slopes& groove_distance) {
    constexpr double kPointExponent = 1.5;
    const Slopes length = mechanics::root(radial * radial + axial * axial);
    const Slopes load = power_law(log_constant, length - groove_distance, kPointExponent);
    return {{load * radial / length, load * axial / length}, {load}};
  }

  const Eigen::VectorXd& numbers_;
  const Eigen::ArrayXd& station_;
  Index count_;
};

void put_shape(const RollerRow& row, Eigen::VectorXd& numbers, Index at) {
  numbers[kConstant] = std::log(row.contact().constant());
  numbers.tail(numbers.size() - at) = row.contact().drops().matrix();
}
void put_shape(const BallRow& row, Eigen::VectorXd& numbers, Index at) {
  numbers[kConstant] = std::log(row.constant());
  numbers[at] = row.groove_distance();
}

auto moves_of(const Change& numbers, Index count, Index j) {
  return Eigen::Map<const Eigen::Matrix<double, 5, 2>>(numbers.data() + moves_at(count) + 10 * j);
}

}  // namespace

StaticSlopes::StaticSlopes(const Bearing& bearing, const RingLoad& load, const RingState& state)
    : held_(load.tilt.has_value()), count_(bearing.element_count()) {
  const ElementRow row = row_of(bearing);
  if (const auto* rollers = std::get_if<RollerRow>(&row)) station_ = rollers->contact().places();
  place_ = place_of(state, std::visit([](const auto& one) { return one.lever(); }, row));
  numbers_ = numbers(bearing, load);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(numbers_.size());
  const Law law(numbers_, station_, count_);
  RingImbalance sum;
  for (Index j = 0; j < count_; ++j) {
    const Element element = law(none, j);
    Eigen::Matrix2d stiffness;
    for (int i = 0; i < 2; ++i) stiffness.row(i) << element.force[i].slope[0], element.force[i].slope[1];
    const auto moves = moves_of(numbers_, count_, j);
    sum.stiffness += moves * stiffness * moves.transpose();
  }
  mechanics::hold<5>({false, false, false, held_, held_}, sum);
  stiffness_ = sum.stiffness;
}

Eigen::VectorXd StaticSlopes::numbers(const Bearing& bearing, const RingLoad& load) const {
  return std::visit(
      [&](const auto& row) {
        const Index shape = shape_at(count_);
        Eigen::VectorXd all(shape + std::max<Index>(station_.size(), 1));
        RingPlace place = place_;
        if (load.tilt) place[3] = row.lever() * std::tan(*load.tilt);
        all.segment<5>(kLoad) = outer_load(load, row.lever());
        for (Index j = 0; j < count_; ++j) {
          all.segment<2>(kCoordinates + 2 * j) = row.coordinates(j, place);
          Eigen::Map<Eigen::Matrix<double, 5, 2>>(all.data() + moves_at(count_) + 10 * j) = row.moves(j);
        }
        put_shape(row, all, shape);
        return all;
      },
      row_of(bearing));
}

ElementSlopes StaticSlopes::along(const Change& change) const {
  const Law law(numbers_, station_, count_);
  std::vector<Element> elements;
  RingImbalance sum;
  sum.force = change.segment<5>(kLoad);
  for (Index j = 0; j < count_; ++j) {
    elements.push_back(law(change, j));
    const Slopes* force = elements.back().force;
    sum.force -= moves_of(numbers_, count_, j) * Eigen::Vector2d(force[0].slope[2], force[1].slope[2]) +
                 moves_of(change, count_, j) * Eigen::Vector2d(force[0].value, force[1].value);
  }
  mechanics::hold<5>({false, false, false, held_, held_}, sum);
  const RingPlace ring = mechanics::lengths_under<5>(sum.force, stiffness_);
  ElementSlopes slopes{Eigen::ArrayXd::Zero(count_), Eigen::ArrayXXd(station_.size(), count_)};
  for (Index j = 0; j < count_; ++j) {
    const Eigen::Vector2d follows = moves_of(numbers_, count_, j).transpose() * ring;
    const std::vector<Slopes>& load = elements[static_cast<std::size_t>(j)].load;
    for (std::size_t k = 0; k < load.size(); ++k) {
      const double one = load[k].slope[2] + load[k].slope[0] * follows[0] + load[k].slope[1] * follows[1];
      slopes.contact[j] += one;
      if (station_.size() > 0) slopes.laminae(static_cast<Index>(k), j) = one;
    }
  }
  return slopes;
}

}  // namespace orbearing::bearing::equilibrium
