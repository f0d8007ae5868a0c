# Sources of app/results, relative to app/. They need netcdf, fmt, nlohmann_json and, through coupling, TBB.
set(ORBEARING_RESULTS_SOURCES
  results/canvas.cpp
  results/continuation_paths.cpp
  results/durable_file.cpp
  results/interruption.cpp
  results/manifest.cpp
  results/merge.cpp
  results/point_file.cpp
  results/progress.cpp
  results/result_folder.cpp
  results/result_row.cpp
  results/row_text.cpp
  results/series_content.cpp
  results/sweep_json.cpp
  results/sweep_run.cpp
  results/terminal_chart.cpp
  results/terminal_table.cpp)
