// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bitset>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <variant>

#include "fairway/avoidance/pledge/rounds.hpp"
#include "fairway/core/speech.hpp"
#include "fairway/core/vec.hpp"

namespace fairway::pledge {

using Members = std::bitset<most_members>;

/// Where a member is held, where it is to go, and how it goes there. All that anybody reckons of its way
/// rests on this and on the plan, so it is used as it comes out of its word, by the sender too.
struct Member {
  Vec3 anchor = Vec3::Zero();       ///< where it is held [m, NED]
  Vec3 destination = Vec3::Zero();  ///< [m, NED]
  double arrival{};                 ///< it has arrived this near to it [m]
  double radius{};                  ///< of its sphere [m]
  double speed{};                   ///< horizontal, along its way [m/s]
  double climb{};                   ///< upwards [m/s]
  double descent{};                 ///< downwards [m/s]
  double turn{};                    ///< in which it turns round [s]
  bool turns_before{false};         ///< to its way, before a plan starts; not told, but known of all
  std::uint8_t version{};           ///< of all this, counted from 0 and modulo 16

  friend bool operator==(const Member&, const Member&) = default;
};

enum class Status : std::uint8_t {
  held,     ///< at its anchor, until a plan has every acknowledgement
  moving,   ///< on its way by the plan
  arrived,  ///< held for ever
  lost,     ///< off what it promised: it holds if it can; its anchor is where it is, its destination where it
            ///< will be `foretold` later if it goes on so
};
inline constexpr double foretold = 10.0;  ///< [s]
inline constexpr double wandering = 1.0;  ///< of who is lost, beyond what it foretold [m]

/// Which plan. Of two plans the one that starts later is the later one, and of two that start together that
/// of the larger author. There is no number to run out of: what is told is the start modulo 58 hours, and
/// nobody tells or hears of a plan that starts beyond `soonest_forgotten` before the present or
/// `farthest_start` after it, so two that are spoken of at one time are less than half of that apart.
struct Epoch {
  static constexpr std::int64_t none = std::numeric_limits<std::int64_t>::min();

  std::int64_t tenths{none};  ///< when all depart [0.1 s]
  std::uint8_t author{};      ///< a member

  explicit operator bool() const { return tenths != none; }
  friend auto operator<=>(const Epoch&, const Epoch&) = default;
};
inline double start_of(const Epoch& epoch) { return 0.1 * static_cast<double>(epoch.tenths); }  ///< [s]
inline constexpr double soonest_forgotten = 36'000.0;                                           ///< [s]
inline constexpr double farthest_start = 1000.0;                                                ///< [s]

/// What every word has.
struct Header {
  std::uint8_t sender{};  ///< a vehicle, of any group
  std::uint8_t round{};   ///< that it is in, modulo four (Rounds)
  Epoch epoch{};          ///< of the newest plan of its group that it knows
  double sent{};          ///< [s], to 0.1 s
  Status status{};
  Members acknowledged{};  ///< who has acknowledged that plan, as far as it knows
  Members departed{};      ///< who has departed by it, likewise
  Members heard{};         ///< whose states it knows
};

/// A member's state, "here I am held".
struct StateWord {
  Header header{};
  Member member{};
};

/// How each member goes: three numbers of the codebook in one byte.
struct Code {
  std::uint8_t ring{};   ///< 0 to 7: straight, or by a ring about the centre (ring_radius)
  std::uint8_t delay{};  ///< 0 to 7, in steps of delay_step; but the last bit of who goes below its way says
                         ///< whether it dives on the spot (is_on_the_spot)
  /// 0 to 3: how much of the time to spare goes by before it dives or climbs, in thirds; of a way that is
  /// level, how many levels below it the member goes (has_levels).
  std::uint8_t dive{};

  std::uint8_t packed() const { return static_cast<std::uint8_t>(ring << 5U | delay << 2U | dive); }
  static Code of(std::uint8_t byte) {
    return {static_cast<std::uint8_t>(byte >> 5U), static_cast<std::uint8_t>(byte >> 2U & 7U),
            static_cast<std::uint8_t>(byte & 3U)};
  }
  friend bool operator==(const Code&, const Code&) = default;
};

/// By which way and when everybody goes that takes part.
struct Plan {
  Epoch epoch{};
  Vec2 centre = Vec2::Zero();  ///< of the rings [m, north and east]
  std::uint8_t scale{};        ///< 0 to 3: how much wider the rings are than `ring_radius` (ring_scale)
  bool to_port{};              ///< the rings are gone round with the centre to starboard unless this is so
  Members participants{};
  std::array<Code, most_members> codes{};
  std::uint32_t digest{};  ///< of the participants' states, 24 bits

  double start() const { return start_of(epoch); }  ///< [s]

  friend bool operator==(const Plan&, const Plan&) = default;
};

/// A plan, whoever passes it on.
struct PlanWord {
  Header header{};
  Plan plan{};
};

using Word = std::variant<StateWord, PlanWord>;

inline const Header& header_of(const Word& word) noexcept {
  return std::visit([](const auto& w) -> const Header& { return w.header; }, word);
}

/// At most 25 bytes. Positions are told relative to `datum`, +-163 m from it and down to 327 m, in steps of
/// 2 cm; farther ones saturate (fits()). O(1).
Speech encode(const StateWord& word, const Vec2& datum) noexcept;
Speech encode(const PlanWord& word, const Vec2& datum) noexcept;

/// The word that the bytes say, if it was sent within 204 s of `now` [s] and is none that was damaged, made
/// by another version, or speaks of a plan that nobody can mean by then (Epoch). O(1).
std::optional<Word> decode(const Speech& speech, const Vec2& datum, double now) noexcept;

/// The member as everybody comes to know it: encoded and decoded.
Member as_told(const Member& member, const Vec2& datum) noexcept;

/// The nearest speed that can be told, along a way and up or down, or, where that is more than `most`, the
/// next lower one [m/s].
double speed_as_told(double speed, double most) noexcept;
double climb_as_told(double speed, double most) noexcept;

/// The nearest centre of rings that can be told.
Vec2 centre_as_told(const Vec2& centre, const Vec2& datum) noexcept;

/// Whether a place can be told at which somebody is held. O(1).
bool can_be_told(const Vec3& place, const Vec2& datum) noexcept;

/// Why a member cannot be told, empty if it can: its places, at either of which it may be held, are too far
/// from the datum, its sphere, in steps of 25 cm upwards, is larger than 15.75 m, it takes longer than 16 s
/// to turn before it gets under way, or it goes so slowly that it is told not to go at all.
std::string_view misfit_of(const Member& member, const Vec2& datum) noexcept;
inline bool fits(const Member& member, const Vec2& datum) noexcept {
  return misfit_of(member, datum).empty();
}

/// 24 bits of the states of those who take part, by which a receiver sees whether it reckons with the same.
std::uint32_t digest_of(const std::array<Member, most_members>& members, const Members& participants,
                        const Vec2& datum) noexcept;

}  // namespace fairway::pledge
