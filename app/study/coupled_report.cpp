#include "app/study/coupled_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

#include "app/results/json_number.hpp"
#include "app/study/fidelity.hpp"
#include "app/units.hpp"
#include "coupling/study/scheme_convergence.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

std::string how(const cosim::CoupledOptions& exchange, const std::string& fidelity) {
  if (fidelity_of(fidelity) == study::Fidelity::monolithic)
    return "gears and all bearings as one system of equations";
  const char* order = exchange.order == cosim::ExchangeOrder::jacobi ? "Jacobi" : "Gauss-Seidel";
  return fmt::format("co-simulated, {} exchange of degree {} in windows of at most {:.3g} \u00b5s{}", order,
                     exchange.extrapolation, kMicro * exchange.window,
                     exchange.iteration.most_passes > 1
                         ? fmt::format(", each repeated up to {} times", exchange.iteration.most_passes)
                         : "");
}

Json one_way_curve(const ChangeResult& one_way, const std::vector<double>& speeds_rpm) {
  Json curve{{"speed_rpm", speeds_rpm}, {"life_h", Json::array()}, {"outer_load_rms_N", Json::array()}};
  for (const study::PointResult& point : one_way.points) {
    curve["life_h"].push_back(number_or_null(life_of(point)));
    curve["outer_load_rms_N"].push_back(point.status == "ok" ? number_or_null(point.outer.load_rms) : Json());
  }
  return curve;
}

Json convergence(const study::PlanetaryDrivetrain& drivetrain) {
  const study::SchemeConvergence found =
      study::scheme_convergence(drivetrain, study::derive(drivetrain), study::common_schemes());
  Json object{{"path_ms", kMilli * found.path},
              {"speed_rpm", kRpm * drivetrain.drive.speed},
              {"rows", Json::array()},
              {"orders", Json::array()}};
  for (const study::SchemeError& error : found.errors)
    object["rows"].push_back({{"scheme", error.scheme},
                              {"window_us", kMicro * error.window},
                              {"force_error", number_or_null(error.force_error)},
                              {"energy_residual", number_or_null(error.energy_residual)}});
  for (const study::SchemeOrder& order : found.orders)
    object["orders"].push_back({{"scheme", order.scheme},
                                {"expected", order.expected},
                                {"measured", number_or_null(order.measured)},
                                {"stability_limit_us", number_or_null(kMicro * order.stability_limit)}});
  return object;
}

}  // namespace

nlohmann::ordered_json coupled_report(const study::PlanetaryDrivetrain& drivetrain,
                                      const std::vector<double>& speeds_rpm, const ChangeResult& one_way,
                                      const std::string& fidelity) {
  return {{"how", how(drivetrain.exchange, fidelity)},
          {"one_way", one_way_curve(one_way, speeds_rpm)},
          // One system exchanges nothing.
          {"convergence",
           fidelity_of(fidelity) == study::Fidelity::monolithic ? Json(nullptr) : convergence(drivetrain)}};
}

}  // namespace orbearing::app
