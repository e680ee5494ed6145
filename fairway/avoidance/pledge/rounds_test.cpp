// SPDX-License-Identifier: Apache-2.0
// Claims C7 and C8 of README.md, by a search through all states of small models: every word may be lost, or
// be heard at any time after it was said, and every vehicle may do what the rules let it at any time.
#include "fairway/avoidance/pledge/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

#include "fairway/core/rng.hpp"

namespace fairway::pledge {
namespace {

/// A rule of `Rounds` that nobody keeps.
enum class LeftOut {
  nothing,
  own_round,     // rule 1, first half
  known_places,  // rule 1, second half
  way,           // rule 2
  everyone,      // rule 3
  order,         // rule 4
};

struct Told {
  std::int8_t round{};
  std::int8_t place{};
  bool moves{false};  ///< from there to the next place
  friend bool operator==(const Told&, const Told&) = default;
};

struct Vehicle {
  Rounds rounds;
  bool moves{false};
  std::array<Told, 20> said{};  ///< all that it ever said, each thing once
  std::int8_t said_count{1};
  std::array<std::int8_t, 4> heard{-1, -1, -1, -1};     ///< which word of each was heard last
  std::array<std::int8_t, 4> believed{-1, -1, -1, -1};  ///< likewise when it departed last

  Told now() const { return said[static_cast<std::size_t>(said_count) - 1]; }
  /// What it does is what that word told, or that it has come to the end of its way.
  bool is_as(const Told& told) const {
    return told.moves && !moves ? now().place == told.place + 1
                                : told.moves == moves && told.place == now().place;
  }
  void say(const Told& word) { said[static_cast<std::size_t>(said_count++)] = word; }
};

struct Model {
  Groups groups;
  int last_round;   ///< beyond which nobody goes
  int most_places;  ///< that a vehicle ever moves to
  LeftOut left_out{LeftOut::nothing};
};

using Sea = std::vector<Vehicle>;

struct Outcome {
  std::size_t states{0};
  std::size_t moves{0};     ///< departures among them
  std::size_t together{0};  ///< pairs of two groups that move at one time
  std::string wrong;        ///< the first thing that must not be
};

class ModelSearch {
 public:
  explicit ModelSearch(const Model& model) : model_{model} {}

  /// All states.
  Outcome run() {
    begin();
    while (!open_.empty() && outcome_.wrong.empty()) {
      const Sea sea = std::move(open_.back());
      open_.pop_back();
      bool is_over = true;  // all was heard, nobody moves, and nobody may do anything
      for (std::size_t i = 0; i < sea.size(); ++i) is_over = !act(sea, i) && is_over;
      const bool is_at_end =
          std::ranges::any_of(sea, [&](const Vehicle& v) { return v.now().round == model_.last_round; });
      if (is_over && !is_at_end) outcome_.wrong = "nobody can ever go on";
    }
    return outcome_;
  }

  /// One of the ways through them, drawn.
  Outcome walk(Rng rng) {
    begin();
    while (!open_.empty() && outcome_.wrong.empty()) {
      const auto choice = static_cast<std::size_t>(rng.uniform(0, static_cast<double>(open_.size())));
      const Sea sea = open_[choice];
      open_.clear();
      for (std::size_t i = 0; i < sea.size(); ++i) act(sea, i);
    }
    return outcome_;
  }

 private:
  void begin() {
    Sea begins(model_.groups.vehicles);
    for (std::size_t i = 0; i < begins.size(); ++i) begins[i].rounds = Rounds{i, model_.groups};
    visit(begins);
  }

  bool has(LeftOut rule) const { return model_.left_out == rule; }

  /// Everything that one vehicle may do next. False for nothing.
  bool act(const Sea& sea, std::size_t i) {
    const Vehicle& v = sea[i];
    const bool may_depart = (has(LeftOut::own_round) || v.rounds.owns()) &&
                            (has(LeftOut::known_places) || v.rounds.knows_places());
    bool can = false;
    if (!v.moves && may_depart && v.now().place < model_.most_places) {
      Sea next = sea;
      next[i].moves = true;
      next[i].believed = v.heard;
      ++outcome_.moves;
      visit(next);
    }
    if (v.moves) {
      can = true;
      Sea next = sea;
      next[i].moves = false;
      const Told now = v.now();
      next[i].say({now.round, static_cast<std::int8_t>(now.place + 1)});
      visit(next);
    }
    if (may_go_on(v) && v.now().round < model_.last_round) {
      can = true;
      Sea next = sea;
      next[i].rounds.go_on();
      next[i].say(
          {static_cast<std::int8_t>(v.now().round + 1), v.now().place, v.moves && !has(LeftOut::way)});
      visit(next);
    }
    for (std::size_t from = 0; from < sea.size(); ++from) {
      if (from == i) continue;
      const std::int8_t first = has(LeftOut::order) ? 0 : static_cast<std::int8_t>(v.heard[from] + 1);
      for (std::int8_t word = first; word < sea[from].said_count; ++word) {
        can = can || word > v.heard[from];
        hear(sea, i, from, word);
      }
    }
    return can;
  }

  bool may_go_on(const Vehicle& v) const { return has(LeftOut::everyone) || v.rounds.may_go_on(true); }

  void hear(const Sea& sea, std::size_t i, std::size_t from, std::int8_t word) {
    Sea next = sea;
    Vehicle& v = next[i];
    const Told told = sea[from].said[static_cast<std::size_t>(word)];
    const std::int64_t before = v.rounds.heard_in(from);
    v.heard[from] = word;
    v.rounds.hear(from, static_cast<std::uint8_t>(told.round % Rounds::modulus), true);
    if (v.rounds.heard_in(from) != std::max<std::int64_t>(before, told.round))
      outcome_.wrong = "a word was taken to be of another round";
    visit(next);
  }

  /// What must be in every state, and whether it is a new one.
  void visit(const Sea& sea) {
    if (!outcome_.wrong.empty() || !seen_.insert(key_of(sea)).second) return;
    ++outcome_.states;
    for (std::size_t i = 0; i < sea.size(); ++i) {
      for (std::size_t j = 0; j < sea.size(); ++j) {
        if (!sea[i].moves || model_.groups.group_of(i) == model_.groups.group_of(j)) continue;
        if (!has_reckoned_with(sea, i, j) && !has_reckoned_with(sea, j, i))
          outcome_.wrong = "two of whom one moves have not reckoned with each other";
        if (sea[j].moves) ++outcome_.together;
      }
    }
    open_.push_back(sea);
  }

  /// Whether one knew what the other does now when it departed last.
  static bool has_reckoned_with(const Sea& sea, std::size_t i, std::size_t j) {
    const std::int8_t word = sea[i].believed[j];
    return word >= 0 && sea[j].is_as(sea[j].said[static_cast<std::size_t>(word)]);
  }

  /// What a vehicle's Rounds hold follows from its own round and from what it heard last of each.
  static std::string key_of(const Sea& sea) {
    std::string key;
    for (const Vehicle& v : sea) {
      key.push_back(v.moves ? 1 : 0);
      key.push_back(static_cast<char>(v.said_count));
      for (std::int8_t word = 0; word < v.said_count; ++word) {
        const Told& told = v.said[static_cast<std::size_t>(word)];
        key.push_back(static_cast<char>(2 * told.round + (told.moves ? 1 : 0)));
        key.push_back(static_cast<char>(told.place));
      }
      for (const std::int8_t word : v.heard) key.push_back(static_cast<char>(word));
      for (std::size_t j = 0; j < sea.size(); ++j) {
        const Told told =
            v.believed[j] < 0 ? Told{-1, -1} : sea[j].said[static_cast<std::size_t>(v.believed[j])];
        key.push_back(static_cast<char>(2 * told.place + (told.moves ? 1 : 0)));
      }
    }
    return key;
  }

  Model model_;
  Outcome outcome_;
  std::unordered_set<std::string> seen_;
  std::vector<Sea> open_;
};

constexpr Groups one_and_one{.vehicles = 2, .most = 1}, two_and_one{.vehicles = 3, .most = 2},
    two_and_two{.vehicles = 4, .most = 2}, three_of_one{.vehicles = 3, .most = 1},
    four_of_one{.vehicles = 4, .most = 1};

TEST(Rounds, OfTwoGroupsWhoDepartsLaterKnowsWhatTheOtherDoesWhateverIsLostOrLate) {
  for (const Model& model : {Model{one_and_one, 6, 2}, Model{two_and_one, 2, 1}, Model{three_of_one, 4, 1}}) {
    const Outcome outcome = ModelSearch{model}.run();
    EXPECT_EQ(outcome.wrong, "") << model.groups.vehicles << " by " << model.groups.most;
    EXPECT_GT(outcome.moves, 0U);
    EXPECT_GT(outcome.together, 0U);
  }
}

TEST(Rounds, OfTwoByTwoAndFourByOneTheSameHoldsOnManyWaysThroughMoreOfThem) {
  std::size_t moves = 0;
  for (const Groups& groups : {two_and_two, four_of_one}) {
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
      const Outcome outcome = ModelSearch{{groups, 7, 3}}.walk(Rng{seed}.stream("rounds"));
      ASSERT_EQ(outcome.wrong, "") << groups.most << ", seed " << seed;
      moves += outcome.moves;
    }
  }
  EXPECT_GT(moves, 4000U);
}

TEST(Rounds, WithoutAnyOneOfTheirRulesTheSearchFindsWhatMustNotBe) {
  const auto wrong = [](const Groups& groups, int last_round, LeftOut rule) {
    return ModelSearch{{groups, last_round, 2, rule}}.run().wrong;
  };
  const std::string elsewhere = "two of whom one moves have not reckoned with each other",
                    misread = "a word was taken to be of another round";
  EXPECT_EQ(wrong(three_of_one, 4, LeftOut::own_round), elsewhere);
  EXPECT_EQ(wrong(one_and_one, 4, LeftOut::known_places), elsewhere);
  EXPECT_EQ(wrong(one_and_one, 4, LeftOut::way), elsewhere);
  EXPECT_EQ(wrong(one_and_one, 4, LeftOut::everyone), misread);
  EXPECT_EQ(wrong(one_and_one, 4, LeftOut::order), misread);
}

TEST(Rounds, DealOutVehiclesSoThatGroupsDifferByOneAtMost) {
  for (std::size_t vehicles = 2; vehicles <= most_vehicles; ++vehicles) {
    const Groups groups{.vehicles = vehicles};
    ASSERT_LE(groups.count(), most_groups);
    std::array<std::size_t, most_groups> sizes{};
    for (std::size_t i = 0; i < vehicles; ++i) {
      EXPECT_EQ(groups.member_of(i), sizes[groups.group_of(i)]++) << i << " of " << vehicles;
      EXPECT_EQ(groups.member_of(i) * groups.count() + groups.group_of(i), i);
    }
    for (std::size_t group = 0; group < groups.count(); ++group) {
      EXPECT_EQ(groups.size_of(group), sizes[group]);
      EXPECT_LE(sizes[group], most_members);
      EXPECT_LE(sizes[0] - sizes[group], 1U);
    }
  }
}

}  // namespace
}  // namespace fairway::pledge
