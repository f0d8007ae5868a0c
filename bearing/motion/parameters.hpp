// Parameters of the motion in time in addition to those of the quasi-static bearing. Every default is an
// assumption; its reason is in the row below, or at the member where no case states it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bearing/contact/traction_law.hpp"
#include "bearing/film/oil_grade.hpp"
#include "bearing/parameters.hpp"

namespace orbearing::bearing {

constexpr described::Names<TractionLaw, kTractionLaws> names_of(TractionLaw) {
  described::Names<TractionLaw, kTractionLaws> names{};
  for (int i = 0; i < kTractionLaws; ++i) {
    const auto law = static_cast<TractionLaw>(i);
    names[static_cast<std::size_t>(i)] = {law, nature_of(law).name};
  }
  return names;
}

}  // namespace orbearing::bearing

namespace orbearing::bearing::motion {

/// Who carries the load of a race contact.
enum class Lubrication {
  full,   // the film only, or the surfaces only: one law of friction
  mixed,  // film and asperities share load and friction by the film ratio [OlverSpikes1998]
};

constexpr described::Names<Lubrication, 2> names_of(Lubrication) {
  return {{{Lubrication::full, "full"}, {Lubrication::mixed, "mixed"}}};
}

/// Rolling resistance by the shear of the oil at the inlet, as a function of load and speed.
enum class RollingLaw {
  reynolds,           // computed: Reynolds' equation of line contacts
  goksem_hargreaves,  // the regression of [ZhouHoeprich1991] to [GoksemHargreaves1978]
};

constexpr described::Names<RollingLaw, 2> names_of(RollingLaw) {
  return {{{RollingLaw::reynolds, "reynolds"}, {RollingLaw::goksem_hargreaves, "goksem-hargreaves"}}};
}

/// Whether shear at the inlet warms the oil, which then resists rolling less.
enum class InletHeating {
  none,               // isothermal
  goksem_hargreaves,  // contact/inlet_heating.hpp [GoksemHargreaves1978]
};

constexpr described::Names<InletHeating, 2> names_of(InletHeating) {
  return {{{InletHeating::none, "none"}, {InletHeating::goksem_hargreaves, "goksem-hargreaves"}}};
}

/// Whether shear at the inlet makes the films thinner that results state.
enum class FilmReduction {
  none,   // isothermal
  gupta,  // contact/heated_film.hpp [Gupta1992]
};

constexpr described::Names<FilmReduction, 2> names_of(FilmReduction) {
  return {{{FilmReduction::none, "none"}, {FilmReduction::gupta, "gupta"}}};
}

/// Reduction of the rolling resistance where inlets are not flooded.
enum class Starvation {
  none,         // flooded; of rollers at rest as far as all oil of the mixture reaches
  skf,          // factor of an oil jet or a low bath, friction/published_torque.hpp [SKF6000]
  replenished,  // of rollers at rest: what the mixture returns to the tracks, friction/replenishment.hpp
};

constexpr described::Names<Starvation, 3> names_of(Starvation) {
  return {{{Starvation::none, "none"}, {Starvation::skf, "skf"}, {Starvation::replenished, "replenished"}}};
}

/// Viscosity of the sheared oil in a contact as a function of the pressure.
enum class PressureLaw {
  barus,     // exp(alpha p), held at a largest exponent
  roelands,  // contact/pressed_oil.hpp [Roelands1966]
};

constexpr described::Names<PressureLaw, 2> names_of(PressureLaw) {
  return {{{PressureLaw::barus, "barus"}, {PressureLaw::roelands, "roelands"}}};
}

/// Race contacts: damping, friction, and whether the film adds to the elastic approach.
struct RaceContactParameters {
  double damping = 0.1;  // [s/m]  load grows by this share per m/s of approach speed [HuntCrossley1975]
  TractionLaw traction = TractionLaw::regularised_coulomb;
  double friction = 0.05;           // [-]    largest friction
  double sliding_scale = 0.1;       // [m/s]  s_0
  double sliding_share = 0.02;      // [-]    largest s_0 of rollers over their rolling speed; 0: no limit
  double limiting_friction = 0.06;  // [-]    limiting shear stress / pressure
  double least_sliding_scale =
      0.01;  // [m/s]  added to s_c, so that a film that has gone leaves finite slope.
             //        Assumption
  PressureLaw pressure_law = PressureLaw::barus;
  double largest_barus_exponent = 8.0;  // [-]    alpha p is held here: beyond it oil does not follow Barus
  double entrainment_scale = 0.01;      // [m/s]  rounds |u| at zero. Assumption: far below any running speed
  bool film_in_approach = false;        // the film takes part in the approach
  bool rolling_resistance = true;       // shear of the oil at the inlet
  RollingLaw rolling_law = RollingLaw::reynolds;
  InletHeating inlet_heating = InletHeating::none;
  FilmReduction film_heating = FilmReduction::none;
  double viscosity_slope = 0.03;   // [1/K]      by which the viscosity falls [Reynolds1886]
  double oil_conductivity = 0.14;  // [W/(m K)]  of mineral and ester oils
  Starvation starvation = Starvation::none;
  double rolling_share = 1.0;  // [-]  of the rolling resistance that starvation leaves
  bool squeeze = false;        // squeeze film: oil resists the approach
  Lubrication lubrication = Lubrication::full;
  double roughness = 0.2e-6;        // [m]  composite rms of roller and race
  double boundary_friction = 0.12;  // [-]  of asperities in contact
};

/// Rows that bearings at rest have too.
inline auto starvation_row(Starvation& starvation) {
  using namespace described;
  return input(
      starvation, "traction.starvation",
      "reduction of the rolling resistance by inlets that are not flooded: SKF's factor, or of rollers "
      "at rest by the oil that returns to the tracks",
      {.reason = "flooded, as in published cases", .where = {"traction.rolling_resistance", "true"}});
}
inline auto film_row(bool& in_approach) {
  using namespace described;
  return input(in_approach, "film.enabled", "the approach includes the film",
               {.reason = "dry contacts first; the effect of the film is shown separately"});
}

template <class Visitor>
void describe(Visitor& visit, RaceContactParameters& m) {
  using namespace described;
  constexpr Where coulomb{"traction.law", kLawsOfSurfaces.text}, mixed{"contact.lubrication", "mixed"};
  members(
      visit, m,
      input(m.damping, "contact.damping", "relative increase of a race load per approach speed",
            {.dimension = dimension::inverse_speed,
             .range = {0.0, 100.0},
             .reason = "a tenth of critical on a small roller at 1 kN"}),
      input(m.traction, "traction.law", "friction in the race contacts over sliding speed",
            {.reason = "the model of [Gai2025]; the sheared film of [BairWiner1979] is the other choice"}),
      input(m.friction, "traction.friction", "largest friction coefficient of the regularised Coulomb law",
            {.range = {0.0, 1.0}, .reason = "mineral oil at moderate pressure", .where = coulomb}),
      input(m.sliding_scale, "traction.sliding_scale", "sliding speed over which friction builds up",
            {.dimension = dimension::speed,
             .range = positive(100.0),
             .reason = "creep of oiled contacts",
             .where = coulomb}),
      input(
          m.sliding_share, "traction.sliding_share",
          "largest traction.sliding_scale over the rolling speed of the rollers at pure rolling; 0: no limit",
          {.range = {0.0, 1.0},
           .reason = "oiled contacts reach their friction at slide-to-roll ratios of 1 to 3 % "
                     "[JohnsonTevaarwerk1977]"}),
      input(m.limiting_friction, "traction.limiting_friction",
            "limiting shear stress of the oil over pressure",
            {.range = {0.0, 1.0}, .reason = "mineral oil", .where = {"traction.law", kLawsOfOil.text}}),
      internal(m.least_sliding_scale, "traction.least_sliding_scale"),
      input(m.pressure_law, "traction.pressure_law",
            "growth of the viscosity with pressure in sheared films: Barus, limited, or Roelands",
            {.reason = "what published cases use", .where = {"traction.law", kLawsOfOil.text}}),
      input(m.largest_barus_exponent, "traction.largest_barus_exponent",
            "limit of pressure-viscosity coefficient times pressure (Barus)",
            {.range = positive(100.0),
             .reason = "the exponent of Roelands' law is 6 to 9 for oils of 3 to 20 mPa s at 1 GPa",
             .where = {"traction.pressure_law", "barus"}}),
      internal(m.entrainment_scale, "traction.entrainment_scale"),
      input(m.rolling_resistance, "traction.rolling_resistance",
            "shear of the oil at the inlet causes rolling resistance", {.reason = "nothing left out"}),
      input(m.rolling_law, "traction.rolling_law",
            "resistance of rollers to rolling as computed by Reynolds' equation, or by the regression of "
            "[ZhouHoeprich1991]",
            {.reason = "computed, not from memory; 0.8 to 1.7 times the regression",
             .where = {"traction.rolling_resistance", "true"}}),
      input(
          m.inlet_heating, "traction.inlet_heating",
          "reduction of the rolling resistance by shear heating of the oil at the inlet",
          {.reason = "isothermal, as in published cases", .where = {"traction.rolling_resistance", "true"}}),
      starvation_row(m.starvation),
      input(
          m.film_heating, "film.inlet_heating",
          "reduction of the reported films, and of kappa by film, by shear heating of the inlet and sliding; "
          "loads, friction and film.enabled keep the isothermal film",
          {.reason = "isothermal, as in published cases"}),
      input(m.viscosity_slope, "heat.viscosity_slope", "relative decrease of the viscosity per kelvin",
            {.dimension = dimension::per_kelvin,
             .range = {0.0, 0.2},
             .reason = "a mineral oil when warm",
             .where = {"heat.enabled|traction.inlet_heating|film.inlet_heating",
                       "true|goksem-hargreaves|gupta"}}),
      internal(m.oil_conductivity, "traction.oil_conductivity"),
      internal(m.rolling_share, "traction.rolling_share"), film_row(m.film_in_approach),
      input(m.squeeze, "contact.squeeze",
            "squeeze film between rolling element and race resists their approach",
            {.reason =
                 "the models of [Gai2025] and [Chen2026], which have none; its effect is shown separately"}),
      input(m.lubrication, "contact.lubrication",
            "friction in the race contacts: one model, or shared by film and asperities",
            {.reason = "smooth surfaces, fully parted"}),
      input(m.roughness, "contact.roughness",
            "composite roughness (rms) of roller and race, for mixed lubrication and squeezed films",
            {.dimension = dimension::small_length,
             .range = positive(100.0),
             .reason = "honed races, ground rollers",
             .where = {"contact.lubrication|contact.squeeze", "mixed|true"}}),
      input(m.boundary_friction, "contact.boundary_friction",
            "friction coefficient of asperities, for mixed lubrication",
            {.range = {0.0, 1.0}, .reason = "mineral oil with additives", .where = mixed}));
}

/// Oil between rolling element and cage pocket before they touch.
enum class PocketFilm {
  none,          // the pocket acts when it is touched
  hydrodynamic,  // rigid-isoviscous line or point contact with entrainment and squeeze
};

constexpr described::Names<PocketFilm, 2> names_of(PocketFilm) {
  return {{{PocketFilm::none, "none"}, {PocketFilm::hydrodynamic, "hydrodynamic"}}};
}

/// Cage pockets and the land that guides the cage. Where a case leaves out the clearance, the stiffness of
/// the pockets or that of the land, they follow from the cage's size and material.
struct CageParameters {
  double pocket_clearance =
      0.1e-3;                     // [m]    along the pitch circle, both sides together. Assumption: the usual
                                  //        play of moulded cages of this size
  double pocket_stiffness = 3e7;  // [N/m]  Assumption: glass-filled polyamide bar
  double pocket_damping = 1.0;    // [s/m]  as damping of the races
  double pocket_friction = 0.05;  // [-]
  PocketFilm pocket_film = PocketFilm::none;
  double pocket_roughness = 0.4e-6;  // [m]    where asperities hold the film
  double guide_diameter = 0.0;       // [m]    of the land; 0: no guidance
  double land_width = 0.0;  // [m]    of one land; 0: what cage width and roller length leave at each side
  int lands = 2;            // [-]
  double largest_eccentricity = 0.98;  // [-]    of the land's clearance where roughness takes over
  double touch_down_stiffness = 1e7;   // [N/m]  Assumption
  double touch_down_damping = 1.0;     // [s/m]  Assumption
  double touch_down_friction = 0.05;   // [-]    Assumption: oiled polymer on steel
};

/// Cases of rollers at rest may state it too.
inline auto guide_land_row(double& diameter) {
  using namespace described;
  return input(diameter, "bearing.cage.guide_land_diameter",
               "diameter of the land that guides the cage; 0: no land, guided by rollers or balls",
               {.dimension = dimension::length, .range = {0.0, 1e4}, .may_be_absent = true});
}

template <class Visitor>
void describe(Visitor& visit, CageParameters& m) {
  using namespace described;
  constexpr Where land{"bearing.cage.guide_land_diameter"};
  members(visit, m,
          input(m.pocket_clearance, "bearing.cage.pocket_clearance",
                "clearance of a roller in its pocket, in diametral measure",
                {.dimension = dimension::length, .range = positive(10.0), .may_be_absent = true}),
          input(m.pocket_stiffness, "bearing.cage.pocket_stiffness", "stiffness of a cage bar",
                {.dimension = dimension::stiffness, .range = positive(1e12), .may_be_absent = true}),
          input(m.pocket_damping, "bearing.cage.pocket_damping",
                "relative increase of a pocket load per approach speed",
                {.dimension = dimension::inverse_speed, .range = {0.0, 100.0}, .reason = "polymer"}),
          input(m.pocket_friction, "bearing.cage.pocket_friction", "friction coefficient of roller and bar",
                {.range = {0.0, 1.0}, .reason = "oiled polymer"}),
          input(m.pocket_film, "bearing.cage.pocket_film",
                "oil film between rolling element and cage pocket before contact",
                {.reason = "pockets act when they are touched"}),
          input(m.pocket_roughness, "bearing.cage.pocket_roughness",
                "roughness of rolling element and pocket, the least film between them",
                {.dimension = dimension::small_length,
                 .range = positive(100.0),
                 .reason = "a moulded or milled bar",
                 .where = {"bearing.cage.pocket_film", "hydrodynamic"}}),
          guide_land_row(m.guide_diameter), internal(m.land_width, "bearing.cage.land_width"),
          internal(m.lands, "bearing.cage.lands"),
          input(m.largest_eccentricity, "bearing.cage.largest_eccentricity",
                "share of the land's clearance where roughness carries",
                {.range = {.least = 0.1, .most = 1.0, .most_allowed = false},
                 .reason = "finish of the land",
                 .where = land}),
          input(m.touch_down_stiffness, "bearing.cage.touch_down_stiffness", "stiffness of cage on land",
                {.dimension = dimension::stiffness, .range = positive(1e12), .where = land}),
          internal(m.touch_down_damping, "bearing.cage.touch_down_damping"),
          internal(m.touch_down_friction, "bearing.cage.touch_down_friction"));
}

/// Rollers of a full complement, which touch one another: steel on steel as at the races, whose line contact
/// and damping they share.
struct NeighbourParameters {
  double friction = 0.12;  // [-]  both spin alike: their surfaces slide, and draw in no oil
};

template <class Visitor>
void describe(Visitor& visit, NeighbourParameters& m) {
  using namespace described;
  members(
      visit, m,
      input(m.friction, "bearing.neighbour_friction",
            "friction coefficient of rollers that touch one another, of a full complement",
            {.range = {0.0, 1.0},
             .reason = "boundary friction of steel in mineral oil with additives: both spin alike, so that "
                       "no oil is drawn in",
             .where = {"bearing.complement", "full"}}));
}

/// Oil-air mixture around the rollers. Assumption: it rests in the carrier frame, the upper bound of its
/// drag.
struct OilDragParameters {
  bool on = true;
  double oil_density = 850.0;     // [kg/m^3]
  double oil_share = 0.05;        // [-]  of the free volume
  double drag_coefficient = 1.1;  // [-]  cylinder across the flow
  double churning_coefficient =
      0.05;  // [-]  Assumption: disc and drum friction of the Reynolds numbers at hand
};

/// Density of the oil [kg/m^3], which counts where it is stirred; else that of a mineral oil.
inline double density_of_oil(const OilDragParameters& drag) {
  return drag.on ? drag.oil_density : OilGrade{}.density;
}

/// Rollers at rest have it too.
inline auto oil_share_row(double& share) {
  using namespace described;
  return input(share, "lubricant.share", "oil in the free volume of the bearing",
               {.range = {0.0, 1.0}, .reason = "oil mist with jets", .where = {"drag.enabled", "true"}});
}

template <class Visitor>
void describe(Visitor& visit, OilDragParameters& m) {
  using namespace described;
  constexpr Where on{"drag.enabled", "true"};
  members(
      visit, m,
      input(m.on, "drag.enabled", "drag and churning in the oil-air mixture", {.reason = "nothing left out"}),
      input(m.oil_density, "lubricant.density", "density of the oil",
            {.dimension = dimension::density,
             .range = positive(20000.0),
             .reason = "mineral oil",
             .where = on}),
      oil_share_row(m.oil_share), internal(m.drag_coefficient, "drag.coefficient"),
      internal(m.churning_coefficient, "drag.churning_coefficient"));
}

/// Pin ring on its support in the carrier. Where a case leaves out the stiffness, it follows from the pin.
struct SupportParameters {
  double stiffness = 5e8;       // [N/m]  Assumption: short steel pin in both carrier walls
  double damping_ratio = 0.05;  // [-]    of pin ring and bore together on the stiffness
};

template <class Visitor>
void describe(Visitor& visit, SupportParameters& m) {
  using namespace described;
  members(visit, m,
          input(m.stiffness, "support.stiffness",
                "radial stiffness of the pin in the carrier, for each bearing on it",
                {.dimension = dimension::stiffness, .range = positive(1e13), .may_be_absent = true}),
          input(m.damping_ratio, "support.damping_ratio", "damping of planet and pin on the support",
                {.range = {0.0, 10.0}, .reason = "bolted steel structure"}));
}

/// Waves of an elastic outer race in motion.
struct RimParameters {
  int most_order = 8;           // [-]  of the waves that move; effect of more waves: README
  double damping_ratio = 0.02;  // [-]  of each wave. Assumption: rings pressed into a steel gear;
                                //      effect of a tenth or five times as much: README
};

template <class Visitor>
void describe(Visitor& visit, RimParameters& m) {
  using namespace described;
  members(visit, m, internal(m.most_order, "rim.most_order"), internal(m.damping_ratio, "rim.damping_ratio"));
}

/// One harmonic of a load: cosine cos(order angle) + sine sin(order angle).
struct LoadHarmonic {
  int order = 1;
  Eigen::Vector2d cosine = Eigen::Vector2d::Zero();  // [N]
  Eigen::Vector2d sine = Eigen::Vector2d::Zero();    // [N]
};

/// Variation of the mesh loads on the bore about their mean as the teeth pass, as a Fourier series.
struct MeshExcitation {
  double angular_frequency = 0.0;       // [rad/s]  of tooth engagement
  std::vector<LoadHarmonic> harmonics;  // in rising order
};

/// Run-up or run-down: all speeds are (1 + ramp t) times those at t = 0. The meshes pass constant power, so
/// their load falls as the speed rises; inertial loads rise with its square.
struct Driving {
  double ramp = 0.0;  // [1/s]  0: steady speeds
};

/// Weight in the plane of the bearing. In the frame of the carrier gravity turns against the carrier.
struct Gravity {
  double across = 0.0;       // [m/s^2]  across the axis of the carrier
  double angle = 0.0;        // [rad]    of the pin from the horizontal at the start, in the sense of rotation
  double planet_mass = 0.0;  // [kg]     whose weight is on the bore; 0: that of the bore

  bool acts() const { return across != 0.0; }
};

template <class Visitor>
void describe(Visitor& visit, Gravity& m) {
  using namespace described;
  constexpr Dimension acceleration{"acceleration", "m/s2", "m/s2", "9.81 m/s2"};
  members(visit, m,
          input(m.across, "inertia.gravity",
                "acceleration of gravity across the axis of the carrier, on rollers, cage, pin and planet in "
                "motion; 0: without weight, as with a vertical axis",
                {.dimension = acceleration,
                 .range = {0.0, 100.0},
                 .reason = "left out: small compared with the inertial fields, except in slow sets"}),
          apart(m.angle), apart(m.planet_mass));
}

/// All that the roller dynamics adds to Bearing.
struct DynamicsParameters {
  RaceContactParameters race;
  CageParameters cage;
  NeighbourParameters neighbours;
  OilDragParameters drag;
  SupportParameters support;
  RimParameters rim;
  MeshExcitation excitation;
  Driving driving;
  InertiaSwitches inertia;
  Gravity gravity;
  Lubricant lubricant = warm_gear_oil;
  double bore_mass = 0.0;  // [kg]  planet mass per bearing; 0: that of the outer ring
};

template <class Visitor>
void describe(Visitor& visit, DynamicsParameters& m) {
  using namespace described;
  members(visit, m, part(m.lubricant), part(m.race), part(m.drag), part(m.support), part(m.rim),
          internal(
              m.bore_mass, "planet.mass_per_bearing",
              "planet mass per bearing, by which support.damping_ratio counts; its inertia is not in the FMU",
              {.dimension = dimension::mass, .range = {.least = 0.0}}),
          part(m.inertia), part(m.gravity), part(m.cage), part(m.neighbours), apart(m.excitation),
          apart(m.driving));
}

}  // namespace orbearing::bearing::motion
