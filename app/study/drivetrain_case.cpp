#include "app/study/drivetrain_case.hpp"

#include <fmt/format.h>

#include "app/case/drivetrain_reader.hpp"
#include "app/case/input_keys.hpp"
#include "coupling/analysis/drivetrain_warnings.hpp"

namespace orbearing::app {

namespace rating = bearing::rating;

std::vector<std::string> gear_warnings(const ResolvedCase& in) {
  return analysis::gear_warnings(stated_drivetrain(in));
}

std::vector<std::string> planar_warnings(const ResolvedCase& in) {
  return is_helical(stated_drivetrain(in)) ? analysis::planar_warnings() : std::vector<std::string>{};
}

std::optional<rating::StatedOil> stated_oil(const ResolvedCase& in) {
  return analysis::stated_oil(machine_of<analysis::LifeInputs>(in), machine_of<analysis::BearingOil>(in),
                              density_of_oil(from_case<bearing::motion::OilDragParameters>(in)));
}

std::vector<std::string> rating_warnings(const ResolvedCase& in) {
  std::vector<std::string> warnings;
  if (analysis::cleanliness_is_assumed(machine_of<analysis::LifeInputs>(in),
                                       machine_of<analysis::BearingOil>(in)))
    warnings.emplace_back(
        "life.cleanliness: not given with the oil; 'high' (-/15/12 of ISO 4406) is taken for a_ISO");
  const std::string governing = governing_life_key(in);
  if (in.has("requirements.life_key") && in.choice("requirements.life_key") != governing)
    warnings.push_back(
        fmt::format("requirements.life_key: {} is judged; the governing life of this case is {} "
                    "(life.method: {})",
                    in.choice("requirements.life_key"), governing, in.choice(keys().life_method)));
  return warnings;
}

rating::LifeMethod life_method(const ResolvedCase& in) {
  return machine_of<analysis::LifeInputs>(in).method;
}

rating::Life governing_life(const ResolvedCase& in) {
  return rating::governing_life(life_method(in), stated_oil(in).has_value());
}

std::string governing_life_key(const ResolvedCase& in) {
  return rating::hours_key(governing_life(in));
}

}  // namespace orbearing::app
