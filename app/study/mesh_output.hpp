// The meshes of a case as JSON and for terminals.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/results/canvas.hpp"
#include "app/study/mesh_study.hpp"

namespace orbearing::app {

/// `meshes` of `orbearing mesh --json`. The parts at the pitch point are those of the first gear's tooth;
/// `gears` holds them for both.
nlohmann::ordered_json meshes_json(const MeshStudy& study);

/// `planet_rim` of `orbearing mesh --json`: influence functions of an elastic rim, orders of waves from 0 on;
/// null where the rim is rigid.
nlohmann::ordered_json planet_rim_json(const MeshStudy& study);

/// `axial` of `orbearing mesh --json`: axial forces of helical teeth, positive along the axis on which the
/// carrier turns counterclockwise; null where teeth are straight.
nlohmann::ordered_json axial_json(const MeshStudy& study);

/// Table of the meshes, parts at the pitch point, and a chart of each kind of mesh.
std::string mesh_text(const MeshStudy& study, Glyphs glyphs);

/// Stiffness over the mesh period, from zero on.
std::string mesh_chart(const gearset::MeshStiffness& mesh, const std::string& title, Glyphs glyphs);

}  // namespace orbearing::app
