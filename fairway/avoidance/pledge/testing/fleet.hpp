// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>
#include <vector>

#include "fairway/avoidance/pledge/agreement.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::pledge {

inline constexpr double step = 0.2;

struct Spoken {
  Speech speech;
  std::size_t from;
  double heard;  ///< when [s]
};

/// A model of all groups: members that keep to their references exactly, or stop before somebody who is held
/// in their way, and a modem that loses what a test has it lose.
struct Fleet {
  std::vector<Spoken> said;
  std::vector<Agreement> members;
  std::vector<Vec3> places;
  std::vector<std::vector<Obstacle>> charts;  ///< of each member
  std::vector<Reference> last_ways;           ///< of who has arrived, which goes on to its end
  std::vector<std::size_t> slots;             ///< of a turn, in which each member speaks
  double turn_period{};
  double on_the_air{0.0};  ///< for which a word is [s]
  double patience{0.0};    ///< in turns
  double period{step};     ///< that members are told to decide at [s]
  double time{0.0};
  double least{never};  ///< between two of them, so far
  int beside_plans{0};  ///< how often somebody stopped since it would have come near to somebody who is held

  Fleet(const std::vector<Member>& all, double period) : turn_period{period} {
    const Terms terms{.count = all.size(), .tubes = {.radius = 1.0, .told = 0.1}};
    for (std::size_t i = 0; i < all.size(); ++i) {
      members.emplace_back(i, terms).hold(all[i]);
      places.push_back(members[i].own().anchor);
      last_ways.emplace_back();
      slots.push_back(i);
    }
    charts.resize(all.size());
  }

  double turn(std::size_t i, double after) const {
    const double first = turn_period * static_cast<double>(slots[i]) / static_cast<double>(members.size());
    return first + turn_period * std::ceil((after - first) / turn_period + 1e-9);
  }

  bool has_turn(std::size_t i) const { return turn(i, time - step) <= time + 1e-9; }

  /// `gets_through(from, to)` says of each word whether it is heard.
  void go_on(const std::function<bool(std::size_t, std::size_t)>& gets_through) {
    for (std::size_t i = 0; i < members.size(); ++i)
      if (has_turn(i)) said.push_back({members[i].say(time, turn_period), i, time + on_the_air});
    for (const Spoken& word : said) {
      if (word.heard > time + 1e-9) continue;
      for (std::size_t j = 0; j < members.size(); ++j)
        if (j != word.from && gets_through(word.from, j))
          members[j].hear(word.speech, word.heard - on_the_air, time);
    }
    std::erase_if(said, [&](const Spoken& word) { return word.heard <= time + 1e-9; });
    for (std::size_t i = 0; i < members.size(); ++i) {
      std::array<Obstacle, most_vehicles> room;
      members[i].go_on(time, period, {{}, turn_period, turn(i, time)}, patience,
                       members[i].chart(charts[i], room));
      if (const Reference* way = members[i].way()) {
        places[i] = way->at(time);
        const Member& m = members[i].own();
        if ((places[i] - m.destination).norm() <= m.arrival) {
          last_ways[i] = *way;
          members[i].arrive(way->knots().back().position);
        }
      } else if (members[i].status() == Status::arrived && !last_ways[i].empty()) {
        places[i] = last_ways[i].at(time);
      }
      if (const Reference* way = members[i].way();
          way != nullptr && members[i].meets_held(*way, time, time + 8.0)) {
        Member stopped = members[i].own();
        stopped.anchor = places[i];
        members[i].hold(stopped);
        ++beside_plans;
      }
      const bool rests = (places[i] - members[i].own().anchor).norm() <= 1.0;
      members[i].take_turns(time, period, turn_period, true, rests);
    }
    for (std::size_t i = 0; i < members.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) least = std::min(least, (places[i] - places[j]).norm());
    time += step;
  }

  std::ptrdiff_t moving() const {
    return std::ranges::count_if(members, [](const Agreement& m) { return m.status() == Status::moving; });
  }

  bool is_done() const {
    return std::ranges::all_of(members, [](const Agreement& m) { return m.status() == Status::arrived; });
  }
};

inline Member crossing(const Vec3& from, const Vec3& to) {
  return {.anchor = from,
          .destination = to,
          .arrival = 3.0,
          .radius = 1.5,
          .speed = 0.45,
          .climb = 0.22,
          .descent = 0.28,
          .turn = 5.0};
}

inline std::vector<Member> three_in_a_plane() {
  std::vector<Member> all;
  for (int i = 0; i < 3; ++i) {
    const double bearing = 2.0943951023931953 * i;
    const Vec3 from{10.0 * std::cos(bearing), 10.0 * std::sin(bearing), 5.0};
    all.push_back(crossing(from, {-from.x(), -from.y(), 5.0}));
  }
  return all;
}

inline std::vector<Member> cube(Rng& rng) {
  std::vector<Member> all;
  for (const auto& [n, e, upper] : {std::tuple{1, 1, true},
                                    {-1, -1, true},
                                    {1, -1, false},
                                    {-1, 1, false},
                                    {-1, -1, false},
                                    {1, 1, false},
                                    {-1, 1, true},
                                    {1, -1, true}}) {
    const auto out = [&] { return upper ? rng.uniform(5, 6.5) : rng.uniform(8.5, 10); };
    all.push_back(crossing({n * out(), e * out(), upper ? rng.uniform(0, 0.5) : 15.0},
                           {-10.0 * n, -10.0 * e, upper ? 20.0 : 0.0}));
  }
  return all;
}

/// Of words: each pair loses half of them, four in a row in the mean.
class LossesInRuns {
 public:
  explicit LossesInRuns(Rng rng) : rng_{rng} {}
  bool operator()(std::size_t from, std::size_t to) {
    bool& loses = loses_[from][to];
    if (rng_.uniform(0, 1) < 0.25) loses = !loses;
    return !loses;
  }

 private:
  Rng rng_;
  std::array<std::array<bool, most_vehicles>, most_vehicles> loses_{};
};

inline const auto always = [](std::size_t, std::size_t) { return true; };

inline bool has_plan(const Agreement& member) { return bool{member.plan().epoch}; }

/// Three of whom one has just proposed, so that all know all and the words that follow decide.
/// In which order three may have their turns.
inline std::vector<std::vector<std::size_t>> orders_of_three() {
  return {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
}

/// Who speak in these slots.
inline Fleet three_about_to_decide(const std::vector<std::size_t>& slots = {0, 1, 2}) {
  Fleet fleet{three_in_a_plane(), 3.0};
  fleet.slots = slots;
  while (std::ranges::none_of(fleet.members, has_plan) && fleet.time < 60.0) fleet.go_on(always);
  return fleet;
}

}  // namespace fairway::pledge
