// SPDX-License-Identifier: Apache-2.0
#include "fairway/report/page.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "fairway/core/error.hpp"

namespace fairway {
namespace {

constexpr std::string_view marker = "__FAIRWAY_DATA__";

// A script element ends at "</script" and changes its parsing at "<!--". In JSON, '<' occurs only inside
// strings, where "\/" and "\u003c" stand for the same characters.
std::string script_safe(const std::string& json) {
  std::string safe;
  safe.reserve(json.size() + json.size() / 64);
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char next = i + 1 < json.size() ? json[i + 1] : '\0';
    if (json[i] == '<' && next == '/') {
      safe += "<\\/";
      ++i;
    } else if (json[i] == '<' && next == '!') {
      safe += "\\u003c";
    } else {
      safe += json[i];
    }
  }
  return safe;
}

[[noreturn]] void refuse(const std::string& path, const std::string& what, int error) {
  const std::string reason = error == 0 ? "write failed" : std::generic_category().message(error);
  throw InputError({path}, "", what + " cannot be written: " + reason);
}

}  // namespace

std::string filled(std::string page, const std::string& json) {
  const std::size_t at = page.find(marker);
  if (at == std::string::npos) throw std::logic_error("page template without " + std::string{marker});
  return page.replace(at, marker.size(), script_safe(json));
}

std::string render_page(const std::string& json) { return filled(embedded::report_template(), json); }

void write_whole(const std::string& text, const std::string& path, const std::string& what) {
  if (std::filesystem::is_directory(path)) refuse(path, what, EISDIR);

  const std::string part = path + ".part";
  errno = 0;
  std::ofstream file{part, std::ios::binary | std::ios::trunc};
  if (!file) refuse(path, what, errno);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  std::error_code failure;
  if (!file) {
    const int error = errno;
    std::filesystem::remove(part, failure);
    refuse(path, what, error);
  }

  std::filesystem::rename(part, path, failure);
  if (failure) {
    const int error = failure.value();
    std::filesystem::remove(part, failure);
    refuse(path, what, error);
  }
}

void write_page(const std::string& json, const std::string& path) {
  write_whole(render_page(json), path, "the report");
}

}  // namespace fairway
