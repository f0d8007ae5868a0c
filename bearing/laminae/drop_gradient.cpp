#include "bearing/laminae/drop_gradient.hpp"

#include <Eigen/LU>
#include <cmath>

namespace orbearing::bearing::laminae {

namespace {

// The unknowns of one roller are w = (elastic, outer approach, tip), its equations
//   r0 = elastic - h_i(Q_i) - h_o(Q_o) - approach(u) = 0,  r1 = Q_o - Q_i - I = 0,  r2 = M_o - M_i = 0,
// those of the ring F + sum Q_o e = 0 in u, with d(approach)/du = -e. With multipliers m of the roller and v
// of the ring the measure L + m . r + v . (F + sum Q_o e) is stationary in w and u:
//   J^T m = -(dL/dw + (v . e) dQ_o/dw),   sum m_0 e = 0.
struct AdjointRoller {
  LaminaLoads inner, outer;
  double inner_film_slope = 0.0;                         // [m/N]  dh_i/dQ_i
  double outer_film_slope = 0.0;                         // [m/N]
  Eigen::Vector3d of_measure = Eigen::Vector3d::Zero();  // m where v is zero
  Eigen::Vector3d of_ring = Eigen::Vector3d::Zero();     // change of m with v . e
};

Eigen::Matrix3d roller_matrix(const LaminaForce& in, const LaminaForce& out, const AdjointRoller& adjoint) {
  const Eigen::RowVector3d inner_load(in.by_approach, -in.by_approach, -in.mixed);
  const Eigen::RowVector3d outer_load(0.0, out.by_approach, out.mixed);
  Eigen::Matrix3d matrix;
  matrix.row(0) = Eigen::RowVector3d::UnitX() - adjoint.inner_film_slope * inner_load -
                  adjoint.outer_film_slope * outer_load;
  matrix.row(1) = outer_load - inner_load;
  matrix.row(2) = Eigen::RowVector3d(-in.mixed, out.mixed + in.mixed, out.by_tip + in.by_tip);
  // A roller or a tilt that nothing holds stays where it is.
  const double lift = 1e-13 * (matrix(1, 1) + matrix(2, 2)) + 1e-30;
  matrix(1, 1) += lift;
  matrix(2, 2) += lift;
  return matrix;
}

AdjointRoller adjoint_roller(const LaminaBearing& bearing, const RollerContacts& contacts,
                             const RollerState& roller, const Eigen::ArrayXd& by_inner,
                             const Eigen::ArrayXd& by_outer) {
  const LaminaContact &inner = bearing.contact(Race::inner), &outer = bearing.contact(Race::outer);
  AdjointRoller adjoint;
  adjoint.inner = inner.loads(roller.inner_approach(), roller.inner_tip);
  adjoint.outer = outer.loads(roller.outer_approach, roller.outer_tip);
  adjoint.inner_film_slope = contacts.inner.film().slope(roller.inner.load);
  adjoint.outer_film_slope = contacts.outer.film().slope(roller.outer.load);
  const Eigen::ArrayXd in = by_inner * adjoint.inner.stiffness, out = by_outer * adjoint.outer.stiffness;
  const Eigen::Vector3d measure(in.sum(), out.sum() - in.sum(),
                                (outer.places() * out).sum() - (inner.places() * in).sum());
  const Eigen::Vector3d outer_load(0.0, roller.outer.by_approach, roller.outer.mixed);
  const Eigen::Matrix3d transposed = roller_matrix(roller.inner, roller.outer, adjoint).transpose();
  const Eigen::PartialPivLU<Eigen::Matrix3d> factors(transposed);
  adjoint.of_measure = -factors.solve(measure);
  adjoint.of_ring = -factors.solve(outer_load);
  return adjoint;
}

Eigen::Vector2d outward(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

// The multiplier v of the ring, whose stiffness is the sum over the rollers.
Eigen::Vector2d ring_multiplier(const LaminaState& state, const std::vector<AdjointRoller>& rollers) {
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();
  Eigen::Vector2d force = Eigen::Vector2d::Zero();
  for (std::size_t j = 0; j < rollers.size(); ++j) {
    const Eigen::Vector2d e = outward(state.angle[static_cast<Eigen::Index>(j)]);
    stiffness -= rollers[j].of_ring[0] * e * e.transpose();
    force += rollers[j].of_measure[0] * e;
  }
  stiffness += (1e-13 * stiffness.trace() + 1e-30) * Eigen::Matrix2d::Identity();
  return stiffness.inverse() * force;
}

DropGradient none(const LaminaBearing& bearing) {
  DropGradient gradient;
  gradient.inner = Eigen::ArrayXd::Zero(bearing.contact(Race::inner).laminae());
  gradient.outer = gradient.inner;
  return gradient;
}

}  // namespace

DropGradient drop_gradient(const LaminaBearing& bearing, const OperatingPoint& point,
                           const QuasiStaticOptions& options, const LaminaState& state,
                           const Eigen::Ref<const Eigen::ArrayXXd>& by_inner_load,
                           const Eigen::Ref<const Eigen::ArrayXXd>& by_outer_load) {
  const RaceEquilibrium problem = quasi_static_problem(bearing.bearing(), point, options, state.angle[0]);
  std::vector<AdjointRoller> rollers;
  for (Eigen::Index j = 0; j < state.angle.size(); ++j)
    rollers.push_back(adjoint_roller(bearing, problem.contacts, state.rollers[static_cast<std::size_t>(j)],
                                     by_inner_load.col(j), by_outer_load.col(j)));
  DropGradient gradient = none(bearing);
  gradient.by_load = ring_multiplier(state, rollers);
  const Eigen::ArrayXd place = bearing.contact(Race::outer).places();
  for (Eigen::Index j = 0; j < state.angle.size(); ++j) {
    const AdjointRoller& roller = rollers[static_cast<std::size_t>(j)];
    const Eigen::Vector2d e = outward(state.angle[j]);
    const double along = gradient.by_load.dot(e);
    const Eigen::Vector3d m = roller.of_measure + along * roller.of_ring;
    gradient.inner += roller.inner.stiffness *
                      (m[0] * roller.inner_film_slope + m[1] + m[2] * place - by_inner_load.col(j));
    const Eigen::ArrayXd outer = roller.outer.stiffness * (m[0] * roller.outer_film_slope - m[1] -
                                                           m[2] * place - along - by_outer_load.col(j));
    gradient.outer += outer;
    gradient.by_tilt += bearing.half_length() * (place * outer).sum() * e;
  }
  return gradient;
}

DropGradient drop_gradient(const LaminaBearing& bearing, const OperatingPoint& point,
                           const QuasiStaticOptions& options, const LaminaResult& result,
                           const Eigen::Ref<const Eigen::ArrayXXd>& by_inner_load,
                           const Eigen::Ref<const Eigen::ArrayXXd>& by_outer_load) {
  DropGradient sum = none(bearing);
  const auto positions = static_cast<Eigen::Index>(result.states.size());
  const Eigen::Index rollers = result.angle.size() / positions;
  for (Eigen::Index position = 0; position < positions; ++position) {
    const auto places = Eigen::seqN(position, rollers, positions);
    const DropGradient one =
        drop_gradient(bearing, point, options, result.states[static_cast<std::size_t>(position)],
                      by_inner_load(Eigen::all, places).eval(), by_outer_load(Eigen::all, places).eval());
    sum.inner += one.inner;
    sum.outer += one.outer;
    sum.by_tilt += one.by_tilt;
    sum.by_load += one.by_load;
  }
  return sum;
}

double by_roller_parameter(const LaminaBearing& bearing, const DropGradient& gradient) {
  const auto places = bearing.contact(Race::inner).places();
  double sum = 0.0;
  for (Eigen::Index k = 0; k < places.size(); ++k)
    sum += (gradient.inner[k] + gradient.outer[k]) *
           profile::drop_per_parameter(bearing.bearing().roller_profile, bearing.half_length() * places[k]);
  return sum;
}

double by_roller_drop(const LaminaBearing& bearing, const DropGradient& gradient, double station) {
  const auto places = bearing.contact(Race::inner).places();
  double sum = 0.0;
  for (Eigen::Index k = 0; k < places.size(); ++k)
    sum +=
        (gradient.inner[k] + gradient.outer[k]) *
        profile::drop_per_drop(bearing.bearing().roller_profile, bearing.half_length() * places[k], station);
  return sum;
}

}  // namespace orbearing::bearing::laminae
