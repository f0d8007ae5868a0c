// A small chart of life over speed, for terminals.
#pragma once

#include <string>
#include <vector>

#include "app/results/canvas.hpp"
#include "app/results/sweep_json.hpp"

namespace orbearing::app {

/// Braille where the locale's character set is UTF-8 (LC_ALL, LC_CTYPE, LANG, in this order).
Glyphs glyphs_of_locale();

/// Life [h], logarithmic, over input speed [rpm], axes labelled, the peak marked and written in a line below.
/// Points without a life are left out and counted. Fewer than two speeds give the line alone.
std::string life_chart(const TableHead& head, const std::vector<ResultRow>& rows, const LifePeak& peak,
                       Glyphs glyphs);

/// "longest life: 47300 h at 6120 rpm; of the grid's points 47100 h at 6000 rpm"
std::string peak_line(const LifePeak& peak);

}  // namespace orbearing::app
