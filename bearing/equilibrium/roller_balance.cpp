#include "bearing/equilibrium/roller_balance.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace orbearing::bearing {

namespace {

constexpr int kMostBisections = 60;
constexpr double kRollerRoundOff = 4e-16;

// A dry point contact in the words of RaceContact.
struct PointRace {
  static constexpr double kExponent = 1.5;  // of the load over the approach

  double constant;  // [N/m^1.5]

  double approach(double load) const { return std::pow(load / constant, 2.0 / 3.0); }
  RaceContact::Response response(double load) const {
    const double elastic = approach(load);
    return {elastic, 2.0 / 3.0 * elastic / load};
  }
  double onset() const { return 0.0; }
  const PointRace& elastic() const { return *this; }
};

// Sum of both geometric approaches at squeeze load s, which both contacts carry besides the inertial load.
template <class Contact>
struct SqueezedRoller {
  const Contact& inner;
  const Contact& outer;
  double inner_extra;  // [N]  inertial load on the inner race
  double outer_extra;  // [N]  inertial load on the outer race

  double approach(double s) const {
    return inner.approach(s + inner_extra) + outer.approach(s + outer_extra);
  }
  /// At s > 0.
  RaceContact::Response response(double s) const {
    const RaceContact::Response in = inner.response(s + inner_extra), out = outer.response(s + outer_extra);
    return {in.approach + out.approach, in.compliance + out.compliance};
  }
};

// The dry, massless roller needs the least approach for a load, so this load is the largest there can be when
// the film's cap is added to the approach.
template <class Contact>
double upper_bound(const SqueezedRoller<Contact>& roller, double approach) {
  using Elastic = std::remove_cvref_t<decltype(roller.inner.elastic())>;
  const double dry_approach = approach - roller.inner.onset() - roller.outer.onset();
  const double per_contact = roller.inner.elastic().approach(1.0) + roller.outer.elastic().approach(1.0);
  return std::pow(std::max(dry_approach, 0.0) / per_contact, Elastic::kExponent);
}

// Newton's method, kept inside the bracket of all earlier iterates: the approach rises with the load
// everywhere, but its slope jumps where the film's cap ends.
template <class Contact>
double squeeze_load(const SqueezedRoller<Contact>& roller, double approach) {
  double low = 0.0;
  double high = upper_bound(roller, approach);
  double s = high;
  for (int i = 0; i < kMostBisections && s > 0.0; ++i) {
    const RaceContact::Response now = roller.response(s);
    const double excess = now.approach - approach;
    (excess > 0.0 ? high : low) = s;
    double next = s - excess / now.compliance;
    if (next < low || next > high) next = low > 0.0 ? 0.5 * (low + high) : 0.1 * high;
    if (std::abs(next - s) <= kRollerRoundOff * s) return next;
    s = next;
  }
  return s;
}

template <class Contact>
RollerBalance balance_element(const Contact& inner, const Contact& outer, double inertial_load,
                              double approach) {
  const SqueezedRoller<Contact> roller{inner, outer, std::max(0.0, -inertial_load),
                                       std::max(0.0, inertial_load)};
  const bool squeezed = approach > roller.approach(0.0);
  if (!squeezed) return {roller.inner_extra, roller.outer_extra, 0.0};
  const double s = squeeze_load(roller, approach);
  if (s <= 0.0) return {roller.inner_extra, roller.outer_extra, 0.0};
  return {s + roller.inner_extra, s + roller.outer_extra, 1.0 / roller.response(s).compliance};
}

}  // namespace

RollerBalance balance_roller(const RaceContact& inner, const RaceContact& outer, double inertial_load,
                             double approach) {
  return balance_element(inner, outer, inertial_load, approach);
}

RollerBalance balance_ball(const PointContact& inner, const PointContact& outer, double inertial_load,
                           double approach) {
  return balance_element(PointRace{inner.constant}, PointRace{outer.constant}, inertial_load, approach);
}

// The outer contact by load and approach over the cosine of the taper, so that both loads differ by the
// inertial load only.
WholeRoller tapered_roller(const LineContact& contact, double taper) {
  const double cosine = std::cos(taper);
  return {{{contact, Film()}, {contact.through_lever(cosine), Film()}}, cosine};
}

RollerBalance balance_whole(const WholeElement& element, double inertial_load, double approach) {
  if (const auto* ball = std::get_if<WholeBall>(&element))
    return balance_ball(ball->inner, ball->outer, inertial_load, approach);
  const auto& [contacts, cosine] = std::get<WholeRoller>(element);
  if (cosine == 1.0) return balance_roller(contacts.inner, contacts.outer, inertial_load, approach);
  RollerBalance both = balance_roller(contacts.inner, contacts.outer, inertial_load, approach / cosine);
  both.outer_load /= cosine;
  both.stiffness /= cosine * cosine;
  return both;
}

double whole_approach(const WholeElement& element, double outer_load) {
  if (const auto* ball = std::get_if<WholeBall>(&element))
    return std::pow(outer_load / in_series(ball->inner, ball->outer), 2.0 / 3.0);
  const WholeRoller& roller = std::get<WholeRoller>(element);
  const double scaled = roller.taper_cosine * outer_load;
  return roller.taper_cosine *
         (roller.contacts.inner.approach(scaled) + roller.contacts.outer.approach(scaled));
}

}  // namespace orbearing::bearing
