// JSON Schema of case files, from the table of fields; editors use it for completion.
#pragma once

#include <string>

namespace orbearing::app {

/// The schema (draft 2020-12) as indented JSON with a final newline; shipped as cases/case.schema.json.
std::string case_schema();

}  // namespace orbearing::app
