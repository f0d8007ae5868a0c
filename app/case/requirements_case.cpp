#include "app/case/requirements_case.hpp"

#include <array>

#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"

namespace orbearing::app {

namespace {

constexpr unsigned kRated = roller_bearing | single_ball_bearing | planetary_drivetrain;
constexpr const char* kLifePath = "requirements.life";
constexpr const char* kLifeKeyPath = "requirements.life_key";

/// One key of the block that holds a number.
struct RequirementRow {
  const char* name;
  const char* key;  // of the result; that of a life is a choice of its own
  const char* unit;
  const char* meaning;
  bool at_most;
  Dimension dimension;
  unsigned models;
};

constexpr Dimension kDuration{"time", "s", "h", "175000 h", 3600.0};
constexpr Dimension kPressure{"pressure", "Pa", "MPa", "1500 MPa", 1e6};

constexpr std::array<RequirementRow, 5> kRequirementRows{
    {{"life", "", "h", "least life of one bearing, of the kind that requirements.life_key names", false,
      kDuration, kRated},
     {"contact_pressure_max", "contact_pressure_max_MPa", "MPa", "largest Hertzian pressure allowed", true,
      kPressure, kRated},
     {"S0", "S0", "", "least static safety factor C0/P0 of ISO 76", false, {}, kRated},
     {"kappa", "kappa", "", "least viscosity ratio of ISO 281", false, {}, kRated},
     {"load_share",
      "largest_load_share",
      "",
      "largest load of one planet allowed, divided by the mean load of the planets (K_gamma)",
      true,
      {},
      planetary_drivetrain}}};

std::string requirement_path(const RequirementRow& row) {
  return std::string("requirements.") + row.name;
}

bool requirements_choose_the_life(const ResolvedCase& in, std::string_view) {
  return in.has(keys().life_method) && in.origin(keys().life_method) == "default" &&
         !in.has(keys().dynamic_capacity);
}

}  // namespace

void table::add_requirements(std::vector<Field>& fields, unsigned models, const Use& use, AnalysisSet crown) {
  for (const RequirementRow& row : kRequirementRows) {
    if ((row.models & models) == 0) continue;
    Rows rows(fields, row.models & models);
    // A stated requirement selects the life that a crown optimizes, where no other input does.
    const Use limit = use.used_too(
        crown, {where_true(requirements_choose_the_life, "where neither life.method nor C is stated")});
    if (row.dimension.name.empty())
      rows.number(requirement_path(row), row.meaning, limit, positive(1e9));
    else
      rows.quantity(requirement_path(row), row.meaning, limit, row.dimension, positive(1e9));
    if (requirement_path(row) == kLifePath)
      rows.choice(kLifeKeyPath, "life that requirements.life limits", use.when(where_given({kLifePath})),
                  {"L10h", "L10rh", "L10mh", "L10mrh", "life_h"});
  }
}

std::vector<std::string> requirement_paths() {
  std::vector<std::string> paths;
  for (const RequirementRow& row : kRequirementRows) paths.push_back(requirement_path(row));
  return paths;
}

std::vector<Requirement> stated_requirements(const ResolvedCase& in) {
  std::vector<Requirement> stated;
  for (const RequirementRow& row : kRequirementRows) {
    const std::string path = requirement_path(row);
    if (!in.has(path)) continue;
    const double limit =
        row.dimension.name.empty() ? in.number(path) : in.quantity(path) / row.dimension.factor;
    stated.push_back(
        {row.name, path == kLifePath ? in.choice(kLifeKeyPath) : row.key, row.unit, limit, row.at_most});
  }
  return stated;
}

}  // namespace orbearing::app
