// The outer ring of a bearing on elements without mass, with scratches: two freedoms, after
// [ScratchVibration].
//
//              load F, weight m g                 u: ring along the load, v: across it, from the concentric
//              place
//                     |                           phi: of an element from the middle of the load zone, in the
//                     v                                sense of rotation
//         .-----------------------.
//        '  outer ring, mass m     '              (1)  delta = (u cos phi + v sin phi - G/2) cos alpha -
//        sinking
//       |        .------.           |             (2)  Q = K delta^n           where delta > 0
//       |       ( shaft  )  o phi   |             (3)  Q_d = c delta'          where delta > 0
//       |        '------'  /        |             (4)  m u'' = F + m g - sum (Q + Q_d) cos alpha cos phi
//        '        o   o   o        '              (5)  m v'' =         - sum (Q + Q_d) cos alpha sin phi
//         '-----------------------'
//         phi = 0: middle of the load zone
//
// The cage turns at its speed of pure rolling. delta' is the whole rate, that of the place of the element
// included.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bearing/defect/scratch.hpp"
#include "bearing/parameters.hpp"
#include "mechanics/convex_search.hpp"
#include "mechanics/record.hpp"

namespace orbearing::bearing::defect {

// Frequencies at which the parts of a bearing pass each other at pure rolling.

struct PassingFrequencies {
  double shaft = 0.0;         // [Hz]  of the inner ring against the outer one
  double cage = 0.0;          // [Hz]
  double outer_pass = 0.0;    // [Hz]  elements over a point of the outer race
  double inner_pass = 0.0;    // [Hz]  elements over a point of the inner race
  double element_pass = 0.0;  // [Hz]  a point of an element over either race: twice its spin in the cage
};

/// By their names in condition monitoring: FTF, BPFO, BPFI and BSF.
void describe(described::Record& record, const PassingFrequencies& frequencies);

/// Speed at which an element rolls about its own axis in the frame of the cage [rad/s], at pure rolling
/// without spin; positive the way the races of faster outer rings turn it. The axis of a ball that touches
/// its races under an angle is across the line of its contacts: eq. (6).
double rolling_speed(const Bearing& bearing, double inner_speed, double outer_speed);

/// At `shaft_speed` [rad/s] of the inner ring; the outer one is stationary.
PassingFrequencies passing_frequencies(const Bearing& bearing, double shaft_speed);
/// At the speeds [rad/s] of both rings, as a planet's bearing has them relative to the carrier: 0 of the pin
/// and that of the planet. The cage's is relative to the same frame.
PassingFrequencies passing_frequencies(const Bearing& bearing, double inner_speed, double outer_speed);

/// Damping of a contact.
enum class DampingLaw {
  viscous,        // c delta': jumps where a contact opens or closes, and may pull just before it opens
  hunt_crossley,  // a Q delta': nothing at first touch, never a pull [HuntCrossley1975]
};

constexpr described::Names<DampingLaw, 2> names_of(DampingLaw) {
  return {{{DampingLaw::viscous, "viscous"}, {DampingLaw::hunt_crossley, "hunt-crossley"}}};
}

/// The ring that vibrates.
struct VibratingRing {
  double mass = 0.0;            // [kg]
  double damping_ratio = 0.05;  // [-]  of critical, of vibration along the load about its equilibrium
  DampingLaw damping_law = DampingLaw::viscous;
};

template <class Visitor>
void describe(Visitor& visit, VibratingRing& m) {
  using namespace described;
  members(visit, m,
          input(m.mass, "bearing.outer_ring_mass", "mass of the outer ring and of what moves with it",
                {.dimension = dimension::mass, .range = positive(1e6)}),
          input(m.damping_ratio, "contact.damping_ratio",
                "damping of the ring's vibration along the load, over the critical one",
                {.range = {0.0, 1.0},
                 .reason = "within 0.25e-5 to 2.5e-5 s times the stiffness, usual for rolling bearings"}),
          input(m.damping_law, "contact.damping_model",
                "damping of a contact: of its speed alone, or of its load and speed",
                {.reason = "as the source writes it"}));
}

/// [N]
double weight_of(const VibratingRing& ring);

/// Run-up of the shaft: at a constant rate, from a share of its speed.
struct RunUp {
  double from = 1.0;  // [-]
  double time = 0.0;  // [s]  that it takes; 0: a steady speed

  /// Speed at `now` [s] over that of the end.
  double share_at(double now) const { return now < time ? from + (1.0 - from) * now / time : 1.0; }
  /// Time [s] in which the shaft turns as far at its speed of the end.
  double turned_at(double now) const {
    if (!(time > 0.0)) return now;
    const double rising = now < time ? now : time;
    return rising * (from + 0.5 * (1.0 - from) * rising / time) + (now - rising);
  }
};

/// Parameters that are constant in time. Scratches are of one kind.
struct ScratchedBearing {
  Bearing bearing;
  VibratingRing ring;
  double load = 0.0;         // [N]  on the outer ring
  double shaft_speed = 0.0;  // [rad/s]  at the end of the run-up, if there is one
  Scratch scratch;
  RunUp run_up;
};

/// Static equilibrium of the ring, and its natural frequency there.
struct StaticPosition {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]  u, v
  Eigen::ArrayXd load;                              // [N]  (elements)
  double stiffness = 0.0;                           // [N/m]  along the load
  double natural_frequency = 0.0;                   // [Hz]   undamped, along the load
  mechanics::SearchReport report;
};

/// The equations of motion in a given form: the sets of loaded contacts and of elements on scratches are
/// constant until the caller changes them, so that the equations are smooth within a step.
class ScratchedMotion {
 public:
  using State = Eigen::Vector4d;  // u, v [m], u', v' [m/s]
  using ConstState = Eigen::Ref<const Eigen::VectorXd>;

  /// Throws std::invalid_argument for impossible parameters, and where no static equilibrium is found.
  explicit ScratchedMotion(const ScratchedBearing& parameters);

  const StaticPosition& static_position() const { return static_; }
  Eigen::Index elements() const { return first_angle_.size(); }

  /// Values whose signs make the form: approach of each element [m], then for each element and scratch how
  /// far it is inside the edges [m].
  Eigen::Index switches() const { return elements() * (1 + static_cast<Eigen::Index>(middle_.size())); }
  void switch_values(double time, const ConstState& x, Eigen::Ref<Eigen::ArrayXd> values) const;
  void set_switch(Eigen::Index which, bool positive) { on_[which] = positive; }

  void rates(double time, const ConstState& x, Eigen::Ref<Eigen::VectorXd> dx) const;

  /// Contact of one element, in the form that now holds.
  struct Contact {
    double angle = 0.0;           // [rad]
    double approach = 0.0;        // [m]
    double approach_speed = 0.0;  // [m/s]
    double elastic_load = 0.0;    // [N]
    double load = 0.0;            // [N]  with damping
  };
  Contact contact(Eigen::Index element, double time, const ConstState& x) const;

  /// Time [s] in which an element passes a scratch; infinite without one.
  double passing_time() const;

  double weight() const;  // [N]  of the ring

 private:
  StaticPosition find_static_position() const;
  void set_scratches();
  void set_damping();
  double from_middle(Eigen::Index element, Eigen::Index scratch, double time) const;
  DefectDepth<double> depth_of(Eigen::Index element, double time) const;

  ScratchedBearing in_;
  BearingGeometry geometry_;
  double constant_ = 0.0;       // [N/m^n]  of both contacts of an element, one behind the other
  double exponent_ = 1.5;       // [-]
  double cosine_ = 1.0;         // [-]      of the contact angle
  double cage_speed_ = 0.0;     // [rad/s]
  double track_speed_ = 0.0;    // [rad/s]  of an element past a scratch, about the track's centre
  double track_radius_ = 0.0;   // [m]      of the scratched track
  double between_ = 0.0;        // [rad]    from one passing of a scratch to the next
  double damping_ = 0.0;        // [N s/m] or [s/m], by the law
  Eigen::ArrayXd first_angle_;  // [rad]  (elements)   at time 0
  std::vector<double> middle_;  // [rad]  (scratches)  at time 0
  ScratchLaw on_inner_, on_outer_;  // of an element that meets this race on a scratch
  Eigen::Array<bool, Eigen::Dynamic, 1> on_;  // (switches)
  StaticPosition static_;
};

}  // namespace orbearing::bearing::defect
