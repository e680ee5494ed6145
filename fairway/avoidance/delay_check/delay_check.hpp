// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "fairway/avoidance/algorithm.hpp"
#include "fairway/avoidance/delay_check/trajectory.hpp"

namespace fairway {

/// Two-step commitments with a delay check, after RMADER (Kondo et al. 2023): a vehicle follows what it has
/// committed to, says what it would do next, waits as long as a word may take, and commits to that only if
/// nothing that it has heard by then conflicts. Here a trajectory is one straight leg and words are those of
/// a modem, 25 bytes a turn. It avoids only whom it hears, and is safe only as far as no word takes longer
/// than the delay check. O(trajectories heard), and before each own turn as many times the candidates.
///
///     paper              here
///     traj_i (committed) Memory::committed
///     traj_i,new         Memory::next
///     delta_DC           delay_turns, in turns of the modem
struct DelayCheck {
  static constexpr AlgorithmInfo info{
      .name = "delay_check",
      .title = "Two-step commitments with a delay check",
      .source = "after RMADER: Kondo, Figueroa, Rached, Tordesillas, Lusk, How 2023 (arXiv 2303.06222)",
      .isotropic = false,
      .handed = true,
      .ignores_obstacles = true,
      .ignores_movers = true,
      .needs_envelope = true,
      .needs_stopping = true,
      .needs_link = true,
  };

  struct Params {
    double delay_turns_count = 1.3;
    double tube_m = 1.0;
    double speed_ratio = 0.95;
    double gain_hz = 0.3;
    double datum_north_m = 0.0;
    double datum_east_m = 0.0;

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          field<&P::delay_turns_count>({0, 100},
                                       "the delay check: turns of the modem from a word to the commitment"),
          field<&P::tube_m>({0.05, 100}, "a vehicle is never farther than this from its trajectory"),
          field<&P::speed_ratio>({0.1, 1}, "of its greatest speed at which a vehicle plans to go"),
          field<&P::gain_hz>({0, 10}, "speed by which it returns to its trajectory, for each metre off it"),
          field<&P::datum_north_m>({-1e6, 1e6}, "to which places are told; the same for all"),
          field<&P::datum_east_m>({-1e6, 1e6}, "likewise"),
      };
    }
  };

  static constexpr std::size_t most_others = 63;  ///< that it keeps in mind; who hears of more plans nothing

  /// What somebody has said last.
  struct Other {
    VehicleId id{};
    double sent{};  ///< [s]
    delay_check::Word word{};
  };

  struct Memory {
    bool begun{false};
    double began{};    ///< [s]
    double time{};     ///< [s]
    double turn{};     ///< it takes to turn round [s]
    double commits{};  ///< when it commits to `own.next`, if it has one [s]
    delay_check::Word own{};
    std::array<Other, most_others> others{};
    std::size_t count{0};
    bool is_crowded{false};  ///< it has heard of more
  };

  Params params;

  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;
  Speech speech(const Memory& memory) const noexcept;
  Reading reading(const Heard& word) const;

 private:
  Vec2 datum() const noexcept { return {params.datum_north_m, params.datum_east_m}; }
  bool begin(const Situation& s, Memory& memory) const noexcept;
  void hear(const Situation& s, Memory& memory) const noexcept;
  void check(const Situation& s, Memory& memory) const noexcept;
  bool is_first_to_plan(const Situation& s, const Memory& memory) const noexcept;
  void plan(const Situation& s, Memory& memory) const noexcept;
  static void stand(const Situation& s, Memory& memory) noexcept;
  std::optional<delay_check::Trajectory> soonest_leg(const Situation& s, const Memory& memory, double departs,
                                                     double most_bend) const noexcept;
  static std::string_view what_it_waits_for(const Memory& memory) noexcept;
  bool is_clear(const Memory& memory, const delay_check::Trajectory& own, double from) const noexcept;
};

static_assert(AvoidanceAlgorithm<DelayCheck>);
static_assert(Speaks<DelayCheck> && ReadsWords<DelayCheck>);

}  // namespace fairway
