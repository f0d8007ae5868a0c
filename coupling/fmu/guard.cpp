#include "coupling/fmu/guard.hpp"

#include "coupling/fmu/model_file.hpp"

namespace orbearing::fmu {

namespace {

void tell(const Log& log, const char* function, const char* reason) noexcept {
  try {
    if (log) log(Status::error, "logStatusError", (std::string(function) + ": " + reason).c_str());
  } catch (...) {  // no memory for the words
  }
}

}  // namespace

Instance* new_instance(const char* function, const char* wrong, const char* token, const char* resources,
                       Log log, bool logging) noexcept {
  try {
    if (wrong != nullptr) throw Refused(wrong);
    if (token == nullptr) throw Refused("GUID or instantiation token: found NULL; required: the model's");
    NumberTable numbers = table_from(read_model(resource_folder(resources)));
    return std::make_unique<Instance>(std::move(numbers), token, log, logging).release();
  } catch (const std::exception& failure) {
    tell(log, function, failure.what());
  } catch (...) {
    tell(log, function, "failed for a reason that is not known");
  }
  return nullptr;
}

void require_position(const void* pointer, const char* what) {
  if (pointer == nullptr) throw Refused(std::string(what) + ": found NULL; required: an address for it");
}

std::vector<std::string> categories_of(std::size_t number, const char* const* list) {
  std::vector<std::string> categories;
  for (std::size_t i = 0; i < number; ++i) {
    if (list == nullptr || list[i] == nullptr)
      throw Refused("log categories: found NULL; required: " + std::to_string(number) + " names");
    categories.emplace_back(list[i]);
  }
  return categories;
}

}  // namespace orbearing::fmu
