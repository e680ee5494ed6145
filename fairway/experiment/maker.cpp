// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/maker.hpp"

#include <gnu/libc-version.h>
#include <sys/utsname.h>

#include <algorithm>
#include <fstream>

#include "fairway/experiment/version.hpp"

namespace fairway {
namespace {

/// The first "model name" that the system tells.
std::string processor_name() {
  std::ifstream file{"/proc/cpuinfo"};
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return ", " + line.substr(colon + 2);
  }
  return "";
}

constexpr const char* compiler_text() {
#if defined(__clang__)
  return "clang++ " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

std::string kind_of(const Maker& maker) {
  std::string text = "fairway " + maker.version + " (" + maker.commit + ", epoch " + maker.epoch + ")";
  for (const std::string& part : {maker.compiler, maker.c_library, maker.processor}) text += ", " + part;
  return text;
}

}  // namespace

Maker this_maker(bool with_host) {
  utsname system{};
  ::uname(&system);
  return {.version = std::string(fairway_version),
          .commit = std::string(fairway_commit()),
          .epoch = std::to_string(results_epoch),
          .compiler = compiler_text(),
          .c_library = std::string("glibc ") + gnu_get_libc_version(),
          .processor = system.machine + processor_name(),
          .host = with_host ? system.nodename : ""};
}

void add_maker(std::vector<Maker>& makers, const Maker& maker) {
  if (std::ranges::find(makers, maker) == makers.end()) makers.push_back(maker);
}

std::vector<std::string> kinds_of(std::span<const Maker> makers) {
  std::vector<std::pair<std::string, std::vector<std::string>>> kinds;
  for (const Maker& maker : makers) {
    const std::string kind = kind_of(maker);
    auto known = std::ranges::find(kinds, kind, [](const auto& entry) { return entry.first; });
    if (known == kinds.end()) known = kinds.insert(kinds.end(), {kind, {}});
    if (!maker.host.empty()) known->second.push_back(maker.host);
  }
  std::ranges::sort(kinds);
  std::vector<std::string> lines;
  for (auto& [line, hosts] : kinds) {
    std::ranges::sort(hosts);
    for (std::size_t i = 0; i < hosts.size(); ++i) line += (i == 0 ? ": " : ", ") + hosts[i];
    lines.push_back(line);
  }
  return lines;
}

std::string remark_on(std::span<const Maker> makers) {
  const std::size_t kinds = kinds_of(makers).size();
  if (kinds < 2) return "";
  return "made by " + std::to_string(kinds) +
         " kinds of program or machine, which come to the same bits but where OMPL plans: rrt_star, blend, "
         "teb";
}

}  // namespace fairway
