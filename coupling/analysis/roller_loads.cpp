#include "coupling/analysis/roller_loads.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "bearing/contact/line_contact.hpp"
#include "bearing/life/inclined_rating.hpp"

namespace orbearing::analysis {

using described::Record;
namespace dimension = described::dimension;

namespace {

// Along the roller whose most loaded lamina carries most on the inner race.
std::vector<double> pressures_along(const NamedSet& set, const LaminaRecord& laminae,
                                    const std::vector<double>& loads, bearing::Race race) {
  const bearing::Bearing& bearing = set.drivetrain.bearing;
  const bearing::PlanetRows& rows = set.drivetrain.rows;
  const bearing::BearingGeometry geometry =
      rows.is_cylindrical() ? set.geometry.bearing
                            : bearing::geometry_of(bearing::rating::upright(bearing, rows));
  const auto count = static_cast<std::ptrdiff_t>(laminae.lamina_position.size());
  const auto most = std::ranges::max_element(laminae.inner_load) - laminae.inner_load.begin();
  std::vector<double> pressures;
  for (std::ptrdiff_t k = 0; k < count; ++k)
    pressures.push_back(bearing::hertz_pressure(
        static_cast<double>(count) * loads[static_cast<std::size_t>(most / count * count + k)],
        bearing::equivalent_radius(geometry, race), bearing.rollers().length, bearing.material));
  return pressures;
}

}  // namespace

std::vector<RollerLoads> roller_loads(std::vector<NamedSet> sets) {
  std::vector<RollerLoads> all;
  for (NamedSet& set : sets) {
    set.drivetrain.carrier_mounting.reset();  // it moves no roller of the set's plane
    PointResult point = evaluate(set.drivetrain, set.geometry, Fidelity::quasi_static);
    all.push_back({std::move(set), std::move(point)});
  }
  return all;
}

void describe(Record& row, const RollerLoads& loads) {
  const LoadDistribution& by_position = loads.point.distribution;
  row.value("set", "of gears; empty in a case of one set", loads.set.name);
  row.array("angle_deg", dimension::angle,
            "position in the load zone, from the outward radial direction towards carrier rotation",
            {"position"}, by_position.angle);
  row.array("inner_load_N", dimension::force, "load of a roller on the inner race", {"position"},
            by_position.inner_load);
  row.array("outer_load_N", dimension::force, "load of a roller on the outer race", {"position"},
            by_position.outer_load);
  const LaminaRecord laminae = loads.point.laminae.value_or(LaminaRecord{});
  row.array("along_mm", dimension::length,
            "middle of a lamina, from the middle of the roller; none of whole contacts", {"lamina"},
            laminae.lamina_position);
  row.array("inner_pressure_MPa", dimension::pressure,
            "pressure along the most loaded roller on the inner race, after Hertz", {"lamina"},
            pressures_along(loads.set, laminae, laminae.inner_load, bearing::Race::inner));
  row.array("outer_pressure_MPa", dimension::pressure,
            "pressure along the same roller on the outer race, after Hertz", {"lamina"},
            pressures_along(loads.set, laminae, laminae.outer_load, bearing::Race::outer));
}

void describe(Record& record, const std::vector<RollerLoads>& sets) {
  record.table("roller_loads", "set", "loads of the rollers of one bearing by position", sets);
}

}  // namespace orbearing::analysis
