#include "orbearing/request.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/case/case_file.hpp"
#include "app/commands/command_line.hpp"
#include "app/results/progress.hpp"
#include "mechanics/cancellation.hpp"

namespace orbearing {

namespace {

using Json = nlohmann::ordered_json;

std::string word_of(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

void add_option(const std::string& name, const Json& value, std::vector<std::string>& words) {
  if (value.is_null() || value == false) return;
  if (value.is_array()) {
    for (const Json& one : value) add_option(name, one, words);
    return;
  }
  if (name == "folders") {
    words.push_back(word_of(value));
    return;
  }
  std::string option = "--" + name;
  std::replace(option.begin(), option.end(), '_', '-');
  const std::string word = word_of(value);
  if (word.empty()) throw BadInput(option + ": found an empty text; required: a value");
  words.push_back(option + "=" + word);
}

// The same as a user would type it.
std::vector<std::string> words_of(const Request& request) {
  std::vector<std::string> words{request.command};
  if (request.given || !request.case_text.empty())
    words.push_back("case.yaml");  // name of the case in memory
  else if (!request.case_file.empty())
    words.push_back(request.case_file);
  for (const std::string& setting : request.settings) words.push_back("--set=" + setting);
  const Json options = Json::parse(request.options, nullptr, false);
  if (!options.is_object())
    throw BadInput("options: found " + request.options +
                   "; required: a JSON object of options by their names");
  for (const auto& [name, value] : options.items()) add_option(name, value, words);
  return words;
}

}  // namespace

Answer answer(const Request& request) {
  app::Asked asked = app::asked_by(words_of(request));
  app::Options& options = asked.options;
  options.json = options.quiet = true;
  if (request.given)
    options.given = request.given->content();
  else if (!request.case_text.empty())
    options.given = app::parse_case(request.case_text, "case.yaml", request.settings);
  Answer answer{.result = "null"};
  options.take_result = [&](const Json& object) { answer.result = object.dump(); };
  options.take_failures = [&](const std::string& line) { answer.failures.push_back(line); };
  if (request.point)
    options.take_point = [&](const nlohmann::ordered_json& row) { request.point(row.dump()); };
  struct Stop {
    bool wished = false;
    ~Stop() {
      if (wished) clear_stop();  // it was for this request alone
    }
  } stop;
  app::ProgressObserver observer;
  if (request.progress)
    observer = [&](std::size_t done, std::size_t all, const std::string& doing) {
      if (request.progress(done, all, doing)) return;
      stop.wished = true;
      request_stop();
    };
  const app::ObservedProgress observed(std::move(observer));
  app::Pace pace;
  std::optional<system::ObservedMotions> motions;
  if (request.motion)
    motions.emplace([&](const system::MotionProgress& now) {
      request.motion(app::motion_json(now, pace.seconds_left(now)).dump());
    });
  answer.code = asked.command(options);
  return answer;
}

}  // namespace orbearing
