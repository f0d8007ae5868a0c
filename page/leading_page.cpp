#include "page/leading_page.hpp"

#include <fmt/format.h>

namespace orbearing::page {

std::string leading_to(const std::string& address) {
  return fmt::format(
      "<!DOCTYPE html>\n<meta charset=\"utf-8\"><title>Orbearing</title><link rel=\"icon\" href=\"data:,\">\n"
      "<meta http-equiv=\"refresh\" content=\"0; url={0}\">\n<a href=\"{0}\">Orbearing</a>\n",
      address);
}

}  // namespace orbearing::page
