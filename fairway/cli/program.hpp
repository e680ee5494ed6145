// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fairway/cli/command.hpp"
#include "fairway/core/params.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway::cli {

/// Exit codes of every verb.
inline constexpr int ok = 0;
inline constexpr int expectation_failed = 1;
inline constexpr int bad_input = 2;
inline constexpr int interrupted = 130;

/// The wish to stop, which Ctrl-C, SIGTERM and SIGHUP set. Until somebody takes it, these signals end the
/// process at once; whoever takes it has something to keep, looks at it again and again, and ends in order.
class StopFlag {
 public:
  StopFlag(std::nullptr_t = nullptr) {}  // nobody stops it
  StopFlag(const std::atomic<bool>& flag, std::atomic<bool>& taken) : flag_{&flag}, taken_{&taken} {}

  operator const std::atomic<bool>*() const {
    if (taken_ != nullptr && !taken_->load(std::memory_order_relaxed)) *taken_ = true;
    return flag_;
  }
  const std::atomic<bool>* operator->() const { return *this; }

 private:
  const std::atomic<bool>* flag_{};
  std::atomic<bool>* taken_{};
};

/// The command line of a process: what was typed, and what a verb leaves behind.
struct Program {
  std::string typed;            ///< the whole command, for reports
  std::function<int()> chosen;  ///< the verb that was asked for
  StopFlag stop;                ///< set by Ctrl-C, SIGTERM and SIGHUP
  std::string name;          ///< of this program, as it was called: "fairway", or one with methods of its own
  const Catalogs& catalogs;  ///< what it offers
  std::atomic<bool>* terminated;  ///< whether it was SIGTERM or SIGHUP that asked to stop

  /// Has `run` chosen where the verb is asked for.
  void on(CLI::App& verb, std::function<int()> run) {
    verb.callback([this, run = std::move(run)] { chosen = run; });
  }
};

// One function per verb, each in its own file: adds the subcommand with its flags, its help and an example.
void add_list(CLI::App& app, Program& program);
void add_describe(CLI::App& app, Program& program);
void add_check(CLI::App& app, Program& program);
void add_run(CLI::App& app, Program& program);
void add_test(CLI::App& app, Program& program);
void add_study(CLI::App& app, Program& program);
void add_sweep(CLI::App& app, Program& program);
void add_merge(CLI::App& app, Program& program);
void add_submit(CLI::App& app, Program& program);
void add_status(CLI::App& app, Program& program);
void add_tune(CLI::App& app, Program& program);
void add_exam(CLI::App& app, Program& program);
void add_compare(CLI::App& app, Program& program);
void add_report(CLI::App& app, Program& program);
void add_replay(CLI::App& app, Program& program);
void add_view(CLI::App& app, Program& program);
void add_diff(CLI::App& app, Program& program);
void add_explain(CLI::App& app, Program& program);
void add_decide(CLI::App& app, Program& program);
void add_trial(CLI::App& app, Program& program);
void add_bench(CLI::App& app, Program& program);

/// "name=value" apart. Throws InputError without a '='.
std::pair<std::string, std::string> split_setting(const std::string& text);

/// `--set a=1 --set b=2` as parameters. Throws InputError for a repeated name.
ParamValues settings_of(const std::vector<std::string>& texts);

/// `--set path=value` as overrides of a scenario. Throws InputError for a repeated path, and for the seed
/// where --seed gives it.
Overrides overrides_of(const std::vector<std::string>& texts, const std::optional<std::uint64_t>& seed = {});

/// Where `path` of what comes with fairway is, such as "scenarios": in the folder that one is in, else where
/// the command is installed. As it is where there is none.
std::string shipped(const std::string& path);

/// Throws InputError unless what `shipped` gave is there: where it has looked, and which flag names another.
void expect_shipped(const std::string& path, const std::string& flag);

/// Opens a file for reading, "-" being standard input; throws InputError naming the file.
std::string read_text(const std::string& file);

}  // namespace fairway::cli
