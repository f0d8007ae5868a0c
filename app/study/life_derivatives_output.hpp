// How derivatives of a life are shown and written.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/results/point_content.hpp"
#include "app/study/life_derivatives.hpp"

namespace orbearing::app {

/// `{quantity, life, unit, of_set, inputs: [...], not_differentiable: [...], without_effect: [...]}`.
nlohmann::ordered_json derivatives_json(const LifeDerivatives& derivatives);

std::string derivatives_text(const LifeDerivatives& derivatives);

/// One row for each input that the life uses; those without a derivative with their reason.
std::string derivatives_csv(const LifeDerivatives& derivatives);

PointContent derivatives_content(const LifeDerivatives& derivatives);

}  // namespace orbearing::app
