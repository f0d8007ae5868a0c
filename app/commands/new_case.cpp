#include "app/commands/new_case.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/resources.hpp"
#include "app/results/durable_file.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

// Takes the name first, so that no file is ever written over.
void make_file(const std::string& name, const std::string& content) {
  const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0 && errno == EEXIST)
    throw BadInput(printable(name) + ": exists already; the name of a new file is required");
  if (descriptor < 0)
    throw BadInput(fmt::format("{}: cannot be made: {}; required: a file in a folder that may be written to",
                               printable(name), std::strerror(errno)));
  close(descriptor);
  try {
    write_aside_and_rename(name, content);
  } catch (...) {
    unlink(name.c_str());
    throw;
  }
}

}  // namespace

int execute(const NewOptions& options) {
  const CaseTemplate chosen = case_template(options.template_name);
  make_file(options.file, chosen.text);
  if (options.print.json)
    print_object({{"template", chosen.name},
                  {"file", options.file},
                  {"title", chosen.title},
                  {"purpose", chosen.purpose},
                  {"units", nlohmann::ordered_json::object()}},
                 options.print);
  else if (!options.print.quiet)
    fmt::print("{}: {}\n", printable(options.file), chosen.title);
  return 0;
}

}  // namespace orbearing::app
