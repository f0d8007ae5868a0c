// This file and connection.hpp alone name httplib: it is slow to compile.
#include "page/page_server.hpp"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <future>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "orbearing/case.hpp"
#include "orbearing/files.hpp"
#include "orbearing/text.hpp"
#include "page/connection.hpp"
#include "page/leading_page.hpp"

namespace orbearing::page {

namespace {

namespace fs = std::filesystem;
using httplib::Response;
using HttpRequest = httplib::Request;
using Clock = std::chrono::steady_clock;

constexpr std::size_t largest_body = 4U << 20U;  // [byte]
constexpr std::size_t largest_head = 1U << 16U;  // [byte]
constexpr int most_at_once = 8;                  // that compute, or are read as they compute
constexpr std::size_t threads = 48;  // of connections: more than compute, so that refusals are quick
constexpr int no_parts = 416;        // status without a content, of which the library would send parts
constexpr std::chrono::seconds request_limit{60};
constexpr std::chrono::seconds report_limit{600};
constexpr std::chrono::seconds heartbeat{5};

constexpr const char* policy =
    "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; worker-src 'self' "
    "blob:; "
    "script-src 'self' 'wasm-unsafe-eval'; frame-ancestors 'none'";

std::string random_token() {
  unsigned char bytes[16];
  if (getrandom(bytes, sizeof bytes, 0) != static_cast<ssize_t>(sizeof bytes))
    throw ComputationFailed("no random numbers for the token of the page");
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

// Takes the same time wherever they differ.
bool same(const std::string& one, const std::string& other) {
  unsigned difference = one.size() == other.size() ? 0U : 1U;
  for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i)
    difference |= static_cast<unsigned char>(one[i]) ^ static_cast<unsigned char>(other[i]);
  return difference == 0;
}

std::string cookie(const HttpRequest& asked, const std::string& name) {
  const std::string header = asked.get_header_value("Cookie");
  for (std::size_t begin = 0; begin < header.size();) {
    const std::size_t end = std::min(header.find(';', begin), header.size());
    const std::size_t first = header.find_first_not_of(' ', begin);
    if (first < end && header.compare(first, name.size() + 1, name + "=") == 0)
      return header.substr(first + name.size() + 1, end - first - name.size() - 1);
    begin = end + 1;
  }
  return {};
}

// Not compressed, as a content of known text would be: the library takes seconds for a megabyte.
void answer_text(Response& response, std::string text, const char* kind, int status = 200) {
  response.status = status;
  if (text.empty()) return response.set_content(text, kind);
  const auto shared = std::make_shared<const std::string>(std::move(text));
  response.set_content_provider(
      shared->size(), kind, [shared](std::size_t from, std::size_t length, httplib::DataSink& sink) {
        const std::string_view part = std::string_view(*shared).substr(from, length);
        return part.size() == length && sink.write(part.data(), length);
      });
}

void answer_json(Response& response, const Json& object, int status = 200) {
  answer_text(response, object.dump(-1, ' ', false, Json::error_handler_t::replace), "application/json",
              status);
}

void refuse_with(Response& response, int status, const std::string& reason) {
  answer_json(response, {{"error", reason}}, status);
}

void answer_failure(Response& response, int code, const Json& errors) {
  answer_json(response, {{"code", code}, {"errors", errors}}, code == 2 ? 422 : 500);
}

// Requests are shallow and have few keys. Deeper ones would overflow the stack where they are copied, and
// among many keys each one is searched for. Discarded where the text is no JSON.
Json parse_body(const std::string& text) {
  constexpr int deepest = 8;
  constexpr std::size_t most_keys = 200;
  std::size_t keys = 0;
  const auto bounded = [&](int depth, Json::parse_event_t event, const Json&) {
    if (depth > deepest)
      throw BadInput(
          fmt::format("request: found more than {} levels of objects and lists; required: fewer", deepest));
    if (event == Json::parse_event_t::key && ++keys > most_keys)
      throw BadInput(fmt::format("request: found more than {} keys; required: fewer", most_keys));
    return true;
  };
  return Json::parse(text, bounded, false);
}

const char* kind_of(const fs::path& file) {
  static const std::map<std::string, const char*> kinds{{".html", "text/html; charset=utf-8"},
                                                        {".css", "text/css; charset=utf-8"},
                                                        {".js", "text/javascript; charset=utf-8"},
                                                        {".mjs", "text/javascript; charset=utf-8"},
                                                        {".json", "application/json"},
                                                        {".svg", "image/svg+xml"},
                                                        {".png", "image/png"},
                                                        {".wasm", "application/wasm"},
                                                        {".woff2", "font/woff2"},
                                                        {".map", "application/json"}};
  const auto found = kinds.find(file.extension().string());
  return found == kinds.end() ? nullptr : found->second;
}

// No number of these names leads out of their folder.
bool is_plain_path(const std::string& path) {
  constexpr std::string_view within = "-.+/";
  bool begins = true;
  for (const char c : path) {
    const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    if (!letter && (begins || within.find(c) == std::string_view::npos)) return false;
    begins = c == '/';
  }
  return !begins;
}

// The first of the folders that holds the file.
void answer_file(Response& response, const std::vector<fs::path>& folders, const std::string& path) {
  const char* kind = kind_of(path);
  std::error_code ignored;
  for (const fs::path& folder : folders)
    if (kind != nullptr && is_plain_path(path) && fs::is_regular_file(folder / path, ignored)) {
      return answer_text(response, read_file(folder / path), kind);
    }
  refuse_with(response, 404, "there is no such file");
}

// A computation among those at once.
class Slot {
 public:
  explicit Slot(std::atomic<int>& taken) : taken_(taken), free_(++taken <= most_at_once) {}
  Slot(const Slot&) = delete;
  Slot& operator=(const Slot&) = delete;
  ~Slot() { --taken_; }
  explicit operator bool() const { return free_; }

 private:
  std::atomic<int>& taken_;
  bool free_;
};

// The pages that are open, by the names that they give themselves; other requests are one page without a
// name.
class Presence {
 public:
  explicit Presence(std::chrono::seconds linger) : linger_(linger) {}
  void sign(const std::string& page = {}) {
    const std::scoped_lock lock(writing_);
    last_ = Clock::now();
    seen_ = true;
    if (pages_.size() < most_pages) pages_[page] = last_;
  }
  void close(const std::string& page) {
    const std::scoped_lock lock(writing_);
    last_ = Clock::now();
    pages_.erase(page);
    pages_.erase("");
  }
  bool gone() {
    const std::scoped_lock lock(writing_);
    const Clock::time_point now = Clock::now();
    std::erase_if(pages_, [&](const auto& page) { return now - page.second > silent * linger_; });
    return seen_ && pages_.empty() && now - last_ > linger_;
  }

 private:
  static constexpr int silent = 3;  // browsers call pages in the background once a minute
  static constexpr std::size_t most_pages = 64;

  std::mutex writing_;
  std::chrono::seconds linger_;
  std::map<std::string, Clock::time_point> pages_;
  Clock::time_point last_;
  bool seen_ = false;
};

class PageServer {
 public:
  explicit PageServer(const PageSettings& settings)
      : settings_(settings),
        workers_(settings.worker, settings.opened.folder),
        jobs_(workers_),
        presence_(settings.linger),
        opened_(settings.opened),
        server_(largest_head + largest_body) {
    server_.new_task_queue = [] { return new httplib::ThreadPool(threads); };
    server_.set_payload_max_length(largest_body);
    server_.set_tcp_nodelay(true);
    // Without the default's SO_REUSEPORT, by which another program could share the port.
    server_.set_socket_options([](auto socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server_.set_pre_routing_handler(
        [this](const HttpRequest& asked, Response& response) { return admit(asked, response); });
    server_.set_post_routing_handler([](const HttpRequest&, Response& response) { add_headers(response); });
    server_.set_error_handler([](const HttpRequest&, Response& response) {
      if (response.body.empty() && !response.content_provider_ && response.status != no_parts)
        refuse_with(response, response.status, reason_of(response.status));
    });
    server_.set_exception_handler(
        [](const HttpRequest&, Response& response, const std::exception_ptr& failure) {
          answer_exception(response, failure);
        });
    add_routes();
  }

  std::vector<fs::path> serve() {
    bind();
    lives_of(settings_.opened);
    std::atomic<bool> left = false;
    std::thread listening([&] {
      server_.listen_after_bind();
      left = true;
    });
    const std::string address = fmt::format("http://127.0.0.1:{}/", port_);
    settings_.started(address + "?token=" + token_, address + "?once=" + once_);
    while (!settings_.interrupted() && (!presence_.gone() || jobs_.running()))
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    ending_ = true;
    // A server that does not listen yet would not notice that it is stopped.
    while (!server_.is_running() && !left) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    server_.stop();
    listening.join();
    return jobs_.end();
  }

 private:
  void bind() {
    const bool bound = settings_.port == 0 ? (port_ = server_.bind_to_any_port("127.0.0.1")) > 0
                                           : server_.bind_to_port("127.0.0.1", port_ = settings_.port);
    if (!bound)
      throw ComputationFailed(
          fmt::format("--port: {} is taken or may not be used; give another one, or none for a free one",
                      settings_.port));
    cookie_ = fmt::format("orbearing_token_{}", port_);
    for (const char* host : {"127.0.0.1", "localhost"}) hosts_.push_back(fmt::format("{}:{}", host, port_));
  }

  static const char* reason_of(int status) {
    switch (status) {
      case 404:
        return "there is no such address";
      case 413:
        return "larger than 4 MiB";
      case 414:
        return "an address that is too long";
      default:
        return "a request that cannot be read";
    }
  }

  static void add_headers(Response& response) {
    response.set_header("Cache-Control", "no-store");
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("Referrer-Policy", "no-referrer");
    response.set_header("Content-Security-Policy", policy);
  }

  static void answer_exception(Response& response, const std::exception_ptr& failure) {
    try {
      std::rethrow_exception(failure);
    } catch (const BadInput& error) {
      Json errors = Json::array();
      for (const std::string& line : error.messages) errors.push_back(printable(line));
      answer_failure(response, 2, errors);
    } catch (const std::exception& error) {
      answer_failure(response, 1, {printable(error.what())});
    }
  }

  bool is_own(const std::string& host) const { return std::ranges::find(hosts_, host) != hosts_.end(); }

  // Browsers send cookies to all ports of a host, but to the paths of the cookie alone: this one is secret.
  bool is_allowed(const HttpRequest& asked) {
    if (same(asked.get_param_value("token"), token_) ||
        same(asked.get_header_value("X-Orbearing-Token"), token_))
      return true;
    if (asked.path.starts_with(home_ + "/") && same(cookie(asked, cookie_), ticket_)) return true;
    return is_entry(asked) && same(asked.get_param_value("once"), once_) && !entered_.exchange(true);
  }

  static bool is_entry(const HttpRequest& asked) {
    return asked.method == "GET" && asked.path == "/" && asked.has_param("once");
  }

  // Before anything of a body is read.
  httplib::Server::HandlerResponse admit(const HttpRequest& asked, Response& response) {
    const auto refused = [&](int status, const char* reason) {
      refuse_with(response, status, reason);
      return httplib::Server::HandlerResponse::Handled;
    };
    if (asked.has_header("Range")) {
      response.status = no_parts;
      return httplib::Server::HandlerResponse::Handled;
    }
    const std::string origin = asked.get_header_value("Origin");
    if (asked.get_header_value_count("Host") != 1 || !is_own(asked.get_header_value("Host")))
      return refused(403, "another host than that of the page");
    if (asked.has_header("Origin") && (!origin.starts_with("http://") || !is_own(origin.substr(7))))
      return refused(403, "from another origin than the page");
    if (!is_allowed(asked)) return refused(403, "without the token of the page's address");
    if (asked.method != "GET" && asked.method != "HEAD" && asked.method != "POST" && asked.method != "DELETE")
      return refused(405, "another method than GET, POST and DELETE");
    if (asked.has_header("Transfer-Encoding") ||
        (asked.method == "POST" && asked.get_header_value_count("Content-Length") != 1))
      return refused(411, "without one Content-Length");
    if (asked.has_header("Content-Encoding")) return refused(415, "a body that is compressed");
    if (asked.is_multipart_form_data()) return refused(415, "a form; required: JSON");
    if (!asked.path.ends_with("/closed")) presence_.sign(asked.get_param_value("page"));
    return httplib::Server::HandlerResponse::Unhandled;
  }

  // Below the path of the page, where its cookie is valid, as without it.
  std::string at(const char* path) const { return "(?:" + home_ + ")?" + path; }

  void add_routes() {
    server_.Get(at("/"),
                [this](const HttpRequest& asked, Response& response) { answer_document(asked, response); });
    server_.Get(at("/web/(.+)"), [this](const HttpRequest& asked, Response& response) {
      answer_file(response, {settings_.files}, asked.matches[1]);
    });
    // Copied beside the page, as in a wheel, or where packages of Debian put them.
    server_.Get(at("/lib/(.+)"), [this](const HttpRequest& asked, Response& response) {
      answer_file(response, {settings_.files / "lib", "/usr/share/javascript"}, asked.matches[1]);
    });
    server_.Get(at("/schema/(case|result)"), [this](const HttpRequest& asked, Response& response) {
      answer_file(response, {settings_.schemas}, asked.matches[1].str() + ".schema.json");
    });
    // By `results` a folder of results within the one that was opened.
    server_.Get(at("/opened"), [this](const HttpRequest& asked, Response& response) {
      answer_json(
          response,
          opened_json(asked.has_param("results")
                          ? read_again(results_within(settings_.opened, asked.get_param_value("results")))
                          : opened_now()));
    });
    server_.Get(at("/folders"), [this](const HttpRequest&, Response& response) {
      answer_json(response, result_folders_json(settings_.opened));
    });
    server_.Get(at("/templates"),
                [](const HttpRequest&, Response& response) { answer_json(response, templates_json()); });
    server_.Get(at("/jobs/([0-9]+)/events"),
                [this](const HttpRequest& asked, Response& response) { answer_events(asked, response); });
    server_.Delete(at("/jobs/([0-9]+)"),
                   [this](const HttpRequest& asked, Response& response) { stop_job(asked, response); });
    post("/request", &PageServer::answer_request);
    post("/jobs", &PageServer::start_job);
    post("/report", &PageServer::answer_report);
    post("/units", &PageServer::answer_units);
    post("/save", &PageServer::answer_save);
    server_.Post(at("/alive"),
                 [](const HttpRequest&, Response& response) { answer_json(response, Json::object()); });
    server_.Post(at("/closed"), [this](const HttpRequest& asked, Response& response) {
      presence_.close(asked.get_param_value("page"));
      answer_json(response, Json::object());
    });
  }

  using Answering = void (PageServer::*)(const HttpRequest&, const Json& body, Response&);

  void post(const char* path, Answering answering) {
    server_.Post(at(path), [this, answering](const HttpRequest& asked, Response& response) {
      const Json body = parse_body(asked.body);
      if (body.is_discarded()) return refuse_with(response, 400, "a body that is no JSON");
      (this->*answering)(asked, body, response);
    });
  }

  // The opened file, with its present text.
  Opened opened_now() {
    const std::scoped_lock lock(reading_file_);
    return opened_ = read_again(opened_);
  }

  void give_cookie(Response& response) const {
    response.set_header("Set-Cookie",
                        fmt::format("{}={}; HttpOnly; SameSite=Strict; Path={}/", cookie_, ticket_, home_));
  }

  // A browser that comes from another site, as the file that leads here is one, sends no cookie along: this
  // page leads on from its own.
  void answer_entry(Response& response) const {
    give_cookie(response);
    answer_text(response, leading_to(home_ + "/"), "text/html; charset=utf-8");
  }

  void answer_document(const HttpRequest& asked, Response& response) {
    if (is_entry(asked)) return answer_entry(response);
    const Opened now = opened_now();
    std::string page = read_file(settings_.files / "index.html"), opened = opened_json(now).dump();
    for (const std::string attribute : {"href", "src"}) {
      const std::string relative = attribute + "=\"web/";
      for (std::size_t at = 0; (at = page.find(relative, at)) != std::string::npos; at += relative.size())
        page.insert(at + attribute.size() + 2, home_ + "/");
    }
    for (std::size_t at = 0; (at = opened.find('<', at)) != std::string::npos;)
      opened.replace(at, 1, "\\u003c");
    const std::string mark = "<!--orbearing:opened-->";
    if (const std::size_t at = page.find(mark); at != std::string::npos)
      page.replace(
          at, mark.size(),
          lives_of(now).get() + "<script type=\"application/json\" id=\"opened\">" + opened + "</script>");
    if (asked.has_param("token")) give_cookie(response);
    answer_text(response, std::move(page), "text/html; charset=utf-8");
  }

  // Computed while the page is loaded, and anew where the text is another.
  std::shared_future<std::string> lives_of(const Opened& opened) {
    const std::scoped_lock lock(reading_file_);
    if (!lives_.valid() || lives_text_ != opened.text) {
      lives_text_ = opened.text;
      lives_ = std::async(std::launch::async, [this, opened] { return computed_lives(opened); });
    }
    return lives_;
  }

  // Table of lives of models that have some: a signal or a film would be computed in vain.
  std::string computed_lives(const Opened& opened) try {
    if (opened.text.empty()) return {};
    const std::string model = Case::parse(opened.text).text("model");
    Json request{{"command", "run"}, {"case_text", opened.text}};
    if (model == "planetary-drivetrain" || model == "ball-bearing")
      request["options"] = {{"fidelity", "quasi-static"}};
    else if (model != "roller-bearing")
      return no_lives("a case of the model " + model + " has none");
    constexpr std::chrono::seconds limit{10};
    const Message message = answer_within(workers_, request, limit, ending_);
    if (message.payload.empty()) return no_lives(message.data.at("errors").at(0));
    return lives_table(opened, Json::parse(message.payload));
  } catch (const std::exception& error) {
    return no_lives(error.what());
  }

  void answer_request(const HttpRequest&, const Json& body, Response& response) {
    require_sound_request(body);
    const Slot slot(computing_);
    if (!slot) return refuse_with(response, 429, "more than 8 requests at once");
    answer_computed(body, request_limit, "application/json", response);
  }

  void answer_computed(const Json& request, std::chrono::seconds limit, const char* kind,
                       Response& response) {
    Message message = answer_within(workers_, request, limit, ending_);
    const Json& code = message.data.at("code");
    if (message.payload.empty()) return answer_failure(response, code, message.data.at("errors"));
    response.set_header("X-Orbearing-Code", code.dump());
    answer_text(response, std::move(message.payload), kind);
  }

  void start_job(const HttpRequest&, const Json& body, Response& response) {
    require_sound_request(body, {"continue", "results"});
    try {
      answer_json(response, {{"job", jobs_.start(body, folder_of_results(body))}}, 202);
    } catch (const ComputationFailed& error) {
      refuse_with(response, 429, error.what());
    }
  }

  // Folder whose sweep is continued; empty: none.
  fs::path folder_of_results(const Json& body) const {
    if (!body.contains("results")) return {};
    const Json& name = body["results"];
    if (!name.is_string() || body.contains("continue") || body.at("command") != "sweep")
      throw BadInput(
          "request: results: found no name, or another command than sweep, or continue; required: the name "
          "of a folder whose sweep is continued");
    return results_within(settings_.opened, name.get<std::string>()).folder;
  }

  void stop_job(const HttpRequest& asked, Response& response) {
    const std::shared_ptr<Job> job = jobs_.find(asked.matches[1]);
    if (!job) return refuse_with(response, 404, "there is no such job");
    job->stop();
    answer_json(response, Json::object());
  }

  // A reader that was cut off continues behind the last event it has.
  static std::size_t last_event(const HttpRequest& asked) {
    const std::string last = asked.get_header_value("Last-Event-ID");
    const bool number = !last.empty() && last.size() < 10 &&
                        std::ranges::all_of(last, [](char c) { return c >= '0' && c <= '9'; });
    return number ? std::stoul(last) : 0;
  }

  struct Reading {
    std::shared_ptr<Job> job;
    Job::Reader reader;
    Slot slot;
    std::size_t next;
    std::size_t latest = 0;
    Clock::time_point spoke = Clock::now();

    Reading(std::shared_ptr<Job> read, std::atomic<int>& taken, std::size_t from)
        : job(std::move(read)), reader(*job), slot(taken), next(from) {}
  };

  void answer_events(const HttpRequest& asked, Response& response) {
    const std::shared_ptr<Job> job = jobs_.find(asked.matches[1]);
    if (!job) return refuse_with(response, 404, "there is no such job");
    auto reading = std::make_shared<Reading>(job, reading_, last_event(asked));
    if (!reading->slot) return refuse_with(response, 429, "more than 8 readers at once");
    response.status = 200;
    response.set_chunked_content_provider(
        "text/event-stream",
        [this, reading](std::size_t, httplib::DataSink& sink) { return tell_events(*reading, sink); });
  }

  bool tell_events(Reading& reading, httplib::DataSink& sink) {
    if (ending_ || !sink.is_writable()) return false;
    presence_.sign();
    const NewEvents found = reading.job->events(reading.next, reading.latest);
    std::string text;
    for (const std::string& one : found.texts) text += one;
    if (text.empty() && Clock::now() - reading.spoke > heartbeat) text = ":\n\n";
    if (!text.empty()) {
      reading.spoke = Clock::now();
      if (!sink.write(text.data(), text.size())) return false;
    }
    reading.next = found.next;
    reading.latest = found.latest;
    if (found.ended) sink.done();
    return true;
  }

  // Report of a case, over its speeds or (of=point) at one operating point, or of a job's results. As HTML it
  // is text: the page shows it in a frame that runs no script.
  void answer_report(const HttpRequest& asked, const Json& body, Response& response) {
    const bool pdf = asked.get_param_value("form") == "pdf";
    const char* kind = pdf ? "application/pdf" : "text/plain; charset=utf-8";
    const std::string of = asked.get_param_value("of");
    if (!of.empty() && of != "point" && of != "speeds")
      return refuse_with(response, 400, "of=: a report is of the point or of the speeds");
    Json request{{"command", "report"}, {"pdf", pdf}, {"of_point", of == "point"}};
    const Slot slot(computing_);
    if (!slot) return refuse_with(response, 429, "more than 8 requests at once");
    if (body.is_object() && body.contains("job")) {
      const std::shared_ptr<Job> job =
          jobs_.find(body["job"].is_string() ? body["job"].get<std::string>() : "");
      if (!job || !job->ended() || job->folder().empty())
        return refuse_with(response, 404, "there is no such job with results");
      request["folder"] = job->folder().string();
      return answer_computed(request, report_limit, kind, response);
    }
    Json swept = body;
    if (swept.is_object()) swept["command"] = "sweep";
    require_sound_request(swept);
    const TemporaryFolder folder;
    swept.update(request);
    swept["folder"] = (folder.path / "results").string();
    answer_computed(swept, report_limit, kind, response);
  }

  struct TemporaryFolder {
    fs::path path = temporary_folder();
    TemporaryFolder() = default;
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
  };

  void answer_units(const HttpRequest&, const Json& body, Response& response) {
    answer_json(response, converted(body));
  }

  void answer_save(const HttpRequest&, const Json& body, Response& response) {
    if (settings_.opened.folder.empty())
      return refuse_with(response, 409, "no folder was opened: download the file");
    const auto is_text = [&](const char* key) { return body.contains(key) && body[key].is_string(); };
    if (!body.is_object() || !is_text("file") || !is_text("text") ||
        body.size() != (is_text("checksum") ? 3U : 2U))
      throw BadInput("request: found another object; required: the texts file and text, and checksum");
    try {
      put_file(body["file"], body["text"],
               body.contains("checksum") ? std::optional<std::string>(body["checksum"]) : std::nullopt);
      answer_json(response,
                  {{"file", body["file"]}, {"checksum", checksum(body["text"].get<std::string>())}});
    } catch (const OtherVersion& other) {
      const std::string fault = fmt::format(
          "{}: found another content than the one that this change began with; nothing was written. "
          "Read it again, or save under another name",
          printable(body["file"].get<std::string>()));
      answer_json(response, {{"errors", {fault}}, {"checksum", other.now}}, 409);
    }
  }

  // Without a stated version, the one that the program read last is used.
  void put_file(const std::string& file, const std::string& text,
                const std::optional<std::string>& began_with) {
    const std::scoped_lock lock(reading_file_);
    save(opened_, file, text, began_with.value_or(file == opened_.file ? checksum(opened_.text) : ""));
    if (file == opened_.file) opened_ = read_again(opened_);
  }

  const PageSettings& settings_;
  const std::string token_ = random_token();   // printed for the program's owner
  const std::string once_ = random_token();    // for the browser that is opened
  const std::string ticket_ = random_token();  // of the cookie
  const std::string home_ = "/page-" + random_token();
  std::atomic<bool> entered_ = false;  // the token of one use was used
  int port_ = 0;
  std::string cookie_;
  std::vector<std::string> hosts_;
  Workers workers_;
  Jobs jobs_;
  Presence presence_;
  std::atomic<bool> ending_ = false;
  std::atomic<int> computing_ = 0, reading_ = 0;
  std::mutex reading_file_;
  Opened opened_;  // as it was read last
  std::string lives_text_;
  std::shared_future<std::string> lives_;
  Server server_;
};

}  // namespace

std::vector<fs::path> serve_page(const PageSettings& settings) {
  return PageServer(settings).serve();
}

}  // namespace orbearing::page
