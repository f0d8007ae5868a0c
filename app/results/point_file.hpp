// A point's results as a netCDF-4 file: named dimensions, units on every variable.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/results/manifest.hpp"
#include "app/results/record_writers.hpp"
#include "coupling/analysis/operating_point.hpp"

namespace orbearing::app {

/// Attributes of each file of results: conventions, title ("case, what"), program, case, status.
std::vector<std::pair<std::string, std::string>> result_attributes(const ManifestHeader& header,
                                                                   const std::string& what,
                                                                   const std::string& status);

/// Scalars of the table in SI, the loads by place, the axes in their unit. A failed point keeps its speed,
/// its axes and its status.
PointContent point_content(const ManifestHeader& header, std::size_t point,
                           const std::vector<double>& axis_values, const analysis::PointResult& result);

/// Appends the position of the point in its sweep: added around the peak or not, and its nearest resonance
/// where one is known.
void add_location_in_sweep(bool refined, const std::optional<Resonance>& resonance, PointContent& content);

/// The bytes of the file. One thread at a time, as the netCDF library requires. Throws ComputationFailed.
std::string netcdf_bytes(const PointContent& content);

/// State in which the motion of a point's file ended; empty where the file holds none or cannot be read. One
/// thread at a time.
std::vector<double> read_final_state(const std::filesystem::path& file);

}  // namespace orbearing::app
