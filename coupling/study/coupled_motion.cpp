#include <stdexcept>

#include "coupling/study/two_way.hpp"

namespace orbearing::study {

std::unique_ptr<cosim::CoupledMotion> coupled_motion(const PlanetaryDrivetrain&, const DrivetrainGeometry&,
                                                     const BearingDuty&, Fidelity) {
  throw std::runtime_error("gears and bearings are not joined yet");
}

}  // namespace orbearing::study
