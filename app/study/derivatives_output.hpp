// How derivatives of a result are shown and written.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/results/point_content.hpp"
#include "app/study/derivatives.hpp"

namespace orbearing::app {

/// `{quantity, QUANTITY: its value, unit, of_set, inputs: [...], not_differentiable: [...], without_effect:
/// [...]}`.
nlohmann::ordered_json derivatives_json(const Derivatives& derivatives);

std::string derivatives_text(const Derivatives& derivatives);

/// One row for each input that the run uses; those without a derivative with their reason.
std::string derivatives_csv(const Derivatives& derivatives);

PointContent derivatives_content(const Derivatives& derivatives);

}  // namespace orbearing::app
