#include "app/case/former_keys.hpp"

#include <array>
#include <string_view>

#include "app/case/case_shape.hpp"

namespace orbearing::app {

namespace {

// A field or a block of fields, of which the last key has changed.
struct FormerPath {
  std::string_view former, present;
};

constexpr std::array<FormerPath, 5> kFormerPaths{{
    // Lambda is the ratio of film and roughness where one reads of a bearing's lubrication.
    {"life.lambda", "life.reduction_factor"},
    {"bearing.inner_race.standing_form", "bearing.inner_race.out_of_roundness"},
    {"bearing.outer_race.standing_form", "bearing.outer_race.out_of_roundness"},
    {"bearing.inner_race.turning_form", "bearing.inner_race.waviness"},
    {"bearing.outer_race.turning_form", "bearing.outer_race.waviness"},
}};

// Blocks whose keys are paths of fields.
constexpr std::array<std::string_view, 3> kBlocksOfPaths{"sweep.", "uncertain.", "assumed."};

std::size_t block_length(std::string_view path) {
  for (const std::string_view block : kBlocksOfPaths)
    if (path.starts_with(block)) return block.size();
  return 0;
}

void rename(Entry& block, const std::string& prefix) {
  if (block.shape != Entry::Shape::block) return;
  for (Member& member : block.members) {
    const std::string present = present_path(prefix + member.key).substr(prefix.size());
    if (present != member.key && find_member(block, present) == nullptr) member.key = present;
    rename(member.value, prefix + member.key + ".");
  }
}

}  // namespace

std::string present_path(const std::string& path) {
  std::size_t begin = block_length(path);
  begin += set_prefix_length(std::string_view(path).substr(begin));
  const std::string_view field = std::string_view(path).substr(begin);
  for (const auto& [former, present] : kFormerPaths) {
    if (!field.starts_with(former)) continue;
    const std::string_view rest = field.substr(former.size());
    if (rest.empty() || rest.front() == '.')
      return path.substr(0, begin) + std::string(present) + std::string(rest);
  }
  return path;
}

void rename_former_keys(Entry& root) {
  rename(root, "");
}

}  // namespace orbearing::app
