#include "coupling/fmu/model_file.hpp"

#include <cstdio>
#include <memory>
#include <string_view>

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
#endif

namespace orbearing::fmu {

namespace {

constexpr std::size_t kLargest = 200'000'000;  // [bytes]

int digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

std::string decoded(std::string_view text, const std::string& location) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    const int high = i + 2 < text.size() ? digit(text[i + 1]) : -1;
    const int low = high >= 0 ? digit(text[i + 2]) : -1;
    if (low < 0 || high * 16 + low == 0)
      throw Refused("resource location: found '" + location + "'; required: two digits behind each %");
    out += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return out;
}

bool starts_with_drive(std::string_view path) {
  return path.size() > 2 && path[0] == '/' && path[2] == ':';
}

// The path of "file:" + rest, where rest is "/p", "///p" or "//localhost/p".
std::string path_of(std::string_view rest, const std::string& location) {
  if (rest.starts_with("//")) {
    rest.remove_prefix(2);
    const std::size_t slash = rest.find('/');
    const std::string_view host = rest.substr(0, slash);
    if (slash == std::string_view::npos || (!host.empty() && host != "localhost"))
      throw Refused("resource location: found '" + location + "'; required: a folder of this computer");
    rest.remove_prefix(slash);
  }
  if (starts_with_drive(rest)) rest.remove_prefix(1);
  return decoded(rest, location);
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File open_file(const std::string& name) {
#ifdef _WIN32
  std::wstring wide(name.size() + 1, L'\0');
  const int length = static_cast<int>(name.size() + 1);
  MultiByteToWideChar(CP_UTF8, 0, name.c_str(), length, wide.data(), length);
  return File(_wfopen(wide.c_str(), L"rb"), &std::fclose);
#else
  return File(std::fopen(name.c_str(), "rb"), &std::fclose);
#endif
}

}  // namespace

std::string resource_folder(const char* location) {
  if (location == nullptr)
    throw Refused("resource location: found NULL; required: that of the FMU's resources");
  const std::string text = location;
  if (text.starts_with("file:")) return path_of(std::string_view(text).substr(5), text);
  const std::size_t scheme = text.find("://");
  if (text.empty() || scheme != std::string::npos)
    throw Refused("resource location: found '" + text + "'; required: file:///... or a path");
  return text;
}

std::string read_model(const std::string& folder) {
  const bool closed = folder.ends_with('/') || folder.ends_with('\\');
  const std::string name = folder + (closed ? "" : "/") + kModelFile;
  const File file = open_file(name);
  if (!file) throw Refused("resources: found no file " + name + "; required: that of the unpacked FMU");
  std::string text;
  char block[65536];
  for (std::size_t count = 0; (count = std::fread(block, 1, sizeof block, file.get())) > 0;) {
    text.append(block, count);
    if (text.size() > kLargest) throw Refused("resources: found a model of more than 200 MB in " + name);
  }
  if (std::ferror(file.get()) != 0) throw Refused("resources: " + name + " could not be read to its end");
  return text;
}

}  // namespace orbearing::fmu
