#include "page/workers.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <map>
#include <thread>

#include "orbearing/errors.hpp"
#include "orbearing/text.hpp"

namespace orbearing::page {

namespace fs = std::filesystem;

namespace {

// Options of each command that touch no file; of a job the server adds the folder.
const std::map<std::string, std::vector<std::string>>& allowed() {
  static const std::map<std::string, std::vector<std::string>> table{
      {"check", {}},
      {"run", {"fidelity", "gears"}},
      {"sweep", {"fidelity", "jobs", "grid_only", "continue"}},
      {"crown",
       {"profile", "tilts", "drops", "spectrum", "shares", "tolerance", "tilt_tolerance", "distribution",
        "life", "of", "starts", "jobs"}},
      {"mesh", {}},
      {"modes", {"speed"}},
      {"stiffness", {}},
      {"sensitivities", {"result", "by", "fidelity", "jobs"}},
      {"signals", {"vary", "fidelity", "noise", "seed", "jobs"}},
      {"validate", {"motion", "samples", "jobs"}}};
  return table;
}

std::string names_of(const std::map<std::string, std::vector<std::string>>& table) {
  std::vector<std::string> names;
  for (const auto& [name, options] : table) names.push_back(name);
  return fmt::format("{}", fmt::join(names, ", "));
}

bool is_scalar(const Json& value) {
  return value.is_string() || value.is_number() || value.is_boolean() || value.is_null();
}

// A number of threads that no machine has would end the process.
bool is_option(const std::string& name, const Json& value) {
  if (name == "jobs") return value.is_number_unsigned() && value <= 64U;
  return is_scalar(value) || (value.is_array() && std::ranges::all_of(value, is_scalar));
}

void check_options(const std::string& command, const Json& options, std::vector<std::string>& mistakes) {
  if (!options.is_object()) {
    mistakes.push_back("request: options: found no object; required: options of the command by their names");
    return;
  }
  const std::vector<std::string>& names = allowed().at(command);
  for (const auto& [name, value] : options.items())
    if (std::ranges::find(names, name) == names.end())
      mistakes.push_back(
          fmt::format("request: options.{}: found an option that the page cannot give to {}; required: {}",
                      shortened(name), command,
                      names.empty() ? "none" : fmt::format("one of {}", fmt::join(names, ", "))));
    else if (!is_option(name, value))
      mistakes.push_back(
          fmt::format("request: options.{}: found {}; required: {}", name, value.type_name(),
                      name == "jobs" ? "a whole number up to 64" : "a text, a number or a list of these"));
}

void check_command(const Json& request, std::vector<std::string>& mistakes) {
  const Json command = request.value("command", Json());
  if (!command.is_string() || !allowed().contains(command)) {
    mistakes.push_back(fmt::format(
        "request: command: found {}; required: one of {}",
        command.is_string() ? quote(command.get<std::string>()) : command.type_name(), names_of(allowed())));
    return;
  }
  check_options(command, request.value("options", Json::object()), mistakes);
  const bool takes_case = command != "validate";
  if (request.contains("case_text") != takes_case)
    mistakes.push_back(takes_case ? "request: case_text: missing; required: the text of a case file"
                                  : "request: case_text: found with validate; required: none");
}

}  // namespace

void require_sound_request(const Json& request, const std::vector<std::string>& more) {
  if (!request.is_object())
    throw BadInput("request: found no JSON object; required: one with the key command");
  std::vector<std::string> mistakes, known{"command", "case_text", "settings", "options"};
  known.insert(known.end(), more.begin(), more.end());
  for (const auto& [name, value] : request.items())
    if (std::ranges::find(known, name) == known.end())
      mistakes.push_back(fmt::format("request: {}: found an unknown key; required: one of {}",
                                     shortened(name), fmt::join(known, ", ")));
  if (request.contains("case_text") && !request["case_text"].is_string())
    mistakes.push_back("request: case_text: found no text; required: the text of a case file");
  const Json settings = request.value("settings", Json::array());
  if (!settings.is_array() || !std::ranges::all_of(settings, [](const Json& one) { return one.is_string(); }))
    mistakes.push_back(
        "request: settings: found no list of texts; required: texts like \"input.power=75 kW\"");
  check_command(request, mistakes);
  if (!mistakes.empty()) throw BadInput(mistakes);
}

// The server's side.

namespace {

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

struct SpawnActions {
  posix_spawn_file_actions_t files{};
  posix_spawnattr_t attributes{};
  SpawnActions() {
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
  }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  ~SpawnActions() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
};

// The socket is its standard input, and what it prints goes to standard error. It has a process group of its
// own, so that signals from a terminal reach the server alone.
pid_t spawn(WorkerProgram program, int socket, const fs::path& folder) {
  std::vector<std::string>&words = program.words, &variables = program.environment;
  if (!folder.empty()) words.push_back(folder.string());
  SpawnActions actions;
  posix_spawn_file_actions_adddup2(&actions.files, socket, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions.files, STDERR_FILENO, STDOUT_FILENO);
  posix_spawn_file_actions_addclosefrom_np(&actions.files, STDERR_FILENO + 1);
  sigset_t defaults;
  sigemptyset(&defaults);
  for (const int signal : {SIGPIPE, SIGINT, SIGTERM}) sigaddset(&defaults, signal);
  posix_spawnattr_setsigdefault(&actions.attributes, &defaults);
  posix_spawnattr_setpgroup(&actions.attributes, 0);
  posix_spawnattr_setflags(&actions.attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  pid_t process = -1;
  const int error = posix_spawn(&process, words.front().c_str(), &actions.files, &actions.attributes,
                                pointers_to(words).data(), pointers_to(variables).data());
  if (error != 0)
    throw ComputationFailed(fmt::format("{}: cannot be started: {}", words.front(), strerror(error)));
  return process;
}

}  // namespace

Worker::Worker(const WorkerProgram& program, const fs::path& folder) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw ComputationFailed(fmt::format("no process for a computation: {}", strerror(errno)));
  socket_ = ends[0];
  try {
    process_ = spawn(program, ends[1], folder);
  } catch (...) {
    close(ends[0]);
    close(ends[1]);
    throw;
  }
  close(ends[1]);
}

Worker::~Worker() {
  close(socket_);
  kill(-process_, SIGKILL);
  kill(process_, SIGKILL);  // it may not have its group yet
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void Worker::send(const Json& request) {
  const std::string line = request.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
  for (std::size_t sent = 0; sent < line.size();) {
    const ssize_t part = ::send(socket_, line.data() + sent, line.size() - sent, MSG_NOSIGNAL);
    if (part < 0 && errno != EINTR) throw ComputationFailed("the computation has ended: its process is gone");
    if (part > 0) sent += static_cast<std::size_t>(part);
  }
}

// A line of JSON, with the number of bytes that follow it, if any.
std::optional<Message> Worker::buffered() {
  const std::size_t end = buffer_.find('\n');
  if (end == std::string::npos) return std::nullopt;
  Json head = Json::parse(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(end));
  const std::size_t bytes = head.value("bytes", std::size_t{0});
  if (buffer_.size() < end + 1 + bytes) return std::nullopt;
  Message message{head.at("event"), std::move(head["data"]), buffer_.substr(end + 1, bytes)};
  buffer_.erase(0, end + 1 + bytes);
  return message;
}

std::optional<Message> Worker::receive(std::chrono::milliseconds patience) {
  const auto until = std::chrono::steady_clock::now() + patience;
  for (;;) {
    if (std::optional<Message> message = buffered()) return message;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - std::chrono::steady_clock::now());
    pollfd waiting{socket_, POLLIN, 0};
    if (left.count() <= 0 || poll(&waiting, 1, static_cast<int>(left.count())) == 0) return std::nullopt;
    char part[1 << 16];
    const ssize_t read = ::recv(socket_, part, sizeof part, 0);
    if (read > 0)
      buffer_.append(part, static_cast<std::size_t>(read));
    else if (read == 0 || errno != EINTR)
      throw ComputationFailed("the computation ended before its result: its process is gone");
  }
}

void Worker::stop() {
  kill(process_, SIGTERM);
}

std::unique_ptr<Worker> Workers::take() {
  {
    const std::scoped_lock lock(taking_);
    if (!idle_.empty()) {
      std::unique_ptr<Worker> worker = std::move(idle_.back());
      idle_.pop_back();
      return worker;
    }
  }
  return fresh();
}

void Workers::give_back(std::unique_ptr<Worker> worker) {
  constexpr std::size_t most_idle = 4;
  const std::scoped_lock lock(taking_);
  if (idle_.size() < most_idle) idle_.push_back(std::move(worker));
}

namespace {

Message failed(const std::string& reason) {
  return {"end", {{"code", 1}, {"errors", {reason}}}, {}};
}

}  // namespace

Message answer_within(Workers& workers, const Json& request, std::chrono::seconds limit,
                      const std::atomic<bool>& ending) try {
  constexpr std::chrono::milliseconds patience{200};
  const auto until = std::chrono::steady_clock::now() + limit;
  std::unique_ptr<Worker> worker = workers.take();
  worker->send(request);
  while (!ending && std::chrono::steady_clock::now() < until) {
    std::optional<Message> message = worker->receive(patience);
    if (!message || message->event != "end") continue;
    workers.give_back(std::move(worker));
    return std::move(*message);
  }
  return failed(ending ? "the program ends"
                       : fmt::format("stopped after {} s; start it as a job", limit.count()));
} catch (const ComputationFailed& error) {
  return failed(error.what());
}

}  // namespace orbearing::page
