// The server of the page, on the loopback address alone.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "page/jobs.hpp"
#include "page/opened.hpp"

namespace orbearing::page {

/// How the page is served.
struct PageSettings {
  Opened opened;
  std::filesystem::path files;    // index.html and what it loads
  std::filesystem::path schemas;  // case.schema.json and result.schema.json
  WorkerProgram worker;
  int port = 0;  // 0: one that is free
  std::chrono::seconds linger{
      60};  // after the last page was closed; three times as long after one fell silent
  std::function<bool()> interrupted;  // whether the program shall end
  // `address` has the token of the program, for its owner to type; `entry` a token of one use, for a browser.
  std::function<void(const std::string& address, const std::string& entry)> started;
};

/// Serves until it is interrupted or the last page was closed. Returns folders of results that are kept.
/// Throws ComputationFailed where the port is taken.
std::vector<std::filesystem::path> serve_page(const PageSettings& settings);

}  // namespace orbearing::page
