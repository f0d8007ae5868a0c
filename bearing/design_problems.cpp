#include "bearing/design_problems.hpp"

#include <cmath>
#include <utility>

#include "mechanics/constants.hpp"
#include "mechanics/member_keys.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::bearing {

using mechanics::Problems;
using mechanics::significant;

namespace {

std::string millimetres(double length, int digits = 4) {
  return significant(1e3 * length, digits) + " mm";
}

double spacing_of(double pitch_diameter, int elements) {
  return pitch_diameter * std::sin(constants::pi / elements);
}

struct Races {
  double inner = 0.0, outer = 0.0;  // [m]  diameters
};

/// Finds what does not fit in one bearing.
class DesignCheck {
 public:
  explicit DesignCheck(const BearingDesign& design) : design_(design), key_(design) {}

  Problems problems() {
    find_crowded_rollers();
    const std::optional<Races> races = races_of_rollers();
    if (races) find_bad_rings(*races);
    if (design_.caged) find_bad_cage(races);
    find_bad_widths();
    return std::move(found_);
  }
  Problems of_balls() {
    if (design_.balls == 0 || design_.ball_diameter == 0.0 || design_.pitch_diameter == 0.0) return {};
    find_open_grooves();
    find_ellipse_along_rolling();
    const double spacing = spacing_of(design_.pitch_diameter, design_.balls);
    if (design_.ball_diameter >= spacing)
      found_.push_back({key_(design_.balls),
                        std::to_string(design_.balls) +
                            " balls do not fit around the pitch circle; a ball diameter (" +
                            millimetres(design_.ball_diameter) + ") less than their centre distance, " +
                            millimetres(spacing) + ", is required"});
    return std::move(found_);
  }

 private:
  template <class Member>
  void require_less(const Member& of, const char* requirement, double low, double high) {
    if (!are_in_order(low, high)) require_order(key_(of), requirement, low, high, found_);
  }

  void find_crowded_rollers() {
    const CylindricalRollers& rollers = design_.rollers;
    if (rollers.count == 0 || rollers.diameter == 0.0 || design_.pitch_diameter == 0.0) return;
    const double spacing = spacing_of(design_.pitch_diameter, rollers.count);
    constexpr double round_off = 1e-12;  // rollers that touch fit
    if (rollers.diameter > spacing * (1.0 + round_off))
      found_.push_back({key_(rollers.count),
                        std::to_string(rollers.count) +
                            " rollers do not fit around the pitch circle; a roller diameter (" +
                            millimetres(rollers.diameter, 6) + ") of at most their centre distance, " +
                            millimetres(spacing, 6) + ", is required. Use fewer or thinner rollers"});
    else if (design_.pocket_clearance && design_.caged)
      require_less(design_.pocket_clearance, "room for bars between the pockets: a roller with its play",
                   rollers.diameter + *design_.pocket_clearance, spacing);
  }

  // Grooves of balls let a cage reach past the balls.
  std::optional<Races> races_of_rollers() const {
    if (design_.pitch_diameter == 0.0 || design_.rollers.diameter == 0.0) return std::nullopt;
    const double reach = design_.rollers.diameter + 0.5 * design_.radial_clearance;
    return Races{design_.pitch_diameter - reach, design_.pitch_diameter + reach};
  }

  void find_bad_rings(const Races& races) {
    require_less(design_.rollers.diameter, "an inner raceway: a roller with half the clearance",
                 0.5 * (races.outer - races.inner), 0.5 * (races.outer + races.inner));
    // Without a ring, seat and race are one.
    if (design_.bore > 0.0 && design_.rings == Rings::both)
      require_less(design_.bore, "a bore within the inner raceway", design_.bore, races.inner);
    if (design_.bore > 0.0)
      require_less(design_.pin_bore, "a hole in the pin", design_.pin_bore, design_.bore);
    if (design_.outside_diameter > 0.0 && design_.rings != Rings::none)
      require_less(design_.outside_diameter, "an outer raceway within the outside diameter", races.outer,
                   design_.outside_diameter);
  }

  void find_bad_cage(const std::optional<Races>& races) {
    const double &inner = design_.cage.inner_diameter, &outer = design_.cage.outer_diameter;
    if (inner == 0.0 || outer == 0.0) return;
    require_less(inner, "an inner diameter of the cage", inner, outer);
    if (races) {
      require_less(inner, "a cage around the inner raceway: this", races->inner, inner);
      require_less(outer, "a cage within the outer raceway", outer, races->outer);
    }
    if (design_.guide_land.value_or(0.0) == 0.0) return;  // rollers or balls guide the cage
    if (design_.cage.guidance == Race::outer)
      require_less(design_.guide_land, "a land around the cage: the cage's outer diameter", outer,
                   *design_.guide_land);
    else
      require_less(design_.guide_land, "a land within the cage", *design_.guide_land, inner);
  }

  void find_bad_widths() {
    const double &roller = design_.rollers.length, &cage = design_.cage.width;
    if (roller == 0.0) return;
    if (design_.width > 0.0 && !are_in_order(roller, design_.width, true))
      require_order(key_(roller), "a roller within the rings", roller, design_.width, found_, true);
    if (cage > 0.0) require_less(cage, "a cage longer than its rollers: a roller", roller, cage);
  }

  void find_open_grooves() {
    if (design_.inner_osculation == 0.0 || design_.outer_osculation == 0.0) return;
    const double openness = design_.inner_osculation + design_.outer_osculation - 1.0;
    const double most = 2.0 * openness * design_.ball_diameter * std::cos(design_.contact_angle);
    if (design_.radial_clearance >= most)
      found_.push_back({key_(design_.radial_clearance),
                        "a clearance in which the balls touch at no contact angle; less than " +
                            significant(1e6 * most, 4) + " um is required by the grooves"});
  }

  // Laws of film and friction hold where the ellipse of contact is longer across the direction of rolling
  // than along it: gamma/(1 + gamma) <= 1/(2 f) on the outer race, which is the first to turn its ellipse.
  void find_ellipse_along_rolling() {
    const double gamma = design_.ball_diameter * std::cos(design_.contact_angle) / design_.pitch_diameter;
    if (design_.outer_osculation == 0.0 || gamma * (2.0 * design_.outer_osculation - 1.0) <= 1.0) return;
    found_.push_back(
        {key_(design_.outer_osculation),
         "an outer groove so wide that the ellipse of contact is longer along the direction of rolling; at "
         "most " +
             significant(0.5 * (1.0 + 1.0 / gamma), 4) + " is required by balls of this size"});
  }

  const BearingDesign& design_;
  mechanics::MemberKeys<BearingDesign> key_;
  Problems found_;
};

}  // namespace

bool are_in_order(double low, double high, bool may_equal) {
  // Sums of lengths that fill a space exactly may miss it by rounding.
  constexpr double rounding = 1e-12;  // [m]
  return may_equal ? low <= high + rounding : low < high;
}

void require_order(const std::string& key, const char* requirement, double low, double high, Problems& found,
                   bool may_equal) {
  if (are_in_order(low, high, may_equal)) return;
  found.push_back({key, "'" + mechanics::as_written(key) + "' does not fit; " + requirement + " (" +
                            millimetres(low) + ") " + (may_equal ? "of at most " : "less than ") +
                            millimetres(high) + " is required"});
}

Problems problems(const BearingDesign& design) {
  return DesignCheck(design).problems();
}

Problems ball_problems(const BearingDesign& design) {
  return DesignCheck(design).of_balls();
}

}  // namespace orbearing::bearing
