// What a report shows of gears and bearings that act on each other.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/study/named_change.hpp"
#include "coupling/study/drivetrain.hpp"

namespace orbearing::app {

/// Keys: `how` (the exchange in words), `one_way` (speeds and lives of the bearing that the gears drive) and
/// `convergence` (errors, orders and stability limits of the schemes at the drivetrain's own speed).
/// @param speeds_rpm of the points of the sweep
/// @param one_way    the bearing at these speeds, driven by gears that do not feel it
nlohmann::ordered_json coupled_report(const study::PlanetaryDrivetrain& drivetrain,
                                      const std::vector<double>& speeds_rpm, const ChangeResult& one_way,
                                      const std::string& fidelity);

}  // namespace orbearing::app
