// A roller bearing whose contacts are cut into laminae; a whole contact is one lamina without drop.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bearing/contact/lamina_contact.hpp"
#include "bearing/equilibrium/quasi_static_state.hpp"
#include "bearing/geometry.hpp"
#include "bearing/parameters.hpp"

namespace orbearing::bearing::laminae {

/// Drop [m] of both bodies at each lamina of a contact; one lamina without drop where the contact is whole.
/// Throws std::invalid_argument where a profile is unsound.
std::vector<double> lamina_drops(const Bearing& bearing, Race race);

/// A bearing with the laminae of its contacts, derived once. Copies are independent.
class LaminaBearing {
 public:
  /// Throws std::invalid_argument where a profile that is cut is unsound.
  explicit LaminaBearing(const Bearing& bearing);

  const Bearing& bearing() const { return bearing_; }
  const BearingGeometry& geometry() const { return geometry_; }
  /// Whether laminae are stated: whole contacts have neither profile nor tilt.
  bool is_cut() const { return bearing_.rollers().laminae > 0; }
  const LaminaContact& contact(Race race) const { return race == Race::inner ? inner_ : outer_; }
  double half_length() const { return 0.5 * bearing_.rollers().length; }  // [m]

 private:
  Bearing bearing_;
  BearingGeometry geometry_;
  LaminaContact inner_;
  LaminaContact outer_;
};

/// Force of the converged rollers on the bore [N].
Eigen::Vector2d force_on_bore(const QuasiStaticState& state);

/// Whether all of them converged.
bool are_settled(const std::vector<RollerState>& rollers);

/// By how much profiles add to the reach of a search [m]: the largest drop of both contacts.
double largest_drop(const LaminaBearing& bearing);

}  // namespace orbearing::bearing::laminae
