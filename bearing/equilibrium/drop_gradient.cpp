#include "bearing/equilibrium/drop_gradient.hpp"

#include "mechanics/convex_search.hpp"

namespace orbearing::bearing::laminae {

namespace {

// The unknowns of one roller are E (elastic) and y = (outer approach, end displacement), its equations
//   r0 = E - h_i(Q_i) - h_o(Q_o) - approach(u) = 0,  r = (Q_o - Q_i - I, M_o - M_i) = 0,
// those of the ring F + sum Q_o e = 0 in u, with d(approach)/du = -e (u and e with the waves of an elastic
// race). With multipliers m0, m of the roller and v of the ring, L + m0 r0 + m . r + v . (F + sum Q_o e) is
// stationary in all unknowns. With H = dr/dy, symmetric, p = dy/dE, S = d(load)/dE, f = dh_i/dQ + dh_o/dQ, t
// = v . e and s = H^-1 dL/dy this gives
//   m0 = -(dL/dE + p . dL/dy + t S)/(1 - f S),  sum m0 e = 0,
//   m = -s - t (1 - p_a, -p_b) + m0 (f_o (1 - p_a, -p_b) - f_i p).
struct AdjointRoller {
  LaminaLoads inner, outer;
  double inner_film_slope = 0.0;                       // [m/N]  f_i
  double outer_film_slope = 0.0;                       // [m/N]  f_o
  double of_measure = 0.0;                             // m0 where v is zero
  Eigen::Vector2d settling = Eigen::Vector2d::Zero();  // s
};

AdjointRoller adjoint_roller(const LaminaBearing& bearing, const RollerContacts& contacts,
                             const RollerState& roller, const Eigen::ArrayXd& by_inner,
                             const Eigen::ArrayXd& by_outer) {
  const LaminaContact &inner = bearing.contact(Race::inner), &outer = bearing.contact(Race::outer);
  AdjointRoller adjoint;
  adjoint.inner = inner.loads(roller.inner_approach(), roller.inner_end_displacement);
  adjoint.outer = outer.loads(roller.outer_approach, roller.outer_end_displacement);
  adjoint.inner_film_slope = contacts.inner.film().slope(roller.inner.load);
  adjoint.outer_film_slope = contacts.outer.film().slope(roller.outer.load);
  const Eigen::ArrayXd in = by_inner * adjoint.inner.stiffness, out = by_outer * adjoint.outer.stiffness;
  const Eigen::Vector2d by_place(out.sum() - in.sum(), (outer.places() * out - inner.places() * in).sum());
  adjoint.of_measure = -roller.per_approach * (in.sum() + roller.per_elastic.dot(by_place));
  adjoint.settling = mechanics::lengths_under<2>(by_place, settling_stiffness(roller));
  return adjoint;
}

// m0 and m for the ring's multiplier along the roller.
struct RollerMultipliers {
  double approach = 0.0;
  Eigen::Vector2d balance = Eigen::Vector2d::Zero();
};

RollerMultipliers multipliers(const AdjointRoller& adjoint, const RollerState& roller, double along) {
  const Eigen::Vector2d outer = Eigen::Vector2d::UnitX() - roller.per_elastic;
  RollerMultipliers m;
  m.approach = adjoint.of_measure - along * roller.stiffness;
  m.balance = -adjoint.settling - along * outer +
              m.approach * (adjoint.outer_film_slope * outer - adjoint.inner_film_slope * roller.per_elastic);
  return m;
}

// The multiplier v of the ring's coordinates, which resist as the rollers do and as the race itself does,
// along each roller.
Eigen::ArrayXd ring_multiplier(const RaceEquilibrium& problem, const QuasiStaticState& state,
                               const std::vector<AdjointRoller>& rollers) {
  std::vector<RollerState> none;
  const RingsOnRollers<Eigen::Dynamic> ring = ring_on_rollers<Eigen::Dynamic>(problem, none);
  const Eigen::MatrixXd& outward = ring.rows.front().outward;
  Eigen::MatrixXd stiffness = ring.stiffness;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(outward.rows());
  for (std::size_t j = 0; j < rollers.size(); ++j) {
    const auto e = outward.col(static_cast<Eigen::Index>(j));
    stiffness += state.rollers[j].stiffness * e * e.transpose();
    force += rollers[j].of_measure * e;
  }
  return outward.transpose() * mechanics::lengths_under<Eigen::Dynamic>(force, stiffness);
}

DropGradient none(const LaminaBearing& bearing) {
  DropGradient gradient;
  gradient.inner = Eigen::ArrayXd::Zero(bearing.contact(Race::inner).laminae());
  gradient.outer = gradient.inner;
  return gradient;
}

}  // namespace

DropGradient drop_gradient(const LaminaBearing& bearing, const OperatingPoint& point,
                           const QuasiStaticOptions& options, const QuasiStaticState& state,
                           const Eigen::Ref<const Eigen::ArrayXXd>& by_inner_load,
                           const Eigen::Ref<const Eigen::ArrayXXd>& by_outer_load) {
  const RaceEquilibrium problem = quasi_static_problem(bearing, point, options, state.angle[0]);
  std::vector<AdjointRoller> rollers;
  for (Eigen::Index j = 0; j < state.angle.size(); ++j)
    rollers.push_back(adjoint_roller(bearing, problem.contacts, state.rollers[static_cast<std::size_t>(j)],
                                     by_inner_load.col(j), by_outer_load.col(j)));
  DropGradient gradient = none(bearing);
  const Eigen::ArrayXd along = ring_multiplier(problem, state, rollers);
  const Eigen::ArrayXd place = bearing.contact(Race::outer).places();
  for (Eigen::Index j = 0; j < state.angle.size(); ++j) {
    const AdjointRoller& roller = rollers[static_cast<std::size_t>(j)];
    const RollerMultipliers m = multipliers(roller, state.rollers[static_cast<std::size_t>(j)], along[j]);
    const Eigen::ArrayXd balance = m.balance[0] + m.balance[1] * place;
    gradient.inner +=
        roller.inner.stiffness * (m.approach * roller.inner_film_slope + balance - by_inner_load.col(j));
    gradient.outer += roller.outer.stiffness *
                      (m.approach * roller.outer_film_slope - balance - along[j] - by_outer_load.col(j));
  }
  return gradient;
}

DropGradient drop_gradient(const LaminaBearing& bearing, const OperatingPoint& point,
                           const QuasiStaticOptions& options, const QuasiStaticResult& result,
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
  }
  return sum;
}

}  // namespace orbearing::bearing::laminae
