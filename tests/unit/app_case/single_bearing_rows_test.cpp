// Structures of single bearings and the table of fields, which still has rows of its own for them, describe
// the same inputs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <type_traits>

#include "app/case/catalogue_fields.hpp"
#include "app/case/described_fields.hpp"
#include "app/case/field_table.hpp"
#include "coupling/analysis/single_bearing.hpp"

namespace orbearing::app::single_bearing_rows_test {
namespace {

using testing::IsEmpty;

template <class T>
inline constexpr bool has_a_kind = std::is_arithmetic_v<T> || std::is_enum_v<T>;

// Compares each row with the field of that path, and keeps the paths.
class Rows {
 public:
  explicit Rows(unsigned models) : models_(models) {}

  template <class Member>
  void operator()(Member& member, const described::Facts& facts) {
    paths.insert(facts.path);
    const Field* field = find_field(facts.path);
    if (field == nullptr || (field->models & models_) == 0 || facts.meaning.empty()) return;
    SCOPED_TRACE(facts.path);
    const described::Details& details = facts.details;
    EXPECT_EQ(field->meaning, facts.meaning);
    EXPECT_EQ(field->dimension.si, details.dimension.si);
    EXPECT_EQ(field->range.least, details.range.least);
    EXPECT_EQ(field->range.most, details.range.most);
    EXPECT_EQ(field->default_reason, details.reason);
    if constexpr (has_a_kind<Member>) {
      if (details.reason.empty()) return;
      Field same{.use = Use(0, 0), .dimension = details.dimension};
      DescribedFields::set_kind(same, member, details);
      EXPECT_EQ(field->default_text, same.default_text);
      EXPECT_EQ(std::set(field->choices.begin(), field->choices.end()),
                std::set(same.choices.begin(), same.choices.end()));
    }
  }

  std::set<std::string> paths{};

 private:
  unsigned models_;
};

template <class... Structs>
std::set<std::string> paths_of(unsigned models) {
  Rows rows(models);
  const auto visit = [&](auto inputs) { describe(rows, inputs); };
  (visit(Structs{}), ...);
  return rows.paths;
}

// Inputs that members follow from, and those of the case as a whole.
bool is_source_of_others(const std::string& path) {
  static const std::set<std::string> sources{"name",
                                             "source",
                                             "model",
                                             "bearing.type",
                                             "bearing.designation",
                                             "bearing.catalogue",
                                             "bearing.complement",
                                             "bearing.clearance_class",
                                             "bearing.cage.material",
                                             "lubricant.viscosity_40",
                                             "lubricant.viscosity_100",
                                             "lubricant.viscosity_index"};
  return sources.contains(path) || path.starts_with("bearing.profile.") || path.starts_with("requirements.");
}

std::set<std::string> left_out(unsigned models, const std::set<std::string>& paths) {
  std::set<std::string> missing;
  for (const Field* field : fields_of(models))
    if (!paths.contains(field->path) && !is_source_of_others(field->path)) missing.insert(field->path);
  return missing;
}

TEST(StructuresOfSingleBearings, HoldAllInputsOfTheirModels) {
  // The land guides a cage in motion, which rollers at rest do not have.
  const std::set<std::string> of_motion{"bearing.cage.guide_land_diameter"};
  EXPECT_EQ(
      left_out(roller_bearing, paths_of<analysis::RollersUnderLoad, analysis::RollerSupport>(roller_bearing)),
      of_motion);
  EXPECT_THAT(left_out(ball_bearing, paths_of<analysis::BallsUnderLoad, analysis::BallSupport>(ball_bearing)),
              IsEmpty());
  EXPECT_THAT(left_out(ball_motion, paths_of<analysis::BallsInTime>(ball_motion)), IsEmpty());
}

}  // namespace
}  // namespace orbearing::app::single_bearing_rows_test
