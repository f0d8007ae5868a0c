#include "coupling/analysis/spatial_modes.hpp"

#include "coupling/analysis/carrier_revolution.hpp"

namespace orbearing::analysis {

using described::Record;
using gearset::spatial::SpatialMode;
namespace dimension = described::dimension;

namespace {

void describe_spatial_mode(Record& row, const SpatialMode& mode) {
  const auto share = [&](const char* name, const char* meaning, double value) {
    row.value(name, dimension::ratio, meaning, value);
  };
  row.value("frequency_Hz", dimension::cycles, "natural frequency", mode.frequency);
  row.value("multiplicity", "modes of this frequency", mode.multiplicity);
  share("in_plane", "share of the kinetic energy: displacement across the axis and rotation about it",
        mode.in_plane);
  share("axial", "the same along the axis", mode.axial);
  share("tilting", "the same of tilts", mode.tilting);
  share("carrier", "the same of the carrier", mode.carrier);
  share("sun", "the same of the sun", mode.sun);
  share("ring", "the same of the ring", mode.ring);
  share("planets", "the same of the planets", mode.planets);
  row.array(
         "shape", dimension::ratio,
         "x, y, z and rotations about them times the centre distance of carrier, sun, planets and ring over "
         "the largest, in a frame of the carrier",
         {"body", "freedom"}, mode.shape)
      .detail = true;
}

}  // namespace

void describe(Record& record, const SpatialModes& of) {
  record.table("modes", "spatial_mode", "natural modes", of.modes, describe_spatial_mode);
}

SpatialModes spatial_modes(const NamedSet& set) {
  const PlanetaryDrivetrain& drivetrain = set.drivetrain;
  return {gearset::spatial::modes_at_rest(
      moving_set(drivetrain, drivetrain.gear_set(), set.geometry.gears.base_helix_angle))};
}

}  // namespace orbearing::analysis
