#include "orbearing/c_interface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "app/case/case_file.hpp"
#include "app/case/catalogue_warnings.hpp"
#include "app/case/check_table.hpp"
#include "app/case/field_table.hpp"
#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/command_line.hpp"
#include "app/errors.hpp"
#include "app/interface/points.hpp"
#include "app/resources.hpp"
#include "app/results/progress.hpp"
#include "app/results/record_writers.hpp"
#include "app/study/analysis.hpp"
#include "app/version.hpp"
#include "mechanics/cancellation.hpp"
#include "orbearing/participant.hpp"
#include "orbearing/request.hpp"
#include "orbearing/sweep.hpp"
#include "orbearing/table.hpp"
#include "orbearing/text.hpp"

struct orbearing_case {
  orbearing::Case of;
  orbearing::app::CaseSource source{};  // without a text where the case was made of another one
};

struct orbearing_machine {
  orbearing::Participant of;
};

struct orbearing_table {
  orbearing::Table of;
};

namespace {

using namespace orbearing;
using Json = nlohmann::ordered_json;

// Memory of the caller, who gives it back to orbearing_free().
template <class Value>
Value* copied(const Value* from, std::size_t count) {
  auto* const copy = static_cast<Value*>(std::malloc(std::max(count, std::size_t{1}) * sizeof(Value)));
  if (copy == nullptr) throw std::bad_alloc();
  std::copy_n(from, count, copy);
  return copy;
}

char* text(const std::string& of) {
  return copied(of.c_str(), of.size() + 1);
}

// Names of files may hold other bytes than UTF-8.
char* text(const Json& of) {
  return text(of.dump(-1, ' ', false, Json::error_handler_t::replace));
}

char* failure(const char* kind, const std::vector<std::string>& messages) {
  return text(Json{{"kind", kind}, {"messages", messages}});
}

// No exception leaves a function of C.
template <class Call>
char* failure_of(const Call& call) {
  try {
    call();
    return nullptr;
  } catch (const BadInput& error) {
    return failure("input", error.messages);
  } catch (const Interrupted& error) {
    return failure("interrupted", {error.what()});
  } catch (const Cancelled& wish) {
    return failure("interrupted", {wish.what()});
  } catch (const ComputationFailed& error) {
    return failure("computation", {error.what()});
  } catch (const std::exception& error) {
    return failure("other", {error.what()});
  }
}

using Pairs = std::vector<std::pair<std::string, std::string>>;

app::CaseSource source_from(const Json& stated) {
  if (stated.contains("file")) return app::source_of(stated.at("file"));
  app::CaseSource source{.name = stated.value("name", "case"), .text = stated.at("text")};
  const Json files = stated.value("files", Json::object());  // items() refers to it
  for (const auto& [name, file] : files.items()) source.files[name] = {file.at(0), file.at(1)};
  return source;
}

orbearing_case case_from(const Json& stated) {
  std::vector<std::string> settings, paths;
  for (const auto& [path, value] : stated.value("settings", Pairs{})) {
    settings.push_back(path + "=" + value);
    paths.push_back(path);
  }
  app::CaseSource source = source_from(stated);
  app::ResolvedCase resolved = app::parse_case(source, settings);
  // An input that another one replaces would read back as another value.
  const std::vector<std::string> replaced = app::replaced_inputs(resolved, paths);
  if (stated.value("as_set", false) && !replaced.empty()) throw BadInput(replaced);
  return {Case(std::move(resolved)), std::move(source)};
}

// From which the same case is read where its files are not.
Json source_json(const app::CaseSource& source) {
  Json files = Json::object();
  for (const auto& [name, file] : source.files) files[name] = Json::array({file.name, file.text});
  return {{"name", source.name}, {"text", source.text}, {"files", files}};
}

// Varied inputs without effect, with a message each.
Json without_effect(const app::ResolvedCase& stated, const Json& query) {
  const std::string fidelity = query.value("fidelity", "");
  const app::Analysis* analysis = app::analysis_of(stated, fidelity);
  return app::varied_without_effect(
      stated, analysis != nullptr ? analysis->used : app::rung_of(stated, fidelity), query.at("paths"));
}

std::vector<app::Setting> settings_of(const Json& rows) {
  std::vector<app::Setting> settings;
  for (const Json& row : rows) {
    const Json& value = row.at(1);
    if (value.is_number())
      settings.push_back({row.at(0), "", value.get<double>()});
    else
      settings.push_back({row.at(0), value.get<std::string>()});
  }
  return settings;
}

app::Input input_at(const app::ResolvedCase& stated, const std::string& path) {
  const std::vector<app::Input>& inputs = stated.inputs();
  const auto found = std::ranges::find(inputs, path, &app::Input::path);
  if (found != inputs.end()) return *found;
  std::vector<std::string> known;
  for (const app::Input& input : inputs) known.push_back(input.path);
  const std::string near = app::nearest_word(path, known);
  throw BadInput(fmt::format(
      "{}: {}: found a path that this case does not have{}; required: the path of a value of the case",
      stated.file(), path, near.empty() ? "" : " (did you mean '" + near + "'?)"));
}

Json value_of(const app::ResolvedCase& stated, const app::Input& input) {
  app::Record record;
  app::describe_value(record, stated, input);
  return app::json_of(record).at("value");
}

Json in_si(const app::Input& input, const Json& text) {
  if (text.is_array()) {
    Json numbers = Json::array();
    for (const Json& one : text) numbers.push_back(in_si(input, one));
    return numbers;
  }
  const app::FieldReading reading = app::read_field_text(*input.field, text.get<std::string>());
  if (!reading.good)
    throw BadInput(fmt::format("{}: {}; {}", input.path, reading.message.found, reading.message.required));
  return reading.value.number;
}

Json units_of(const std::string& path) {
  const app::Field* field = app::find_field(path);
  if (field == nullptr) return nullptr;
  Json columns = Json::array();
  for (const app::ListColumn& column : field->columns)
    columns.push_back(Json::array({app::column_key(column), column.dimension.si}));
  return Json::array({field->dimension.si, columns});
}

Json input_row(const app::ResolvedCase& stated, const app::Input& input) {
  constexpr std::array kinds{"quantity", "integer", "number", "flag", "choice", "text", "list"};
  const auto& [path, field] = input;
  const bool given = stated.has(path);
  const auto reason = stated.assumed().find(path);
  const bool has_reason = reason != stated.assumed().end();
  return {{"path", path},
          {"kind", kinds.at(static_cast<std::size_t>(field->kind))},
          {"unit", field->dimension.customary},
          {"si_unit", field->dimension.si},
          {"meaning", field->meaning},
          {"given", given ? Json(stated.given(path)) : Json()},
          {"source", !given                             ? "absent"
                     : stated.origin(path) == "default" ? "default"
                     : has_reason                       ? "assumed"
                                                        : "given"},
          {"reason", has_reason ? reason->second : ""}};
}

// Answer for one input of the case.
Json answer_of(const app::ResolvedCase& stated, const std::string& of, const app::Input& input,
               const Json& query) {
  if (of == "si") return in_si(input, query.at("text"));
  if (!stated.has(input.path)) return nullptr;
  return of == "given" ? Json(stated.given(input.path)) : value_of(stated, input);
}

Json answer_of(const orbearing_case* stated, const Json& query) {
  const std::string of = query.at("of"), path = query.value("path", "");
  if (of == "si_units") return units_of(path);
  if (stated == nullptr) throw std::logic_error("no case was given");
  const app::ResolvedCase& content = stated->of.content();
  if (of == "name") return content.text("name");
  if (of == "model") return content.choice("model");
  if (of == "file") return content.file();
  if (of == "source") return source_json(stated->source);
  if (of == "without_effect") return without_effect(content, query);
  if (of == "stated_beside_designation") return app::stated_beside_designation(content, query.at("paths"));
  if (of == "hash") return app::case_hash(content);
  if (of == "resolved") return stated->of.resolved();
  if (of == "value" || of == "given" || of == "si")
    return answer_of(content, of, input_at(content, path), query);
  if (of != "inputs" && of != "axes") throw std::logic_error("unknown query: " + of);
  Json rows = of == "axes" ? Json::object() : Json::array();
  if (of == "axes")
    for (const app::SweepAxis& axis : content.axes()) rows[axis.path] = axis.values;
  else
    for (const app::Input& input : content.inputs()) rows.push_back(input_row(content, input));
  return rows;
}

Json port_rows(const std::vector<Port>& ports) {
  Json rows = Json::array();
  for (const Port& one : ports) rows.push_back(Json::array({one.name, one.unit, one.meaning}));
  return rows;
}

// Now and then: a caller of another language may need longer for a call than a point takes.
std::function<void(std::size_t)> seldom(orbearing_progress progress, std::size_t all, void* caller) {
  using Clock = std::chrono::steady_clock;
  if (progress == nullptr) return {};
  return [=, last = Clock::now()](std::size_t done) mutable {
    const Clock::time_point now = Clock::now();
    if (now - last < std::chrono::milliseconds(50)) return;
    last = now;
    if (progress(done, all, "", caller) != 0) request_stop();  // until the end of the Interruption
  };
}

void give(const std::vector<double>& numbers, double** values, std::size_t* count) {
  *values = copied(numbers.data(), numbers.size());
  *count = numbers.size();
}

}  // namespace

extern "C" {

const char* orbearing_version() {
  return app::program_version.data();
}

const char* orbearing_instruction_set() {
  return app::instruction_set.data();
}

void orbearing_free(void* memory) {
  std::free(memory);
}

char* orbearing_use_python(const char* interpreter, const char* package) {
  return failure_of([&] { app::use_resources({app::resources().folder, package, interpreter}); });
}

int orbearing_command_line(int count, char** words) {
  return app::run_command_line(count, words);
}

char* orbearing_case_read(const char* stated, orbearing_case** found) {
  return failure_of([&] { *found = new orbearing_case(case_from(Json::parse(stated))); });
}

char* orbearing_case_with(const orbearing_case* from, const char* settings, orbearing_case** found) {
  return failure_of([&] {
    *found = new orbearing_case{Case(from->of.content().with(settings_of(Json::parse(settings))))};
  });
}

char* orbearing_case_without_sweep(const orbearing_case* from, orbearing_case** found) {
  return failure_of([&] { *found = new orbearing_case{Case(from->of.content().without_sweep())}; });
}

void orbearing_case_delete(orbearing_case* stated) {
  delete stated;
}

char* orbearing_case_query(const orbearing_case* stated, const char* query, char** result) {
  return failure_of([&] { *result = text(answer_of(stated, Json::parse(query))); });
}

char* orbearing_request(const orbearing_case* stated, const char* request, orbearing_progress progress,
                        void* caller, char** result, char** failures) {
  return failure_of([&] {
    const Json asked = Json::parse(request);
    Request wanted{.command = asked.at("command"), .options = asked.value("options", Json::object()).dump()};
    if (stated != nullptr) wanted.given = stated->of;
    if (progress != nullptr)
      wanted.progress = [=](std::size_t done, std::size_t all, const std::string& doing) {
        return progress(done, all, doing.c_str(), caller) == 0;
      };
    const app::Interruption interruption;
    const Answer found = answer(wanted);
    *failures = text(Json(found.failures));
    *result = text(found.result);
  });
}

char* orbearing_evaluate(const orbearing_case* stated, const char* request, const double* values,
                         std::size_t count, orbearing_progress progress, void* caller, char** result,
                         double** table) {
  return failure_of([&] {
    const Json asked = Json::parse(request);
    const std::vector<std::string> paths = asked.at("paths");
    const app::Interruption interruption;
    const Points found = evaluate(
        stated->of, paths, {values, values + count * paths.size()}, asked.value("fidelity", "quasi-static"),
        asked.value("jobs", 0), seldom(progress, count, caller),
        asked.value("without_effect", false) ? WithoutEffect::allowed : WithoutEffect::refused);
    *result = text(Json{{"columns", found.columns}, {"status", found.status}});
    *table = copied(found.numbers.data(), found.numbers.size());
  });
}

char* orbearing_table_read(const char* file, orbearing_table** found) {
  return failure_of([&] { *found = new orbearing_table{Table::read(file)}; });
}

void orbearing_table_delete(orbearing_table* table) {
  delete table;
}

char* orbearing_table_case(const orbearing_table* table, orbearing_case** found) {
  return failure_of([&] { *found = new orbearing_case{table->of.stated()}; });
}

char* orbearing_table_content(const orbearing_table* table, char** result) {
  return failure_of([&] {
    Json inputs = Json::array();
    for (const TableInput& one : table->of.inputs())
      inputs.push_back(Json::array({one.path, one.from, one.to}));
    *result = text(Json{{"results", table->of.results()}, {"inputs", inputs}, {"bound", table->of.bound()}});
  });
}

char* orbearing_table_answers(const orbearing_table* table, const char* request, const double* values,
                              std::size_t count, double** answers, char** failures) {
  return failure_of([&] {
    const Json asked = Json::parse(request);
    TableQuery query{.compute = asked.at("compute"), .jobs = asked.at("jobs")};
    if (!asked.at("bound").is_null()) query.bound = asked.at("bound");
    const app::Interruption interruption;
    const TableAnswers found =
        table->of.answers(asked.at("result"), {values, values + count * table->of.inputs().size()}, query);
    std::vector<double> rows;
    for (std::size_t i = 0; i < count; ++i)
      rows.insert(rows.end(), {found.values[i], found.errors[i], found.computed[i] != 0 ? 1.0 : 0.0});
    *failures = text(
        Json(std::vector<std::pair<std::size_t, std::string>>(found.failures.begin(), found.failures.end())));
    *answers = copied(rows.data(), rows.size());
  });
}

char* orbearing_machine_make(const orbearing_case* stated, const char* model, orbearing_machine** made) {
  return failure_of([&] {
    const std::string of = model;
    if (of != "bearing" && of != "gearset")
      throw BadInput("model: found '" + printable(of) + "'; required: bearing or gearset");
    *made = new orbearing_machine{of == "gearset" ? Participant::gearset(stated->of)
                                                  : Participant::bearing(stated->of)};
  });
}

void orbearing_machine_delete(orbearing_machine* machine) {
  delete machine;
}

char* orbearing_machine_ports(const orbearing_machine* machine, char** result) {
  return failure_of([&] {
    *result = text(
        Json{{"inputs", port_rows(machine->of.inputs())}, {"outputs", port_rows(machine->of.outputs())}});
  });
}

char* orbearing_machine_set_input(orbearing_machine* machine, const char* name, double value,
                                  const double* slope) {
  return failure_of(
      [&] { machine->of.set_input(name, value, slope != nullptr ? std::optional(*slope) : std::nullopt); });
}

char* orbearing_machine_input(const orbearing_machine* machine, const char* name, double* value) {
  return failure_of([&] { *value = machine->of.input(name); });
}

char* orbearing_machine_initialize(orbearing_machine* machine, double time) {
  return failure_of([&] { machine->of.initialize(time); });
}

char* orbearing_machine_advance(orbearing_machine* machine, double length) {
  return failure_of([&] {
    constexpr double long_step = 1e-3;  // [s]  a caller may stop longer ones by Ctrl-C
    std::optional<app::Interruption> interruption;
    if (length > long_step) interruption.emplace();
    machine->of.advance(length);
  });
}

char* orbearing_machine_output(orbearing_machine* machine, const char* name, double* value) {
  return failure_of([&] { *value = machine->of.output(name); });
}

char* orbearing_machine_outputs(orbearing_machine* machine, double** values, std::size_t* count) {
  return failure_of([&] { give(machine->of.values(), values, count); });
}

char* orbearing_machine_slope(orbearing_machine* machine, const char* output, const char* input,
                              double* value) {
  return failure_of([&] { *value = machine->of.slope(output, input); });
}

double orbearing_machine_time(const orbearing_machine* machine) {
  return machine->of.time();
}

char* orbearing_machine_save(orbearing_machine* machine, double** state, std::size_t* count) {
  return failure_of([&] { give(machine->of.save(), state, count); });
}

char* orbearing_machine_restore(orbearing_machine* machine, const double* state, std::size_t count) {
  return failure_of([&] { machine->of.restore({state, state + count}); });
}
}
