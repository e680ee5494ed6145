// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/algorithm.hpp"
#include "fairway/avoidance/pledge/agreement.hpp"
#include "fairway/avoidance/pledge/datum.hpp"
#include "fairway/avoidance/pledge/obedience.hpp"

namespace fairway {

/// Acknowledged commitments over a modem: a group of up to eight stays where it is until a plan for all has
/// every member's acknowledgement, and then each keeps to its reference in a tube. What is lost on the way
/// delays it, and never brings two together (README.md, whose claims are the rules of `Agreement`). It keeps
/// off what the chart shows. More than eight are up to four groups, which depart in turns. It avoids nobody
/// who does not agree. A decision is O(knots + obstacles), and while a plan is sought up to 0.5 ms more.
struct Pledge {
  static constexpr AlgorithmInfo info{
      .name = "pledge",
      .title = "Acknowledged commitments: no collision, whatever the modem loses",
      .source = "ours",
      .isotropic = false,
      .handed = true,
      .ignores_movers = true,
      .needs_envelope = true,
      .needs_stopping = true,
      .needs_chart = true,
      .needs_link = true,
      .follows = true,
      .finds_way = true,
  };

  struct Params {
    int team_count = 8;
    double tube_m = 1.0;
    double speed_ratio = 0.95;
    double gain_hz = 0.3;
    double patience_count = 4.0;
    double headway_s = 20.0;
    double datum_north_m = 0.0;
    double datum_east_m = 0.0;

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          field<&P::team_count>({2, pledge::most_vehicles},
                                "vehicles that agree, whose ids are 0 to one less; in a scenario all whose "
                                "methods do, unless it says how many; more than eight are several groups, "
                                "which depart in turns"),
          field<&P::tube_m>({0.05, 100}, "a member is never farther than this from its promised place"),
          field<&P::speed_ratio>({0.1, 1}, "of its greatest speed at which a member plans to go"),
          field<&P::gain_hz>({0, 10}, "speed by which it returns to its reference, for each metre off it"),
          field<&P::patience_count>(
              {0, 20},
              "turns more than the least that acknowledgements are waited for, where the "
              "clock has not begun"),
          field<&P::headway_s>(
              {0, 60},
              "for so long whoever stops on its way should be in nobody's: a plan that lacks "
              "a second of it has to be half a second quicker"),
          field<&P::datum_north_m>({-1e6, 1e6}, "to which places are told; the same for all"),
          field<&P::datum_east_m>({-1e6, 1e6}, "likewise"),
      };
    }
  };

  struct Memory {
    bool begun{false};
    std::int64_t aimed_round{-1};      ///< the last one in which it chose where to go
    Vec3 aimed_from = Vec3::Zero();    ///< where it lay then [m, NED]
    int idle_rounds{};                 ///< of its own, since it lay elsewhere
    std::size_t asides{};              ///< how often it went aside, since no plan led it on
    bool waits{false};                 ///< it has chosen to stay for this round
    std::optional<Vec3> refused_at{};  ///< where it stays that cannot take part [m, NED]
    std::string_view misfit{};         ///< why its goal cannot be told, if that is so
    double moved{};                    ///< when it was not at rest, since it was lost [s]
    Vec3 drift = Vec3::Zero();         ///< its velocity since then without the waves [m/s, NED]
    double turn_period{};
    double time{};
    Vec3 stay = Vec3::Zero();  ///< where a lost member holds [m, NED]
    int losses{};              ///< how often it was lost
    bool gives_way{false};     ///< to somebody who is lost, or who goes as it has promised
    bool is_beside{false};     ///< it has stopped beside a plan
    std::array<std::optional<double>, pledge::most_vehicles>
        heard{};  ///< when each said what was taken last [s]
    pledge::Agreement agreement{};
    pledge::DatumWatch datum{};
    pledge::Obedience obedience{};
  };

  Params params;

  Command decide(const Situation& given, Memory& memory, Context& context) const noexcept;
  Speech speech(const Memory& memory) const noexcept;
  Reading reading(const Heard& word) const;

 private:
  pledge::Tubes tubes() const noexcept { return {.radius = params.tube_m, .told = 0.1}; }
  Command decided(const Situation& s, const pledge::Chart& chart, Memory& memory,
                  Context& context) const noexcept;
  Command refused(const Situation& s, std::string_view why, Memory& memory) const noexcept;
  Command stayed(const Situation& s, const Memory& memory) const noexcept;
  std::string_view begin(const Situation& s, Memory& memory) const noexcept;
  std::string_view hear(const Situation& s, Memory& memory) const noexcept;
  void take_part(const Situation& s, const pledge::Chart& chart, Memory& memory) const noexcept;
  bool rests(const Situation& s, const Memory& memory) const noexcept;
  void retarget(const Situation& s, Memory& memory) const noexcept;
  void keep(const Situation& s, pledge::Agreement& agreement) const noexcept;
  void aim(const Situation& s, const pledge::Chart& chart, Memory& memory) const noexcept;
  void watch(const Situation& s, const pledge::Chart& chart, Memory& memory) const noexcept;
  void stay_at(const Situation& s, const Vec3& place, pledge::Agreement& agreement) const noexcept;
  void lose(const Situation& s, Memory& memory) const noexcept;
  void recover(const Situation& s, Memory& memory) const noexcept;
};

static_assert(AvoidanceAlgorithm<Pledge>);
static_assert(Speaks<Pledge> && ReadsWords<Pledge>);

}  // namespace fairway
