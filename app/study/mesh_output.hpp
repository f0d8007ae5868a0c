// Charts of the meshes of a case, for terminals.
#pragma once

#include <string>

#include "app/results/canvas.hpp"
#include "app/study/mesh_study.hpp"

namespace orbearing::app {

/// A chart of each kind of mesh.
std::string mesh_charts(const MeshStudy& study, Glyphs glyphs);

/// Stiffness over the mesh period, from zero on.
std::string mesh_chart(const gearset::MeshStiffness& mesh, const std::string& title, Glyphs glyphs);

}  // namespace orbearing::app
