// The stiffness of a bearing as rows of text, and as a table that ROSS reads.
#pragma once

#include <string>

#include "app/study/stiffness_study.hpp"

namespace orbearing::app {

/// Displacements and stiffnesses, a row for each point.
std::string stiffness_csv(const StiffnessStudy& study);

/// The points of one series as a worksheet (BIFF 4, .xls) with the columns that ROSS's
/// BearingElement.from_table reads: kxx, kxy, kyx, kyy [N/m], damping 0 [N s/m] and frequency [rad/s], the
/// speed, rising. A single point stands there twice, at two speeds. ROSS takes nothing of the axis and of
/// tilts.
std::string ross_table(const StiffnessStudy& study, std::size_t series);

}  // namespace orbearing::app
