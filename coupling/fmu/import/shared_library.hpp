// A shared library, loaded for as long as it is used.
#pragma once

#include <filesystem>
#include <string>

namespace orbearing::fmu {

class SharedLibrary {
 public:
  /// Whether symbols serve libraries that are loaded later.
  enum class Symbols { its_own, for_all };

  /// A path, or the bare name of a library of the system. Throws ForeignFmuError with the loader's words.
  explicit SharedLibrary(const std::filesystem::path& file, Symbols symbols = Symbols::its_own);
  ~SharedLibrary();
  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;

  /// Throws ForeignFmuError where the library has no function of that name.
  template <typename Function>
  Function* function(const std::string& name) const {
    return reinterpret_cast<Function*>(address(name));
  }

 private:
  void* address(const std::string& name) const;

  void* handle_ = nullptr;
  std::string name_;
};

}  // namespace orbearing::fmu
