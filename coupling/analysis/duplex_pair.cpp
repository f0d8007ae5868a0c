#include "coupling/analysis/duplex_pair.hpp"

#include <algorithm>

#include "mechanics/member_keys.hpp"

namespace orbearing::analysis {

namespace duplex = bearing::duplex;

duplex::Shaft Spindle::shaft() const {
  duplex::Shaft shaft{.mass = mass, .levers = {first_lever, second_lever}};
  if (const auto* stated = std::get_if<ShaftOfInertia>(&form)) {
    shaft.inertia_x = stated->inertia_x;
    shaft.inertia_y = stated->inertia_y;
  } else {
    const auto& cylinder = std::get<CylindricalShaft>(form);
    shaft.inertia_x = shaft.inertia_y = duplex::cylinder_inertia(mass, cylinder.diameter, cylinder.density);
  }
  return shaft;
}

bool PreloadedPair::rotates() const {
  return operation.shaft_speed != 0.0 ||
         std::ranges::any_of(operation.speeds, [](double speed) { return speed != 0.0; });
}

bool PreloadedPair::has_linear_formulas() const {
  return arrangement != duplex::Arrangement::back_to_back && operation.shaft_speed == 0.0;
}

duplex::Shaft PreloadedPair::linear_shaft() const {
  const duplex::Shaft shaft = spindle.shaft();
  return {.mass = linear.mass.value_or(shaft.mass),
          .levers = {linear.first_lever.value_or(shaft.levers.first),
                     linear.second_lever.value_or(shaft.levers.second)},
          .inertia_x = linear.inertia_x.value_or(shaft.inertia_x),
          .inertia_y = linear.inertia_y.value_or(shaft.inertia_y)};
}

std::optional<duplex::Housing> PreloadedPair::free_housing() const {
  const auto* free = std::get_if<duplex::Housing>(&housing);
  return free != nullptr ? std::optional(*free) : std::nullopt;
}

double PreloadedPair::approach() const {
  return duplex::approach_under(bearing, preload) + 0.5 * spacer_difference;
}

bearing::equilibrium::RowMotion PreloadedPair::motion_at(double speed) const {
  return {.speeds = {.inner = speed}, .inertia = ball_inertia};
}

namespace {

const PreloadedPair& preloaded(const PreloadedPair& pair) {
  return pair;
}
const PreloadedPair& preloaded(const DuplexPair& pair) {
  return pair.preloaded;
}

template <class Inputs>
std::vector<mechanics::Conditional<Inputs>> conditions_of_pair() {
  const PreloadedPair pair;
  const mechanics::MemberKeys key(pair);
  const std::string &speed = key(pair.operation.shaft_speed), &speeds = key(pair.operation.speeds),
                    &inertia = key(pair.ball_inertia.enabled), &arrangement = key(pair.arrangement);
  const auto rotates = [](const Inputs& in) { return preloaded(in).rotates(); };
  return {
      {.keys = {"linear."},
       .premises = {{.on = {arrangement, speed},
                     .holds = [](const Inputs& in) { return preloaded(in).has_linear_formulas(); },
                     .text = "where " + arrangement + " is face-to-face or tandem, and " + speed + " is 0"}}},
      {.keys = key.within(pair.ball_inertia), .premises = {{.on = {speed, speeds}, .holds = rotates}}},
      {.keys = {key(pair.bearing.material.density)},
       .premises = {
           {.on = {speed, speeds, inertia},
            .holds =
                [](const Inputs& in) {
                  return preloaded(in).rotates() && preloaded(in).ball_inertia.enabled;
                },
            .text = "together with " + speed + " or " + speeds + ", and where " + inertia + " is true"}}}};
}

}  // namespace

std::vector<mechanics::Conditional<PreloadedPair>> PreloadedPair::conditions() {
  std::vector<mechanics::Conditional<PreloadedPair>> all = conditions_of_pair<PreloadedPair>();
  const PreloadedPair of;
  const mechanics::MemberKeys key(of);
  const std::string& inertia = key(of.ball_inertia.enabled);
  all.push_back({.keys = {key(of.operation.shaft_speed)},
                 .premises = {{.on = {inertia},
                               .holds = [](const PreloadedPair& pair) { return pair.ball_inertia.enabled; },
                               .text = "where " + inertia + " is true"}}});
  return all;
}

// Hours of life follow from the speed of any shaft.
std::vector<mechanics::Conditional<DuplexPair>> DuplexPair::conditions() {
  return conditions_of_pair<DuplexPair>();
}

mechanics::Problems problems(const DuplexPair& machine) {
  const PreloadedPair& pair = machine.preloaded;
  const mechanics::MemberKeys key(pair);
  mechanics::Problems found;
  if (!pair.is_linear()) return found;
  if (pair.operation.shaft_speed != 0.0 || !pair.operation.speeds.empty())
    found.push_back(
        {pair.operation.speeds.empty() ? key(pair.operation.shaft_speed) : key(pair.operation.speeds),
         "a rotating shaft together with stiffness: linear; nonlinear is required: the linear "
         "formulas include no speed"});
  if (pair.arrangement == duplex::Arrangement::back_to_back)
    found.push_back(
        {"stiffness",
         "'linear' for a pair back to back; nonlinear is required: the linear formulas are printed for "
         "face-to-face, and are those of a tandem"});
  return found;
}

}  // namespace orbearing::analysis
