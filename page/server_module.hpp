// The server as a module that a program loads: the HTTP library brings encryption and compression with it,
// which other commands would load at each start.
#pragma once

#include <filesystem>
#include <vector>

#include "page/page_server.hpp"

/// serve_page(): `kept` takes its folders. The program and the module are of one build.
extern "C" void orbearing_serve_page(const orbearing::page::PageSettings& settings,
                                     std::vector<std::filesystem::path>& kept);
