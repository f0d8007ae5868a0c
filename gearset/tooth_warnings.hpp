// Warnings of teeth that run all the same, for every kind of gear train.
#pragma once

#include <string>

#include "gearset/tooth_form.hpp"
#include "gearset/warning.hpp"

namespace orbearing::gearset {

/// Where warnings go, and the key of the case that they concern.
struct ToothWarnings {
  std::string position;
  Warnings list;

  void undercut(const ExternalTooth& tooth, const std::string& gear);
  /// @param reached [m] tangent length on `tooth` that the other gear's tip calls for
  void reach(double reached, const ExternalTooth& tooth, const std::string& other, const std::string& gear);
  /// @param clearance [m] between the tips of one gear and the root circle of the other
  void clearance(double clearance, double module, const std::string& tip, const std::string& root);
  void contact_ratio(double ratio, const std::string& mesh);
};

}  // namespace orbearing::gearset
