// Words of the checks across fields.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Where `path` stands; of a value that the case leaves out, the place of one of its block, or of the model.
inline Location location_for(const ResolvedCase& in, const std::string& path) {
  if (in.has(path)) return in.location(path);
  const std::string block = path.substr(0, path.rfind('.') + 1);
  for (const Input& input : in.inputs())
    if (!block.empty() && input.path.starts_with(block) && is_stated(in, input.path))
      return in.location(input.path);
  return in.has("model") ? in.location("model") : Location{};
}

/// Adds a mistake at the place of `path`.
inline void add_error_at(const ResolvedCase& in, const std::string& path, std::string found,
                         std::string required, std::vector<Mistake>& mistakes) {
  mistakes.push_back({location_for(in, path), path, {std::move(found), std::move(required)}});
}

inline bool has_all(const ResolvedCase& in, std::initializer_list<const char*> paths) {
  for (const char* path : paths)
    if (!in.has(path)) return false;
  return true;
}

}  // namespace orbearing::app
