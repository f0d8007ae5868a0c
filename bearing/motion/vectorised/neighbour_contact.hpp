// Rollers of a full complement, which no cage keeps apart, where they touch: one roller and one of its
// neighbours a lane, in polar axes of the roller.
//
//     t            n from the roller's centre to that of its neighbour, t = z x n; both spin alike, so that
//     ^            their surfaces slide on one another at the sum of their speeds
//   ( o )( o ) --> n
//
// They touch in the middle of what they overlap: both arms together are the distance of the centres, so that
// forces and moments balance.
#pragma once

#include "bearing/motion/vectorised/race_contact.hpp"
#include "mechanics/packs/aligned_array.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// Slopes of the force on the roller by its motion relative to the neighbour, and position of the neighbour.
struct NeighbourSlopes {
  ContactSlopes<Pack> on_roller;
  Pack by_neighbour_spin[3];
  Pack r, radial, orbital;  // of the neighbour
  Pack cosine, sine;        // of the angle from the roller to its neighbour

  /// Components along the neighbour's own axes of a row in the roller's.
  void to_neighbour(const Pack (&row)[2], Pack& along_r, Pack& along_t) const {
    along_r = row[0] * cosine + row[1] * sine;
    along_t = row[1] * cosine - row[0] * sine;
  }
};

/// Numbers of the neighbours of each roller, moved into its lane.
class Neighbours {
 public:
  static constexpr int kGroups = 6;  // of the state, the end displacements with it

  explicit Neighbours(int packs)
      : lanes_(packs * kLanes), ahead_(kGroups * packs), behind_(kGroups * packs) {}

  /// From the first `groups` groups of lanes of `x`.
  void take(const double* x, int groups, int rollers) {
    for (int group = 0; group < groups; ++group) {
      const double* from = x + group * lanes_;
      double *ahead = entry(ahead_, group), *behind = entry(behind_, group);
      for (int j = 0; j + 1 < rollers; ++j) {
        ahead[j] = from[j + 1];
        behind[j + 1] = from[j];
      }
      ahead[rollers - 1] = from[0];
      behind[0] = from[rollers - 1];
      for (int j = rollers; j < lanes_; ++j) ahead[j] = behind[j] = from[j] + 1.0;  // lanes without a roller
    }
  }
  Pack ahead(int group, int pack) const { return load(entry(ahead_, group) + pack * kLanes); }
  Pack behind(int group, int pack) const { return load(entry(behind_, group) + pack * kLanes); }

 private:
  double* entry(AlignedArray<Pack>& of, int group) const {
    return reinterpret_cast<double*>(&of[0]) + group * lanes_;
  }
  const double* entry(const AlignedArray<Pack>& of, int group) const {
    return reinterpret_cast<const double*>(&of[0]) + group * lanes_;
  }
  int lanes_;
  AlignedArray<Pack> ahead_, behind_;
};

/// Force of one neighbour on the roller, and what the contact stores and loses.
struct NeighbourForce : ContactForce<Pack> {
  Pack energy{}, power{};  // [J], [W]
};

/// Lanes outside `present` touch nothing. Whether any touches.
template <bool WithSlopes>
bool neighbour_contact(const NeighbourConstants& law, const Mask& present, const RollerMotion& own,
                       const RollerMotion& other, NeighbourForce& force, NeighbourSlopes& slopes) {
  const SineCosine turn = sine_cosine(other.theta - own.theta);
  const Pack d_r = other.r * turn.cosine - own.r, d_t = other.r * turn.sine;
  const Pack square = d_r * d_r + d_t * d_t, inverse = inverse_root(square), distance = square * inverse;
  const Pack approach = own.radius + other.radius - distance;
  const Mask touching = present & (approach > 0.0);
  if (!any(touching)) {
    if constexpr (WithSlopes) slopes = NeighbourSlopes{};
    return false;
  }
  const Pack n_r = d_r * inverse, n_t = d_t * inverse;
  const Pack other_way = other.r * other.orbital;
  const Pack w_r = other.radial * turn.cosine - other_way * turn.sine - own.radial;
  const Pack w_t = other.radial * turn.sine + other_way * turn.cosine - own.r * own.orbital;
  const Pack v_n = w_r * n_r + w_t * n_t, v_t = w_t * n_r - w_r * n_t;
  const Pack arm = own.radius - 0.5 * approach, other_arm = other.radius - 0.5 * approach;
  const Pack sliding = v_t - own.spin * arm - other.spin * other_arm;
  const Pack stiffness = only(touching, law.stiffness * ninth_root(approach));
  const Pack elastic = stiffness * approach;
  const Pack damped = damping_factor(law.damping, -v_n);
  const Pack load = elastic * damped;
  const auto put = [&](const Pack& friction) {
    force.f_r = -load * n_r - friction * n_t;
    force.f_t = friction * n_r - load * n_t;
    force.moment = friction * arm;
    force.load = load;
    force.energy = LineLaw::energy(elastic, approach);
    force.power = (elastic - load) * v_n + friction * sliding;
  };
  if constexpr (!WithSlopes) {
    put(law.friction.force(load, sliding));
  } else {
    using mechanics::variable;
    const auto friction = law.friction.force(variable<0>(load), variable<1>(sliding));
    put(friction.value);
    const Pack by_load = friction.template by<0>(), by_sliding = friction.template by<1>();
    const Pack by_closing = elastic * damping_factor(law.damping, variable<0>(-v_n)).template by<0>();
    // Rates along n and t and of the moment, by what the neighbour does relative to the roller.
    struct Rate {
      Pack normal, tangential, moment;
    };
    const auto rate = [&](const Pack& of_load, const Pack& of_sliding) {
      const Pack rubbed = by_load * of_load + by_sliding * of_sliding;
      return Rate{-of_load, rubbed, rubbed * arm};
    };
    Rate apart = rate(-LineLaw::slope(stiffness) * damped, -0.5 * (own.spin + other.spin));
    apart.moment += 0.5 * friction.value;
    Rate across = rate(-by_closing * v_t * inverse, -v_n * inverse);
    across.normal -= friction.value * inverse;
    across.tangential -= load * inverse;
    const Rate by_v_n = rate(-by_closing, Pack{}), by_v_t = rate(Pack{}, spread(1.0));
    const auto turned = [&](const Rate& x, Pack& out_r, Pack& out_t, Pack& out_moment) {
      out_r = x.normal * n_r - x.tangential * n_t;
      out_t = x.normal * n_t + x.tangential * n_r;
      out_moment = x.moment;
    };
    // The roller's motion relative to its neighbour is the opposite.
    const auto relative = [&](const Rate& by_n, const Rate& by_t, Pack(&into)[3][2]) {
      const auto mix = [&](const Pack& n, const Pack& t) {
        return Rate{-(n * by_n.normal + t * by_t.normal), -(n * by_n.tangential + t * by_t.tangential),
                    -(n * by_n.moment + t * by_t.moment)};
      };
      turned(mix(n_r, -n_t), into[0][0], into[1][0], into[2][0]);
      turned(mix(n_t, n_r), into[0][1], into[1][1], into[2][1]);
    };
    relative(apart, across, slopes.on_roller.by_position);
    relative(by_v_n, by_v_t, slopes.on_roller.by_velocity);
    turned(rate(Pack{}, -arm), slopes.on_roller.by_spin[0], slopes.on_roller.by_spin[1],
           slopes.on_roller.by_spin[2]);
    turned(rate(Pack{}, -other_arm), slopes.by_neighbour_spin[0], slopes.by_neighbour_spin[1],
           slopes.by_neighbour_spin[2]);
    slopes.r = other.r;
    slopes.radial = other.radial;
    slopes.orbital = other.orbital;
    slopes.cosine = turn.cosine;
    slopes.sine = turn.sine;
  }
  return true;
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
