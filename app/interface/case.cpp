#include "orbearing/case.hpp"

#include "app/case/case_file.hpp"
#include "app/case/field_table.hpp"
#include "app/case/resolved_writer.hpp"
#include "app/version.hpp"
#include "orbearing/version.hpp"

namespace orbearing {

std::string version() {
  return std::string(app::program_version);
}

std::string instruction_set() {
  return std::string(app::instruction_set);
}

Case::Case(app::ResolvedCase resolved)
    : content_(std::make_shared<const app::ResolvedCase>(std::move(resolved))) {}

Case Case::read(const std::string& file, const std::vector<std::string>& settings) {
  return Case(app::read_case(file, settings));
}

Case Case::parse(const std::string& text, const std::string& name, const std::vector<std::string>& settings) {
  return Case(app::parse_case(text, name, settings));
}

Case Case::with(const std::string& path, const std::string& text) const {
  return Case(content_->with(path, text));
}

Case Case::with(const std::string& path, double number) const {
  return Case(content_->with(path, number));
}

bool Case::has(const std::string& path) const {
  return content_->has(path);
}

double Case::number(const std::string& path) const {
  const app::Field* field = has(path) ? app::find_field(path) : nullptr;
  if (field == nullptr || (!app::is_numeric(*field) && field->kind != app::Kind::flag))
    throw BadInput(path + ": found no number of this case; required: the path of a number that it has");
  return content_->value(path).number;
}

std::string Case::text(const std::string& path) const {
  if (!has(path)) throw BadInput(path + ": found no value; required: the path of an input that the case has");
  return content_->written(path);
}

std::string Case::resolved() const {
  return app::write_resolved(*content_);
}

}  // namespace orbearing
