// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/program.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

#include "fairway/core/text.hpp"
#include "fairway/experiment/executor.hpp"
#include "fairway/experiment/version.hpp"
#include "fairway/record/output_file.hpp"
#include "fairway/scenario/tree.hpp"
#include "fairway/sim/divergence.hpp"

namespace fairway::cli {
namespace {

std::atomic<bool> stop_requested{false};
std::atomic<bool> stop_taken{false};
std::atomic<bool> terminated{false};

/// From within a signal's handler: nothing here takes a lock or memory.
[[noreturn]] void end_at_once() {
  constexpr std::string_view line = "fairway: interrupted\n";
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line.data(), line.size());
  remove_parts();
  std::_Exit(interrupted);
}

extern "C" void on_interrupt(int signal) {
  if (signal != SIGINT) terminated = true;
  // nobody looks at the flag, or this is the second signal
  if (!stop_taken || stop_requested.exchange(true)) end_at_once();
}

/// The last part of what the program was called by.
std::string name_of(int argc, const char* const* argv) {
  const std::string name = argc > 0 ? std::filesystem::path(argv[0]).filename().string() : "";
  return name.empty() ? "fairway" : name;
}

std::string typed_line(int argc, const char* const* argv) {
  std::string line = name_of(argc, argv);
  for (int i = 1; i < argc; ++i) line += " " + shell_word(argv[i]);
  return line;
}

void add_verbs(CLI::App& app, Program& program) {
  add_list(app, program);
  add_describe(app, program);
  add_check(app, program);
  add_run(app, program);
  add_test(app, program);
  add_study(app, program);
  add_sweep(app, program);
  add_merge(app, program);
  add_submit(app, program);
  add_status(app, program);
  add_tune(app, program);
  add_exam(app, program);
  add_compare(app, program);
  add_report(app, program);
  add_replay(app, program);
  add_view(app, program);
  add_diff(app, program);
  add_explain(app, program);
  add_decide(app, program);
  add_trial(app, program);
  add_bench(app, program);
}

/// A mistyped verb gets its neighbour named; everything else is the library's own message.
int explain_parse_error(const CLI::App& app, const CLI::ParseError& error, int argc,
                        const char* const* argv) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    return app.exit(error, std::cout, std::cerr);
  }
  std::string hint;
  if (argc > 1 && argv[1][0] != '-') {
    std::vector<std::string_view> verbs;
    for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
      verbs.push_back(verb->get_name());
    if (std::ranges::find(verbs, std::string_view(argv[1])) == verbs.end()) {
      std::cerr << "fairway: unknown verb \"" << argv[1] << "\"" << suggestion(argv[1], verbs) << "\n";
      return bad_input;
    }
    hint = "; see " + app.get_name() + " " + argv[1] + " --help";
  }
  std::string message = error.what();
  std::ranges::replace(message, '\n', ' ');
  std::cerr << "fairway: " << message << (hint.empty() ? "; see " + app.get_name() + " --help" : hint)
            << "\n";
  return bad_input;
}

/// What the verb that was asked for comes to; help, where that was.
int obey(CLI::App& app, const Program& program, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return explain_parse_error(app, error, argc, argv);
  }
  return program.chosen ? program.chosen() : bad_input;
}

/// Names and values go into tables, pages and recordings, which are UTF-8.
int refuse_word(std::string_view word) {
  std::cerr << "fairway: the command line has \"" << yaml::shown(word)
            << "\", which is not UTF-8; expected names and values in that encoding\n";
  return bad_input;
}

/// Where an installed fairway keeps what comes with it.
std::filesystem::path installed_folder() {
  std::error_code none;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", none);
  return program.parent_path().parent_path() / "share/fairway";
}

}  // namespace

int run_command(int argc, const char* const* argv, const Catalogs& catalogs) {
  CLI::App app{"Collision avoidance for marine robots: methods, vehicles, simulation, experiments.",
               name_of(argc, argv)};
  app.set_version_flag("--version", std::string("fairway ") + std::string(fairway_version));
  app.require_subcommand(1);
  app.footer("Example: fairway study cubes --seeds 20 --out results");
  Program program{typed_line(argc, argv), {},       {stop_requested, stop_taken},
                  app.get_name(),         catalogs, &terminated};
  if (not_utf8(program.name)) return refuse_word(program.name);
  for (int i = 1; i < argc; ++i)
    if (not_utf8(argv[i])) return refuse_word(argv[i]);
  add_verbs(app, program);
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  // a terminal that goes away ends a job as a scheduler does, unless nohup has it go on
  if (std::signal(SIGHUP, on_interrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond what may be written is then an error like a full disk

  try {
    const int code = obey(app, program, argc, argv);
    std::cout.flush();
    if (!std::cout) throw InputError("standard output could not be written");
    return code;
  } catch (const InputError& error) {
    std::cout.flush();
    std::cerr << "fairway: " << error.what() << "\n";
    return bad_input;
  } catch (const std::filesystem::filesystem_error& error) {  // a name too long, a folder that is not ours
    std::cout.flush();
    std::cerr << "fairway: " << error.path1().string() << ": " << error.code().message() << "\n";
    return bad_input;
  } catch (const RunAbandoned&) {
    std::cerr << "fairway: interrupted\n";
    return interrupted;
  } catch (const RunDiverged& error) {
    std::cout.flush();
    std::cerr << "fairway: " << error.what() << "\n";
    return expectation_failed;
  } catch (const std::exception& error) {
    std::cout.flush();
    std::cerr << "fairway: internal error: " << error.what() << "\n";
    return 70;
  }
}

std::pair<std::string, std::string> split_setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError("--set " + text + ": expected name=value");
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

ParamValues settings_of(const std::vector<std::string>& texts) {
  ParamValues values;
  for (const std::string& text : texts) {
    const auto [name, value] = split_setting(text);
    if (std::ranges::any_of(values, [&](const auto& v) { return v.first == name; })) {
      throw InputError("--set " + name + ": given twice");
    }
    values.emplace_back(name, parse_value(value));
  }
  return values;
}

Overrides overrides_of(const std::vector<std::string>& texts, const std::optional<std::uint64_t>& seed) {
  Overrides overrides;
  for (const std::string& text : texts) {
    overrides.push_back(split_setting(text));
    const std::string& path = overrides.back().first;
    if (std::ranges::count(overrides, path, &Overrides::value_type::first) > 1)
      throw InputError("--set " + path + ": given twice");
    if (seed && path == "seed") throw InputError("--set seed: --seed gives it, too; expected one of the two");
  }
  return overrides;
}

std::string shipped(const std::string& path) {
  std::error_code none;
  if (std::filesystem::exists(path, none)) return path;
  const std::filesystem::path installed = installed_folder() / path;
  return std::filesystem::exists(installed, none) ? installed.string() : path;
}

void expect_shipped(const std::string& path, const std::string& flag) {
  std::error_code none;
  if (std::filesystem::exists(path, none)) return;
  throw InputError(path + ": is neither here nor in " + installed_folder().string() + "; give it by " + flag +
                   ", or go to the folder of fairway's sources");
}

std::string read_text(const std::string& file) {
  std::ostringstream text;
  if (file == "-") {
    text << std::cin.rdbuf();
  } else {
    std::ifstream in{file, std::ios::binary};
    if (!in) throw InputError(file + ": cannot be opened for reading");
    text << in.rdbuf();
  }
  return text.str();
}

}  // namespace fairway::cli
