// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/progress.hpp"

#include <fmt/format.h>

#include <cmath>

namespace fairway {
namespace {

constexpr std::chrono::milliseconds redraw_period{200};

/// "0:29", "12:05", "3:04:05".
std::string duration_text(double seconds_left) {
  const auto s = static_cast<long long>(std::ceil(seconds_left));
  if (s >= 3600) return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

}  // namespace

std::string progress_text(const std::string& name, const ProgressCount& count, double elapsed_s) {
  std::string text = fmt::format("{}: {} of {} runs", name, count.present + count.made, count.total);
  if (count.failed > 0) text += fmt::format(", {} failed", count.failed);
  if (count.made > 0 && elapsed_s > 0.0) {
    const double rate = static_cast<double>(count.made) / elapsed_s;
    const auto left = static_cast<double>(count.total - count.present - count.made);
    text += fmt::format(", {:.3g} runs/s, {} left", rate, duration_text(left / rate));
  }
  return text;
}

Progress::Progress(std::string name, int descriptor)
    : name_{std::move(name)}, descriptor_{descriptor}, visible_{::isatty(descriptor) == 1} {}

void Progress::begin(const ProgressCount& count) {
  began_ = Clock::now();
  drawn_ = began_;
  draw(count, "");
}

void Progress::update(const ProgressCount& count) {
  if (Clock::now() - drawn_ < redraw_period) return;
  drawn_ = Clock::now();
  draw(count, "");
}

void Progress::end(const ProgressCount& count) { draw(count, "\n"); }

void Progress::draw(const ProgressCount& count, const char* ending) {
  if (!visible_) return;
  const double elapsed_s = std::chrono::duration<double>(Clock::now() - began_).count();
  // to the line's beginning; then clear what a longer line left
  const std::string line = fmt::format("\r{}\x1b[K{}", progress_text(name_, count, elapsed_s), ending);
  if (::write(descriptor_, line.data(), line.size()) < 0) visible_ = false;  // the terminal has gone
}

}  // namespace fairway
