// The stiffness matrix of a housing in a file of its own, as {file: housing.txt} says in place of the list of
// its elements.
//
//     x1       y1       z1       x2      ...     three columns for each bearing: across, upward, along the
//     axis (N/mm)   (N/mm)   (N/mm)   (N/mm)  ...     in brackets, or behind the names: x1_N_per_mm
//     3.1e6    2.0e4    0        4.5e5   ...     as many rows as columns, in their order
#pragma once

#include <string>
#include <vector>

#include "app/case/field.hpp"

namespace orbearing::app {

/// Most rows and columns.
inline constexpr std::size_t most_matrix_rows = 60;

/// Elements row by row, each with its place in the file. What is wrong is added to `mistakes` at its line and
/// column, with the list empty.
Entry matrix_of_file(const Field& field, const Entry& block, const std::string& path,
                     const std::string& case_file, std::vector<Mistake>& mistakes);

/// The same from the text of `file`.
Entry matrix_of_text(const Field& field, const std::string& text, const std::string& path,
                     const std::string& file, std::vector<Mistake>& mistakes);

}  // namespace orbearing::app
