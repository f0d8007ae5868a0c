// Requests of the page, each answered by a process of its own: a failure, an endless computation or a stop
// ends only that process, and the server continues.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace orbearing::page {

using Json = nlohmann::ordered_json;

/// Checks a request of a page: {"command", "case_text", "settings", "options"} with the commands and the
/// options that touch no file. `more` are further keys that are allowed. Throws BadInput with every mistake.
void require_sound_request(const Json& request, const std::vector<std::string>& more = {});

/// Message of a worker process: "progress", "motion", "point", and last of all "end".
struct Message {
  std::string event;
  Json data;            // of "end": code, errors, stopped
  std::string payload;  // of "end": the bytes of --json, or a page
};

/// The program whose process calls work(): its words, behind which the folder of the case is put, and its
/// environment, "NAME=value".
struct WorkerProgram {
  std::vector<std::string> words;
  std::vector<std::string> environment;
};

/// A process that answers requests, one after the other.
class Worker {
 public:
  /// Files that a case names are read from `folder` alone; empty: none are.
  Worker(const WorkerProgram& program, const std::filesystem::path& folder);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  /// Ends the process, whatever it does.
  ~Worker();

  void send(const Json& request);
  /// The next message; none where there was none in time. Throws ComputationFailed where the process has
  /// ended.
  std::optional<Message> receive(std::chrono::milliseconds patience);
  /// Asks the computation to end, which keeps its points. The process takes no further request.
  void stop();

 private:
  std::optional<Message> buffered();

  pid_t process_ = -1;
  int socket_ = -1;
  std::string buffer_;
};

/// Processes that wait for requests, so that none waits for the start of a process.
class Workers {
 public:
  Workers(WorkerProgram program, std::filesystem::path folder)
      : program_(std::move(program)), folder_(std::move(folder)) {}

  std::unique_ptr<Worker> take();
  /// Takes back a process that has answered.
  void give_back(std::unique_ptr<Worker> worker);
  std::unique_ptr<Worker> fresh() const { return std::make_unique<Worker>(program_, folder_); }

 private:
  WorkerProgram program_;
  std::filesystem::path folder_;
  std::mutex taking_;
  std::vector<std::unique_ptr<Worker>> idle_;
};

/// The last message to a request; "end" with code 1 where the process took longer than `limit`, ended or
/// `ending` became true.
Message answer_within(Workers& workers, const Json& request, std::chrono::seconds limit,
                      const std::atomic<bool>& ending);

/// The process itself: answers what comes by standard input until that ends. Returns the exit code.
int work();

}  // namespace orbearing::page
