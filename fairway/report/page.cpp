// SPDX-License-Identifier: Apache-2.0
#include "fairway/report/page.hpp"

#include <stdexcept>
#include <string_view>

#include "fairway/record/output_file.hpp"

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

}  // namespace

std::string filled(std::string page, const std::string& json) {
  const std::size_t at = page.find(marker);
  if (at == std::string::npos) throw std::logic_error("page template without " + std::string{marker});
  return page.replace(at, marker.size(), script_safe(json));
}

std::string render_page(const std::string& json) { return filled(embedded::report_template(), json); }

void write_page(const std::string& json, const std::string& path) { write_file(path, render_page(json)); }

}  // namespace fairway
