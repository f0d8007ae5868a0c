#include "coupling/analysis/gear_modes.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/constants.hpp"

namespace orbearing::analysis {

using described::Record;
using gearset::dynamics::Mode;
using gearset::dynamics::ModeKind;
using gearset::dynamics::SetModel;
namespace dimension = described::dimension;

const char* kind_name(ModeKind kind) {
  switch (kind) {
    case ModeKind::rotational:
      return "rotational";
    case ModeKind::translational:
      return "translational";
    case ModeKind::planet:
      break;
  }
  return "planet";
}

ModeShape shape_of(const Mode& mode) {
  constexpr double alike = 1e-6;  // relative
  const Eigen::VectorXd reach = mode.shapes.rowwise().norm();
  const auto most =
      std::ranges::find_if(reach, [&](double r) { return r >= (1.0 - alike) * reach.maxCoeff(); });
  const Eigen::Index largest = most - reach.begin();
  const Eigen::VectorXcd shape =
      mode.shapes * mode.shapes.row(largest).adjoint() / (reach[largest] * reach[largest]);
  const auto rows = [](const Eigen::VectorXd& values) -> Eigen::MatrixX3d {
    return values.reshaped<Eigen::RowMajor>(values.size() / 3, 3);
  };
  return {rows(shape.real()), rows(Eigen::VectorXd::Zero(shape.size()) - shape.imag())};
}

void describe(Record& record, const ModeStudy& study) {
  record.table("modes", "mode", "natural modes", study.modes, [&](Record& row, const Mode& mode) {
    row.value("frequency_Hz", dimension::cycles, "natural frequency", mode.frequency);
    row.value("kind", "rotational, translational or planet", kind_name(mode.kind));
    row.value("multiplicity", "modes of this frequency and kind", mode.multiplicity);
    row.value("growth_per_s", dimension::growth, "rate at which the motion grows", mode.growth);
    row.value("over_planet_frequency", dimension::ratio, "over that of a planet on its bearing alone",
              mode.frequency / study.planet_frequency);
    const ModeShape shape = shape_of(mode);
    const std::vector<described::Along> along{"member", "direction"};
    row.array("shape", dimension::ratio,
              "x, y and rotation times radius of sun, ring, carrier and planets over the largest; of planets "
              "outward and tangential",
              along, shape.position)
        .detail = true;
    // Without rotation all members move in phase: the second shape would be zero.
    if (shape.quarter.cwiseAbs().maxCoeff() > 0.0)
      row.array("shape_quarter", dimension::ratio, "the same a quarter of a period later", along,
                shape.quarter)
          .detail = true;
  });
}

ModeStudy mode_study(const SetModel& model, bool at_speed) {
  const auto& planet = model.parameters.planet;
  return {at_speed ? modes_at_speed(model) : modes_at_rest(model),
          std::sqrt(planet.bearing_stiffness / planet.mass) / constants::two_pi};
}

Campbell campbell(const SetModel& model, double nominal_speed) {
  constexpr int steps = 20;
  std::vector<double> factors;
  Campbell diagram;
  for (int i = 0; i <= steps; ++i) {
    factors.push_back(static_cast<double>(i) / steps);
    diagram.speeds.push_back(factors.back() * nominal_speed);
    auto& mesh = diagram.mesh_harmonics.emplace_back();
    for (std::size_t n = 0; n < mesh.size(); ++n)
      mesh[n] = static_cast<double>(n + 1) * factors.back() * model.operation.mesh_frequency;
  }
  diagram.frequencies = campbell_frequencies(model, factors).transpose();
  return diagram;
}

void describe(Record& record, const Campbell& diagram) {
  record.array("speed_rpm", dimension::angular_speed, "from rest to the nominal speed", {"speed"},
               diagram.speeds);
  record.array("frequencies_Hz", dimension::cycles, "natural, ascending", {"speed", "frequency"},
               diagram.frequencies);
  record.array("mesh_harmonics_Hz", dimension::cycles, "orders 1 to 4 of the mesh frequency",
               {"speed", "order"}, diagram.mesh_harmonics);
}

}  // namespace orbearing::analysis
