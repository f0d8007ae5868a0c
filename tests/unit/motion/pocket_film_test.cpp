// The closed forms of the film between roller and bar against the pressure field they come from.
#include "bearing/contact/rigid_line_film.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <vector>

#include "bearing/contact/pocket_law.hpp"
#include "bearing/plane.hpp"

namespace orbearing::bearing::motion::pocket_film_test {
namespace {

constexpr double kViscosity = 0.01;  // [Pa s]
constexpr double kLength = 5.7e-3;   // [m]
constexpr double kRadius = 2.62e-3;  // [m]
constexpr double kQuadrature =
    1e-7;  // relative: the integrals begin 1e-9 rad short of infinity, on spans of 0.01 rad and more
constexpr double kRoundOff = 1e-12;

// The field of the header, of a film that flows in +x.
struct Field {
  double gap;
  double entrainment;
  double closing;

  double height(double x) const { return gap + x * x / (2.0 * kRadius); }
  double pressure(double x) const {
    return kViscosity * (6.0 * closing * kRadius - 4.0 * entrainment * x) / (height(x) * height(x));
  }
  double slope(double x) const {
    const double h = height(x);
    return kViscosity * (-4.0 * entrainment / (h * h) -
                         2.0 * x / kRadius * (6.0 * closing * kRadius - 4.0 * entrainment * x) / (h * h * h));
  }
  // Flow against Reynolds' equation: h^3 p'.
  double flow(double x) const { return std::pow(height(x), 3) * slope(x); }
  double end() const { return 1.5 * closing * kRadius / entrainment; }

  template <class Function>
  double integral(Function f) const {
    // x = scale tan(t) from minus infinity to where the pressure ends.
    const double scale = std::sqrt(2.0 * kRadius * gap);
    boost::math::quadrature::tanh_sinh<double> rule;
    return rule.integrate(
        [&](double t) {
          const double c = std::cos(t);
          return f(scale * std::tan(t)) * scale / (c * c);
        },
        -0.5 * M_PI + 1e-9, std::atan(end() / scale));
  }
};

const std::vector<Field> kFields = {{1e-6, 3.0, 0.0},    {5e-6, 5.0, 0.05}, {5e-6, 5.0, -0.05},
                                    {40e-6, 0.5, 0.4},   {2e-6, 0.2, 0.2},  {2e-6, 2.0, -0.2},
                                    {30e-6, 8.0, -0.01}, {0.4e-6, 1.0, 0.1}};

LineFilm<double, double> line_film(double gap, double entrainment, double closing) {
  const auto film = RigidLineFilm<double>::of(kViscosity, kLength, kRadius);
  return film.at(film.slenderness(gap), entrainment, closing);
}

LineFilm<double, double> film_of(const Field& f) {
  return line_film(f.gap, f.entrainment, f.closing);
}

// Lost in the film [W] at surface speeds whose difference is `sliding` and half sum `entrainment` [m/s].
double line_film_power(const LineFilm<double, double>& film, double entrainment, double closing,
                       double sliding) {
  return film.load * closing + film.shear * (sliding * sliding + 4.0 * entrainment * entrainment);
}

TEST(PocketFilm, FieldSolvesReynoldsEquation) {
  for (const Field& f : kFields) {
    const double scale = std::sqrt(2.0 * kRadius * f.gap);
    for (double x : {-3.0 * scale, -scale, -0.2 * scale, 0.4 * scale}) {
      const double step = 1e-4 * scale;
      const double left = (f.flow(x + step) - f.flow(x - step)) / (2.0 * step);
      const double right = 12.0 * kViscosity * (f.entrainment * x / kRadius - f.closing);
      const double size = 12.0 * kViscosity * (f.entrainment * scale / kRadius + std::abs(f.closing));
      EXPECT_NEAR(left, right, 1e-6 * size) << "central difference of relative step 1e-4";
    }
  }
}

TEST(PocketFilm, LoadIsTheIntegralOfThePressure) {
  for (const Field& f : kFields) {
    const double load = kLength * f.integral([&](double x) { return f.pressure(x); });
    EXPECT_NEAR(film_of(f).load, load, kQuadrature * load);
  }
}

// Sheared and pumped oil: integral of eta (du)^2 / h + h^3 p'^2 / (12 eta).
TEST(PocketFilm, PowerIsWhatTheOilDissipates) {
  for (const Field& f : kFields)
    for (double sliding : {0.0, 3.0, -7.0}) {
      const double lost = kLength * f.integral([&](double x) {
        const double h = f.height(x);
        return kViscosity * sliding * sliding / h + h * h * h * f.slope(x) * f.slope(x) / (12.0 * kViscosity);
      });
      EXPECT_NEAR(line_film_power(film_of(f), f.entrainment, f.closing, sliding), lost, kQuadrature * lost);
    }
}

TEST(PocketFilm, KnownLimits) {
  const double g = 3e-6;
  const double rolling = line_film(g, 4.0, 0.0).load;
  const double martin = 4.896 * kViscosity * 4.0 * kRadius * kLength / g;
  EXPECT_NEAR(rolling / martin, 4.0 / 4.896, kRoundOff);
  const double squeezed = line_film(g, 0.0, 0.1).load;
  EXPECT_NEAR(squeezed, 3.0 * std::sqrt(2.0) * M_PI * kViscosity * 0.1 * kLength * std::pow(kRadius / g, 1.5),
              kRoundOff * squeezed);
  EXPECT_EQ(line_film(g, 0.0, -0.1).load, 0.0);
  EXPECT_EQ(line_film(g, 0.0, 0.0).load, 0.0);
}

TEST(PocketFilm, NeverPullsAndAlwaysDissipates) {
  for (double gap = 4e-7; gap < 1e-3; gap *= 3.0)
    for (double u = 1e-6; u < 30.0; u *= 7.0)
      for (double v : {-10.0, -0.1, -1e-4, 0.0, 1e-4, 0.1, 10.0}) {
        const auto film = line_film(gap, u, v);
        EXPECT_GE(film.load, 0.0);
        EXPECT_GE(film.shear, 0.0);
        EXPECT_GE(line_film_power(film, u, v, 0.0), -1e-15 * film.load * std::abs(v))
            << gap << ' ' << u << ' ' << v;
      }
}

const PocketLaw kPocket{.half_clearance = 0.05e-3,
                        .stiffness = 3e7,
                        .damping = 1.0,
                        .friction = {0.05, 0.1},
                        .viscous = 2.0 * kViscosity * kLength,
                        .roughness = 0.4e-6};

struct PocketForces {
  Wrench on_roller, on_cage;
  double load, power;
};

// Film, and touch where the bar is pressed in, in the pocket that points along `outward`.
PocketForces pocket_forces(const BodyMotion& roller, const BodyMotion& cage, const Vector2& outward) {
  const Vector2 ahead = across(outward), position = roller.position - cage.position,
                velocity = roller.velocity - cage.velocity;
  const PocketMotion motion{position.dot(ahead),   position.dot(outward), velocity.dot(ahead),
                            velocity.dot(outward), roller.speed,          cage.speed};
  const auto on_both = [&](const auto& law) {
    const Vector2 force = law.ahead * ahead + law.along * outward;
    return PocketForces{{force, law.roller_moment}, {-force, law.cage_moment}, -law.ahead, law.power};
  };
  PocketForces all = on_both(kPocket.oil(kRadius, 0.0, motion));
  const double bar = std::copysign(1.0, motion.offset);
  if (kPocket.depth(bar, motion.offset, 0.0) > 0.0)
    all.load += on_both(kPocket.touch(bar, kRadius, 0.0, motion)).load;
  return all;
}

// The power loss of both bodies is dissipated and stored, and moments cancel, in any motion.
TEST(PocketFilm, PowerAndMomentsBalanceOnRollerAndCage) {
  const Vector2 outward(std::cos(0.3), std::sin(0.3));
  for (double offset : {0.0, 0.03e-3, -0.0495e-3, 0.0499e-3})
    for (double spin : {-5000.0, 300.0, 6000.0}) {
      const BodyMotion cage{Vector2(1e-5, -2e-5), Vector2(0.1, -0.3), 700.0};
      const BodyMotion roller{cage.position + 17.8e-3 * outward + offset * across(outward),
                              Vector2(-3.0, 11.5), spin};
      const PocketForces f = pocket_forces(roller, cage, outward);
      const double given = f.on_roller.force.dot(roller.velocity) + f.on_roller.moment * roller.speed +
                           f.on_cage.force.dot(cage.velocity) + f.on_cage.moment * cage.speed;
      EXPECT_GT(f.power, 0.0);
      EXPECT_NEAR(given, -f.power, 1e-10 * f.power);
      const double rotating = f.on_roller.moment + cross(roller.position, f.on_roller.force) +
                              f.on_cage.moment + cross(cage.position, f.on_cage.force);
      EXPECT_NEAR(rotating, 0.0, 1e-14 * f.on_roller.force.norm());
    }
}

// The film carries before touch, and grows into it without a jump.
TEST(PocketFilm, CarriesBeforeTouchAndGoesOverWithoutAJump) {
  const auto load_at = [](double offset) {
    const BodyMotion roller{Vector2(17.8e-3, offset), Vector2(0.0, 0.1), 4000.0};
    return pocket_forces(roller, {Vector2::Zero(), Vector2::Zero(), 0.0}, Vector2(1.0, 0.0)).load;
  };
  EXPECT_GT(load_at(0.049e-3), 1.0);
  const double touch = 0.05e-3;
  EXPECT_NEAR(load_at(touch + 1e-12), load_at(touch - 1e-12), 1e-4);  // [N]  3e7 N/m over 2 pm
  EXPECT_NEAR(load_at(touch - 0.4e-6 - 1e-13), load_at(touch - 0.4e-6 + 1e-13), 1e-4);
}

}  // namespace
}  // namespace orbearing::bearing::motion::pocket_film_test
