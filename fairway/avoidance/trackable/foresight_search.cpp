// SPDX-License-Identifier: Apache-2.0
// Which of many plans is taken.
#include <algorithm>
#include <limits>
#include <span>

#include "fairway/avoidance/trackable/foresight.hpp"

namespace fairway::trackable {
namespace {

constexpr std::size_t few = 4;  // plans

}  // namespace

struct Foresight::Search {
  struct Held {  // where a backup begins
    Motion<double> motion;
    std::size_t plan;
    bool is_clear;
  };
  const Foresight& in;
  const Courses& courses;
  std::size_t count;
  const lanes::Kernel& kernel;
  Bounds bounds;
  std::array<double, most_courses> clear_steps;
  std::array<Held, most_courses> held;
  std::size_t held_count = 0;

  Search(const Foresight& foresight, const Courses& all, std::size_t number)
      : in{foresight}, courses{all}, count{number}, kernel{lanes::kernel_for(lanes::most_lanes)} {
    bounds = in.bounds(all.quickest, 0.0);
  }

  Fan fan() const { return fan_among(bounds); }

  Fan fan_among(const Bounds& among) const {
    Fan fan;
    fan.response = &in.response_;
    fan.hazards = in.hazards_.data();
    fan.near2 = among.near2.data();
    fan.first_steps = among.first_steps.data();
    fan.within2 = among.any_within ? among.within2.data() : nullptr;
    fan.hazard_count = in.places_.count();
    fan.steps = in.steps_;
    fan.hold_steps = in.hold_steps_;
    fan.courses = &courses;
    fan.now = &in.now_;
    return fan;
  }

  static void put(Fan& fan, std::size_t lane, const Motion<double>& m) {
    std::size_t column = 0;
    for (const double value :
         {m.north, m.east, m.ahead_north, m.ahead_east, m.turn_rate, m.speed, m.sway, m.error})
      fan.motion[column++][lane] = value;
  }
  static Motion<double> held_at(const Fan& fan, std::size_t lane) {
    const auto of = [&](std::size_t column) { return fan.held[column][lane]; };
    return {of(0), of(1), of(2), of(3), of(4), of(5), of(6), of(7)};
  }

  /// The first course that is clear, or their number; of who is set aside, that has a backup besides, but for
  /// what goes along, since it may be set on something beyond the window. Keeps in mind who may have a
  /// backup. What is asked is clear most often, or little else: few are looked at first.
  std::size_t first_clear() {
    Fan fan = this->fan();
    const bool needs_backup = in.needs_backup();
    for (const lanes::Kernel* of = &lanes::kernel_for(few); fan.first < count; of = &kernel) {
      of->roll(fan);
      const std::size_t end = std::min(fan.first + of->lanes, count), before = held_count;
      std::copy_n(fan.clear_steps, end - fan.first, clear_steps.begin() + fan.first);
      for (std::size_t i = fan.first; i < end; ++i) {
        if (fan.clear_steps[i - fan.first] != static_cast<double>(in.steps_)) continue;
        if (!needs_backup) return i;
        hold(fan, i, true);
      }
      const std::span<const Held> clear = std::span{held}.subspan(before, held_count - before);
      if (!clear.empty())
        if (const std::size_t at = first_backed_up(clear, in.without_what_goes_along(bounds)); at < count)
          return at;
      for (std::size_t i = fan.first; i < end; ++i) {
        const double clear = fan.clear_steps[i - fan.first];
        if (clear >= static_cast<double>(in.hold_steps_) && clear != static_cast<double>(in.steps_))
          hold(fan, i, false);
      }
      fan.first = end;
    }
    return count;
  }

  void hold(const Fan& fan, std::size_t plan, bool is_clear) {
    held[held_count++] = {held_at(fan, plan - fan.first), plan, is_clear};
  }

  /// The first of all that has a backup, or their number.
  std::size_t first_backed_up() const { return first_backed_up({held.data(), held_count}, bounds); }

  /// The first that is clear, with a backup or without, or their number.
  std::size_t first_clear_so_far() const {
    std::size_t first = count;
    for (std::size_t i = 0; i < held_count; ++i)
      if (held[i].is_clear) first = std::min(first, held[i].plan);
    return first;
  }

  /// The first of these. Lanes that there is none for repeat the last.
  std::size_t first_backed_up(std::span<const Held> all, const Bounds& among) const {
    Fan fan = fan_among(among);
    fan.begin = in.hold_steps_;
    const bool circles = in.cannot_stop();
    fan.plans = circles ? Fan::Plans::circle : Fan::Plans::stop;
    const std::size_t sides = circles ? 2 : 1;
    for (std::size_t begin = 0; begin < sides * all.size(); begin += kernel.lanes) {
      const std::size_t end = std::min(begin + kernel.lanes, sides * all.size());
      for (std::size_t lane = 0; lane < kernel.lanes; ++lane) {
        const std::size_t i = std::min(begin + lane, end - 1);
        fan.side[lane] = i % sides == 0 ? 1.0 : -1.0;
        put(fan, lane, all[i / sides].motion);
      }
      kernel.roll(fan);
      for (std::size_t i = begin; i < end; ++i)
        if (fan.clear_steps[i - begin] == static_cast<double>(in.steps_)) return all[i / sides].plan;
    }
    return count;
  }

  /// Where nothing is clear: of the courses that leave nearly as much room as any, the first that has most of
  /// it at the end, since what all lose alike on the way says nothing of who gets out. Of who cannot stop,
  /// and looks ahead by all of a circle, only those count that are clear for longest: later there may be
  /// others. Their number if none leaves more than `most`.
  std::size_t roomiest(double most) {
    const double longest =
        in.cannot_stop() ? *std::max_element(clear_steps.begin(), clear_steps.begin() + count) : 0.0;
    std::array<double, most_courses> rooms, last_rooms;
    bounds.first_steps.fill(0);
    bounds.near2.fill(0.0);
    Fan fan = this->fan();
    fan.asks_room = true;
    for (; fan.first < count; fan.first += kernel.lanes) {
      kernel.roll(fan);
      for (std::size_t i = fan.first; i < std::min(fan.first + kernel.lanes, count); ++i) {
        rooms[i] =
            clear_steps[i] >= longest ? fan.room[i - fan.first] : -std::numeric_limits<double>::infinity();
        last_rooms[i] = fan.last_room[i - fan.first];
      }
    }
    const double best_room = *std::max_element(rooms.begin(), rooms.begin() + count);
    if (!(best_room > most)) return count;
    std::size_t best = count;
    for (std::size_t i = 0; i < count; ++i)
      if (in.is_nearly(rooms[i], best_room) && (best == count || last_rooms[i] > last_rooms[best])) best = i;
    return best;
  }
};

Foresight::Pick Foresight::best_of(const Plan& asked, const Courses& courses,
                                   std::size_t count) const noexcept {
  if (asked.turn_rate && is_safe(asked)) return {count, Prospect::clear};
  Search search{*this, courses, count};
  if (const std::size_t at = search.first_clear(); at < count) return {at, Prospect::clear};
  if (const std::size_t at = search.first_backed_up(); at < count) return {at, Prospect::backed_up};
  if (asked.turn_rate && is_clear(asked, std::abs(asked.speed))) return {count, Prospect::clear};
  if (const std::size_t at = search.first_clear_so_far(); at < count) return {at, Prospect::clear};
  const double most = asked.turn_rate ? room_of(asked).least : -std::numeric_limits<double>::infinity();
  return {search.roomiest(most), Prospect::lost};
}

}  // namespace fairway::trackable
