#include "page/server_module.hpp"

void orbearing_serve_page(const orbearing::page::PageSettings& settings,
                          std::vector<std::filesystem::path>& kept) {
  kept = orbearing::page::serve_page(settings);
}
