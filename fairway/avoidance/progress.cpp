// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/progress.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/math.hpp"

namespace fairway {
namespace {

constexpr double least_share = 0.1;       // of the way cruised in a window: less is no progress
constexpr double near_share = 1.0 / 3.0;  // likewise: whoever is farther has no part in it
constexpr double return_windows = 1.5;    // a place left for so long is new again

}  // namespace

std::string_view note_of(Headway headway) noexcept {
  switch (headway) {
    case Headway::making:
    case Headway::holding:
      break;
    case Headway::waiting:
      return "no progress: waiting for somebody to clear the way";
    case Headway::deadlocked:
      return "no progress: deadlocked with somebody who is at rest as well";
    case Headway::trapped:
      return "no progress: trapped, and nobody is near who could clear the way";
  }
  return {};
}

// every room is that of a place from the beginning, so that whoever looks for one looks among places
void Trail::forget() noexcept {
  here_ = {};
  entered_ = since_ = here_.seen;
  std::ranges::fill(rooms_, here_);
  room_of_.fill(none);
  for (std::size_t room = 0; room < rooms_.size(); ++room)
    room_of_[room + 1] = static_cast<std::uint8_t>(room);
  present_ = newest_ = 0;
}

bool Trail::see(double time, const Vec3& position, double step, double window) noexcept {
  const auto is_recent = [&](const Place& place) { return time - place.seen <= return_windows * window; };
  const auto is_in = [&](const Place& place) {
    return is_recent(place) && (position - place.position).squaredNorm() <= step * step;
  };
  if (is_in(here_)) {
    here_.seen = time;
    if (time - entered_ <= window) return false;
    here_.position = position;  // what it crept in a window leads nowhere
    entered_ = time;
    return false;
  }
  entered_ = time;
  const auto known =
      std::ranges::find_if(room_of_, [&](std::uint8_t room) { return room != none && is_in(rooms_[room]); });
  if (known != room_of_.end()) {
    std::swap(here_, rooms_[*known]);
    here_.seen = time;
    room_of_[present_] = std::exchange(*known, none);
    present_ = static_cast<std::uint8_t>(known - room_of_.begin());
    return false;
  }
  newest_ = static_cast<std::uint8_t>((newest_ + 1U) % most_places);
  leave_for(newest_, is_recent);
  present_ = newest_;
  here_ = {position, time};
  since_ = time;
  return true;
}

/// Keeps the place that is here in the room of the one that `next` replaces, or else of one that was too long
/// ago.
template <class IsRecent>
void Trail::leave_for(std::uint8_t next, const IsRecent& is_recent) noexcept {
  if (next == present_) return;
  std::uint8_t room = std::exchange(room_of_[next], none);
  if (room == none) {
    const auto left = std::ranges::find_if(
        room_of_, [&](std::uint8_t other) { return other != none && !is_recent(rooms_[other]); });
    if (left != room_of_.end()) {
      room = std::exchange(*left, none);
    } else {
      rooms_.reserve(most_places - 1);
      room = static_cast<std::uint8_t>(rooms_.size());
      rooms_.emplace_back();
    }
  }
  rooms_[room] = here_;
  room_of_[present_] = room;
}

void ProgressWatch::forget() noexcept {
  *this = ProgressWatch{window_, std::move(trail_)};
  trail_.forget();
}

void ProgressWatch::see(double time, const Vec3& position, const Goal& goal, bool under_way) noexcept {
  const bool sets_out = under_way && !under_way_;
  time_ = time;
  under_way_ = under_way && goal.cruise_speed > 0.0;
  if (goal.cruise_speed > 0.0) step_ = least_share * goal.cruise_speed * window_;
  const bool is_new_place = trail_.see(time, position, step_, window_);

  // another goal is no progress, but what is nearest to it begins anew
  const double distance = (goal.position - position).norm();
  const bool begins = sets_out || goal.position != goal_;
  const bool is_nearer = !begins && distance <= least_distance_ - step_;
  goal_ = goal.position;
  if (begins || is_nearer || time - nearer_at_ > window_) {
    least_distance_ = begins ? distance : math::fmin(distance, least_distance_);
    nearer_at_ = time;
  }
  if (is_new_place || is_nearer || sets_out || !under_way_) last_progress_ = time;
}

double ProgressWatch::reach() const noexcept { return near_share / least_share * step_; }

ProgressReport ProgressWatch::judge(Mode mode, std::span<const Bystander> bystanders) const noexcept {
  ProgressReport report{.state = Headway::making, .last_progress = last_progress_, .since = last_progress_};
  if (!under_way_) report.state = Headway::holding;
  if (!is_late()) return report;

  const Bystander* moving = nullptr;
  const Bystander* resting = nullptr;
  double latest = last_progress_;
  for (const Bystander& other : bystanders) {
    if (other.gap > reach()) continue;
    const bool rests = time_ - other.rests_since > window_;
    if (rests && !other.may_clear_way) continue;
    const Bystander*& nearest = rests ? resting : moving;
    if (nearest == nullptr || other.gap < nearest->gap) nearest = &other;
    latest = math::fmax(latest, other.rests_since);
  }
  const bool waits = moving != nullptr || (resting == nullptr && mode == Mode::hold);
  report.state = waits ? Headway::waiting : resting != nullptr ? Headway::deadlocked : Headway::trapped;
  if (report.state == Headway::deadlocked) report.since = latest;
  if (const Bystander* who = moving != nullptr ? moving : resting) report.with = who->id;
  return report;
}

}  // namespace fairway
