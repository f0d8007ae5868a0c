// Lines for people on standard error. It may be closed, or a file on a full disk: what becomes of a line
// changes neither the work nor its exit code.
#pragma once

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string_view>
#include <utility>

namespace orbearing::app {

/// Writes the text as it is.
inline void print_to_standard_error(std::string_view text) noexcept {
  if (std::fwrite(text.data(), 1, text.size(), stderr) != text.size() || std::fflush(stderr) != 0)
    std::clearerr(stderr);
}

/// The same of a format with its values.
template <class... Values>
void print_to_standard_error(fmt::format_string<Values...> format, Values&&... values) {
  print_to_standard_error(std::string_view(fmt::format(format, std::forward<Values>(values)...)));
}

/// Standard input, output and error that are closed become files that refuse to be read or written. The first
/// file that is opened would take their number otherwise, and messages would go into it.
inline void hold_standard_streams() noexcept {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) == -1)
      if (const int held = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY); held != stream)
        ::close(held);
}

}  // namespace orbearing::app
