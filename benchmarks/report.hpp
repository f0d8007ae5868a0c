// All figures of a run of the benchmarks, as JSON and as a table.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace orbearing::bench {

/// Measures everything; prints its progress on standard error. Keys as in the contract of the command line.
nlohmann::ordered_json measure();

/// The same for people.
std::string table(const nlohmann::ordered_json& figures);

}  // namespace orbearing::bench
