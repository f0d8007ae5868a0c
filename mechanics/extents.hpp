// Some members of a structure, named in code.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

namespace orbearing::mechanics {

/// Members by their addresses, with all that is within them.
class Extents {
 public:
  template <class... Members>
  explicit Extents(const Members&... members) : all_{{&members, &members + 1}...} {}

  bool hold(const void* address) const {
    return std::ranges::any_of(all_, [&](const Extent& one) {
      return !std::less<>()(address, one.begin) && std::less<>()(address, one.end);
    });
  }

 private:
  struct Extent {
    const void *begin, *end;
  };
  std::vector<Extent> all_;
};

}  // namespace orbearing::mechanics
