#include "orbearing/table.hpp"

#include "app/case/case_file.hpp"
#include "app/study/table_study.hpp"

namespace orbearing {

Table::Table(std::shared_ptr<const app::TabulatedCase> content, Case stated)
    : content_(std::move(content)), stated_(std::move(stated)) {}

Table Table::read(const std::string& file) {
  auto content = std::make_shared<const app::TabulatedCase>(app::read_table(file));
  Case stated{app::parse_case(content->resolved_case, content->file).without_sweep()};
  return {std::move(content), std::move(stated)};
}

const std::vector<TableInput>& Table::inputs() const {
  return content_->inputs;
}

std::vector<std::string> Table::results() const {
  std::vector<std::string> names;
  for (const app::TabulatedResult& result : content_->results) names.push_back(result.name);
  return names;
}

double Table::bound() const {
  return content_->bound;
}

TableAnswers Table::answers(const std::string& result, const std::vector<double>& values,
                            const TableQuery& query) const {
  return app::answers_of(*content_, stated_.content(), result, values, query);
}

}  // namespace orbearing
