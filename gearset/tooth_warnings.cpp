#include "gearset/tooth_warnings.hpp"

#include "gearset/involute.hpp"
#include "gearset/warning.hpp"

namespace orbearing::gearset {

namespace {

// Gears that just reach the end of an involute are sound; this keeps round-off from warning about them.
constexpr double reach_tolerance = 1e-9;  // [module]

}  // namespace

void ToothWarnings::undercut(const ExternalTooth& tooth, const std::string& gear) {
  if (!tooth.undercut) return;
  list.push_back({position, "the " + gear + " is undercut: its profile shift " + decimal(tooth.shift, 4) +
                                " lies below the limit " + decimal(least_shift_without_undercut(tooth), 4) +
                                "; its involute begins at a radius of " + millimetres(tooth.form_radius) +
                                " (base circle " + millimetres(tooth.base_radius) +
                                ") and the path of contact ends there"});
}

void ToothWarnings::reach(double reached, const ExternalTooth& tooth, const std::string& other,
                          const std::string& gear) {
  const double foot = tangent_length(tooth.base_radius, tooth.form_radius);
  const double tolerance = reach_tolerance * tooth.module;
  if (reached >= foot - tolerance) return;
  const std::string limit =
      reached < -tolerance ? "base circle, where there is no involute" : "form circle, into the root fillet";
  list.push_back({position, "the tips of the " + other + " reach below the " + gear + "'s " + limit +
                                "; the path of contact ends at the " + gear + "'s form radius " +
                                millimetres(tooth.form_radius) +
                                ", and the tips need relief or a smaller addendum"});
}

void ToothWarnings::clearance(double clearance, double module, const std::string& tip,
                              const std::string& root) {
  if (clearance >= -reach_tolerance * module) return;
  list.push_back({position, "the tips of the " + tip + " dig into the roots of the " + root + " by " +
                                millimetres(-clearance) + "; raise the clearance or change the shifts"});
}

void ToothWarnings::contact_ratio(double ratio, const std::string& mesh) {
  if (ratio >= 1.0) return;
  list.push_back({position, "the contact ratio of the " + mesh + " is " + decimal(ratio, 3) +
                                "; at least 1 is needed for continuous drive"});
}

}  // namespace orbearing::gearset
