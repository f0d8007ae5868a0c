#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

#include "app/case/printable.hpp"
#include "app/case/rows_file.hpp"
#include "app/commands/command_line.hpp"
#include "app/errors.hpp"
#include "app/page/page_server.hpp"
#include "app/resources.hpp"
#include "app/standard_error.hpp"
#include "mechanics/cancellation.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

// What the desktop opens addresses with; its end is waited for by nobody.
void show_in_browser(const std::string& address) {
  std::string words[] = {"xdg-open", address};
  char* pointers[] = {words[0].data(), words[1].data(), nullptr};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&files, stream, "/dev/null", O_RDWR, 0);
  pid_t process = -1;
  if (posix_spawnp(&process, "xdg-open", &files, nullptr, pointers, environ) != 0)
    print_to_standard_error(
        "no program to open the address with (xdg-open, Debian: xdg-utils): open it in a browser\n");
  posix_spawn_file_actions_destroy(&files);
}

// A process of the page's server reads no file but those that the case names in the folder that was opened.
int work_within(const std::string& folder) {
  keep_row_files_within(folder);
  if (!folder.empty()) fs::current_path(folder);
  return page::work();
}

}  // namespace

int open_command(const Options& options) {
  if (options.worker) return work_within(options.case_file);
  page::PageSettings settings{
      .opened = page::opened_as(options.case_file), .files = page_files(), .port = options.port};
  settings.linger = std::chrono::seconds(options.linger);
  settings.interrupted = [] { return stop_requested(); };
  settings.started = [&](const std::string& address) {
    fmt::print("{}\n", address);
    std::fflush(stdout);
    if (!options.no_browser) show_in_browser(address);
  };
  for (const fs::path& folder : page::serve_page(settings))
    if (!options.quiet) fmt::print("results are kept in {}; orbearing open shows them\n", folder.string());
  return 0;
}

}  // namespace orbearing::app
