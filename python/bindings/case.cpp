// A case: read, changed, asked for its values.
#include <pybind11/stl.h>

#include <fmt/format.h>

#include "app/case/case_file.hpp"
#include "app/case/field_table.hpp"
#include "app/case/resolved_writer.hpp"
#include "app/case/settings.hpp"
#include "python/bindings/bindings.hpp"

namespace orbearing::python {

namespace py = pybind11;

namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

std::vector<std::string> as_options(const Settings& settings) {
  std::vector<std::string> texts;
  for (const auto& [path, text] : settings) texts.push_back(path + "=" + text);
  return texts;
}

const app::Field& field_at(const Case& core, const std::string& path) {
  for (const app::Input& input : core.content().inputs())
    if (input.path == path) return *input.field;
  std::vector<std::string> known;
  for (const app::Input& input : core.content().inputs()) known.push_back(input.path);
  const std::string near = app::nearest_word(path, known);
  throw BadInput(fmt::format(
      "{}: {}: found a path that this case does not have{}; required: the path of a value of the case",
      core.content().file(), path, near.empty() ? "" : " (did you mean '" + near + "'?)"));
}

// Rows as a case writes them: a list of all columns, or the names of those that the row has.
py::list rows_of(const app::Field& field, const app::FieldValue& value) {
  const std::vector<double>& numbers = value.list;
  py::list rows;
  const std::size_t columns = field.columns.size();
  for (std::size_t i = 0; i + columns <= numbers.size(); i += columns) {
    py::list all;
    py::dict named;
    for (std::size_t k = 0; k < columns; ++k) {
      all.append(numbers[i + k]);
      const app::ListColumn& column = field.columns[k];
      if ((column.one_of != 0 || column.optional) && numbers[i + k] == 0.0) continue;
      const py::str key(app::column_key(column));
      if (column.text)
        named[key] = app::text_numbered(value.texts, numbers[i + k]);
      else
        named[key] = numbers[i + k];
    }
    rows.append(app::has_choices(field) ? py::object(named) : py::object(all));
  }
  return rows;
}

py::object value_of(const Case& core, const std::string& path) {
  const app::Field& field = field_at(core, path);
  if (!core.content().has(path)) return py::none();
  switch (field.kind) {
    case app::Kind::quantity:
      return py::float_(core.content().quantity(path));
    case app::Kind::number:
      return py::float_(core.content().number(path));
    case app::Kind::integer:
      return py::int_(core.content().integer(path));
    case app::Kind::flag:
      return py::bool_(core.content().flag(path));
    case app::Kind::choice:
      return py::str(core.content().choice(path));
    case app::Kind::text:
      return py::str(core.content().text(path));
    case app::Kind::list:
      if (field.element == app::Kind::text) return py::cast(core.content().texts(path));
      if (!field.columns.empty()) return rows_of(field, core.content().value(path));
      if (field.element == app::Kind::integer) {
        const std::vector<double>& list = core.content().list(path);
        const std::vector<long> whole(list.begin(), list.end());
        const auto size = static_cast<std::ptrdiff_t>(field.group);
        if (size == 0 || list.size() == field.group) return py::cast(whole);
        py::list groups;
        for (auto first = whole.begin(); first != whole.end(); first += size)
          groups.append(py::cast(std::vector<long>(first, first + size)));
        return groups;
      }
      return py::cast(core.content().list(path));
  }
  return py::none();
}

// The SI unit of a number that stands at a path of any case, and of the columns of its rows; nothing where no
// field has that path.
py::object si_units(const std::string& path) {
  const app::Field* field = app::find_field(path);
  if (field == nullptr) return py::none();
  py::list columns;
  for (const app::ListColumn& column : field->columns)
    columns.append(py::make_tuple(app::column_key(column), std::string(column.dimension.si)));
  return py::make_tuple(std::string(field->dimension.si), columns);
}

double in_si(const app::Field& field, const std::string& path, const std::string& text) {
  const app::FieldReading reading = app::read_field_text(field, text);
  if (!reading.good)
    throw BadInput(
        fmt::format("{}: found {}; required: {}", path, reading.message.found, app::requirement(field)));
  return reading.value.number;
}

const char* kind_name(app::Kind kind) {
  switch (kind) {
    case app::Kind::quantity:
      return "quantity";
    case app::Kind::integer:
      return "integer";
    case app::Kind::number:
      return "number";
    case app::Kind::flag:
      return "flag";
    case app::Kind::choice:
      return "choice";
    case app::Kind::text:
      return "text";
    case app::Kind::list:
      return "list";
  }
  return "";
}

py::dict described(const Case& core, const app::Input& input) {
  const auto& [path, field] = input;
  py::dict row;
  row["path"] = path;
  row["kind"] = kind_name(field->kind);
  row["unit"] = std::string(field->dimension.customary);
  row["si_unit"] = std::string(field->dimension.si);
  row["meaning"] = field->meaning;
  const bool given = core.content().has(path);
  row["given"] = given ? py::object(py::str(core.content().given(path))) : py::none();
  const auto& assumed = core.content().assumed();
  const auto reason = assumed.find(path);
  const bool is_default = given && core.content().origin(path) == "default";
  row["source"] = !given ? "absent" : is_default ? "default" : reason != assumed.end() ? "assumed" : "given";
  row["reason"] = reason == assumed.end() ? "" : reason->second;
  return row;
}

py::list inputs_of(const Case& core) {
  py::list rows;
  for (const app::Input& input : core.content().inputs()) rows.append(described(core, input));
  return rows;
}

py::dict axes_of(const Case& core) {
  py::dict axes;
  for (const app::SweepAxis& axis : core.content().axes()) axes[py::str(axis.path)] = py::cast(axis.values);
  return axes;
}

}  // namespace

void add_case(py::module_& module) {
  py::class_<Case>(module, "CoreCase", "A case with every value checked; it never changes.")
      .def(
          "with_settings",
          [](const Case& core, const Settings& settings) {
            std::vector<app::Setting> all;
            for (const auto& [path, text] : settings) all.push_back({path, text});
            return Case{core.content().with(all)};
          },
          py::arg("settings"), py::call_guard<py::gil_scoped_release>(),
          "A copy with values replaced, by (path, text as in a case file); what follows from them is derived "
          "anew.")
      .def(
          "with_numbers",
          [](const Case& core, const std::vector<std::pair<std::string, double>>& settings) {
            std::vector<app::Setting> all;
            for (const auto& [path, number] : settings) all.push_back({path, "", number});
            return Case{core.content().with(all)};
          },
          py::arg("settings"), "The same by (path, number in SI).")
      .def(
          "without_sweep", [](const Case& core) { return Case{core.content().without_sweep()}; },
          "The one operating point that the values state.")
      .def(
          "si",
          [](const Case& core, const std::string& path, const std::string& text) {
            return in_si(field_at(core, path), path, text);
          },
          py::arg("path"), py::arg("text"), "What the case's reader makes of a text for that input, in SI.")
      .def(
          "si",
          [](const Case& core, const std::string& path, const std::vector<std::string>& texts) {
            const app::Field& field = field_at(core, path);
            std::vector<double> values;
            for (const std::string& text : texts) values.push_back(in_si(field, path, text));
            return values;
          },
          py::arg("path"), py::arg("texts"), "The same of many texts.")
      .def("value", &value_of, py::arg("path"), "The present value, in SI; None where there is none.")
      .def(
          "given",
          [](const Case& core, const std::string& path) -> py::object {
            field_at(core, path);
            if (!core.content().has(path)) return py::none();
            return py::str(core.content().given(path));
          },
          py::arg("path"), "The present value as written, with its unit; None where there is none.")
      .def("inputs", &inputs_of,
           "All that may stand in this case: dicts of path, kind, unit (customary), si_unit, meaning, given, "
           "source "
           "(given, assumed, default or absent) and reason.")
      .def("axes", &axes_of, "Swept inputs and their values as written.")
      .def(
          "resolved", [](const Case& core) { return app::write_resolved(core.content()); },
          "The resolved case as YAML, from which the same numbers follow.")
      .def("hash", [](const Case& core) { return app::case_hash(core.content()); })
      .def("file", [](const Case& core) { return core.content().file(); })
      .def("name", [](const Case& core) { return core.content().text("name"); })
      .def("model", [](const Case& core) { return core.content().choice("model"); });
  module.def("si_units", &si_units, py::arg("path"),
             "(unit, [(column, unit), ...]) of the numbers at a path, in SI, empty where they have none; "
             "None where no "
             "input has that path.");
  module.def(
      "load",
      [](const std::string& file, const Settings& settings) {
        return Case{app::read_case(file, as_options(settings))};
      },
      py::arg("file"), py::arg("settings") = Settings{}, py::call_guard<py::gil_scoped_release>(),
      "Reads and checks a case file.");
  module.def(
      "parse",
      [](const std::string& text, const std::string& name, const Settings& settings) {
        return Case{app::parse_case(text, name, as_options(settings))};
      },
      py::arg("text"), py::arg("name") = "case", py::arg("settings") = Settings{},
      py::call_guard<py::gil_scoped_release>(),
      "The same of a text; `name` stands for the file in messages.");
}

}  // namespace orbearing::python
