// The process that answers the requests of a page's server.
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <mutex>
#include <thread>

#include "mechanics/cancellation.hpp"
#include "orbearing/files.hpp"
#include "orbearing/pace.hpp"
#include "orbearing/request.hpp"
#include "orbearing/text.hpp"
#include "page/workers.hpp"

namespace orbearing::page {

namespace {

namespace fs = std::filesystem;

// Connection to the server: requests to this process and its answers.
class Server {
 public:
  // Standard input is given up, so that no process that a command starts holds it.
  Server() : socket_(fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)) {
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    dup2(nothing, STDIN_FILENO);
    close(nothing);
    std::thread([socket = socket_] { end_with_server(socket); }).detach();
  }

  bool read_line(std::string& line) {
    for (std::size_t seen = 0;;) {
      const std::size_t end = buffer_.find('\n', seen);
      if (end != std::string::npos) {
        line = buffer_.substr(0, end);
        buffer_.erase(0, end + 1);
        return true;
      }
      seen = buffer_.size();
      char part[1 << 16];
      const ssize_t read = recv(socket_, part, sizeof part, 0);
      if (read < 0 && errno == EINTR && !stop_requested()) continue;
      if (read <= 0) return false;
      buffer_.append(part, static_cast<std::size_t>(read));
    }
  }

  void tell(const char* event, Json data, const std::string& payload = {}) {
    Json head{{"event", event}, {"data", std::move(data)}};
    if (!payload.empty()) head["bytes"] = payload.size();
    const std::string text = head.dump() + '\n' + payload;
    const std::scoped_lock lock(telling_);
    for (std::size_t sent = 0; sent < text.size();) {
      const ssize_t part = send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
      if (part < 0 && errno != EINTR) return request_stop();
      if (part > 0) sent += static_cast<std::size_t>(part);
    }
  }

 private:
  // The result is not needed when the server has ended.
  static void end_with_server(int socket) {
    pollfd waiting{socket, POLLRDHUP, 0};
    while (poll(&waiting, 1, -1) < 0 && errno == EINTR) {
    }
    request_stop();
    std::this_thread::sleep_for(std::chrono::seconds(2));
    _exit(1);
  }

  int socket_;
  std::string buffer_;
  std::mutex telling_;
};

Request request_of(const Json& asked, Server& server, Pace& pace) {
  Request request{.command = asked.at("command"), .case_text = asked.value("case_text", "")};
  if (asked.contains("case_text") && request.case_text.empty()) request.case_text = "\n";  // none is given
  for (const Json& one : asked.value("settings", Json::array())) request.settings.push_back(one);
  Json options = asked.value("options", Json::object());
  const std::string folder = asked.value("folder", "");
  if (!folder.empty()) options.update({{"output", folder}, {"resume", true}});
  request.options = options.dump();
  request.progress = [&](std::size_t done, std::size_t all, const std::string& doing) {
    const std::optional<double> left =
        pace.seconds_left(doing, static_cast<double>(done), static_cast<double>(all));
    server.tell(
        "progress",
        {{"done", done}, {"all", all}, {"doing", doing}, {"seconds_left", left ? Json(*left) : Json()}});
    return true;  // a stop request ends the computation itself
  };
  if (!folder.empty())
    request.point = [&](const std::string& row) { server.tell("point", Json::parse(row)); };
  return request;
}

// The page of a folder of results, those of the request where it states a case: a drivetrain over its speeds
// or at one operating point, a bearing at its load.
std::string report_of(const Json& asked, Server& server) {
  const fs::path folder = asked.at("folder").get<std::string>();
  const bool pdf = asked.at("pdf").get<bool>();
  Pace pace;
  if (asked.contains("case_text")) {
    Json computed = asked;
    const Case opened = Case::parse(asked["case_text"].get<std::string>());
    const bool swept = opened.text("model") == "planetary-drivetrain" && !asked.value("of_point", false);
    computed["command"] = swept ? "sweep" : "run";
    answer(request_of(computed, server, pace));
  }
  answer({.command = "report", .options = Json{{"folders", {folder.string()}}, {"pdf", pdf}}.dump()});
  return read_file(folder / (pdf ? "report.pdf" : "report.html"));
}

void answer_request(const Json& asked, Server& server) {
  if (asked.at("command") == "report") return server.tell("end", {{"code", 0}}, report_of(asked, server));
  Pace pace;
  Request request = request_of(asked, server, pace);
  request.motion = [&](const std::string& motion) { server.tell("motion", Json::parse(motion)); };
  const Answer found = answer(request);
  // As the command prints it.
  server.tell("end", {{"code", found.code}, {"errors", found.failures}},
              Json::parse(found.result).dump(2) + '\n');
}

Json failure(int code, const std::vector<std::string>& lines, bool stopped = false) {
  Json errors = Json::array();
  for (const std::string& line : lines) errors.push_back(printable(line));
  return {{"code", code}, {"errors", std::move(errors)}, {"stopped", stopped}};
}

void answer_line(const std::string& line, Server& server) {
  try {
    answer_request(Json::parse(line), server);
  } catch (const BadInput& error) {
    server.tell("end", failure(2, error.messages));
  } catch (const Interrupted& error) {
    server.tell("end", failure(1, {error.what()}, true));
  } catch (const Cancelled& wish) {
    server.tell("end", failure(1, {wish.what()}, true));
  } catch (const std::exception& error) {
    server.tell("end", failure(1, {error.what()}));
  }
}

}  // namespace

int work() {
  Server server;
  for (std::string line; !stop_requested() && server.read_line(line);) answer_line(line, server);
  return 0;
}

}  // namespace orbearing::page
