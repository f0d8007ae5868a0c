// Long computations: each in a process and a folder of its own, with events that readers follow, stopped and
// continued.
#pragma once

#include <atomic>
#include <condition_variable>
#include <map>
#include <thread>

#include "page/workers.hpp"

namespace orbearing::page {

/// Events of a job from a place on, as a reader takes them.
struct NewEvents {
  std::vector<std::string> texts;  // of a stream of server-sent events
  std::size_t next = 0;            // place of the next one
  std::size_t latest = 0;          // number of the last one given of those of which only the latest counts
  bool ended = false;              // no further event follows
};

/// One computation from its start to its end.
class Job {
 public:
  Job(std::unique_ptr<Worker> worker, const Json& request, std::filesystem::path folder);
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;
  ~Job();

  /// Waits a moment for events behind `from`; `latest` is that of the former ones.
  NewEvents events(std::size_t from, std::size_t latest);
  void stop() { stopping_ = true; }
  bool ended();
  bool has_points();
  const std::filesystem::path& folder() const { return folder_; }

  /// For as long as it lives, the job has a reader.
  class Reader {
   public:
    explicit Reader(Job& job) : job_(job) { ++job_.readers_; }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() {
      job_.left_ = std::chrono::steady_clock::now();
      --job_.readers_;
    }

   private:
    Job& job_;
  };

 private:
  void follow();
  bool take(Message message);
  void finish(const Message& message);
  void add(const char* event, const Json& data);
  bool is_left() const;

  std::unique_ptr<Worker> worker_;
  std::filesystem::path folder_;
  std::atomic<bool> stopping_ = false;
  std::atomic<int> readers_ = 0;
  std::atomic<std::chrono::steady_clock::time_point> left_ = std::chrono::steady_clock::now();
  std::mutex writing_;
  std::condition_variable written_;
  std::vector<std::string> events_;
  struct Latest {
    std::size_t number;
    std::string text;
  };
  std::map<std::string, Latest> latest_;  // of progress and motion, which replace what was before
  std::size_t number_of_latest_ = 0;
  Json points_ = Json::array();
  bool ended_ = false;
  std::thread following_;
};

/// A new one. Throws ComputationFailed.
std::filesystem::path temporary_folder();

/// All jobs of a page. Results of sweeps are in folders below a temporary one.
class Jobs {
 public:
  explicit Jobs(Workers& workers) : workers_(workers) {}
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;
  ~Jobs();

  /// Begins one and returns its name. "continue" in the request names one that was stopped; `results` is a
  /// folder of results in which its sweep is continued, else empty. Throws BadInput, and ComputationFailed
  /// where too many run.
  std::string start(const Json& request, const std::filesystem::path& results = {});
  /// None where there is none of that name.
  std::shared_ptr<Job> find(const std::string& name);
  bool running();
  /// Stops all; returns folders that hold points.
  std::vector<std::filesystem::path> end();

 private:
  std::filesystem::path folder_for(const Json& request);

  Workers& workers_;
  std::mutex naming_;
  std::filesystem::path temporary_;
  std::map<std::string, std::shared_ptr<Job>> jobs_;
  std::size_t last_ = 0;
};

}  // namespace orbearing::page
