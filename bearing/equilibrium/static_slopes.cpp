#include "bearing/equilibrium/static_slopes.hpp"

#include <cmath>
#include <vector>

#include "bearing/contact/line_law.hpp"
#include "mechanics/root_search.hpp"
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
  ElementSlopes slopes{Eigen::ArrayXd::Zero(count_), {}, Eigen::ArrayXXd(station_.size(), count_)};
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

namespace {

// By the place of the ball from the outer groove centre (0 and 1), by that of the inner one from the ball (2
// and 3), and along a change (4).
template <unsigned kVariables>
using BallSlopes = mechanics::SparseDual<kVariables, double>;
using AllBallSlopes = BallSlopes<0b11111u>;

template <unsigned kVariables, int index>
BallSlopes<kVariables> ball_coordinate(double value, double along) {
  BallSlopes<kVariables> x{value, {}};
  x.slope[BallSlopes<kVariables>::index(index)] = 1.0;
  x.slope[BallSlopes<kVariables>::index(4)] = along;
  return x;
}

template <class From, class To, class Convert>
void convert_constants(const BallLaw<From>& from, BallLaw<To>& to, Convert&& convert) {
  std::vector<From> constants;
  each_constant(from, [&](const From& one) { constants.push_back(one); });
  std::size_t next = 0;
  each_constant(to, [&](To& one) { one = convert(constants[next], next), ++next; });
}

// Where the numbers of balls in motion stand: the load, the constants, the groove centres of all balls, how
// the forces of each act on the ring's coordinates.
constexpr Index kLawConstants = 22;
constexpr Index kLaw = 5, kGrooves = kLaw + kLawConstants;
Index acts_at(Index count) {
  return kGrooves + 2 * count;
}
auto acts_in(const Change& numbers, Index count, Index j) {
  return Eigen::Map<const MovingBallRow::RingActs>(numbers.data() + acts_at(count) + 15 * j);
}

}  // namespace

// One ball at its place: forces on it and on the ring, with slopes that hold the ball or let it follow.
struct MovingBallSlopes::Ball {
  Eigen::Vector3d ring;                                   // [N], [N], [N m]
  Eigen::Matrix<double, 3, 2> by_grooves;                 // of it, the ball in balance
  Eigen::Vector3d ring_along;                             // the same, along the change
  Eigen::RowVector2d inner_by_grooves, outer_by_grooves;  // [N/m]  of the contact loads
  double inner_along = 0.0, outer_along = 0.0;
};

MovingBallSlopes::MovingBallSlopes(const Bearing& bearing, const RowMotion& motion, const RingLoad& load,
                                   const RingState& state)
    : held_(load.tilt.has_value()),
      count_(bearing.element_count()),
      ball_place_(state.ball_place),
      inner_control_(state.inner_control) {
  const BallRow row(bearing);
  place_ = place_of(state, row.lever());
  law_ = ball_law(bearing, motion, row);
  numbers_ = numbers(bearing, motion, load);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(numbers_.size());
  RingImbalance sum;
  for (Index j = 0; j < count_; ++j) {
    const auto acts = acts_in(numbers_, count_, j);
    sum.stiffness -= acts * ball_along(none, j).by_grooves * acts.leftCols<2>().transpose();
  }
  mechanics::hold<5>({false, false, false, held_, held_}, sum);
  stiffness_ = sum.stiffness;
}

Eigen::VectorXd MovingBallSlopes::numbers(const Bearing& bearing, const RowMotion& motion,
                                          const RingLoad& load) const {
  const MovingBallRow row(bearing, motion);
  const BallRow& geometry = row.geometry();
  Eigen::VectorXd all(acts_at(count_) + 15 * count_);
  RingPlace place = place_;
  if (load.tilt) place[3] = row.lever() * std::tan(*load.tilt);
  all.head<5>() = outer_load(load, row.lever());
  Index next = kLaw;
  const BallLaw<double> law = ball_law(bearing, motion, geometry);
  each_constant(law, [&](double one) { all[next++] = one; });
  for (Index j = 0; j < count_; ++j) {
    all.segment<2>(kGrooves + 2 * j) = geometry.coordinates(j, place);
    Eigen::Map<MovingBallRow::RingActs>(all.data() + acts_at(count_) + 15 * j) = row.acts_of(j);
  }
  return all;
}

MovingBallSlopes::Ball MovingBallSlopes::ball_along(const Change& change, Index j) const {
  using Constant = BallSlopes<0b10000u>;
  BallLaw<Constant> law{
      .attitude = law_.attitude, .gyroscopic_moment = law_.gyroscopic_moment, .filmed = law_.filmed};
  convert_constants(law_, law, [&](double value, std::size_t i) {
    return Constant{value, {change[kLaw + static_cast<Index>(i)]}};
  });
  const Eigen::Vector2d outer = ball_place_.col(j), inner = numbers_.segment<2>(kGrooves + 2 * j) - outer,
                        along = change.segment<2>(kGrooves + 2 * j);
  const auto f = law.forces<AllBallSlopes>(
      ball_coordinate<0b10011u, 0>(outer[0], 0.0), ball_coordinate<0b10011u, 1>(outer[1], 0.0),
      ball_coordinate<0b11100u, 2>(inner[0], along[0]), ball_coordinate<0b11100u, 3>(inner[1], along[1]),
      inner_control_[static_cast<std::size_t>(j)] ? SpinControl::inner : SpinControl::outer);
  const auto by_grooves = [](const AllBallSlopes& x) { return Eigen::RowVector2d(x.slope[2], x.slope[3]); };
  const auto by_place = [](const AllBallSlopes& x) {
    return Eigen::RowVector2d(x.slope[0] - x.slope[2], x.slope[1] - x.slope[3]);
  };
  Eigen::Matrix2d stiffness, ball_by_grooves;
  stiffness << -by_place(f.ball_r), -by_place(f.ball_z);
  ball_by_grooves << by_grooves(f.ball_r), by_grooves(f.ball_z);
  Eigen::Matrix2d follows;
  for (int i = 0; i < 2; ++i)
    follows.col(i) = mechanics::lengths_under_any<2>(ball_by_grooves.col(i), stiffness);
  const Eigen::Vector2d moved =
      mechanics::lengths_under_any<2>(Eigen::Vector2d(f.ball_r.slope[4], f.ball_z.slope[4]), stiffness);
  Ball ball;
  const AllBallSlopes* ring[] = {&f.ring_r, &f.ring_z, &f.ring_moment};
  for (int i = 0; i < 3; ++i) {
    ball.ring[i] = ring[i]->value;
    ball.by_grooves.row(i) = by_grooves(*ring[i]) + by_place(*ring[i]) * follows;
    ball.ring_along[i] = ring[i]->slope[4] + by_place(*ring[i]).dot(moved);
  }
  ball.inner_by_grooves = by_grooves(f.inner_load) + by_place(f.inner_load) * follows;
  ball.outer_by_grooves = by_grooves(f.outer_load) + by_place(f.outer_load) * follows;
  ball.inner_along = f.inner_load.slope[4] + by_place(f.inner_load).dot(moved);
  ball.outer_along = f.outer_load.slope[4] + by_place(f.outer_load).dot(moved);
  return ball;
}

ElementSlopes MovingBallSlopes::along(const Change& change) const {
  std::vector<Ball> balls;
  RingImbalance sum;
  sum.force = change.head<5>();
  for (Index j = 0; j < count_; ++j) {
    balls.push_back(ball_along(change, j));
    sum.force += acts_in(numbers_, count_, j) * balls.back().ring_along +
                 acts_in(change, count_, j) * balls.back().ring;
  }
  mechanics::hold<5>({false, false, false, held_, held_}, sum);
  const RingPlace ring = mechanics::lengths_under_any<5>(sum.force, stiffness_);
  ElementSlopes slopes{Eigen::ArrayXd(count_), Eigen::ArrayXd(count_), {}};
  for (Index j = 0; j < count_; ++j) {
    const Ball& ball = balls[static_cast<std::size_t>(j)];
    const Eigen::Vector2d grooves = acts_in(numbers_, count_, j).leftCols<2>().transpose() * ring;
    slopes.contact[j] = ball.inner_along + ball.inner_by_grooves.dot(grooves);
    slopes.outer[j] = ball.outer_along + ball.outer_by_grooves.dot(grooves);
  }
  return slopes;
}

}  // namespace orbearing::bearing::equilibrium
