#include "coupling/fmu/import/messages.hpp"

namespace orbearing::fmu {

void Messages::add(const char* category, const char* text) {
  const std::lock_guard lock{mutex_};
  std::string line = category != nullptr && *category != '\0' ? "[" + std::string(category) + "] " : "";
  line += text != nullptr ? text : "";
  while (!line.empty() && (line.back() == '\n' || line.back() == ' ')) line.pop_back();
  lines_.push_back(std::move(line));
  if (lines_.size() > most) lines_.pop_front();
}

std::string Messages::take() {
  const std::lock_guard lock{mutex_};
  std::string text;
  for (const std::string& line : lines_) text += (text.empty() ? "; it says: " : " | ") + line;
  lines_.clear();
  return text;
}

}  // namespace orbearing::fmu
