// The door of the engine for JavaScript: a request in, its answer out, both as text of JSON, as `orbearing
// open` takes and gives them; progress on the way.
#include <emscripten.h>

#include <fmt/format.h>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>

#include "mechanics/cancellation.hpp"
#include "orbearing/errors.hpp"
#include "orbearing/quantity.hpp"
#include "orbearing/request.hpp"

// engine_worker.js passes them on to the page.
EM_JS(void, tell_progress, (double done, double all, const char* doing),
      { Module.progress({done : done, all : all, doing : UTF8ToString(doing)}); });
EM_JS(void, tell_motion, (const char* event), { Module.motion(JSON.parse(UTF8ToString(event))); });

namespace {

using namespace orbearing;
using Json = nlohmann::ordered_json;

std::string failure(int code, const std::vector<std::string>& lines) {
  return Json{{"code", code}, {"errors", lines}}.dump();
}

Request request_of(const Json& asked) {
  Request request;
  request.command = asked.value("command", "");
  request.case_text = asked.value("case_text", "");
  request.settings = asked.value("settings", std::vector<std::string>{});
  if (asked.contains("options")) request.options = asked.at("options").dump();
  request.progress = [](std::size_t done, std::size_t all, const std::string& doing) {
    tell_progress(static_cast<double>(done), static_cast<double>(all), doing.c_str());
    return true;
  };
  request.motion = [](const std::string& motion) { tell_motion(motion.c_str()); };
  return request;
}

std::string computed(const Json& asked) {
  const Answer answer = orbearing::answer(request_of(asked));
  return fmt::format(R"({{"code": {}, "failures": {}, "result": {}}})", answer.code,
                     Json(answer.failures).dump(), answer.result);
}

// {"value": "3 mm", "unit": "um"} -> 3000
std::string converted(const Json& asked) {
  const std::string value = asked.value("value", ""), unit = asked.value("unit", "");
  const double number = in_unit(value, unit);
  return Json{{"code", 0}, {"result", {{"number", number}, {"text", fmt::format("{} {}", number, unit)}}}}
      .dump();
}

std::string answer_to(const char* text) {
  try {
    const Json asked = Json::parse(text);
    return asked.contains("unit") ? converted(asked) : computed(asked);
  } catch (const BadInput& error) {
    return failure(2, error.messages);
  } catch (const std::exception& error) {
    return failure(1, {error.what()});
  } catch (const Cancelled& wish) {
    return failure(1, {wish.what()});
  }
}

}  // namespace

/// The caller gives the answer back by free().
extern "C" char* orbearing_answer(const char* request) {
  return strdup(answer_to(request).c_str());
}
