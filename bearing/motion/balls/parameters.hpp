// Parameters of the motion of a ball bearing in addition to those of a roller bearing. Every default is an
// assumption; the row below states its reason.
#pragma once

#include "bearing/motion/parameters.hpp"
#include "mechanics/part_rows.hpp"

namespace orbearing::bearing::balls {

/// Resistance of a ball to rolling as a function of load and speed.
enum class BallRolling {
  houpert,   // the regression of [Houpert1987]
  reynolds,  // computed: Reynolds' equation of elliptical contacts
};

constexpr described::Names<BallRolling, 2> names_of(BallRolling) {
  return {{{BallRolling::houpert, "houpert"}, {BallRolling::reynolds, "reynolds"}}};
}

/// Friction over the ellipses of contact.
struct EllipseParameters {
  BallRolling rolling = BallRolling::houpert;
  double eyring_stress = 5e6;  // [Pa]  at which the oil begins to thin by shear
  int slices = 9;              // [-]   of an ellipse across the direction of rolling
  int rows = 1;                // [-]   points of each along it
};

template <class Visitor>
void describe(Visitor& visit, EllipseParameters& m) {
  using namespace described;
  members(
      visit, m,
      input(m.rolling, "traction.ball_rolling_law",
            "resistance of balls to rolling by the regression of [Houpert1987], or as computed by Reynolds' "
            "equation",
            {.reason = "what published cases use; computed, it is 1.5 to 2 times as much",
             .where = {"traction.rolling_resistance", "true"}}),
      input(m.eyring_stress, "traction.eyring_stress", "shear stress at which the oil begins to thin",
            {.dimension = dimension::stress,
             .range = positive(1.0),
             .reason = "mineral oil",
             .where = {"traction.law", kLawsOfThinnedOil.text}}),
      input(m.slices, "traction.slices", "slices of an ellipse of contact across the direction of rolling",
            {.range = {1, 32}, .reason = "friction within a per cent", .numerical = true}),
      input(m.rows, "traction.rows", "points of each slice along the direction of rolling",
            {.range = {1, 8}, .reason = "ellipses are slender", .numerical = true}));
}

/// Pockets of a ball bearing's cage.
struct PocketParameters {
  double straight = 0.0;  // [m]  of an oblong pocket, along the pitch circle
};

template <class Visitor>
void describe(Visitor& visit, PocketParameters& m) {
  using namespace described;
  members(visit, m,
          input(m.straight, "bearing.cage.pocket_straight",
                "length of the straight part of an oblong pocket along the pitch circle",
                {.dimension = dimension::length, .range = {0.0, 100.0}, .reason = "round pockets"}));
}

/// Motion of the oil-air mixture round the balls.
enum class OilMotion {
  carried,  // with its own speed, by the balance of its angular momentum (mixture.hpp)
  at_rest,  // in the housing: the upper bound of drag, Eqs. (29) and (30) of [Chen2026]
};

constexpr described::Names<OilMotion, 2> names_of(OilMotion) {
  return {{{OilMotion::carried, "carried"}, {OilMotion::at_rest, "at-rest"}}};
}

/// Source of the share of oil in the free volume.
enum class OilFill {
  stated,  // lubricant.share
  parker,  // by flow, speed and size [Parker1984], mixture.hpp
};

constexpr described::Names<OilFill, 2> names_of(OilFill) {
  return {{{OilFill::stated, "stated"}, {OilFill::parker, "parker"}}};
}

struct MixtureParameters {
  OilMotion motion = OilMotion::carried;
  double flow = 0.0;  // [m^3/s]
  OilFill fill = OilFill::stated;
};

/// Rollers at rest have it too.
inline auto oil_flow_row(double& flow) {
  using namespace described;
  return input(flow, "lubricant.flow",
               "oil flow through the bearing, which is accelerated to the mixture's speed and removes heat",
               {.dimension = dimension::flow, .range = {0.0, 1000.0}, .reason = "grease, or a bath"});
}

template <class Visitor>
void describe(Visitor& visit, MixtureParameters& m) {
  using namespace described;
  members(visit, m,
          input(m.motion, "drag.mixture",
                "oil and air around the balls rotate by their balance of angular momentum, or rest",
                {.reason = "balls, cage and shaft drag them along", .where = {"drag.enabled", "true"}}),
          oil_flow_row(m.flow),
          input(m.fill, "lubricant.fill",
                "share of oil in the free volume: stated, or by flow and speed as Parker measured",
                {.reason = "lubricant.share", .where = {"drag.enabled", "true"}}));
}

/// A ring and what it carries along.
struct RingBodyParameters {
  double mass = 0.0;    // [kg]      0: that of the ring
  double across = 0.0;  // [kg m^2]  about a diameter; 0: that of the ring
  bool held = false;    // its position is given
};

/// All that the motion of balls adds to Bearing.
struct MotionParameters {
  motion::RaceContactParameters race;
  motion::CageParameters cage;
  motion::OilDragParameters drag;
  MixtureParameters mixture;
  Lubricant lubricant = warm_gear_oil;
  EllipseParameters ellipse;
  PocketParameters pocket;
  RingBodyParameters inner;
  RingBodyParameters outer{.held = true};
};

template <class Visitor>
void describe(Visitor& visit, MotionParameters& m) {
  using namespace described;
  const std::string_view ring_alone = "the ring alone: a light shaft";
  const auto of_balls = [&] {  // others are of rollers alone
    mechanics::describe_without(visit, m.race, m.race.sliding_share, m.race.rolling_law, m.race.film_heating,
                                m.race.film_in_approach, m.race.lubrication, m.race.boundary_friction);
  };
  members(visit, m, part(m.race, of_balls),
          part(m.cage, [&] { mechanics::describe_without(visit, m.cage, m.cage.pocket_stiffness); }),
          part(m.drag), part(m.mixture), part(m.lubricant), part(m.ellipse), part(m.pocket),
          together(input(m.inner.mass, "rotor.mass",
                         "mass that moves with the inner ring, including the ring; 0: the ring only",
                         {.dimension = dimension::mass, .range = {0.0, 1e6}, .reason = ring_alone}),
                   input(m.inner.across, "rotor.inertia",
                         "moment of inertia about a diameter of the parts that move with the inner ring; 0: "
                         "the ring only",
                         {.dimension = dimension::inertia, .range = {0.0, 1e6}, .reason = ring_alone})),
          apart(m.outer));
}

}  // namespace orbearing::bearing::balls
