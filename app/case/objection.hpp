// Words of the checks across fields.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Adds a mistake at the place of `path`.
inline void object_to(const ResolvedCase& in, const std::string& path, std::string found,
                      std::string required, std::vector<Mistake>& mistakes) {
  mistakes.push_back({in.place(path), path, {std::move(found), std::move(required)}});
}

inline bool has_all(const ResolvedCase& in, std::initializer_list<const char*> paths) {
  for (const char* path : paths)
    if (!in.has(path)) return false;
  return true;
}

}  // namespace orbearing::app
