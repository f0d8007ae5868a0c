// Arguments that the libraries of bearings refuse; words and numbers in tests/messages.txt.
#include <gtest/gtest.h>

#include <limits>

#include "bearing/contact/ellipse_traction.hpp"
#include "bearing/contact/point_contact.hpp"
#include "bearing/default_design.hpp"
#include "bearing/defect/scratched_bearing.hpp"
#include "bearing/defect/scratched_elements.hpp"
#include "bearing/equilibrium/row_group.hpp"
#include "bearing/film/reynolds/line.hpp"
#include "bearing/film/reynolds/point.hpp"
#include "bearing/life/basic_life.hpp"
#include "bearing/life/life_modification.hpp"
#include "bearing/motion/balls/ball_bearing.hpp"
#include "bearing/motion/balls/published_form.hpp"
#include "bearing/motion/model.hpp"
#include "bearing/pin_beam.hpp"
#include "bearing/pressure/contact.hpp"
#include "bearing/pressure/strip_contact.hpp"
#include "bearing/profile/profile.hpp"
#include "tests/messages.hpp"
#include "tests/unit/defect/scratched_bearings.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"
#include "tests/unit/system/small_ball_bearing.hpp"

namespace orbearing::bearing::bearing_refusals_test {
namespace {

using Refused = std::invalid_argument;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// The reducer's bearing in motion, with something spoiled.
template <class Spoil>
void rollers_with(Spoil&& spoil) {
  Bearing bearing = test::reducer_bearing();
  motion::DynamicsParameters parameters = test::reducer_parameters();
  OperatingPoint point = test::reducer_point(6000.0);
  spoil(bearing, parameters, point);
  (void)motion::bearing_model(bearing, point, parameters);
}

#define EXPECT_ROLLERS_REFUSED(id, ...)                                                          \
  EXPECT_REFUSED(Refused, id,                                                                    \
                 rollers_with([](Bearing& b, motion::DynamicsParameters& p, OperatingPoint& o) { \
                   (void)b, (void)p, (void)o;                                                    \
                   __VA_ARGS__;                                                                  \
                 }))

TEST(BearingRefusals, OilOfRollersInMotion) {
  EXPECT_ROLLERS_REFUSED("rollers oil", p.race.squeeze = true; p.lubricant.viscosity = 0.0);
  EXPECT_ROLLERS_REFUSED("rollers roughness", p.race.squeeze = true; p.lubricant.viscosity = 0.01;
                         p.race.roughness = 0.0);
  EXPECT_ROLLERS_REFUSED("rollers boundary", p.race.lubrication = motion::Lubrication::mixed;
                         p.lubricant.viscosity = 0.01; p.race.roughness = 1e-6;
                         p.race.boundary_friction = -0.1);
  EXPECT_ROLLERS_REFUSED("rollers pocket", p.cage.pocket_film = motion::PocketFilm::hydrodynamic;
                         p.lubricant.viscosity = 0.01; p.cage.pocket_roughness = 0.0);
}

TEST(BearingRefusals, FormOfRollersInMotion) {
  EXPECT_ROLLERS_REFUSED("wave order", b.inner.form = {{0, 1e-6, 0.0}});
  EXPECT_ROLLERS_REFUSED("wave amplitude", b.outer.form = {{3, 3e-3, 0.0}});
  EXPECT_ROLLERS_REFUSED("deviations", b.rollers().diameter_deviation.assign(16, 1e-6));
  EXPECT_ROLLERS_REFUSED("deviation", b.rollers().diameter_deviation = {-4e-3});
  EXPECT_ROLLERS_REFUSED("complement of two", b.cage = {}; b.rollers().count = 2);
  EXPECT_ROLLERS_REFUSED("complement", b.cage = {}; b.rollers().count = 22);
}

TEST(BearingRefusals, BodiesAndScalesOfRollersInMotion) {
  EXPECT_ROLLERS_REFUSED("one roller", b.rollers().count = 1);
  EXPECT_ROLLERS_REFUSED("roller mass", b.material.density = 0.0);
  EXPECT_ROLLERS_REFUSED("cage mass", b.cage.density = 0.0);
  EXPECT_ROLLERS_REFUSED("pin ring", b.inner.seat_diameter = 31e-3);
  EXPECT_ROLLERS_REFUSED("bore mass", p.bore_mass = 0.0; b.outer.seat_diameter = 0.0);
  EXPECT_ROLLERS_REFUSED("support", p.support.stiffness = 0.0);
  EXPECT_ROLLERS_REFUSED("pocket clearance", p.cage.pocket_clearance = -1e-3);
  EXPECT_ROLLERS_REFUSED("eccentricity", p.cage.largest_eccentricity = 1.0);
  EXPECT_ROLLERS_REFUSED("sliding scale", p.race.sliding_scale = 0.0);
  EXPECT_ROLLERS_REFUSED("entrainment scale", p.race.entrainment_scale = 0.0);
  EXPECT_ROLLERS_REFUSED("traction model", p.race.traction = TractionLaw::ree_eyring);
  EXPECT_ROLLERS_REFUSED("speed ramp", p.driving.ramp = kNaN);
  EXPECT_ROLLERS_REFUSED("land clearance", p.cage.guide_diameter = 38e-3);
  EXPECT_ROLLERS_REFUSED("land width", b.cage.width = 5.6e-3);
  EXPECT_ROLLERS_REFUSED("acceleration", p.driving.ramp = 1.0; o.carrier.acceleration = 5.0);
}

template <class Spoil>
void balls_with(Spoil&& spoil) {
  Bearing bearing = system::small_ball_bearing(20e-6);
  balls::MotionParameters parameters = system::small_ball_motion();
  parameters.lubricant.viscosity = 0.02;
  spoil(bearing, parameters);
  (void)balls::ball_numbers(bearing, parameters);
}

#define EXPECT_BALLS_REFUSED(id, ...)                                                 \
  EXPECT_REFUSED(Refused, id, balls_with([](Bearing& b, balls::MotionParameters& p) { \
                   (void)b, (void)p;                                                  \
                   __VA_ARGS__;                                                       \
                 }))

TEST(BearingRefusals, BallsInMotion) {
  EXPECT_BALLS_REFUSED("balls squeeze oil", p.race.squeeze = true; p.lubricant.viscosity = 0.0);
  EXPECT_BALLS_REFUSED("balls roughness", p.race.squeeze = true; p.race.roughness = 0.0);
  EXPECT_BALLS_REFUSED("balls osculation", b.inner.osculation = 0.5);
  EXPECT_BALLS_REFUSED("balls pocket oil", p.cage.pocket_film = motion::PocketFilm::hydrodynamic;
                       p.lubricant.viscosity = 0.0);
  EXPECT_BALLS_REFUSED("balls pocket", p.cage.pocket_clearance = 0.0);
  EXPECT_BALLS_REFUSED("balls straight pocket", p.pocket.straight = -1e-3);
  EXPECT_BALLS_REFUSED("balls land", p.cage.guide_diameter = 38e-3);
  EXPECT_BALLS_REFUSED("balls land width", p.cage.guide_diameter = 40e-3; b.cage.width = 9e-3);
  EXPECT_BALLS_REFUSED("balls flow", p.mixture.flow = -1.0);
  EXPECT_BALLS_REFUSED("balls inner ring", b.width = 0.0);
  EXPECT_BALLS_REFUSED("balls outer ring", p.outer.held = false; b.outer.seat_diameter = 0.0);
  EXPECT_BALLS_REFUSED("one ball", b.balls().count = 1);
  EXPECT_BALLS_REFUSED("ball mass", b.material.density = 0.0);
  EXPECT_BALLS_REFUSED("balls cage mass", b.cage.density = 0.0);
  EXPECT_BALLS_REFUSED("balls sheared oil", p.race.traction = TractionLaw::limiting_shear;
                       p.lubricant.viscosity = 0.0);
}

template <class Spoil>
defect::ScratchedBearing scratched_with(defect::Scratched race, Spoil&& spoil) {
  defect::ScratchedBearing in = defect::scratched(race);
  in.bearing.cage = {33e-3, 44e-3, 13e-3, 1310.0, Race::outer};
  in.bearing.width = 15e-3;
  spoil(in);
  return in;
}

TEST(BearingRefusals, ScratchesOfABearingAtRest) {
  using defect::ScratchedBearing;
  using defect::ScratchedMotion;
  const auto outer = [](auto spoil) { return scratched_with(defect::Scratched::outer, spoil); };
  const auto ball = [](auto spoil) { return scratched_with(defect::Scratched::ball, spoil); };
  EXPECT_REFUSED(Refused, "scratched ring", ScratchedMotion{outer([](auto& in) { in.ring.mass = 0.0; })});
  EXPECT_REFUSED(Refused, "scratched load", ScratchedMotion{outer([](auto& in) { in.load = -5.0; })});
  EXPECT_REFUSED(Refused, "scratched width",
                 ScratchedMotion{outer([](auto& in) { in.scratch.width = 0.0; })});
  EXPECT_REFUSED(Refused, "scratched depth",
                 ScratchedMotion{outer([](auto& in) { in.scratch.depth = -1e-3; })});
  EXPECT_REFUSED(Refused, "scratched element",
                 ScratchedMotion{ball([](auto& in) { in.scratch.element = 10; })});
  EXPECT_REFUSED(Refused, "scratched kind",
                 ScratchedMotion{scratched_with(defect::Scratched::roller, [](auto&) {})});
}

TEST(BearingRefusals, ScratchesAmongBallsInMotion) {
  const auto motion = [](const defect::ScratchedBearing& in) {
    (void)defect::scratched_numbers(in, system::small_ball_motion());
  };
  const auto outer = [](auto spoil) { return scratched_with(defect::Scratched::outer, spoil); };
  const auto ball = [](auto spoil) { return scratched_with(defect::Scratched::ball, spoil); };
  EXPECT_REFUSED(Refused, "moving ring", motion(outer([](auto& in) { in.ring.mass = 0.0; })));
  EXPECT_REFUSED(Refused, "moving width", motion(outer([](auto& in) { in.scratch.width = 0.0; })));
  EXPECT_REFUSED(Refused, "moving depth", motion(outer([](auto& in) { in.scratch.depth = 0.0; })));
  EXPECT_REFUSED(Refused, "moving scratches",
                 motion(outer([](auto& in) { in.scratch.more_angles.assign(32, 0.1); })));
  EXPECT_REFUSED(Refused, "ball width", motion(ball([](auto& in) { in.scratch.width = 0.0; })));
  EXPECT_REFUSED(Refused, "ball depth", motion(ball([](auto& in) { in.scratch.depth = 0.0; })));
  EXPECT_REFUSED(Refused, "ball element", motion(ball([](auto& in) { in.scratch.element = 0; })));
  EXPECT_REFUSED(Refused, "ball scratches",
                 motion(ball([](auto& in) { in.scratch.more_angles.assign(4, 0.1); })));
  EXPECT_REFUSED(Refused, "roller among balls",
                 motion(scratched_with(defect::Scratched::roller, [](auto&) {})));
  EXPECT_REFUSED(Refused, "duty load", (void)defect::scratched_duty(outer([](auto& in) { in.load = 0.0; })));
}

TEST(BearingRefusals, ScratchesAmongRollersInMotion) {
  using defect::Scratch;
  motion::BearingModel model =
      motion::bearing_model(test::reducer_bearing(), test::reducer_point(6000.0), test::reducer_parameters());
  const auto put = [&](auto spoil) {
    Scratch scratch{.race = defect::Scratched::roller, .width = 1e-3, .depth = 1e-5};
    spoil(scratch);
    motion::BearingModel one = model;
    defect::put_scratches({scratch}, one);
  };
  EXPECT_REFUSED(Refused, "rollers width", put([](Scratch& s) { s.width = 3e-3; }));
  EXPECT_REFUSED(Refused, "ball among rollers", put([](Scratch& s) { s.race = defect::Scratched::ball; }));
  EXPECT_REFUSED(Refused, "scratch as printed",
                 put([](Scratch& s) { s.form = ScratchForm::literature_variant; }));
  EXPECT_REFUSED(Refused, "scratched roller", put([](Scratch& s) { s.element = 16; }));
  EXPECT_REFUSED(Refused, "measured depths", put([](Scratch& s) {
                   s.form = ScratchForm::profile, s.profile = {0.0, 1.0};
                 }));
  const Scratch sound{.race = defect::Scratched::roller, .width = 1e-3, .depth = 1e-5};
  std::vector<Scratch> three(3, sound);
  for (int i = 0; i < 3; ++i) three[static_cast<std::size_t>(i)].element = i + 1;
  EXPECT_REFUSED(Refused, "three rollers", defect::put_scratches(three, model));
}

TEST(BearingRefusals, FilmsThatAreNone) {
  using namespace film;
  const LineFilmCase line{.radius = 5e-3, .modulus = 226e9, .load = 1e5, .rolling = 1.0};
  const auto lines = [&](auto spoil) {
    LineFilmCase contact = line;
    LineFilmGrid grid;
    spoil(contact, grid);
    (void)solve_line_film(contact, grid);
  };
  EXPECT_REFUSED(Refused, "line load", lines([](auto& c, auto&) { c.load = 0.0; }));
  EXPECT_REFUSED(Refused, "line speed", lines([](auto& c, auto&) { c.rolling = -1.0; }));
  EXPECT_REFUSED(Refused, "line cells", lines([](auto&, auto& g) { g.cells = 31; }));
  const auto points = [&](auto spoil) {
    PointFilmCase contact{
        .curvature_x = 100.0, .curvature_y = 100.0, .modulus = 226e9, .load = 10.0, .rolling = 1.0};
    PointFilmGrid grid;
    spoil(contact, grid);
    (void)solve_point_film(contact, grid);
  };
  EXPECT_REFUSED(Refused, "point load", points([](auto& c, auto&) { c.load = 0.0; }));
  EXPECT_REFUSED(Refused, "point speed", points([](auto& c, auto&) { c.rolling = 0.0; }));
  EXPECT_REFUSED(Refused, "point cells", points([](auto&, auto& g) { g.across = 48; }));
}

TEST(BearingRefusals, RowsAndContacts) {
  using equilibrium::RowGroup;
  const Bearing balls = system::small_ball_bearing(0.0);
  EXPECT_REFUSED(Refused, "no rows", RowGroup({}));
  EXPECT_REFUSED(Refused, "side of a row", RowGroup({{.bearing = balls, .side = 0.5}}));
  EXPECT_REFUSED(Refused, "curvature difference", (void)contact_ellipse(1.0));
  balls::MotionParameters free = system::small_ball_motion();
  free.outer.held = false;
  balls::BallBearing both(balls::ball_numbers(balls, free), {});
  EXPECT_REFUSED(Refused, "two free rings", balls::PublishedForm{both});
}

TEST(BearingRefusals, ProfilesThatAreNone) {
  using namespace profile;
  const double l = 10e-3;
  EXPECT_REFUSED(Refused, "profile length", require_sound(Chamfer{0.0, 1e-3, 1e-6}));
  EXPECT_REFUSED(Refused, "chamfer", require_sound(Chamfer{l, 6e-3, 1e-6}));
  EXPECT_REFUSED(Refused, "chamfer depth", require_sound(Chamfer{l, 1e-3, -1e-6}));
  EXPECT_REFUSED(Refused, "crown drop", require_sound(CircularCrown{l, -1e-6}));
  EXPECT_REFUSED(Refused, "crown too deep", require_sound(CircularCrown{l, 5e-3}));
  EXPECT_REFUSED(Refused, "straight part", require_sound(StraightCircular{l, l, 1e-6}));
  EXPECT_REFUSED(Refused, "curved end", require_sound(StraightCircular{l, 0.6 * l, 2e-3}));
  EXPECT_REFUSED(Refused, "lundberg", require_sound(Lundberg{l, -1e-6, 0.1}));
  EXPECT_REFUSED(Refused, "johns-gohar", require_sound(JohnsGohar{l, 1e-6, 1.0}));
  EXPECT_REFUSED(Refused, "iso diameter", require_sound(Iso16281{l, 0.0, 1.0}));
  EXPECT_REFUSED(Refused, "iso scale", require_sound(Iso16281{l, l, -1.0}));
  EXPECT_REFUSED(Refused, "steepness", require_sound(FujiwaraKawase{l, 1e-6, 0.0, 1.0}));
  EXPECT_REFUSED(Refused, "crowned fraction", require_sound(FujiwaraKawase{l, 1e-6, 1.0, 1.1}));
  EXPECT_REFUSED(Refused, "table of one", require_sound(Table{{0.0}, {0.0}}));
  EXPECT_REFUSED(Refused, "table order", require_sound(Table{{1e-3, 0.0}, {0.0, 1e-6}}));
  EXPECT_REFUSED(Refused, "table drop", require_sound(Table{{0.0, 1e-3}, {0.0, -1e-6}}));
}

TEST(BearingRefusals, HalfSpacesAndGrids) {
  using namespace half_space;
  const Material steel{.youngs_modulus = 206e9, .poisson_ratio = 0.3};
  const HalfSpaceContact sound{.length = 10e-3, .equivalent_radius = 4e-3, .roller = steel, .race = steel};
  const auto with = [&](auto spoil) {
    HalfSpaceContact contact = sound;
    spoil(contact);
    (void)StripContact{contact, {}};
  };
  EXPECT_REFUSED(Refused, "strip length", with([](auto& c) { c.length = 0.0; }));
  EXPECT_REFUSED(Refused, "strip radius", with([](auto& c) { c.equivalent_radius = -1.0; }));
  EXPECT_REFUSED(Refused, "strip roller", with([](auto& c) { c.roller.youngs_modulus = 0.0; }));
  EXPECT_REFUSED(Refused, "strip race", with([](auto& c) { c.race.poisson_ratio = 0.6; }));
  const StripContact strips{sound, {}};
  const Eigen::ArrayXd flat = Eigen::ArrayXd::Zero(strips.grid().middle.size());
  EXPECT_REFUSED(Refused, "strip approach", strips.at_approach(flat, kNaN, 0.0));
  EXPECT_REFUSED(Refused, "strip relief", (void)mean_relief(strips.grid(), [](double) { return kNaN; }));
}

TEST(BearingRefusals, RimsPinsEllipsesAndLives) {
  ElasticRace race = test::bending_race();
  EXPECT_REFUSED(Refused, "rim order", (void)motion::moving_waves(race, {.most_order = -1}));
  EXPECT_REFUSED(Refused, "rim damping", (void)motion::rim_waves(race, {.damping_ratio = -0.1}));
  race.mass[2] = 0.0;
  EXPECT_REFUSED(Refused, "rim mass", (void)motion::rim_waves(race, {}));
  race.mass.conservativeResize(3);
  EXPECT_REFUSED(Refused, "rim masses", (void)motion::rim_waves(race, {}));
  EXPECT_REFUSED(Refused, "pin span", (void)pin_compliance({.diameter = 0.01}, {0.0}));
  EXPECT_REFUSED(Refused, "ellipse slices", (void)ellipse_points(0, 4));
  EXPECT_REFUSED(Refused, "ellipse rows", (void)ellipse_points(4, 0));
  EXPECT_REFUSED(Refused, "ellipse points", (void)ellipse_points(20, 20));
  EXPECT_REFUSED(Refused, "cage material", (void)cage_material("wood"));
  EXPECT_REFUSED(Refused, "kappa",
                 (void)rating::life_modification_factor(rating::RollingElement::ball, 0.09, 1.0));
  EXPECT_REFUSED(Refused, "fatigue ratio",
                 (void)rating::life_modification_factor(rating::RollingElement::ball, 1.0, -1.0));
  EXPECT_REFUSED(Refused, "standing ratio", (void)rating::required_viscosity(0.0, 50e-3));
}

}  // namespace
}  // namespace orbearing::bearing::bearing_refusals_test
