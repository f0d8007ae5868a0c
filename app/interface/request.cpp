#include "orbearing/request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "app/case/case_file.hpp"
#include "app/commands/commands.hpp"
#include "app/options/option_json.hpp"
#include "app/results/progress.hpp"
#include "mechanics/cancellation.hpp"

namespace orbearing {

namespace {

using Json = nlohmann::ordered_json;

Json options_of(const Request& request) {
  Json options = Json::parse(request.options, nullptr, false);
  if (!options.is_object())
    throw BadInput("options: found " + request.options +
                   "; required: a JSON object of options by their names");
  for (const std::string& setting : request.settings) options["set"].push_back(setting);
  return options;
}

// Puts the file of the request's case, if it has one; a case in memory is read behind all options. Returns
// the names of options that the request gives so.
std::set<std::string> put_case(const Request& request, const app::OptionList& options, bool takes_given) {
  const bool in_memory = request.given || !request.case_text.empty();
  if (!in_memory && request.case_file.empty()) return {};
  const auto row = std::ranges::find_if(
      options, [](const app::Option& option) { return option.name == "CASE" || option.name == "--case"; });
  if (row == options.end())
    throw BadInput(fmt::format("{}: found a case; required: no case with this command", request.command));
  if (in_memory && !takes_given)
    throw BadInput(fmt::format("{}: found a case in memory; required: the file of a case", request.command));
  const std::string fault = in_memory ? std::string() : app::put_value(*row, request.case_file);
  if (!fault.empty()) throw BadInput(row->name + ": " + fault);
  return {row->name};
}

void read_case(const Request& request, app::StatedCase& stated) {
  if (request.given && !stated.settings.empty())
    throw BadInput("settings: found with a case that is read already; required: none");
  if (request.given)
    stated.given = request.given->content();
  else if (!request.case_text.empty())
    stated.given = app::parse_case(request.case_text, "case.yaml", stated.settings);
}

// The command with all that the request states.
app::CommandRequest command_of(const Request& request) {
  app::CommandRequest command = app::command_called(request.command);
  app::StatedCase* stated = app::stated_case(command);
  const app::OptionList options = app::option_list(command);
  app::put_json(options_of(request), options, put_case(request, options, stated != nullptr));
  if (stated != nullptr) read_case(request, *stated);
  return command;
}

}  // namespace

Answer answer(const Request& request) {
  app::CommandRequest command = command_of(request);
  app::Printing& print = app::printing_of(command);
  print.json = print.quiet = true;
  Answer answer{.result = "null"};
  print.to.result = [&](const Json& object) { answer.result = object.dump(); };
  print.to.failures = [&](const std::string& line) { answer.failures.push_back(line); };
  if (request.point) print.to.point = [&](const Json& row) { request.point(row.dump()); };
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
  Pace pace;
  std::optional<system::ObservedMotions> motions;
  if (request.motion)
    motions.emplace([&](const system::MotionProgress& now) {
      request.motion(app::motion_json(now, app::seconds_left(pace, now)).dump());
    });
  answer.code = app::execute(command);
  return answer;
}

}  // namespace orbearing
