#include "coupling/study/scheme_convergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "coupling/cosim/monolithic.hpp"
#include "coupling/cosim/planetary_coupling.hpp"
#include "coupling/study/driven_setups.hpp"

namespace orbearing::study {

namespace {

using cosim::CoupledOptions;
using cosim::ExchangeOrder;

constexpr double kRunaway = 1.0;  // [-]  a force error beyond the forces themselves

// Forces on all planets [N] at each time of the comparison. (2 x planets, times)
using Path = Eigen::MatrixXd;

Path reference_path(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                    const ConvergenceOptions& options) {
  cosim::CoupledSetup setup{driven_gears_setup(drivetrain), driven_bearing_setup(drivetrain, geometry),
                            drivetrain.bearings_per_planet};
  setup.gears.allowed_share = options.allowed_share;
  setup.bearing.allowed_length_error = options.reference_length_error;
  cosim::Monolithic system(setup);
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

Trial trial(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry, const Scheme& scheme,
            double window, const ConvergenceOptions& options) {
  const cosim::PlanetaryCoupling parts = cosim::planetary_coupling(
      drivetrain, geometry,
      {.allowed_share = options.allowed_share, .allowed_length_error = options.allowed_length_error});
  CoupledOptions exchange = scheme.options;
  exchange.window = {.longest = window};
  cosim::CoupledRun run(parts.participants(), cosim::connect_by_name(parts.participants()), exchange);
  run.initialize(0.0);
  const Eigen::Index planets = drivetrain.set.planets;
  Trial result{.path = Path::Zero(2 * planets, options.longest_windows)};
  const auto observe = [&](const cosim::WindowRecord& record) {
    result.residual += std::abs(record.residual);
    for (const cosim::JointValue& joint : record.end->joints)
      result.passed += std::abs(joint.force * joint.velocity) * record.window.length();
  };
  for (long i = 0; i < options.longest_windows; ++i) {
    const cosim::CoupledReport part = run.advance(std::lround(options.longest_window / window), observe);
    if (!part.completed) throw std::runtime_error(part.message);
    for (Eigen::Index planet = 0; planet < planets; ++planet)  // joints x, y, rotation of each planet in turn
      for (Eigen::Index axis = 0; axis < 2; ++axis)
        result.path(2 * planet + axis, i) =
            run.values().joints[static_cast<std::size_t>(3 * planet + axis)].force;
  }
  return result;
}

SchemeError error_of(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                     const Scheme& scheme, double window, const Path& reference,
                     const ConvergenceOptions& options) {
  SchemeError error{.scheme = scheme.name, .window = window};
  try {
    const Trial found = trial(drivetrain, geometry, scheme, window, options);
    error.force_error = (found.path - reference).norm() / reference.norm();
    error.energy_residual = found.residual / found.passed;
  } catch (const std::runtime_error&) {
    error.force_error = std::numeric_limits<double>::quiet_NaN();
    error.energy_residual = error.force_error;
  }
  return error;
}

// Slope between the two shortest windows whose errors still fall by half or more.
SchemeOrder order_of(const Scheme& scheme, const std::vector<SchemeError>& falling) {
  SchemeOrder order{scheme.name, scheme.expected_order, std::numeric_limits<double>::quiet_NaN()};
  for (std::size_t i = 1; i < falling.size(); ++i) {
    const double ratio = falling[i - 1].force_error / falling[i].force_error;
    if (!(ratio > 1.5) || !(falling[i - 1].force_error < 0.5 * kRunaway)) continue;
    order.measured = std::log(ratio) / std::log(falling[i - 1].window / falling[i].window);
  }
  return order;
}

}  // namespace

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
       2});
  return schemes;
}

SchemeConvergence scheme_convergence(const PlanetaryDrivetrain& drivetrain,
                                     const DrivetrainGeometry& geometry, const std::vector<Scheme>& schemes,
                                     const ConvergenceOptions& options) {
  const Path reference = reference_path(drivetrain, geometry, options);
  SchemeConvergence result{.path = options.longest_window * static_cast<double>(options.longest_windows)};
  for (const Scheme& scheme : schemes) {
    std::vector<SchemeError> errors;
    for (int halving = 0; halving <= options.halvings; ++halving)
      errors.push_back(error_of(drivetrain, geometry, scheme, std::ldexp(options.longest_window, -halving),
                                reference, options));
    result.orders.push_back(order_of(scheme, errors));
    result.errors.insert(result.errors.end(), errors.begin(), errors.end());
  }
  return result;
}

}  // namespace orbearing::study
