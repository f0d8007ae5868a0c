#include "coupling/system/heated_balls.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "mechanics/checks.hpp"
#include "mechanics/linear_algebra.hpp"

namespace orbearing::system {

ThermalNetwork::ThermalNetwork(const Eigen::VectorXd& capacity, const Eigen::MatrixXd& between,
                               const Eigen::VectorXd& outward, const Eigen::VectorXd& outside)
    : capacity_(capacity), outward_(outward), outside_(outside) {
  using mechanics::require;
  const Eigen::Index n = capacity.size();
  require(capacity.minCoeff() > 0.0, "heat capacity [J/K]", capacity.minCoeff(), "more than 0");
  require(between.minCoeff() >= 0.0, "thermal conductance [W/K]", between.minCoeff(), "0 or more");
  require(outward.minCoeff() >= 0.0, "thermal conductance to the outside [W/K]", outward.minCoeff(),
          "0 or more");
  conductance_ = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    conductance_(i, i) = outward[i];
    for (Eigen::Index k = 0; k < n; ++k) {
      if (k == i) continue;
      conductance_(i, k) = -between(i, k);
      conductance_(i, i) += between(i, k);
    }
  }
  const Eigen::VectorXd scale = capacity.cwiseSqrt().cwiseInverse();
  const mechanics::SymmetricModes decay =
      mechanics::symmetric_modes(scale.asDiagonal() * conductance_ * scale.asDiagonal());
  rates_ = decay.values;
  modes_ = decay.vectors;
  require(rates_.minCoeff() > 1e-12 * rates_.maxCoeff(), "slowest rate of the thermal network [1/s]",
          rates_.minCoeff(), "more than 0: every body needs a way outward for its heat");
}

Eigen::VectorXd ThermalNetwork::steady(const Eigen::VectorXd& heat) const {
  return conductance_.ldlt().solve(heat + outward_.cwiseProduct(outside_));
}

Eigen::VectorXd ThermalNetwork::after(const Eigen::VectorXd& temperature, const Eigen::VectorXd& heat,
                                      double time) const {
  const Eigen::VectorXd end = steady(heat), root = capacity_.cwiseSqrt();
  const Eigen::VectorXd part = modes_.transpose() * root.cwiseProduct(temperature - end);
  const Eigen::VectorXd left = (-time * rates_).array().exp() * part.array();
  return end + (modes_ * left).cwiseQuotient(root);
}

double ThermalNetwork::leaving(const Eigen::VectorXd& temperature) const {
  return outward_.dot(temperature - outside_);
}

double ThermalNetwork::longest_time() const {
  return 1.0 / rates_.minCoeff();
}

double ThermalNetwork::shortest_time() const {
  return 1.0 / rates_.maxCoeff();
}

namespace {

enum Body { balls, inner_ring, outer_ring, oil, housing };

constexpr double kSteelCapacity = 460.0;  // [J/(kg K)]
constexpr double kOilCapacity = 1.7e6;    // [J/(m^3 K)]
constexpr double kLeastCapacity = 1.0;    // [J/K]  of a ring whose mass is not known

constexpr int kMostSteps = 200;
constexpr int kMostBalances = 60;
constexpr int kMostOutlets = 8;
constexpr double kLookShare = 0.1;           // of the run, for each look at the heat on the way
constexpr double kOutletErrorOfLooks = 2.0;  // [K]

double capacity_of(const bearing::balls::BodyNumbers& body, double radius) {
  // A held ring has no mass of its own; its moment of inertia has.
  const double mass = body.mass > 0.0 ? body.mass : body.polar / (radius * radius);
  return std::max(kLeastCapacity, kSteelCapacity * mass);
}

}  // namespace

ThermalNetwork thermal_network(const bearing::balls::BallNumbers& c, const HeatParameters& heat) {
  Eigen::VectorXd capacity(kWarmBodies);
  capacity[balls] = kSteelCapacity * c.mass * c.balls;
  capacity[inner_ring] = capacity_of(c.inner_ring, c.pitch_radius - c.radius);
  capacity[outer_ring] = capacity_of(c.outer_ring, c.pitch_radius + c.radius);
  capacity[oil] = heat.oil_capacity;
  capacity[housing] = heat.housing_capacity;
  Eigen::MatrixXd between = Eigen::MatrixXd::Zero(kWarmBodies, kWarmBodies);
  const auto join = [&](Body a, Body b, double conductance) { between(a, b) = between(b, a) = conductance; };
  join(balls, inner_ring, heat.contact);
  join(balls, outer_ring, heat.contact);
  for (const Body body : {balls, inner_ring, outer_ring}) join(body, oil, heat.to_oil);
  join(outer_ring, housing, heat.fit);
  Eigen::VectorXd outward = Eigen::VectorXd::Zero(kWarmBodies);
  Eigen::VectorXd outside = Eigen::VectorXd::Constant(kWarmBodies, heat.surroundings);
  outward[housing] = heat.housing;
  outward[inner_ring] = heat.shaft;
  outward[oil] = kOilCapacity * c.oil_flow;
  outside[oil] = heat.inlet;
  return {capacity, between, outward, outside};
}

Eigen::VectorXd heat_by_body(const bearing::balls::BallPowerLoss& loss) {
  const double contacts = loss.sliding + loss.differential + loss.spin + loss.damping;
  Eigen::VectorXd heat = Eigen::VectorXd::Zero(kWarmBodies);
  heat[balls] = 0.5 * contacts;
  heat[inner_ring] = heat[outer_ring] = 0.25 * contacts;
  heat[oil] = loss.total() - contacts;
  return heat;
}

// Circles of the grooves' centres and radii of grooves and balls grow each by its own temperature; pitch
// diameter and clearance are those that lead to the circles that then are.
bearing::Bearing warm_bearing(const bearing::Bearing& cold, const HeatParameters& heat,
                              const Eigen::VectorXd& temperature) {
  const auto larger = [&](Body body) { return 1.0 + heat.expansion * (temperature[body] - heat.sizes_at); };
  const double ball = cold.balls().diameter, cosine = std::cos(cold.balls().contact_angle);
  bearing::Balls warm_balls = cold.balls();
  warm_balls.diameter = ball * larger(balls);
  bearing::Bearing warm = cold;
  warm.elements = warm_balls;
  warm.inner.osculation = cold.inner.osculation * larger(inner_ring) / larger(balls);
  warm.outer.osculation = cold.outer.osculation * larger(outer_ring) / larger(balls);
  // Radius of a groove's centre circle beyond the pitch circle, towards the ball.
  const auto beyond = [&](const bearing::Bearing& of, bearing::Race race) {
    return (of.ring(race).osculation - 0.5) * of.balls().diameter * cosine;
  };
  using bearing::Race;
  const double quarter = 0.25 * cold.radial_clearance, middle = 0.5 * cold.pitch_diameter;
  const double inner = larger(inner_ring) * (middle + beyond(cold, Race::inner) - quarter);
  const double outer = larger(outer_ring) * (middle - beyond(cold, Race::outer) + quarter);
  warm.pitch_diameter = inner + outer - beyond(warm, Race::inner) + beyond(warm, Race::outer);
  warm.radial_clearance = 2.0 * (outer - inner + beyond(warm, Race::inner) + beyond(warm, Race::outer));
  return warm;
}

double viscosity_at(double stated, double slope, const HeatParameters& heat, double temperature) {
  return stated * std::exp(-slope * (temperature - heat.stated_at));
}

double outlet_temperature(const HeatParameters& heat, double flow, double power) {
  return heat.inlet + power / (kOilCapacity * flow);
}

double balanced_outlet(const HeatParameters& heat, double flow, const std::function<double(double)>& power) {
  mechanics::require(flow > 0.0, "flow of oil [m^3/s]", flow,
                     "more than 0 where the oil takes the heat along");
  const auto missed = [&](double temperature) {
    return temperature - outlet_temperature(heat, flow, power(temperature));
  };
  const double at_inlet = missed(heat.inlet), at_most = missed(kHottestOil);
  if (!(at_most > 0.0)) {
    std::ostringstream text;
    text << "the oil leaves at more than " << kHottestOil << " degC; required: more flow, or cooler oil";
    throw std::domain_error(text.str());
  }
  if (!(at_inlet < 0.0)) return heat.inlet;
  std::uintmax_t steps = 100;
  const auto [below, above] =
      boost::math::tools::toms748_solve(missed, heat.inlet, kHottestOil, at_inlet, at_most,
                                        boost::math::tools::eps_tolerance<double>(40), steps);
  return 0.5 * (below + above);
}

std::vector<WarmState> warm_to_steady(const ThermalNetwork& network, const HeatSource& source,
                                      const Eigen::VectorXd& start, double error, double steady) {
  std::vector<WarmState> states{{0.0, start, source(start)}};
  const auto far = [&](const WarmState& state) {
    return (network.steady(state.heat) - state.temperature).cwiseAbs().maxCoeff();
  };
  double length = network.shortest_time();
  for (int i = 0; far(states.back()) > 4.0 * error; ++i) {
    if (i == kMostSteps) throw std::runtime_error("temperatures do not settle");
    const WarmState& now = states.back();
    const Eigen::VectorXd first = network.after(now.temperature, now.heat, length);
    const Eigen::VectorXd mean = 0.5 * (now.heat + source(first));
    const Eigen::VectorXd then = network.after(now.temperature, mean, length);
    const double missed = (then - first).cwiseAbs().maxCoeff();
    if (missed > 4.0 * error) {
      length *= 0.5;
      continue;
    }
    states.push_back({now.time + length, then, source(then)});
    if (missed < error) length *= 2.0;
  }
  // Near it: half the way to where this heat would lead, as often as needed.
  for (int i = 0; far(states.back()) > steady; ++i) {
    if (i == kMostBalances) throw std::runtime_error("temperatures do not settle");
    const WarmState& now = states.back();
    const Eigen::VectorXd then = 0.5 * (now.temperature + network.steady(now.heat));
    states.push_back({now.time + network.longest_time(), then, source(then)});
  }
  return states;
}

namespace {

double warm_viscosity(const bearing::balls::MotionParameters& parameters, const HeatParameters& heat,
                      double temperature) {
  return viscosity_at(parameters.lubricant.viscosity, parameters.race.viscosity_slope, heat, temperature);
}

// A short run for a look at the heat on the way.
BallRunOptions look_of(const BallRunOptions& options) {
  BallRunOptions look = options;
  look.duration = kLookShare * options.duration;
  look.observed = 0.5;
  look.samples = 200;
  return look;
}

WarmState warm_oil(const HeatParameters& heat, double flow, const bearing::balls::BallPowerLoss& loss) {
  return {0.0, Eigen::VectorXd::Constant(kWarmBodies, outlet_temperature(heat, flow, loss.total())),
          heat_by_body(loss)};
}

// Temperature of oil and what its heat leads to: T -> g(T), by the secant of the last two runs.
class OutletBalance {
 public:
  explicit OutletBalance(double inlet) : at_(inlet) {}

  double at() const { return at_; }                          // [degC]  of the run to come
  double missed() const { return std::abs(led_to_ - of_); }  // [K]  by the last run

  void add(double led_to) {
    // Heat falls as the oil warms, and less than would hold the temperature where it is.
    if (runs_++ > 0 && at_ != of_) slope_ = std::clamp((led_to - led_to_) / (at_ - of_), kSteepest, 0.0);
    of_ = at_;
    led_to_ = led_to;
    at_ += (led_to - at_) / (1.0 - slope_);
  }

 private:
  static constexpr double kSteepest = -2.0;
  double at_, of_ = 0.0, led_to_ = 0.0, slope_ = 0.0;
  int runs_ = 0;
};

// Heat falls as the oil warms: each temperature leads to the next, by short runs and then by whole ones.
BallRunResult run_to_outlet(const bearing::Bearing& bearing,
                            const bearing::balls::MotionParameters& parameters,
                            const bearing::balls::BallDuty& duty,
                            const bearing::rating::ContactCapacities& capacities,
                            const BallRunOptions& options, const HeatParameters& heat,
                            std::vector<WarmState>& warming, const std::function<void(double)>& progress) {
  const double flow = parameters.mixture.flow;
  mechanics::require(flow > 0.0, "flow of oil [m^3/s]", flow,
                     "more than 0 where the oil takes the heat along");
  OutletBalance outlet(heat.inlet);
  bearing::balls::MotionParameters warm = parameters;
  BallRunOptions look = look_of(options);
  const auto advance = [&](const BallRunOptions& how, const std::function<void(double)>& reached) {
    warm.lubricant.viscosity = warm_viscosity(parameters, heat, outlet.at());
    BallRunResult run = run_balls(bearing, warm, duty, capacities, how, reached);
    if (!run.completed) return run;
    const WarmState led_to = warm_oil(heat, flow, run.means.loss);
    warming = {{0.0, Eigen::VectorXd::Constant(kWarmBodies, outlet.at()), led_to.heat}, led_to};
    outlet.add(led_to.temperature[oil]);
    return run;
  };
  for (int i = 0; i < kMostOutlets && (i == 0 || outlet.missed() > kOutletErrorOfLooks); ++i) {
    BallRunResult run = advance(look, {});
    if (!run.completed) return run;
    look.from = std::move(run.final_state);
  }
  BallRunResult whole;
  for (int i = 0; i < kMostOutlets; ++i) {
    whole = advance(options, progress);
    if (!whole.completed) return whole;
    const double by_scatter = outlet_temperature(heat, flow, whole.means.heat_error) - heat.inlet;
    if (outlet.missed() <= std::max(kOutletError, by_scatter)) return whole;
  }
  whole.completed = false;
  whole.message = "the oil's outlet temperature does not settle";
  return whole;
}

}  // namespace

BallRunResult run_heated_balls(const bearing::Bearing& bearing,
                               const bearing::balls::MotionParameters& parameters,
                               const bearing::balls::BallDuty& duty,
                               const bearing::rating::ContactCapacities& capacities,
                               const BallRunOptions& options, const HeatParameters& heat,
                               std::vector<WarmState>& warming, const std::function<void(double)>& progress) {
  if (heat.model == HeatModel::oil)
    return run_to_outlet(bearing, parameters, duty, capacities, options, heat, warming, progress);
  const ThermalNetwork network = thermal_network(bearing::balls::ball_numbers(bearing, parameters), heat);
  BallRunOptions look = look_of(options);
  bearing::balls::MotionParameters warm = parameters;
  std::vector<double> state;
  const HeatSource source = [&](const Eigen::VectorXd& temperature) {
    warm.lubricant.viscosity = warm_viscosity(parameters, heat, temperature[oil]);
    look.from = state;
    BallRunResult run = run_balls(warm_bearing(bearing, heat, temperature), warm, duty, capacities, look);
    if (!run.completed) throw std::runtime_error(run.message);
    state = std::move(run.final_state);
    return heat_by_body(run.means.loss);
  };
  BallRunResult failed;
  try {
    warming = warm_to_steady(network, source, Eigen::VectorXd::Constant(kWarmBodies, heat.surroundings));
  } catch (const std::runtime_error& error) {
    failed.message = error.what();
    return failed;
  }
  warm.lubricant.viscosity = warm_viscosity(parameters, heat, warming.back().temperature[oil]);
  BallRunResult result = run_balls(warm_bearing(bearing, heat, warming.back().temperature), warm, duty,
                                   capacities, options, progress);
  // The heat of the whole run gives the last state of the heat balance.
  if (result.completed) {
    const Eigen::VectorXd last = heat_by_body(result.means.loss);
    warming.push_back({warming.back().time, network.steady(last), last});
  }
  return result;
}

}  // namespace orbearing::system
