#include "app/results/loaded_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <utility>

#include "app/errors.hpp"

namespace orbearing::app {

LoadedLibrary::LoadedLibrary(std::string title, const std::vector<std::string>& files)
    : title_(std::move(title)) {
  for (const std::string& file : files)
    if (handle_ == nullptr) handle_ = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle_ == nullptr)
    throw ComputationFailed(fmt::format("{} cannot be loaded: {}", title_, ::dlerror()));
}

void* LoadedLibrary::symbol(const char* name) const {
  void* const found = ::dlsym(handle_, name);
  if (found == nullptr) throw ComputationFailed(fmt::format("{} has no function {}", title_, name));
  return found;
}

}  // namespace orbearing::app
