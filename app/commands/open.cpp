#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

#include "app/case/rows_file.hpp"
#include "app/commands/open.hpp"
#include "app/errors.hpp"
#include "app/resources.hpp"
#include "app/standard_error.hpp"
#include "mechanics/cancellation.hpp"
#include "orbearing/files.hpp"
#include "page/leading_page.hpp"
#include "page/page_server.hpp"
#ifdef ORBEARING_PAGE_SERVER
#include "app/results/loaded_library.hpp"
#include "page/server_module.hpp"
#endif

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

// A file that leads a browser to an address. Arguments of a process are visible to all users of a machine;
// this file is not.
class LeadingFile {
 public:
  LeadingFile() = default;
  LeadingFile(const LeadingFile&) = delete;
  LeadingFile& operator=(const LeadingFile&) = delete;
  ~LeadingFile() {
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
  }

  fs::path write(const std::string& address) {
    folder_ = page::temporary_folder();  // which its owner alone can enter
    const fs::path file = folder_ / "open.html";
    write_file(file, page::leading_to(address));
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    return file;
  }

 private:
  fs::path folder_;
};

// This program; where it is a part of Python, the command of its package.
std::vector<std::string> this_program() {
  std::error_code ignored;
  const fs::path self = fs::read_symlink("/proc/self/exe", ignored);
  if (self != fs::canonical(resources().interpreter, ignored)) return {self.string()};
  return {resources().interpreter.string(), "-m", "orbearing.command_line"};
}

std::vector<std::string> environment_of_program() {
  std::vector<std::string> variables;
  for (char** one = environ; *one != nullptr; ++one)
    if (!std::string_view(*one).starts_with("PYTHONPATH=")) variables.emplace_back(*one);
  variables.push_back("PYTHONPATH=" + resources().package.string());
  return variables;
}

// Opens the file with the desktop's default program; does not wait for it to end.
void show_in_browser(const std::string& file) {
  std::string words[] = {"xdg-open", file};
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

std::vector<fs::path> serve(const page::PageSettings& settings) {
#ifdef ORBEARING_PAGE_SERVER
  const LoadedLibrary module("the page's server",
                             {(resources().folder / "lib" / "orbearing" / ORBEARING_PAGE_SERVER).string()});
  std::vector<fs::path> kept;
  module.function<decltype(&orbearing_serve_page)>("orbearing_serve_page")(settings, kept);
  return kept;
#else
  return page::serve_page(settings);
#endif
}

}  // namespace

int execute(const OpenOptions& options) {
  if (options.worker) return work_within(options.opened);
  page::PageSettings settings{.opened = page::opened_as(options.opened),
                              .files = page_files(),
                              .schemas = shipped_cases(),
                              .worker = {this_program(), environment_of_program()},
                              .port = options.port};
  for (const char* word : {"open", "--worker"}) settings.worker.words.emplace_back(word);
  settings.linger = std::chrono::seconds(options.linger);
  settings.interrupted = [] { return stop_requested(); };
  LeadingFile leading;
  settings.started = [&](const std::string& address, const std::string& entry) {
    fmt::print("{}\n", address);
    std::fflush(stdout);
    if (!options.no_browser) show_in_browser(leading.write(entry).string());
  };
  for (const fs::path& folder : serve(settings))
    if (!options.print.quiet)
      fmt::print("results are kept in {}; orbearing open shows them\n", folder.string());
  return 0;
}

}  // namespace orbearing::app
