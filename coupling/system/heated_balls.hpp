// A ball bearing that its own friction warms, until as much heat leaves as arises. Temperatures change over
// minutes, the motion over milliseconds: short runs say what heat arises at given temperatures, and the
// network of thermal_network.hpp goes on from there in long steps (averaging).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "coupling/system/ball_run.hpp"

namespace orbearing::system {

// A few bodies of one temperature each, which take in heat and pass it on: C T' = W - G (T - T_0).

class ThermalNetwork {
 public:
  /// `capacity` [J/K] of each body; `between` [W/K], symmetric, of which the diagonal is not read; `outward`
  /// [W/K] to what has the temperature `outside` [degC] beside that body. Throws std::invalid_argument where
  /// a capacity is not positive, a conductance negative, or a body has no way outward for its heat.
  ThermalNetwork(const Eigen::VectorXd& capacity, const Eigen::MatrixXd& between,
                 const Eigen::VectorXd& outward, const Eigen::VectorXd& outside);

  /// Temperatures [degC] at which as much leaves as comes in: `heat` [W] of each body.
  Eigen::VectorXd steady(const Eigen::VectorXd& heat) const;
  /// Temperatures [degC] after `time` [s] of steady `heat` from `temperature` on: exact.
  Eigen::VectorXd after(const Eigen::VectorXd& temperature, const Eigen::VectorXd& heat, double time) const;
  /// Heat flow to the outside [W].
  double leaving(const Eigen::VectorXd& temperature) const;
  /// Longest and shortest time in which a difference falls to 1/e [s].
  double longest_time() const;
  double shortest_time() const;

 private:
  Eigen::VectorXd capacity_, outward_, outside_;
  Eigen::MatrixXd conductance_;  // [W/K]
  Eigen::VectorXd rates_;        // [1/s]  of the modes
  Eigen::MatrixXd modes_;        // of C^(-1/2) G C^(-1/2)
};

/// Bodies of the network, in this order.
inline constexpr int kWarmBodies = 5;
inline constexpr const char* kWarmBodyNames[kWarmBodies] = {"balls", "inner_ring", "outer_ring", "oil",
                                                            "housing"};

/// Which bodies take in heat.
enum class HeatModel {
  network,  // balls, rings, oil and housing
  oil,      // only the oil, which leaves with all heat: T = T_in + W/(c flow)
};

constexpr described::Names<HeatModel, 2> names_of(HeatModel) {
  return {{{HeatModel::network, "network"}, {HeatModel::oil, "oil"}}};
}

/// Paths of the heat. Conductances between two bodies, each an assumption of its size.
struct HeatParameters {
  bool on = false;
  HeatModel model = HeatModel::network;
  double surroundings = 25.0;       // [degC]
  double contact = 2.0;             // [W/K]  of balls to each ring
  double to_oil = 3.0;              // [W/K]  of balls and of each ring to the oil
  double fit = 20.0;                // [W/K]  of outer ring to housing
  double housing = 3.0;             // [W/K]  of housing to surroundings
  double shaft = 1.0;               // [W/K]  of inner ring by the shaft to surroundings
  double inlet = 40.0;              // [degC]  of the oil that flows in
  double stated_at = 70.0;          // [degC]  at which lubricant.viscosity holds
  double expansion = 11.5e-6;       // [1/K]  of rings and balls
  double sizes_at = 20.0;           // [degC]  at which sizes and clearance hold
  double housing_capacity = 400.0;  // [J/K]
  double oil_capacity = 5.0;        // [J/K]  of the oil in the bearing
};

inline constexpr described::Where where_heated{"heat.enabled", "true"};

/// Rows that rollers at rest have too.
inline auto heat_enabled_row(bool& on) {
  return described::input(
      on, "heat.enabled",
      "temperatures and the oil's viscosity are computed from the friction; of rollers at rest with "
      "heat.model: oil",
      {.reason = "the viscosity is stated at running temperature"});
}
inline auto heat_model_row(HeatModel& model) {
  return described::input(
      model, "heat.model",
      "heat leaves by balls, rings, oil and housing, or by the oil that flows through alone",
      {.reason = "bearings lose heat by their seats too", .where = where_heated});
}
inline auto heat_inlet_row(double& inlet) {
  using namespace described;
  return input(inlet, "heat.inlet", "temperature of the oil that flows in",
               {.dimension = dimension::temperature,
                .range = {-60.0, 400.0},
                .reason = "a tank's",
                .where = where_heated});
}

template <class Visitor>
void describe(Visitor& visit, HeatParameters& m) {
  using namespace described;
  const auto row = [&](double& member, const char* path, const char* meaning, const Dimension& dimension,
                       Range range, const char* reason) {
    return input(member, path, meaning,
                 {.dimension = dimension, .range = range, .reason = reason, .where = where_heated});
  };
  const Range conductance{0.0, 1e5}, temperature{-60.0, 400.0};
  rows(visit, heat_enabled_row(m.on), heat_model_row(m.model),
       row(m.surroundings, "heat.surroundings", "temperature around housing and shaft",
           dimension::temperature, temperature, "a warm room"),
       row(m.contact, "heat.contact_conductance", "conductance of the balls to each ring",
           dimension::conductance, conductance, "small bearing, contacts that sweep the races"),
       row(m.to_oil, "heat.oil_conductance", "conductance of the balls and of each ring to the oil",
           dimension::conductance, conductance, "small bearing, splashed"),
       row(m.fit, "heat.fit_conductance", "conductance of the outer ring to the housing",
           dimension::conductance, conductance, "tight seat"),
       row(m.housing, "heat.housing_conductance", "conductance of the housing to its surroundings",
           dimension::conductance, positive(1e5), "a housing of some square decimetres in still air"),
       row(m.shaft, "heat.shaft_conductance",
           "conductance of the inner ring along the shaft to the surroundings", dimension::conductance,
           conductance, "a shaft of the bore's diameter"),
       heat_inlet_row(m.inlet),
       row(m.stated_at, "heat.viscosity_temperature", "reference temperature of lubricant.viscosity",
           dimension::temperature, temperature, "running temperature"),
       row(m.expansion, "heat.expansion", "linear thermal expansion of rings and balls",
           dimension::per_kelvin, Range{0.0, 1e-4}, "through-hardened bearing steel"),
       row(m.sizes_at, "heat.sizes_temperature", "reference temperature of sizes and clearance",
           dimension::temperature, temperature, "reference temperature of ISO 1"));
}

/// The network of a bearing: capacities of steel from the masses, 460 J/(kg K); oil takes 1.7 MJ/(m^3 K)
/// along.
ThermalNetwork thermal_network(const bearing::balls::BallNumbers& bearing, const HeatParameters& heat);

/// Heat by body [W]: what contacts of the races lose falls half to the balls and a quarter to each ring, all
/// else to the oil.
Eigen::VectorXd heat_by_body(const bearing::balls::BallPowerLoss& loss);

/// `bearing` where rings and balls have these temperatures [degC, (kWarmBodies)], each free to expand with
/// its own: grooves, balls and with them the clearance G, of which G' - G = a [d_o (T_o - T_0) - d_i (T_i -
/// T_0) - 2 D (T_b - T_0)], d_o and d_i the diameters of the races, D that of the balls. The clearance stated
/// is that of the mounted bearing: what fits take of it when cold is in it, and no more is taken or given
/// back, as with a shaft as warm as the inner ring and a housing as warm as the outer one, both of the
/// bearing's steel. The cage and its pockets keep their sizes.
bearing::Bearing warm_bearing(const bearing::Bearing& bearing, const HeatParameters& heat,
                              const Eigen::VectorXd& temperature);

/// Viscosity [Pa s] of the oil at `temperature` [degC]: eta_0 exp(-slope (T - T_0)) [Reynolds1886], `slope`
/// [1/K].
double viscosity_at(double stated, double slope, const HeatParameters& heat, double temperature);

/// Temperature [degC] of oil that comes in at `heat`'s inlet and leaves with all of `power` [W].
double outlet_temperature(const HeatParameters& heat, double flow, double power);

/// Temperature [degC] at which oil leaves with all of `power` [W] that arises at that temperature and falls
/// with it. Throws std::domain_error where that is beyond kHottestOil.
double balanced_outlet(const HeatParameters& heat, double flow, const std::function<double(double)>& power);
inline constexpr double kHottestOil = 150.0;  // [degC]  to which formulas of viscosity hold

/// Says how much heat [W] arises by body at given temperatures [degC], kept for the next call where motion
/// goes on.
using HeatSource = std::function<Eigen::VectorXd(const Eigen::VectorXd& temperature)>;

/// One instant of the way to the steady state.
struct WarmState {
  double time = 0.0;            // [s]
  Eigen::VectorXd temperature;  // [degC]
  Eigen::VectorXd heat;         // [W]
};

/// Largest error of the outlet's temperature [K], unless the scatter of the heat is more.
inline constexpr double kOutletError = 0.03;

/// From `start` until the temperatures are steady, by steps of Heun's method on the exact solution of
/// steady heat, which grow as `error` [K] allows; the last state is
/// that at which as much leaves as arises, to `steady` [K]. Throws std::runtime_error where they do not
/// settle.
std::vector<WarmState> warm_to_steady(const ThermalNetwork& network, const HeatSource& source,
                                      const Eigen::VectorXd& start, double error = 0.5, double steady = 0.05);

/// Runs the bearing at the temperatures it takes on. `warming` gets the way there. With the oil alone all
/// bodies have its outlet's temperature and the sizes that are stated; `warming` then has no time. Its last
/// two states are the one of which the run has the viscosity and the one to which its heat leads: at most
/// `kOutletError`, or what the heat's own error makes, apart, or the run reports that it did not settle.
BallRunResult run_heated_balls(const bearing::Bearing& bearing,
                               const bearing::balls::MotionParameters& parameters,
                               const bearing::balls::BallDuty& duty,
                               const bearing::rating::ContactCapacities& capacities,
                               const BallRunOptions& options, const HeatParameters& heat,
                               std::vector<WarmState>& warming,
                               const std::function<void(double)>& progress = {});

}  // namespace orbearing::system
