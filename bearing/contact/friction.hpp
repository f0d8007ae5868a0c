// Friction and rolling resistance of an oiled race contact: each law once, with its constants, for plain
// numbers, packs and both with their slopes. `Number` is a double for one race, a pair of numbers for both.
//
// A law has its constants, of(), which derives them from what the user states, and its force. Parameters
// are motion::RaceContactParameters and Contact for FilmContact, which are not named here: files
// compiled for special instruction sets include this one, and their headers must not.
#pragma once

#include "bearing/contact/film_law.hpp"
#include "bearing/contact/inlet_heating.hpp"
#include "bearing/contact/pressed_oil.hpp"
#include "bearing/contact/traction_law.hpp"

namespace orbearing::bearing {

/// A loaded contact as its friction laws see it.
template <class Load, class LogLoad, class LogSpeed>
struct OiledContact {
  Load load;           // [N]  > 0
  LogLoad log_load;    // [ln N]
  LogSpeed log_speed;  // [ln(m/s)]  of the entrainment speed
};

template <class Load, class LogSpeed>
auto oiled_contact(const Load& load, const LogSpeed& log_speed) {
  using mechanics::logarithm;
  const auto log_load = logarithm(load);
  return OiledContact<Load, decltype(logarithm(load)), LogSpeed>{load, log_load, log_speed};
}

/// Regularised Coulomb friction, mu Q s / sqrt(s^2 + s_0^2): Eq. (17) of [Gai2025].
template <class Number>
struct CoulombFriction {
  Number friction{};       // [-]
  Number sliding_scale{};  // [m/s]

  template <class Parameters>
  static CoulombFriction of(const Parameters& given) {
    return {given.friction, given.sliding_scale};
  }

  /// [N] with the sign of `sliding` [m/s], at `load` [N].
  template <class Load, class Speed>
  auto force(const Load& load, const Speed& sliding) const {
    return load * (friction * mechanics::rounded_sign(sliding, sliding_scale));
  }
};

/// Limiting shear, mu Q (1 - exp(-|s| / s_c)) sign(s): the film is sheared as a Newtonian oil, eta s / h,
/// until the stress nears its limit, friction times pressure; the exponential between both is that of
/// [BairWiner1979]. The viscosity follows Barus up to the largest exponent, or Roelands; the pressure is the
/// mean one of a Hertzian line contact, chapter 4 of [Johnson1985]. s_c = mu p h / eta.
template <class Number>
struct LimitingShear {
  Number friction{};           // [-]    limiting stress over pressure
  Number sliding_scale{};      // [m/s]  added to s_c
  Number largest_exponent{};   // [-]    of the pressure-viscosity law
  Number pressure_exponent{};  // [N^-0.5]  of that law over the root of the load
  Number log_scale{};          // [ln(m/s)]  mu p / eta at 1 N without pressure, times 1 m
  RoelandsExponent<Number> roelands;
  Number roelands_pressure{};  // [Pa/N^0.5]  mean pressure over the root of the load
  FilmLaw<Number> film;

  template <class Parameters, class Contact>
  static LimitingShear of(const Parameters& given, const Contact& contact, const FilmLaw<Number>& film) {
    using namespace mechanics;
    constexpr double kPi = 3.141592653589793, kNoFriction = 1e-100;
    // Load over the area 2 b l, b = sqrt(8 Q R / (pi E' l)), at 1 N; E' twice the composite modulus of the
    // source.
    const double pressure =
        0.5 * root(kPi * contact.reduced_modulus / (8.0 * contact.equivalent_radius * contact.length));
    return {given.limiting_friction,
            given.least_sliding_scale,
            given.largest_barus_exponent,
            contact.lubricant.pressure_viscosity * pressure,
            logarithm(larger(given.limiting_friction, kNoFriction) * pressure / contact.lubricant.viscosity),
            RoelandsExponent<Number>::of(contact.lubricant.viscosity, contact.lubricant.pressure_viscosity),
            pressure,
            film};
  }

  /// [N] with the sign of `sliding` [m/s]. The film begins to thin at the load where it does at 1 m/s.
  template <class Oiled, class Speed>
  auto force(const Oiled& contact, const Speed& sliding, bool by_roelands = false) const {
    using namespace mechanics;
    const auto at = [&](const auto& exponent) {
      const auto log_film = film.log_uncapped(larger(contact.log_load, film.log_cap_load), contact.log_speed);
      const auto scale =
          exponential(0.5 * contact.log_load - exponent + log_film + log_scale) + sliding_scale;
      return contact.load * (friction * saturated(sliding / scale));
    };
    if (by_roelands) return at(roelands.at(root(contact.load) * roelands_pressure));
    return at(smaller(root(contact.load) * pressure_exponent, largest_exponent));
  }
};

/// Share of the load that asperities carry at `film_ratio` [-] = least film / composite roughness: 1 without
/// film, 0 where the film is thick; 1 / (1 + ratio)^2 [OlverSpikes1998].
template <class Ratio>
auto asperity_share(const Ratio& film_ratio) {
  const auto inverse = 1.0 / (1.0 + film_ratio);
  return inverse * inverse;
}

/// Mixed lubrication: film and asperities share load and friction by the film ratio.
template <class Number>
struct MixedFriction {
  CoulombFriction<Number> boundary;  // of the asperities
  Number log_roughness{};            // [ln m]  composite rms, times central over least film
  FilmLaw<Number> film;

  template <class Parameters>
  static MixedFriction of(const Parameters& given, const FilmLaw<Number>& film) {
    return {{given.boundary_friction, given.sliding_scale},
            mechanics::logarithm(film.kCentralOverLeast * given.roughness),
            film};
  }

  /// Friction [N] of a contact in which the film under the whole load would give `film_friction` [N].
  /// Asperities carry their share with boundary friction, the film the rest: both have the sign of the
  /// sliding.
  template <class Oiled, class Force, class Speed>
  auto shared(const Force& film_friction, const Oiled& contact, const Speed& sliding) const {
    using mechanics::exponential;
    const auto share =
        asperity_share(exponential(film.log_central(contact.log_load, contact.log_speed) - log_roughness));
    return film_friction + share * (boundary.force(contact.load, sliding) - film_friction);
  }
};

/// Resistance of the oil at the inlet of a lubricated line contact to rolling, as Reynolds' equation gives it
/// (isothermal, fully flooded; factors of inlet heating and of sliding are 1): an interpolation between rigid
/// bodies in oil of one viscosity and elastic ones in oil that thickens, in the groups of Moes,
///
///     F = E' R l (2 U)^(3/4) (A^-3 + B^-3)^(-1/3),  A = 1.4705 M^(1/2),  B = 2.2818 M^-0.04543 L^-0.0923,
///     M = W (2 U)^(-1/2),  L = G (2 U)^(1/4),  U = eta u/(E' R),  W = Q/(E' R l),  G = alpha E'.
///
/// A is that of rigid cylinders in closed form (docs/reynolds.md), the three numbers of B are fitted to
/// points that film/reynolds computes; within 4.1 % of all of them, 2.1 % rms. Without pressure-viscosity A
/// is used without B.
template <class Number>
struct ComputedRolling {
  static constexpr double kRigid = 1.4705;
  static constexpr double kElastic = 2.2818, kElasticLoad = -0.04543, kElasticMaterial = -0.0923;
  static constexpr double kBlend = 3.0;      // power of A and B in their mean
  static constexpr double kLoadScale = 1.0;  // [N]  below it A falls in proportion to the load, not its root

  // Powers of load and speed in A, and of both in (A/B)^3.
  static constexpr double kRigidLoad = 0.5, kRigidSpeed = 0.75 - 0.25;
  static constexpr double kRatioLoad = kBlend * (0.5 - kElasticLoad);
  static constexpr double kRatioSpeed = kBlend * (0.5 * (kElasticLoad - 0.5) - 0.25 * kElasticMaterial);

  Number log_factor{};  // [ln N]  A's force at 1 N and 1 m/s
  Number log_ratio{};   // [-]  (A/B)^3 there; far below 0 where oil keeps its viscosity

  /// Requires oil: viscosity > 0.
  template <class Contact>
  static ComputedRolling of(const Contact& contact) {
    using namespace mechanics;
    const double modulus = contact.reduced_modulus, radius = contact.equivalent_radius;
    const double unit = modulus * radius * contact.length;                                       // [N]
    const double log_speed = logarithm(2.0 * contact.lubricant.viscosity / (modulus * radius));  // of 2 U
    const double log_load = -logarithm(unit) - 0.5 * log_speed;                                  // of M
    const double material = contact.lubricant.pressure_viscosity * modulus;
    const double no_ratio = -600.0;
    return {logarithm(kRigid * unit) + 0.75 * log_speed + 0.5 * log_load,
            material > 0.0 ? kBlend * (logarithm(kRigid / kElastic) + (0.5 - kElasticLoad) * log_load -
                                       kElasticMaterial * (logarithm(material) + 0.25 * log_speed))
                           : no_ratio};
  }

  /// As RollingResistance::force().
  template <class Oiled, class Speed>
  auto force(const Oiled& contact, const Speed& rolling) const {
    using namespace mechanics;
    const auto ratio =
        exponential(kRatioLoad * contact.log_load + kRatioSpeed * contact.log_speed + log_ratio);
    const auto size = exponential((kRigidSpeed - 1.0) * contact.log_speed + kRigidLoad * contact.log_load +
                                  log_factor - (1.0 / kBlend) * logarithm(1.0 + ratio));
    return size * root(contact.load / (contact.load + kLoadScale)) * rolling;
  }
};

/// The same by the regression F_R = 4.318 (alpha E' U)^0.658 W^0.0126 R l / alpha of [ZhouHoeprich1991] to
/// [GoksemHargreaves1978]: between 0.82 and 1.73 of what is computed, from W = 1e-5 on.
///
/// The oil drags each surface back with it. The pressure's resultant gives the equilibrium of forces, after
/// [Houpert1987].
template <class Number>
struct RollingResistance {
  static constexpr double kSpeed = 0.658;
  static constexpr double kLoad = 0.0126;
  static constexpr double kLoadScale = 1.0;  // [N]  below it the resistance falls in proportion to the load

  Number factor{};  // [N]  at unit speed and load; 0 without oil

  template <class Contact>
  static RollingResistance of(const Contact& contact) {
    using namespace mechanics;
    const double alpha = contact.lubricant.pressure_viscosity, eta = contact.lubricant.viscosity;
    if (alpha <= 0.0 || eta <= 0.0) return {};
    const double area = contact.equivalent_radius * contact.length;
    return {4.318 *
            exponential(kSpeed * logarithm(alpha * eta / contact.equivalent_radius) -
                        kLoad * logarithm(contact.reduced_modulus * area)) *
            area / alpha};
  }

  /// Backward force on each surface [N], with the sign of `rolling` [m/s], of which the entrainment speed is
  /// the size, rounded at zero. Falls to zero with the load.
  template <class Oiled, class Speed>
  auto force(const Oiled& contact, const Speed& rolling) const {
    using mechanics::exponential;
    const auto powers = exponential((kSpeed - 1.0) * contact.log_speed + kLoad * contact.log_load);
    return factor * powers * (contact.load / (contact.load + kLoadScale)) * rolling;
  }
};

/// Heating of the inlet as far as it does not depend on the motion.
template <class Number>
struct InletHeatingScale {
  Number log_loading{};  // [ln(s^2/m^2)]  beta eta/k, heated_inlet_share()

  template <class Parameters, class Contact>
  static InletHeatingScale of(const Parameters& given, const Contact& contact) {
    return {
        mechanics::logarithm(given.viscosity_slope * contact.lubricant.viscosity / given.oil_conductivity)};
  }
};

/// Selected laws.
struct FrictionChoice {
  TractionLaw traction = TractionLaw::regularised_coulomb;  // one that rollers have
  bool roelands = false;                                    // else Barus, held at the largest exponent
  bool mixed = false;  // asperities share load and friction with the film
  bool rolling_resistance = false;
  bool computed_rolling = false;  // else by regression
  bool inlet_heating = false;     // shear at the inlet lowers the rolling resistance
};

/// The constants of all laws: numbers only, so that those of two races can be put side by side.
template <class Number>
struct FrictionNumbers {
  CoulombFriction<Number> coulomb;
  LimitingShear<Number> shear;
  MixedFriction<Number> asperities;
  RollingResistance<Number> rolling;
  ComputedRolling<Number> computed;
  InletHeatingScale<Number> heating;
};

/// Tangential forces of one race contact.
template <class Number>
struct FrictionLaws : FrictionChoice, FrictionNumbers<Number> {
  using FrictionNumbers<Number>::coulomb, FrictionNumbers<Number>::shear;
  using FrictionNumbers<Number>::asperities, FrictionNumbers<Number>::rolling;
  using FrictionNumbers<Number>::computed, FrictionNumbers<Number>::heating;

  template <class Parameters, class Contact>
  static FrictionLaws of(const Parameters& given, const Contact& contact) {
    using Lubrication = decltype(given.lubrication);
    using Rolling = decltype(given.rolling_law);
    using Heating = decltype(given.inlet_heating);
    using Pressed = decltype(given.pressure_law);
    const auto film = FilmLaw<Number>::of(contact);
    FrictionLaws laws;
    laws.traction = given.traction;
    laws.roelands = given.pressure_law == Pressed::roelands;
    laws.mixed = given.lubrication == Lubrication::mixed;
    laws.coulomb = CoulombFriction<Number>::of(given);
    switch (laws.traction) {
      case TractionLaw::limiting_shear:
        laws.shear = LimitingShear<Number>::of(given, contact, film);
        break;
      case TractionLaw::regularised_coulomb:  // asperities have it, too
      case TractionLaw::ree_eyring:           // rollers lack it
        break;
    }
    if (laws.mixed) laws.asperities = MixedFriction<Number>::of(given, film);
    laws.rolling = RollingResistance<Number>::of(contact);
    laws.computed_rolling = given.rolling_law == Rolling::reynolds;
    const bool oil = contact.lubricant.viscosity > 0.0;
    if (oil) laws.computed = ComputedRolling<Number>::of(contact);
    laws.rolling.factor *= given.rolling_share;
    laws.computed.log_factor += mechanics::logarithm(given.rolling_share);
    laws.rolling_resistance =
        given.rolling_resistance && (laws.computed_rolling ? oil : laws.rolling.factor > 0.0);
    laws.inlet_heating =
        oil && given.inlet_heating == Heating::goksem_hargreaves && given.viscosity_slope > 0.0;
    if (laws.inlet_heating) laws.heating = InletHeatingScale<Number>::of(given, contact);
    return laws;
  }

  /// Whether friction, or anything, needs the logarithms of load and entrainment speed.
  bool oiled_friction() const { return nature_of(traction).shears_oil || mixed; }
  bool oiled() const { return oiled_friction() || rolling_resistance; }

  /// [N]  by a law of surfaces, which has no oil.
  template <class Load, class Speed>
  auto of_surfaces(const Load& load, const Speed& sliding) const {
    switch (traction) {
      case TractionLaw::regularised_coulomb:
        return coulomb.force(load, sliding);
      case TractionLaw::limiting_shear:
      case TractionLaw::ree_eyring:
        break;  // laws of oil
    }
    __builtin_trap();
  }

  /// Gives `take` the friction [N] on the roller, with the slopes of the selected law, at `load` [N]
  /// >= 0, sliding speed `sliding` [m/s] of race less roller and ln of the entrainment speed (used where
  /// oiled()). It never opposes the sliding: force * sliding >= 0.
  template <class Load, class Speed, class LogSpeed, class Take>
  void friction(const Load& load, const Speed& sliding, const LogSpeed& log_speed, const Take& take) const {
    using mechanics::only;
    if (!oiled_friction()) return take(of_surfaces(load, sliding));
    const auto loaded = mechanics::value_of(load) > 0.0;
    const auto contact = oiled_contact(above_zero(load, loaded), log_speed);
    const auto finish = [&](const auto& film_friction) {
      if (mixed)
        take(only(loaded, asperities.shared(film_friction, contact, sliding)));
      else
        take(only(loaded, film_friction));
    };
    switch (traction) {
      case TractionLaw::regularised_coulomb:
        return finish(of_surfaces(contact.load, sliding));
      case TractionLaw::limiting_shear:
        return finish(shear.force(contact, sliding, roelands));
      case TractionLaw::ree_eyring:
        break;
    }
    __builtin_trap();  // refused where the model of a bearing is made: rollers lack it
  }
  /// The same of plain numbers.
  template <mechanics::Fixed Value>
  Value friction(const Value& load, const Value& sliding, const Value& log_speed) const {
    Value force{};
    friction(load, sliding, log_speed, [&](const Value& f) { force = f; });
    return force;
  }

  /// Rolling resistance [N], as RollingResistance::force(), at `load` [N] >= 0; only if it is switched on.
  template <class Load, class Speed, class LogSpeed>
  auto inlet(const Load& load, const Speed& signed_speed, const LogSpeed& log_speed) const {
    using namespace mechanics;
    const auto loaded = mechanics::value_of(load) > 0.0;
    const auto contact = oiled_contact(above_zero(load, loaded), log_speed);
    const auto isothermal = only(loaded, computed_rolling ? computed.force(contact, signed_speed)
                                                          : rolling.force(contact, signed_speed));
    if (!inlet_heating) return isothermal;
    return decltype(isothermal)(isothermal * heated_inlet_share(2.0 * log_speed + heating.log_loading));
  }

 private:
  // The load, 1 N where there is none.
  template <class Load, class Mask>
  static auto above_zero(const Load& load, const Mask& loaded) {
    using namespace mechanics;
    const auto& value = mechanics::value_of(load);
    using Value = mechanics::Plain<decltype(value)>;
    return mechanics::with_value(load, Value(select(loaded, value, Value{} + 1.0)));
  }
};

}  // namespace orbearing::bearing
