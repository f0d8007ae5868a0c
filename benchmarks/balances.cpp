#include "benchmarks/balances.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "bearing/equilibrium/row_group.hpp"
#include "bearing/film/reynolds/point.hpp"
#include "benchmarks/clocks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bench {

namespace {

// Median over seven of the mean time [s] of `count` calls.
template <class Work>
double time_of(const Work& work, int count) {
  std::vector<double> times;
  for (int i = 0; i < 7; ++i) {
    const Stopwatch watch;
    for (int j = 0; j < count; ++j) work();
    times.push_back(watch.cpu() / count);
  }
  std::nth_element(times.begin(), times.begin() + 3, times.end());
  return times[3];
}

// Bearing 218 of [Harris2006] with 16 balls under a load in all its directions.
double ball_balance() {
  using namespace bearing;
  constexpr double kDegree = constants::degree, kRpm = constants::pi / 30.0;
  const Bearing balls{.inner = {.osculation = 0.5232},
                      .outer = {.osculation = 0.5232},
                      .elements = Balls{.count = 16, .diameter = 22.23e-3, .contact_angle = 40.0 * kDegree},
                      .pitch_diameter = 125.26e-3};
  const equilibrium::RowMotion motion{.speeds = {.inner = 10000.0 * kRpm}};
  const equilibrium::RingLoad load{.radial = 5000.0, .axial = 17800.0, .moment = 50.0, .moment_across = 20.0};
  return time_of(
      [&] {
        if (!equilibrium::balance_bearing(balls, motion, load).report.converged)
          throw std::runtime_error("the balance of the benchmark was not found");
      },
      300);
}

// W = 1e-6, U = 1e-11, G = 4560 in a circular contact, as docs/reynolds.md.
double point_film(int cells) {
  using namespace bearing::film;
  PointFilmCase contact{.modulus = 228e9, .oil = {.viscosity = 0.02, .pressure_viscosity = 20e-9}};
  constexpr double kRadius = 0.01;
  set_ellipse(contact, kRadius, 1.0);
  contact.load = 1e-6 * contact.modulus * kRadius * kRadius;
  contact.rolling = 1e-11 * contact.modulus * kRadius / contact.oil.viscosity;
  const PointFilmGrid grid{.along = cells, .across = cells};
  return time_of(
      [&] {
        if (!solve_point_film(contact, grid).converged)
          throw std::runtime_error("the film of the benchmark was not solved");
      },
      1);
}

}  // namespace

void put_balances(nlohmann::ordered_json& out) {
  out["ball_balance_us"] = 1e6 * ball_balance();
  out["reynolds_129_s"] = point_film(128);
  out["reynolds_257_s"] = point_film(256);
}

}  // namespace orbearing::bench
