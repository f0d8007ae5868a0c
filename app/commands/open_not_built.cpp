// In place of the page's server where its library was missing as the program was built.
#include "app/commands/open.hpp"
#include "app/errors.hpp"

namespace orbearing::app {

int execute(const OpenOptions&) {
  throw ComputationFailed(
      "open: this program was built without the page's server; install libcpp-httplib-dev (Debian) and build "
      "it again");
}

}  // namespace orbearing::app
