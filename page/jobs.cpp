#include "page/jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "orbearing/errors.hpp"

namespace orbearing::page {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds patience{200};
constexpr std::chrono::minutes longest_alone{10};  // without a reader
constexpr std::chrono::seconds grace{5};           // for a computation to end after a stop request
constexpr std::size_t most_running = 8;
constexpr std::size_t most_kept = 64;  // of those that have ended

std::string event_text(const std::string& id, const char* event, const Json& data) {
  return fmt::format("{}event: {}\ndata: {}\n\n", id, event,
                     data.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

Job::Job(std::unique_ptr<Worker> worker, const Json& request, fs::path folder)
    : worker_(std::move(worker)), folder_(std::move(folder)) {
  worker_->send(request);
  following_ = std::thread([this] { follow(); });
}

Job::~Job() {
  stop();
  following_.join();
}

bool Job::is_left() const {
  return readers_ == 0 && Clock::now() - left_.load() > longest_alone;
}

void Job::follow() try {
  std::optional<Clock::time_point> asked;
  for (;;) {
    if (!asked && (stopping_ || is_left())) {
      worker_->stop();
      asked = Clock::now();
    }
    if (asked && Clock::now() - *asked > grace) break;
    if (std::optional<Message> message = worker_->receive(patience); message && !take(std::move(*message)))
      return;
  }
  worker_.reset();
  finish({"end", {{"code", 1}, {"errors", {"interrupted"}}, {"stopped", true}}, {}});
} catch (const std::exception& error) {
  worker_.reset();
  finish({"end", {{"code", 1}, {"errors", {error.what()}}, {"stopped", stopping_.load()}}, {}});
}

// False behind the last message.
bool Job::take(Message message) {
  if (message.event == "end") {
    worker_.reset();
    finish(message);
    return false;
  }
  const std::scoped_lock lock(writing_);
  if (message.event == "progress" || message.event == "motion") {
    latest_[message.event] = {++number_of_latest_, event_text("", message.event.c_str(), message.data)};
    written_.notify_all();
  } else {
    points_.push_back(message.data);
    add("point", message.data);
  }
  return true;
}

void Job::finish(const Message& message) {
  const std::scoped_lock lock(writing_);
  ended_ = true;
  if (message.data.value("stopped", false))
    add("stopped", {{"points", points_}});
  else if (message.payload.empty())
    add("failed", {{"code", message.data.at("code")}, {"errors", message.data.at("errors")}});
  else
    add("result", Json::parse(message.payload));
}

void Job::add(const char* event, const Json& data) {
  events_.push_back(event_text(fmt::format("id: {}\n", events_.size() + 1), event, data));
  written_.notify_all();
}

NewEvents Job::events(std::size_t from, std::size_t latest) {
  std::unique_lock lock(writing_);
  written_.wait_for(lock, patience,
                    [&] { return ended_ || events_.size() > from || number_of_latest_ != latest; });
  NewEvents found{{}, events_.size(), number_of_latest_, ended_};
  for (std::size_t i = std::min(from, events_.size()); i < events_.size(); ++i)
    found.texts.push_back(events_[i]);
  for (const auto& [name, one] : latest_)
    if (one.number > latest && !ended_) found.texts.push_back(one.text);
  return found;
}

bool Job::ended() {
  const std::scoped_lock lock(writing_);
  return ended_;
}

bool Job::has_points() {
  const std::scoped_lock lock(writing_);
  return !points_.empty();
}

fs::path temporary_folder() {
  std::string name = (fs::temp_directory_path() / "orbearing-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw ComputationFailed(fmt::format("{}: cannot be made: {}", name, std::strerror(errno)));
  return name;
}

Jobs::~Jobs() {
  end();
}

// Folder of the job that is continued, else a new one for a command that keeps points.
fs::path Jobs::folder_for(const Json& request) {
  if (request.contains("continue")) {
    const Json& name = request["continue"];
    const auto found = name.is_string() ? jobs_.find(name.get<std::string>()) : jobs_.end();
    if (found == jobs_.end() || !found->second->ended() || found->second->folder().empty())
      throw BadInput(fmt::format("request: continue: found {}; required: the job of a sweep that has ended",
                                 name.dump()));
    return found->second->folder();
  }
  const std::string command = request.at("command");
  if (command != "sweep" && command != "run" && command != "report") return {};
  if (temporary_.empty()) temporary_ = temporary_folder();
  return temporary_ / fmt::format("{}-{}", command, last_ + 1);
}

std::string Jobs::start(const Json& request, const fs::path& results) {
  const std::scoped_lock lock(naming_);
  const auto is_running = [](const auto& one) { return !one.second->ended(); };
  if (static_cast<std::size_t>(std::ranges::count_if(jobs_, is_running)) >= most_running)
    throw ComputationFailed(fmt::format("{} jobs run already; stop one of them", most_running));
  const fs::path folder = results.empty() ? folder_for(request) : results;
  Json asked = request;
  for (const char* key : {"continue", "results"}) asked.erase(key);
  if (!folder.empty()) asked["folder"] = folder.string();
  auto job = std::make_shared<Job>(workers_.fresh(), asked, folder);
  while (jobs_.size() >= most_kept + most_running) jobs_.erase(std::ranges::find_if_not(jobs_, is_running));
  const std::string name = fmt::format("{:04}", ++last_);
  jobs_[name] = std::move(job);
  return name;
}

std::shared_ptr<Job> Jobs::find(const std::string& name) {
  const std::scoped_lock lock(naming_);
  const auto found = jobs_.find(name);
  return found == jobs_.end() ? nullptr : found->second;
}

bool Jobs::running() {
  const std::scoped_lock lock(naming_);
  return std::ranges::any_of(jobs_, [](const auto& one) { return !one.second->ended(); });
}

std::vector<fs::path> Jobs::end() {
  const std::scoped_lock lock(naming_);
  for (const auto& [name, job] : jobs_) job->stop();
  std::vector<fs::path> kept;
  std::error_code ignored;
  for (const auto& [name, job] : jobs_) {
    while (!job->ended()) std::this_thread::sleep_for(patience / 10);
    if (temporary_.empty() || job->folder().parent_path() != temporary_ ||
        std::ranges::find(kept, job->folder()) != kept.end())
      continue;  // a folder that was opened stays
    if (job->has_points())
      kept.push_back(job->folder());
    else
      fs::remove_all(job->folder(), ignored);
  }
  jobs_.clear();
  if (!temporary_.empty() && kept.empty()) fs::remove_all(temporary_, ignored);
  temporary_.clear();
  return kept;
}

}  // namespace orbearing::page
