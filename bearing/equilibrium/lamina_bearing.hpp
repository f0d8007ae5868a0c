// Quasi-static roller bearing whose contacts are cut into laminae: profiles, a bore that is tilted on its
// pin, and rollers that tilt between both.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bearing/contact/lamina_contact.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/equilibrium/race_equilibrium.hpp"
#include "bearing/equilibrium/tilted_roller.hpp"

namespace orbearing::bearing::laminae {

/// A bearing with the laminae of its contacts, derived once. Copies are independent.
class LaminaBearing {
 public:
  /// Throws std::invalid_argument where the bearing has no laminae or a profile is unsound.
  explicit LaminaBearing(const Bearing& bearing,
                         mechanics::InstructionSet set = mechanics::best_instruction_set());

  const Bearing& bearing() const { return bearing_; }
  const BearingGeometry& geometry() const { return geometry_; }
  const LaminaContact& contact(Race race) const { return race == Race::inner ? inner_ : outer_; }
  double half_length() const { return 0.5 * bearing_.rollers().length; }  // [m]

 private:
  Bearing bearing_;
  BearingGeometry geometry_;
  LaminaContact inner_;
  LaminaContact outer_;
};

/// Equilibrium at one cage angle.
struct LaminaState {
  Eigen::Vector2d displacement = Eigen::Vector2d::Zero();  // [m]    bore relative to pin, in the middle
  Eigen::VectorXd waves;  // [m]  of an elastic outer race, as RingCoordinates has them
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  // [N/m]  of the bore against its displacement
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();  // [N m]  of the rollers on the bore, against its tilt
  Eigen::ArrayXd angle;                              // [rad]  (rollers)
  std::vector<RollerState> rollers;
  SolverReport report;
};

/// Equilibria over one roller pitch of cage angles, gathered by place on the races. Arrays are over places,
/// evenly spaced from first_roller on.
struct LaminaResult {
  Eigen::ArrayXd angle;                                    // [rad]
  Eigen::ArrayXd inner_load;                               // [N]
  Eigen::ArrayXd outer_load;                               // [N]
  Eigen::ArrayXd roller_tilt;                              // [rad]  outward at positive x
  Eigen::ArrayXXd inner_lamina_load;                       // [N]    (laminae, places)
  Eigen::ArrayXXd outer_lamina_load;                       // [N]    (laminae, places)
  Eigen::Vector2d displacement = Eigen::Vector2d::Zero();  // [m]    mean over the cage angles
  Eigen::ArrayXd race_form;                          // [m]    of the outer race, mean over the cage angles
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();  // [N m]  mean over the cage angles
  Eigen::Vector2d total_bore_load = Eigen::Vector2d::Zero();  // [N]    with what cage and rollers add
  SolverReport report;                                        // the worst over the cage angles
  std::vector<LaminaState> states;                            // (cage angles)
};

/// The rollers of a bearing at one cage angle, which settle between its races wherever these stand.
class SettlingRollers {
 public:
  /// `states` (rollers): where the searches start, and what they find. All three outlive this.
  SettlingRollers(const LaminaBearing& bearing, const RaceEquilibrium& problem,
                  std::vector<RollerState>& states);

  /// Roller `j` between races that have come closer by `approach` [m] in the middle, the outer one with its
  /// end displaced by `outer_end_displacement` [m].
  const RollerState& settle(Eigen::Index j, double approach, double outer_end_displacement) const;

 private:
  TiltedRoller roller_;
  const RaceEquilibrium& problem_;
  std::vector<RollerState>& states_;
};

/// What settled rollers do to the bore: force [N] and moment [N m], conjugate to its displacement and tilt.
Eigen::Vector2d force_on_bore(const LaminaState& state);
Eigen::Vector2d moment_on_bore(const LaminaBearing& bearing, const LaminaState& state);

/// Whether all of them settled.
bool are_settled(const std::vector<RollerState>& rollers);

/// By how much profiles add to the reach of a search [m]: the largest drop of both contacts.
double largest_drop(const LaminaBearing& bearing);

/// Equilibrium with the first roller at `first_roller` [rad]; the search starts from `near` where one is
/// given. The bore's tilt is that of the point; forces balance, the moment that holds the tilt is a result.
LaminaState lamina_state(const LaminaBearing& bearing, const OperatingPoint& point,
                         const QuasiStaticOptions& options, double first_roller,
                         const LaminaState* near = nullptr);

/// A result over one roller pitch without loads yet, and what the balance at cage angle `position` of
/// `positions` adds to it: loads by place, means, the worst report, the state itself.
LaminaResult empty_result(const LaminaBearing& bearing, const OperatingPoint& point,
                          const QuasiStaticOptions& options);
void put_position(const LaminaBearing& bearing, LaminaState state, Eigen::Index position,
                  Eigen::Index positions, LaminaResult& result);

/// Equilibria over one roller pitch. Throws std::invalid_argument as quasi_static_bearing() does.
LaminaResult quasi_static_laminae(const LaminaBearing& bearing, const OperatingPoint& point,
                                  const QuasiStaticOptions& options);

}  // namespace orbearing::bearing::laminae
