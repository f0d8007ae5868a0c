// Arguments that gears and bearings in motion refuse; words and numbers in tests/messages.txt.
#include <gtest/gtest.h>

#include <limits>

#include "coupling/analysis/gear_dynamics.hpp"
#include "coupling/analysis/one_way.hpp"
#include "coupling/system/driven_bearing.hpp"
#include "coupling/system/driven_gears.hpp"
#include "coupling/system/heated_balls.hpp"
#include "gearset/dynamics/bodies.hpp"
#include "gearset/dynamics/model.hpp"
#include "gearset/mean_loads.hpp"
#include "gearset/mesh/loaded/loaded_teeth.hpp"
#include "tests/gear_sets.hpp"
#include "tests/messages.hpp"
#include "tests/unit/cosim/driven_reducer.hpp"

namespace orbearing::system::coupling_refusals_test {
namespace {

using Refused = std::invalid_argument;
namespace gears = gearset::dynamics;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <class Spoil>
void driven_with(Spoil&& spoil) {
  DrivenBearingSetup setup = test::driven_reducer();
  spoil(setup);
  (void)DrivenBearing{setup};
}

#define EXPECT_DRIVEN_REFUSED(id, ...) \
  EXPECT_REFUSED(Refused, id, driven_with([](DrivenBearingSetup& s) { __VA_ARGS__; }))

TEST(CouplingRefusals, OfADrivenBearing) {
  EXPECT_DRIVEN_REFUSED("driven place", s.first_roller = kNaN);
  EXPECT_DRIVEN_REFUSED("driven reduction", s.reduction_factor = 0.0);
  EXPECT_DRIVEN_REFUSED("driven error", s.allowed_length_error = 0.0);
  EXPECT_DRIVEN_REFUSED("driven bins", s.bins = 0);
  EXPECT_DRIVEN_REFUSED("driven tilt", s.bore_tilt = {3e-3, 4e-3});
  EXPECT_DRIVEN_REFUSED("driven tilt without end", s.bore_tilt = {kNaN, 0.0});
  EXPECT_DRIVEN_REFUSED("driven load", s.start_load = {kNaN, 0.0});
  EXPECT_DRIVEN_REFUSED("driven steps", s.most_steps = 0);
  EXPECT_DRIVEN_REFUSED("driven mesh", s.dynamics.excitation.harmonics.resize(2));
}

template <class Spoil>
void set_with(Spoil&& spoil) {
  gears::SetParameters set = gears::test::reducer_dynamics();
  gears::Operation operation = gears::test::reducer_operation(628.0);
  spoil(set, operation);
  (void)gears::set_model(set, operation);
}

#define EXPECT_SET_REFUSED(id, ...)                                                       \
  EXPECT_REFUSED(Refused, id, set_with([](gears::SetParameters& s, gears::Operation& o) { \
                   (void)s, (void)o;                                                      \
                   __VA_ARGS__;                                                           \
                 }))

TEST(CouplingRefusals, OfAGearSet) {
  EXPECT_SET_REFUSED("set inertia", s.ring.inertia = -1.0);
  EXPECT_SET_REFUSED("set radius", s.carrier.radius = 0.0);
  EXPECT_SET_REFUSED("set support", s.sun.support.damping = -5.0);
  EXPECT_SET_REFUSED("planet mass", s.planet.mass = 0.0);
  EXPECT_SET_REFUSED("planet radius", s.planet.radius = kNaN);
  EXPECT_SET_REFUSED("planet stiffness", s.planet.bearing_stiffness = -2.0);
  EXPECT_SET_REFUSED("planet damping", s.planet.bearing_damping = -3.0);
  EXPECT_SET_REFUSED("mesh damping", s.sun_mesh.damping = -4.0);
  EXPECT_SET_REFUSED("mesh angle", s.ring_mesh.pressure_angle = 1.5);
  EXPECT_SET_REFUSED("set angles", s.planet_angles = {0.0, 1.0});
  EXPECT_SET_REFUSED("mesh below zero", s.sun_mesh.stiffness = gearset::PeriodicCurve(
                                            [](double f) { return 1e8 * (f - 0.1); }, {0.0}, 8));
  EXPECT_SET_REFUSED("affine bearing", s.planet.affine_bearing.emplace().stiffness.setConstant(kNaN));
  EXPECT_SET_REFUSED("pulling teeth", s.separation = false;
                     s.sun_mesh.loaded = std::make_shared<const gearset::LoadedTeeth>(
                         s.sun_mesh.stiffness, s.sun_mesh.stiffness, -0.4, 2.1, 1e-10,
                         std::vector<gearset::FaceSlice>{{0.0, 0.0}}));
  EXPECT_SET_REFUSED("run-up from", o.run_up.from = 0.0);
  EXPECT_SET_REFUSED("run-up duration", o.run_up.duration = -1.0);
  EXPECT_SET_REFUSED("mesh frequency", o.mesh_frequency = -7.0);
}

TEST(CouplingRefusals, OfStudies) {
  EXPECT_REFUSED(Refused, "orders of a fit", analysis::AffineFit(100.0, 0));
  EXPECT_REFUSED(Refused, "mesh at rest", (void)analysis::run_gears_from({}, {}, {}));
  const gearset::PlanetarySet set = gearset::reducer();
  const gearset::WorkingGeometry geometry = gearset::working_geometry(set);
  EXPECT_REFUSED(
      Refused, "motor at rest",
      (void)gearset::mean_loads(set, geometry, gearset::MemberRatios{}, {.power = 1.0, .speed = 0.0}));
  EXPECT_REFUSED(std::domain_error, "carrier without plates",
                 (void)gears::set_bodies(set, geometry,
                                         {.sun_bore = 50e-3, .ring_outside = 280e-3, .planet_bore = 47e-3}));
  DrivenGearsSetup driven{.set = gears::test::reducer_dynamics(),
                          .operation = gears::test::reducer_operation(628.0)};
  driven.set.planet.coupled_bearing = true;
  driven.allowed_share = 0.0;
  EXPECT_REFUSED(Refused, "driven gears' error", DrivenGears{driven});
}

TEST(CouplingRefusals, OfAThermalNetwork) {
  const auto of = [](double value) { return Eigen::VectorXd::Constant(1, value).eval(); };
  const auto between = [](double value) { return Eigen::MatrixXd::Constant(1, 1, value).eval(); };
  EXPECT_REFUSED(Refused, "conductance", ThermalNetwork(of(1.0), between(-2.0), of(1.0), of(20.0)));
  EXPECT_REFUSED(Refused, "conductance outward", ThermalNetwork(of(1.0), between(0.0), of(-3.0), of(20.0)));
}

}  // namespace
}  // namespace orbearing::system::coupling_refusals_test
