#include "app/study/rated_oil.hpp"

#include <algorithm>
#include <array>

#include "app/case/oil_case.hpp"
#include "app/case/static_case.hpp"

namespace orbearing::app {

namespace {

namespace rating = bearing::rating;

rating::Lubrication lubrication_of(const ResolvedCase& in) {
  const std::string& found = in.choice("life.lubrication");
  if (found == "oil-bath") return rating::Lubrication::oil_bath;
  return found == "grease" ? rating::Lubrication::grease : rating::Lubrication::circulating_oil;
}

// Words, and the codes of ISO 4406 that stand for them where oil circulates.
rating::Cleanliness cleanliness_of(const std::string& found) {
  constexpr std::array<std::array<const char*, 2>, 5> levels{{{"highest", "-/13/10"},
                                                              {"high", "-/15/12"},
                                                              {"medium", "-/17/14"},
                                                              {"low", "-/19/16"},
                                                              {"lowest", "-/21/18"}}};
  const auto level = std::find_if(levels.begin(), levels.end(),
                                  [&](const auto& names) { return found == names[0] || found == names[1]; });
  return static_cast<rating::Cleanliness>(level - levels.begin());
}

rating::LifeMethod life_method(const ResolvedCase& in) {
  for (const auto& name : names_of(rating::LifeMethod{}))
    if (in.choice("life.method") == name.text) return name.value;
  return rating::LifeMethod::lundberg_palmgren;
}

bool says_cleanliness(const ResolvedCase& in) {
  return in.has("life.contamination_factor") || in.has("life.cleanliness");
}

bool says_viscosity(const ResolvedCase& in) {
  return in.has("life.viscosity_ratio") || in.has("lubricant.kinematic_viscosity");
}

}  // namespace

std::optional<rating::StatedOil> stated_oil(const ResolvedCase& in) {
  if (!says_cleanliness(in) && !says_viscosity(in)) return std::nullopt;
  rating::StatedOil oil;
  if (in.has("life.viscosity_ratio")) {
    oil.viscosity_ratio = in.number("life.viscosity_ratio");
  } else if (in.has("lubricant.kinematic_viscosity")) {
    oil.kinematic_viscosity = in.quantity("lubricant.kinematic_viscosity");
  } else {
    oil.kinematic_viscosity = in.quantity("lubricant.viscosity") / oil_density(in);
  }
  if (in.has("life.contamination_factor")) oil.contamination_factor = in.number("life.contamination_factor");
  if (in.has("life.lubrication")) oil.lubrication = lubrication_of(in);
  if (in.has("life.cleanliness")) oil.cleanliness = cleanliness_of(in.choice("life.cleanliness"));
  return oil;
}

std::vector<std::string> oil_warnings(const ResolvedCase& in) {
  if (!says_viscosity(in) || says_cleanliness(in)) return {};
  return {"life.cleanliness: not given beside the oil; 'high' (-/15/12 of ISO 4406) is taken for a_ISO"};
}

study::RatedBearing rated_bearing(const ResolvedCase& in) {
  study::RatedBearing rated{.stated = stated_ratings_of(in),
                            .oil = stated_oil(in),
                            .reliability_factor = rating::reliability_factor(in.number("life.reliability")),
                            .method = life_method(in)};
  if (in.choice("life.viscosity_ratio_by") == "film") rated.roughness = in.quantity("contact.roughness");
  return rated;
}

std::string life_to_go_by(const ResolvedCase& in) {
  const bool oil = stated_oil(in).has_value();
  switch (life_method(in)) {
    case rating::LifeMethod::iso281:
      return oil ? "L10mh" : "L10h";
    case rating::LifeMethod::iso16281:
      return oil ? "L10mrh" : "L10rh";
    case rating::LifeMethod::lundberg_palmgren:
      break;
  }
  return "life_h";
}

}  // namespace orbearing::app
