// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "fairway/cli/numbers.hpp"
#include "fairway/cli/outputs.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/experiment/recording_info.hpp"
#include "fairway/view/film_recording.hpp"
#include "fairway/view/playback.hpp"

namespace fairway::cli {
namespace {

struct ViewOptions {
  std::string recording;
  std::string out;
  double from_s{0.0};
  double to_s{std::numeric_limits<double>::infinity()};
  std::int64_t every{1};
  bool sketch{false};
  bool json{false};
};

/// How much of the work is done, on a terminal, at most five times a second, if it takes long.
class Percentage {
 public:
  explicit Percentage(std::size_t total) : total_{total}, drawn_{Clock::now()} {}
  ~Percentage() {
    if (shown_) std::cerr << "\r\x1b[K" << std::flush;
  }
  Percentage(const Percentage&) = delete;
  Percentage& operator=(const Percentage&) = delete;

  void add_one() {
    ++done_;
    if (!visible_ || Clock::now() - drawn_ < std::chrono::milliseconds{200}) return;
    drawn_ = Clock::now();
    shown_ = true;
    std::cerr << fmt::format("\r\x1b[K{} % of {} frames", 100 * done_ / total_, total_) << std::flush;
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::size_t total_;
  std::size_t done_{};
  bool visible_{::isatty(STDERR_FILENO) == 1};
  bool shown_{false};
  Clock::time_point drawn_;
};

/// The recording's name with .html for .mcap.
std::string page_beside(const std::string& recording) {
  const std::filesystem::path path{recording};
  return path.extension() == ".mcap" ? std::filesystem::path{path}.replace_extension(".html").string()
                                     : recording + ".html";
}

/// What is wrong with the flags together.
void check_view_options(const ViewOptions& options) {
  if (!(options.to_s >= options.from_s))
    throw InputError(fmt::format("--to {}: expected seconds, {} or more", options.to_s, options.from_s));
}

FilmLimits film_limits_of(const ViewOptions& options) {
  FilmLimits limits;
  limits.from_s = options.from_s;
  limits.to_s = options.to_s;
  limits.every = static_cast<std::size_t>(options.every);
  return limits;
}

void check_window(const Recording& recording, const ViewOptions& options, const Film& film) {
  if (film.size() > 0) return;
  if (recording.size() == 0) throw InputError(options.recording + ": holds no frames");
  throw InputError(fmt::format("{}: no frame in the time that --from and --to leave; it runs from {} to {} s",
                               options.recording, recording.frame(0).time,
                               recording.frame(recording.size() - 1).time));
}

void print_view(const ViewOptions& options, const Film& film, std::size_t bytes) {
  const std::string page = std::filesystem::absolute(options.out).lexically_normal().string();
  if (options.json) {
    std::cout << nlohmann::json{{"recording", options.recording},
                                {"playback", page},
                                {"frames", film.size()},
                                {"stride", film.stride()},
                                {"bytes", bytes},
                                {"sketches", film.has_sketches()},
                                {"notice", film.notice()}}
                     .dump(2)
              << "\n";
    return;
  }
  std::cout << "playback: " << page << "\n";
  if (const std::string notice = film.notice(); !notice.empty()) std::cout << notice << "\n";
}

int view(const ViewOptions& options, const Outputs& outputs, const Program& program) {
  check_view_options(options);
  outputs.judge({options.recording});
  const Recording recording = Recording::read(options.recording);
  const RecordingInfo& info = recording.info();
  const Scenario scenario = recorded_scenario(recording, options.recording);
  Film film{scenario, film_limits_of(options), &program.catalogs.avoiders};
  const bool again = options.sketch && !holds_thoughts(recording);
  bool complete = false;
  {
    Percentage progress{again ? recording.run_frame_count() : recording.size()};
    const FilmWatch watch{program.stop, [&progress] { progress.add_one(); }};
    complete = again ? show_again(recording, scenario, program.catalogs, options.recording, film, watch)
                     : show_recorded(recording, film, watch);
  }
  if (!complete) {
    std::cerr << "fairway: interrupted\n";
    return interrupted;
  }
  film.finish(recording.divergence());
  check_window(recording, options, film);
  const std::size_t bytes = write_playback(
      options.out, playback_document(scenario, {info.version, program.typed, info.period, {}}, &film));
  print_view(options, film, bytes);
  return ok;
}

}  // namespace

void add_view(CLI::App& app, Program& program) {
  CLI::App* verb =
      app.add_subcommand("view", "A recorded run in three dimensions: one page that plays it in any browser");
  verb->footer("Example: fairway view cube.mcap --sketch --out cube.html");
  auto options = std::make_shared<ViewOptions>();
  verb->add_option("recording", options->recording, "MCAP file written by `fairway run --out`")
      ->check(not_empty())
      ->required();
  auto outputs = std::make_shared<Outputs>(*verb);
  outputs->add("--out", options->out, playback_file,
               "write the page here; beside the recording, as .html, unless given");
  verb->add_flag(
      "--sketch", options->sketch,
      "show what each method drew of its thinking; simulates the run again where that is not recorded");
  verb->add_option("--from", options->from_s, "leave out what is earlier [s]")->transform(finite_number(0.0));
  verb->add_option("--to", options->to_s, "leave out what is later [s]")->transform(finite_number(0.0));
  verb->add_option("--every", options->every, "show one frame in so many")
      ->transform(whole_number(std::int64_t{1}))
      ->capture_default_str();
  verb->add_flag("--json", options->json, "print JSON");
  program.on(*verb, [=, &program] {
    if (options->out.empty()) options->out = page_beside(options->recording);
    return view(*options, *outputs, program);
  });
}

}  // namespace fairway::cli
