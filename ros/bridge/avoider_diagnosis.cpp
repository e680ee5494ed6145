// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>

#include "ros/bridge/avoider_parts.hpp"

namespace fairway::bridge {
namespace {

constexpr double lately = 5.0;  // [s]

using Counts = decltype(HelmReport::own_counts);

/// Rounded for people: "0.82".
std::string rounded(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  return text.data();
}

std::int64_t refused_of(const Counts& counts) {
  return std::accumulate(counts.begin() + 1, counts.end(), std::int64_t{0});
}

/// "ok", or what is wrong with a neighbour, in a word.
const char* state_of(const HelmReport::Neighbour& neighbour) {
  if (!neighbour.heard) return "never heard";
  if (neighbour.lost) return "lost";
  return neighbour.stale ? "stale" : "ok";
}

/// The name of the mate whose number a track has; empty if there is none.
std::string name_of(const HelmSetup& setup, const std::optional<TrackId>& id) {
  if (!id) return {};
  const auto mate =
      std::ranges::find(setup.team, number(*id), [](const TeamMate& m) { return number(m.id); });
  return mate == setup.team.end() ? std::string() : mate->name;
}

std::string count_words(const HelmReport& report) {
  const auto heard = std::ranges::count_if(report.neighbours, &HelmReport::Neighbour::shown);
  return std::to_string(heard) + " of " + std::to_string(report.neighbours.size());
}

std::string summary_of(const HelmReport& report) {
  const HelmOrder& order = report.order;
  switch (order.state) {
    case HelmState::waiting:
      return "waiting for own navigation";
    case HelmState::idle:
      return "idle: no goal";
    case HelmState::arrived:
      return "arrived, holding";
    case HelmState::keeping:
      return "keeping position, as told";
    case HelmState::holding:
    case HelmState::handed_back: {
      const bool held = order.state == HelmState::holding;
      std::string words = (held ? "holding: " : "handed back: ") + std::string(order.reason);
      if (order.reason.starts_with("own navigation")) words += " (" + rounded(report.own_age) + " s old)";
      return words;
    }
    case HelmState::under_way:
      break;
  }
  if (const std::string_view note = note_of(order.progress.state); !note.empty())
    return "under way, " + std::string(note) + " (" + rounded(order.time - order.progress.last_progress) +
           " s)";
  switch (order.command.mode) {
    case Mode::cruise:
      return "under way, " + count_words(report) + " neighbours known, nobody in the way";
    case Mode::avoid:
      return "under way, avoiding " + count_words(report);
    case Mode::hold:
      return "under way, waiting for others to pass";
    case Mode::infeasible:
      break;
  }
  return "under way, no safe velocity found";
}

Diagnosis::Level level_of(const HelmReport& report, double now) {
  using Level = Diagnosis::Level;
  const HelmState state = report.order.state;
  if (state == HelmState::holding || state == HelmState::handed_back) return Level::error;
  if (state == HelmState::waiting) return Level::stale;
  const bool is_late = std::ranges::any_of(
      report.neighbours, [](const HelmReport::Neighbour& n) { return !n.heard || n.stale || n.lost; });
  const bool is_infeasible = report.order.command.mode == Mode::infeasible;
  const bool is_stuck =
      report.order.progress.state == Headway::deadlocked || report.order.progress.state == Headway::trapped;
  return is_late || is_infeasible || is_stuck || now - report.refused_at < lately ? Level::warning
                                                                                  : Level::ok;
}

}  // namespace

Diagnosis diagnosis_of(const Helm& helm, double now) {
  const HelmReport report = helm.report(now);
  Diagnosis diagnosis{.level = level_of(report, now), .summary = summary_of(report), .values = {}};
  const auto say = [&](std::string name, std::string value) {
    diagnosis.values.emplace_back(std::move(name), std::move(value));
  };
  const auto say_counts = [&](const std::string& whose, const Counts& counts) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
      say(whose + enum_name(static_cast<FixVerdict>(i)) + "_count", std::to_string(counts[i]));
    }
  };

  const HelmOrder& order = report.order;
  say("state", enum_name(order.state));
  say("reason", std::string(order.reason));
  say("mode", enum_name(order.command.mode));
  say("note", std::string(order.command.note));
  say("progress", enum_name(order.progress.state));
  say("progress_note", std::string(note_of(order.progress.state)));
  say("no_progress_s", rounded(order.time - order.progress.last_progress));
  say("progress_with", name_of(helm.setup(), order.progress.with));
  say("method", std::string(helm.algorithm().title));
  say("decision_count", std::to_string(report.decisions));
  say("infeasible_count", std::to_string(report.infeasible));
  say("clock_restart_count", std::to_string(report.clock_restarts));
  say("record_refused_count", std::to_string(report.records_refused));
  say("own.age_s", rounded(report.own_age));
  say("own.position_sigma_m", rounded(report.own_position_sigma));
  say("own.verdict", enum_name(report.own_verdict));
  say_counts("own.", report.own_counts);
  for (const HelmReport::Neighbour& neighbour : report.neighbours) {
    const std::string whose = neighbour.mate->name + ".";
    say(whose + "state", state_of(neighbour));
    say(whose + "age_s", rounded(neighbour.age));
    say(whose + "distance_m", rounded(neighbour.distance));
    say(whose + "growth_m", rounded(neighbour.growth));
    say(whose + "verdict", enum_name(neighbour.verdict));
    say(whose + "refused_count", std::to_string(refused_of(neighbour.counts)));
    say_counts(whose, neighbour.counts);
  }
  return diagnosis;
}

}  // namespace fairway::bridge
