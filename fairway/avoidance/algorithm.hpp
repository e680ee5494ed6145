// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/avoidance/command.hpp"
#include "fairway/avoidance/situation.hpp"
#include "fairway/avoidance/sketch.hpp"
#include "fairway/core/params.hpp"
#include "fairway/core/rng.hpp"

namespace fairway {

/// What decide() may use besides its arguments.
struct Context {
  Rng& rng;
  Sketch* sketch = nullptr;  ///< null unless someone is looking
};

/// What to print about an algorithm, and where it comes from.
struct AlgorithmInfo {
  std::string_view name;           ///< as written in a scenario: "orca3d"
  std::string_view title;          ///< "Optimal reciprocal collision avoidance in three dimensions"
  std::string_view source;         ///< the paper and the equations implemented
  bool planar = false;             ///< thinks in the horizontal plane: reads and writes d = 0
  bool allocates = false;          ///< true only for planners that must
  bool isotropic = true;           ///< turning the scene about the vertical turns the answer
  bool handed = false;             ///< prefers a side: the mirrored scene need not have the mirrored answer
  bool steers_by_heading = false;  ///< reckons with the turn: goes straight for the goal once it heads for it

  // what is none of its business: it decides the same without it. A wrapper says it of its own part
  bool ignores_obstacles = false;  ///< spheres, walls and polygons
  bool ignores_movers = false;     ///< tracks: vehicles and what drifts

  bool commands_forces = false;  ///< it may answer with a wrench, which its own gains hold to the vehicle

  bool needs_envelope = false;  ///< reads Situation::envelope, which takes some milliseconds to find

  // what it takes for granted of the vehicle and of what is about; where that is not so, the user is told
  bool needs_sway = false;      ///< moves a point that goes any way at once
  bool needs_stopping = false;  ///< waits, or ends at rest
  bool needs_chart = false;     ///< of what stands it avoids only what is charted
  bool needs_link = false;      ///< decides nothing without hearing from the others

  bool follows = false;     ///< asks of a vehicle that must turn only what it can follow: sway is not needed
  bool shows_only = false;  ///< of a wrapper: changes what the inner avoider is shown, not what it answers
  bool finds_way = false;   ///< goes round what stands by a way that it looks for to the goal
};

/// "ignores obstacles and whatever moves"; empty for whoever ignores nothing.
constexpr std::string_view ignorance_of(const AlgorithmInfo& info) {
  if (info.ignores_obstacles && info.ignores_movers) return "ignores obstacles and whatever moves";
  if (info.ignores_obstacles) return "ignores obstacles";
  return info.ignores_movers ? "ignores whatever moves" : "";
}

/// Something that a method may take for granted.
struct Need {
  bool AlgorithmInfo::*member;
  std::string_view word;
};
inline constexpr std::array all_needs{
    Need{&AlgorithmInfo::needs_sway, "sway"}, Need{&AlgorithmInfo::needs_stopping, "stopping"},
    Need{&AlgorithmInfo::needs_chart, "chart"}, Need{&AlgorithmInfo::needs_link, "link"},
    Need{&AlgorithmInfo::planar, "plane"}};

/// For algorithms that remember nothing.
struct NoMemory {
  friend constexpr bool operator==(const NoMemory&, const NoMemory&) = default;
};

/// A collision avoidance algorithm: a function of the situation, its own memory and the given
/// randomness. Nothing else may influence it, no clock, no globals, no I/O, so a copied Memory
/// replays exactly, and a run can be resumed at any step.
template <class A>
concept AvoidanceAlgorithm =
    requires(const A& a, const Situation& situation, typename A::Memory& memory, Context& context) {
      requires Reflected<typename A::Params> && std::copyable<typename A::Memory>;
      { A::info } -> std::convertible_to<AlgorithmInfo>;
      { A{typename A::Params{}} } -> std::copyable;
      { a.params } -> std::convertible_to<const typename A::Params&>;
      { a.decide(situation, memory, context) } noexcept -> std::same_as<Command>;
    };

/// An algorithm that has something to say: what it would say in its vehicle's next turn, as it stands in its
/// memory. Its vehicle says that instead of telling where it is.
template <class A>
concept Speaks = requires(const A& a, const typename A::Memory& memory) {
  { a.speech(memory) } noexcept -> std::same_as<Speech>;
};

/// A word in plain words, for people who look at a run.
struct Reading {
  std::string text;                  ///< a line, whose subject is who said it: "is held at [1, 2, 3] m NED"
  std::vector<VehicleId> awaited{};  ///< whose words its sender waits for, as far as the word tells
};

/// An algorithm that says how a word of its kind is read. What is no such word it says to be none. Words are
/// never read in a step.
template <class A>
concept ReadsWords = requires(const A& a, const Heard& word) {
  { a.reading(word) } -> std::same_as<Reading>;
};

class Avoider;

/// A strategy around another avoider, such as stop-and-wait: it may ask the inner one, change what
/// it is shown or what it answered.
template <class W>
concept AvoidanceWrapper = requires(const W& w, const Situation& situation, Avoider& inner,
                                    typename W::Memory& memory, Context& context) {
  requires Reflected<typename W::Params> && std::copyable<typename W::Memory>;
  { W::info } -> std::convertible_to<AlgorithmInfo>;
  { w.decide(situation, inner, memory, context) } noexcept -> std::same_as<Command>;
};

}  // namespace fairway
