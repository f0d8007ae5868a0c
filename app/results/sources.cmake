# Sources of app/results, relative to app/. They need netcdf, fmt, nlohmann_json and, through coupling, TBB.
set(ORBEARING_RESULTS_SOURCES
  results/durable_file.cpp
  results/life_table.cpp
  results/manifest.cpp
  results/merge.cpp
  results/point_file.cpp
  results/progress.cpp
  results/record_arrays.cpp
  results/record_json.cpp
  results/record_schema.cpp
  results/record_text.cpp
  results/result_folder.cpp
  results/result_row.cpp
  results/spectrum_life.cpp
  results/sweep_run.cpp
  results/terminal_chart.cpp
  results/verdicts.cpp)
