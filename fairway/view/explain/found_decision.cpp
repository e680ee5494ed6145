// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/explain/found_decision.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/text.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/record/hash_checker.hpp"
#include "fairway/sim/simulation.hpp"
#include "fairway/view/word_reader.hpp"

namespace fairway {
namespace {

/// Whether anything but commands differs.
bool differ_in_state(const Frame& recorded, const Frame& now) {
  if (recorded.vehicles.size() != now.vehicles.size()) return true;
  for (std::size_t i = 0; i < now.vehicles.size(); ++i) {
    VehicleFrame same_command = recorded.vehicles[i];
    same_command.command = now.vehicles[i].command;
    if (first_difference(same_command, now.vehicles[i])) return true;
  }
  return false;
}

std::optional<std::pair<double, double>> avoiding_span(const Recording& recording, std::size_t vehicle) {
  std::optional<std::pair<double, double>> span;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const Frame frame = recording.frame(i);
    if (is_avoiding(frame.vehicles[vehicle].phase)) span = {span ? span->first : frame.time, frame.time};
  }
  return span;
}

/// Holds frames to the recording, keeps the decision in force at one of them, and passes on what surrounds
/// it.
class Witness final : public FrameSink, public DecisionObserver {
 public:
  Witness(const Recording& recording, const Scenario& scenario, const Instant& instant, FrameSink* sink)
      : progress_{scenario.exam.progress_window_s, surroundings_of(scenario)},
        recording_{recording},
        instant_{instant},
        asked_{recording.frame(instant.frame)},
        sink_{sink},
        checker_{recording} {}

  void see(std::size_t index, const Situation& situation, const Command& command) override {
    if (index != instant_.vehicle) return;
    kept_.emplace(situation, command);
    fresh_ = true;
  }

  void write(const Frame& frame) override {
    check(frame);
    if (frame.tick <= asked_.tick) progress_.see(frame);
    const VehicleFrame& vehicle = frame.vehicles[instant_.vehicle];
    if (std::exchange(fresh_, false)) {
      kept_->tick = frame.tick;
      decided_ = frame.tick;
      kept_->strokes.assign(vehicle.strokes.begin(), vehicle.strokes.end());
    }
    if (frame.tick <= asked_.tick) {
      command_ = vehicle.command;
      const auto own = std::ranges::find(frame.words, instant_.vehicle, &SpokenWord::from);
      if (own != frame.words.end()) said_ = *own;
    }
    if (sink_ != nullptr) sink_->write(frame);
  }

  /// Throws unless what was seen is the recorded run.
  void hold_to_recording() const {
    if (!checker_.first_mismatch() || only_own_command_differs()) return;
    throw InputError("this is another run, so its decisions are others: " + checker_.describe() +
                     " (ask with the build, and on the kind of machine, that recorded it)");
  }

  /// The last word of the vehicle asked about.
  const std::optional<SpokenWord>& said() const { return said_; }

  FoundDecision found() {
    const VehicleFrame& recorded = asked_.vehicles[instant_.vehicle];
    FoundDecision found{.instant = instant_,
                        .tick = asked_.tick,
                        .time = asked_.time,
                        .phase = recorded.phase,
                        .leg = {},
                        .decision = {},
                        .asked = avoiding_span(recording_, instant_.vehicle),
                        .difference = first_difference({.command = recorded.command}, {.command = command_}),
                        .progress = progress_.state(instant_.vehicle),
                        .note = command_.note,
                        .words = {},
                        .matched = checker_.matched()};
    if (is_avoiding(recorded.phase)) found.decision = std::move(kept_);
    return found;
  }

 private:
  void check(const Frame& frame) {
    const bool same_so_far = !checker_.first_mismatch();
    checker_.write(frame);
    while (next_ + 1 < recording_.size() && recording_.frame(next_).tick < frame.tick) ++next_;
    if (!same_so_far || !checker_.first_mismatch()) return;
    only_commands_ = !differ_in_state(recording_.frame(next_), frame);
  }

  /// The run is the recorded one until the decision asked about, which comes out differently.
  bool only_own_command_differs() const {
    const Command& recorded = asked_.vehicles[instant_.vehicle].command;
    return only_commands_ && decided_ && checker_.first_mismatch()->tick >= *decided_ &&
           first_difference({.command = recorded}, {.command = command_});
  }

  ProgressMetric progress_;
  const Recording& recording_;
  Instant instant_;
  Frame asked_;
  FrameSink* sink_;
  HashChecker checker_;
  std::size_t next_{};  // frame of the recording
  std::optional<KeptDecision> kept_;
  std::optional<SpokenWord> said_;
  std::optional<Tick> decided_;  // when that was
  Command command_;              // in force, at most until the frame asked about
  bool fresh_{false};
  bool only_commands_{false};
};

/// Behind the step of the frame asked about, which was at `time`.
std::optional<FoundWords> words_of(const Simulation& simulation, std::size_t vehicle,
                                   const std::optional<SpokenWord>& said, double time) {
  const std::span<const Agent> agents = simulation.agents();
  const Avoider& avoider = agents[vehicle].avoider;
  if (!avoider.speaks()) return {};
  const auto read = [&](std::size_t from, const Heard& word) -> FoundWord {
    const std::optional<Reading> reading = avoider.reading(word);
    return {from, time - word.sent, word.speech, reading ? reading->text : unread_text(word.speech)};
  };
  FoundWords words;
  if (said) words.said = read(vehicle, {agents[vehicle].ship().id, said->sent, said->speech});
  for (const Heard& word : simulation.heard_by(vehicle)) {
    const auto from = std::ranges::find(agents, word.from, [](const Agent& a) { return a.ship().id; });
    words.heard.push_back(read(static_cast<std::size_t>(from - agents.begin()), word));
  }
  return words;
}

std::int64_t ticks_of(double time, double period) {
  return static_cast<std::int64_t>(std::ceil(time / period));
}

}  // namespace

KeptDecision::KeptDecision(const Situation& situation, const Command& command)
    : situation_{situation},
      command_{command},
      model_{situation.model == nullptr ? nullptr : std::make_unique<const OnboardModel>(*situation.model)},
      envelope_{situation.envelope == nullptr ? nullptr
                                              : std::make_unique<const Envelope>(*situation.envelope)},
      tracks_{situation.tracks.begin(), situation.tracks.end()},
      obstacles_{situation.obstacles.begin(), situation.obstacles.end()} {
  for (Obstacle& obstacle : obstacles_) {
    vertices_.emplace_back(obstacle.vertices.begin(), obstacle.vertices.end());
    obstacle.vertices = vertices_.back();
  }
  situation_.model = model_.get();
  situation_.envelope = envelope_.get();
  situation_.tracks = tracks_;
  situation_.obstacles = obstacles_;
}

std::optional<FoundDecision> find_decision(const Recording& recording, const Scenario& scenario,
                                           const Catalogs& catalogs, const Instant& instant,
                                           const DecisionWindow& window, const std::atomic<bool>* stop) {
  const Frame asked = recording.frame(instant.frame);
  const std::int64_t target = count(asked.tick);
  const bool has_window = window.sink != nullptr;
  const std::int64_t before = has_window ? ticks_of(window.before_s, scenario.step_s) : 0;
  const std::int64_t after = has_window ? ticks_of(window.after_s, scenario.step_s) : 0;
  // the decision in force may be as old as this
  const std::int64_t watched = target - std::max<std::int64_t>(before, scenario.steps_per_decision - 1);

  Simulation simulation{scenario, catalogs};
  Witness witness{recording, scenario, instant, window.sink};
  const std::array<FrameSink*, 1> sinks{&witness};
  std::optional<FoundDecision> found;
  while (!simulation.is_done() && count(simulation.tick()) <= target + after) {
    if (stop != nullptr && stop->load(std::memory_order_relaxed)) return {};
    const Tick now = simulation.tick();
    simulation.show_thoughts(recording.info().sketches || count(now) >= watched);
    simulation.observe(count(now) >= watched && count(now) <= target ? &witness : nullptr);
    simulation.step(sinks);
    witness.hold_to_recording();
    if (count(now) != target) continue;
    found = witness.found();
    const Leg* leg = simulation.agents()[instant.vehicle].mission.leg();
    if (leg != nullptr) found->leg = *leg;
    found->words = words_of(simulation, instant.vehicle, witness.said(), asked.time);
  }
  if (!found) throw InputError("this is another run: it ends before tick " + std::to_string(target));
  return found;
}

}  // namespace fairway
