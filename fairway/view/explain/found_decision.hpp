// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fairway/avoidance/progress.hpp"
#include "fairway/avoidance/situation.hpp"
#include "fairway/record/frame.hpp"
#include "fairway/record/quantities.hpp"
#include "fairway/record/recording.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/sim/catalogs.hpp"
#include "fairway/view/explain/instant.hpp"

namespace fairway {

/// A decision with all that it was made of. Movable; `situation` points into it.
class KeptDecision {
 public:
  KeptDecision(const Situation& situation, const Command& command);
  KeptDecision(KeptDecision&&) noexcept = default;
  KeptDecision& operator=(KeptDecision&&) noexcept = default;

  const Situation& situation() const { return situation_; }
  const Command& command() const { return command_; }

  Tick tick{};                  ///< when it was made
  std::vector<Stroke> strokes;  ///< drawn in making it

 private:
  Situation situation_;
  Command command_;
  std::unique_ptr<const OnboardModel> model_;
  std::unique_ptr<const Envelope> envelope_;
  std::vector<Track> tracks_;
  std::vector<Obstacle> obstacles_;
  std::vector<std::vector<Vec3>> vertices_;  // of the obstacles
};

/// A word that a method said, as the vehicle asked about reads it.
struct FoundWord {
  std::size_t from{};  ///< index of who said it
  double age{};        ///< at the frame asked about [s]
  Speech speech{};
  std::string text;  ///< what it says, in a line
};

/// What a vehicle whose method speaks had said and heard.
struct FoundWords {
  std::optional<FoundWord> said;  ///< the last one
  std::vector<FoundWord> heard;   ///< the last one of each of the others, by vehicle
};

/// What was found of an instant of a recorded run by simulating it again.
struct FoundDecision {
  Instant instant;
  Tick tick{};    ///< of the frame asked about
  double time{};  ///< likewise [s]
  Phase phase{};
  std::optional<Leg> leg;                ///< being carried out; none after the last
  std::optional<KeptDecision> decision;  ///< in force; none where no avoider is asked
  /// First and last recorded frame at which an avoider is [s]; none if it never is.
  std::optional<std::pair<double, double>> asked;
  /// Between the recorded command and the one found; none if they are the same to the bit.
  std::optional<QuantityDifference> difference;
  ProgressReport progress;          ///< as of the frame asked about; `with` as `ProgressMetric` has it
  std::string_view note;            ///< of the command found: why, in the method's words
  std::optional<FoundWords> words;  ///< as of the frame asked about; none where its method does not speak
  std::size_t matched{};            ///< recorded frames met on the way, all the same to the bit
};

/// For whoever wants to see what surrounds the decision: all frames of the run until some time after it, with
/// thoughts shown from some time before it.
struct DecisionWindow {
  double before_s{};
  double after_s{};
  FrameSink* sink{nullptr};  ///< null: nobody
};

/// Simulates `scenario`, the recorded one, again until `instant`, holding every frame to the recording, and
/// asks the decision in force then with the sketch on. It was made at that frame or, where decisions are
/// rarer than frames, before. Throws InputError naming the tick where another run comes of it, since then it
/// would be another's decision; a command that differs while everything it was decided on is the same is no
/// such case, but `difference`. `stop`, if not null, ends it early: then there is no answer. O(run until
/// then).
std::optional<FoundDecision> find_decision(const Recording& recording, const Scenario& scenario,
                                           const Catalogs& catalogs, const Instant& instant,
                                           const DecisionWindow& window = {},
                                           const std::atomic<bool>* stop = nullptr);

}  // namespace fairway
