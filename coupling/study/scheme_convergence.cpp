#include "coupling/study/scheme_convergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "coupling/cosim/planetary_coupling.hpp"
#include "coupling/study/driven_setups.hpp"
#include "coupling/system/monolithic.hpp"

namespace orbearing::study {

namespace {

using cosim::CoupledOptions;
using cosim::ExchangeOrder;

constexpr double kRunaway = 10.0;  // [-]  forces over the largest true one: the exchange has run away
constexpr double kSound = 0.5;     // [-]  errors of the forces that are usable for an order
constexpr double kFalls = 1.5;     // [-]  ratio of errors of two windows that is more than a floor's scatter
constexpr double kLonger = 7.0 / 6.0;

// A way to exchange, and the order with which its error shall fall where all is smooth.
struct Scheme {
  std::string name;
  CoupledOptions options;  // but for the window
  int expected_order = 1;  // [-]  of the error in the length of the window
};

struct ConvergenceOptions {
  double longest_window = 4e-5;         // [s]
  int halvings = 4;                     // windows from the longest one down
  long longest_windows = 8;             // whose length is the path; rollers are chaotic beyond 0.5 ms
  double allowed_length_error = 2e-13;  // [m]  of a step of a bearing, so that what is seen is the exchange's
  double allowed_share = 1e-8;          // [-]  of the gears
  double reference_length_error = 5e-14;  // [m]  of the system solved as one
  double shortest_limit = 1e-5;  // [s]  windows tried for stability, each by a sixth longer than the last
  double longest_limit = 1e-4;   // [s]
  double stability_path = 2e-3;  // [s]  in which an unstable exchange shall have run away
};

// Forces on all planets [N] at each time of the comparison. (2 x planets, times)
using Path = Eigen::MatrixXd;

Path reference_path(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                    const ConvergenceOptions& options) {
  system::CoupledSetup setup = coupled_setup(drivetrain, geometry);
  setup.gears.allowed_share = options.allowed_share;
  setup.bearing.allowed_length_error = options.reference_length_error;
  system::Monolithic system(setup);
  system.initialize(0.0);
  Path path = Path::Zero(2 * system.planets(), options.longest_windows);
  for (long i = 0; i < options.longest_windows; ++i) {
    system.advance({options.longest_window * static_cast<double>(i),
                    options.longest_window * static_cast<double>(i + 1)});
    for (int b = 0; b < system.bearings(); ++b)
      path.block<2, 1>(2 * (b / drivetrain.bearings_per_planet), i) += system.reaction(b).force;
  }
  return path;
}

// One co-simulation with its forces and its energies.
struct Trial {
  Path path;
  double residual = 0.0;  // [J]
  double passed = 0.0;    // [J]
};

// Throws std::runtime_error where a force passes `largest_force`.
Trial trial(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry, const Scheme& scheme,
            double window, double largest_force, const ConvergenceOptions& options) {
  system::CoupledSetup setup = coupled_setup(drivetrain, geometry);
  setup.gears.allowed_share = options.allowed_share;
  setup.bearing.allowed_length_error = options.allowed_length_error;
  const cosim::PlanetaryCoupling parts = cosim::planetary_coupling(setup);
  CoupledOptions exchange = scheme.options;
  exchange.window = window;
  cosim::CoupledRun run(parts.sides, exchange);
  run.initialize(0.0);
  const Eigen::Index planets = drivetrain.set.planets;
  Trial result{.path = Path::Zero(2 * planets, options.longest_windows)};
  const auto observe = [&](const cosim::WindowRecord& record) {
    for (const cosim::JointValue& joint : record.end->joints)
      if (std::abs(joint.force) > largest_force) throw std::runtime_error("the exchange ran away");
  };
  for (long i = 0; i < options.longest_windows; ++i) {
    const cosim::CoupledReport part = run.advance(std::lround(options.longest_window / window), observe);
    if (!part.completed) throw std::runtime_error(part.message);
    result.residual += part.absolute_residual;
    result.passed += part.passed;
    for (Eigen::Index planet = 0; planet < planets; ++planet)  // joints x, y, rotation of each planet in turn
      for (Eigen::Index axis = 0; axis < 2; ++axis)
        result.path(2 * planet + axis, i) =
            run.values().joints[static_cast<std::size_t>(3 * planet + axis)].force;
  }
  return result;
}

SchemeError error_of(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                     const Scheme& scheme, double window, const Path& reference, double largest_force,
                     const ConvergenceOptions& options) {
  SchemeError error{.scheme = scheme.name, .window = window};
  try {
    const Trial found = trial(drivetrain, geometry, scheme, window, largest_force, options);
    error.force_error = (found.path - reference).norm() / reference.norm();
    error.energy_residual = found.residual / found.passed;
  } catch (const std::runtime_error&) {
    error.force_error = std::numeric_limits<double>::quiet_NaN();
    error.energy_residual = error.force_error;
  }
  return error;
}

// Slope between the two shortest windows whose errors still fall.
double measured_order(const std::vector<SchemeError>& falling) {
  double order = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 1; i < falling.size(); ++i) {
    const double ratio = falling[i - 1].force_error / falling[i].force_error;
    if (!(ratio > kFalls) || !(falling[i - 1].force_error < kSound)) continue;
    order = std::log(ratio) / std::log(falling[i - 1].window / falling[i].window);
  }
  return order;
}

double stability_limit(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                       const Scheme& scheme, double largest_force, const ConvergenceOptions& options) {
  ConvergenceOptions rough;
  rough.allowed_length_error = drivetrain.steady_state.allowed_length_error;
  rough.allowed_share = system::DrivenGearsSetup{}.allowed_share;
  for (double window = options.shortest_limit; window <= options.longest_limit; window *= kLonger) {
    rough.longest_window = window;
    rough.longest_windows = std::lround(options.stability_path / window);
    try {
      trial(drivetrain, geometry, scheme, window, largest_force, rough);
    } catch (const std::runtime_error&) {
      return window;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<Scheme> common_schemes() {
  std::vector<Scheme> schemes;
  for (const auto& [name, order] :
       {std::pair{"Jacobi", ExchangeOrder::jacobi}, std::pair{"Gauss-Seidel", ExchangeOrder::gauss_seidel}})
    for (int degree = 0; degree <= 2; ++degree)
      schemes.push_back({std::string(name) + ", degree " + std::to_string(degree),
                         {.order = order, .extrapolation = degree},
                         degree + 1});
  schemes.push_back(
      {"iterated, degree 1",
       {.order = ExchangeOrder::gauss_seidel, .extrapolation = 1, .iteration = {.most_passes = 20}},
       3});
  return schemes;
}

}  // namespace

SchemeConvergence scheme_convergence(const PlanetaryDrivetrain& drivetrain,
                                     const DrivetrainGeometry& geometry) {
  const ConvergenceOptions options;
  const Path reference = reference_path(drivetrain, geometry, options);
  const double largest_force = kRunaway * reference.cwiseAbs().maxCoeff();
  SchemeConvergence result{.path = options.longest_window * static_cast<double>(options.longest_windows)};
  for (const Scheme& scheme : common_schemes()) {
    std::vector<SchemeError> errors;
    for (int halving = 0; halving <= options.halvings; ++halving)
      errors.push_back(error_of(drivetrain, geometry, scheme, std::ldexp(options.longest_window, -halving),
                                reference, largest_force, options));
    const bool explicit_exchange = scheme.options.iteration.most_passes == 1;
    result.orders.push_back({scheme.name, scheme.expected_order, measured_order(errors),
                             explicit_exchange
                                 ? stability_limit(drivetrain, geometry, scheme, largest_force, options)
                                 : std::numeric_limits<double>::quiet_NaN()});
    result.errors.insert(result.errors.end(), errors.begin(), errors.end());
  }
  return result;
}

}  // namespace orbearing::study
