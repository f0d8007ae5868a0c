# Sources of app/case, for the target of the app.
set(ORBEARING_CASE_SOURCES
  case/arrangement_case.cpp
  case/bearing_fields.cpp
  case/case_file.cpp
  case/case_resolver.cpp
  case/case_shape.cpp
  case/check_table.cpp
  case/condition_fields.cpp
  case/consistency.cpp
  case/drivetrain_fields.cpp
  case/dynamics_fields.cpp
  case/field.cpp
  case/field_table.cpp
  case/key_hints.cpp
  case/mistake.cpp
  case/pair_case.cpp
  case/pair_fields.cpp
  case/printable.cpp
  case/resolved_case.cpp
  case/resolved_writer.cpp
  case/schema.cpp
  case/settings.cpp
  case/sweep_axes.cpp
  case/sweep_consistency.cpp
  case/units.cpp
  case/yaml_tree.cpp)
set(ORBEARING_CASE_LIBRARIES yaml-cpp udunits2 fmt::fmt nlohmann_json::nlohmann_json)
