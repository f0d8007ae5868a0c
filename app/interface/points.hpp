// Operating points for callers that have already checked which inputs have an effect.
#pragma once

#include "orbearing/sweep.hpp"

namespace orbearing {

/// Treatment of inputs among `paths` that have no effect on any point.
enum class WithoutEffect { refused, allowed };

/// As evaluate(). A study varies choices as well: an input may have no effect on the points of one call, and
/// one on those of others.
Points evaluate(const Case& stated, const std::vector<std::string>& paths, const std::vector<double>& values,
                const std::string& fidelity, int jobs, const std::function<void(std::size_t)>& done,
                WithoutEffect without_effect);

}  // namespace orbearing
