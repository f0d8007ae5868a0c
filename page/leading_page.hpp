// How a browser gets to the page without a secret among the arguments of its process.
#pragma once

#include <string>

namespace orbearing::page {

/// A page of HTML that leads on to an address.
std::string leading_to(const std::string& address);

}  // namespace orbearing::page
