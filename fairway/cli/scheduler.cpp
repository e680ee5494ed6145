// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/scheduler.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <sstream>

#include "fairway/core/error.hpp"
#include "fairway/core/text.hpp"

namespace fairway::cli::slurm {
namespace {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// What a command says. Throws InputError if it fails.
std::string asked(const std::string& command) {
  // a locale of its own could translate what is read
  std::FILE* pipe = ::popen(("LC_ALL=C " + command + " 2>&1").c_str(), "re");
  if (pipe == nullptr) throw InputError(command + ": cannot be started");
  std::string text;
  std::array<char, 4096> part{};
  for (std::size_t size = 0; (size = std::fread(part.data(), 1, part.size(), pipe)) > 0;)
    text.append(part.data(), size);
  const int status = ::pclose(pipe);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    const std::string name = command.substr(0, command.find(' '));
    throw InputError("Slurm: " + name + " failed: " + (text.empty() ? "it said nothing" : first_line(text)));
  }
  return text;
}

template <class Number>
bool read_number(const std::string& text, Number& number) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && stop == end;
}

}  // namespace

std::string send(std::span<const std::string> options, const std::string& script) {
  std::string command = "sbatch --parsable";
  for (const std::string& option : options) command += " " + shell_word(option);
  // "123", or "123;cluster"
  const std::string id = first_line(asked(command + " " + shell_word(script)));
  return id.substr(0, id.find(';'));
}

std::map<std::uint32_t, std::string> queued(std::span<const std::string> jobs) {
  std::map<std::uint32_t, std::string> states;
  if (jobs.empty()) return states;
  std::istringstream lines{asked("squeue --me -h -r -o '%F %K %T'")};
  for (std::string job, task, state; lines >> job >> task >> state;) {
    std::uint32_t number = 0;
    if (std::ranges::find(jobs, job) != jobs.end() && read_number(task, number)) states[number] = state;
  }
  return states;
}

std::uint32_t most_tasks() {
  std::istringstream words{asked("scontrol show config")};
  for (std::string name, equals, value; words >> name;) {
    std::uint32_t most = 0;
    if (name == "MaxArraySize" && words >> equals >> value && read_number(value, most) && most > 0)
      return most;
  }
  throw InputError("Slurm: scontrol show config says no MaxArraySize");
}

unsigned cores_of_a_node() {
  std::istringstream words{asked("sinfo -h -o %c")};
  unsigned least = 0;
  for (std::string word; words >> word;) {
    // "64+" where nodes of a kind differ
    unsigned cores = 0;
    if (!read_number(word.substr(0, word.find('+')), cores)) continue;
    least = least == 0 ? cores : std::min(least, cores);
  }
  if (least == 0) throw InputError("Slurm: sinfo names no node");
  return least;
}

}  // namespace fairway::cli::slurm
