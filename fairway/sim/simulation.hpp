// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fairway/comms/exchange.hpp"
#include "fairway/core/boxed.hpp"
#include "fairway/core/crew.hpp"
#include "fairway/core/vicinity.hpp"
#include "fairway/perception/nearest_first.hpp"
#include "fairway/perception/scene.hpp"
#include "fairway/record/frame.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/sim/agent.hpp"
#include "fairway/sim/decision_observer.hpp"
#include "fairway/sim/divergence.hpp"
#include "fairway/sim/stage_times.hpp"
#include "fairway/world/obstacle_field.hpp"
#include "fairway/world/sea/sea.hpp"

namespace fairway {

/// How long deciding took on this machine: never among the results of a run. Those who decide together share
/// their time.
struct DecisionTimes {
  std::int64_t count{};
  double total_s{};
  double worst_s{};
};

/// A run of one scenario. The same scenario gives the same bits, whatever else runs beside it.
class Simulation {
 public:
  /// Throws InputError, with its place in the file, for what the catalogs do not accept and for what cannot
  /// be simulated (feasibility.hpp).
  Simulation(const Scenario& scenario, const Catalogs& catalogs);

  /// One tick: everyone is told, sees, decides and steers on the same frozen instant, which `sinks`
  /// then receive, and only then does anything move. Once the run has diverged, nothing more happens, and no
  /// sink receives anything. Where no sink wants tracks, nobody keeps them, and frames have none. Does not
  /// allocate after the first tick, but for the tracks of a crowd where they are kept. O(vehicles and who is
  /// in reach of each).
  void step(std::span<FrameSink* const> sinks);

  /// The first half of a step: everyone is told and sees, and what is seen is kept. Then situations and
  /// orders may be asked and given.
  void look();

  /// The second half: everyone decides and steers, `sinks` receive it, everything moves.
  void act(std::span<FrameSink* const> sinks);

  /// Whether vehicle `index` is to decide. Valid between look() and act().
  bool is_deciding(std::size_t index) const { return is_deciding(agents_[index]); }

  /// What a vehicle knows of the others and of what stands still.
  struct Sight {
    std::vector<Track> tracks;
    std::vector<Obstacle> obstacles;
  };
  /// What vehicle `index` saw when it last was to decide, all obstacles that it knows of, and of tracks as
  /// many as its method looks at. Valid after look(), for as long as it is called.
  const Sight& sight(std::size_t index) const { return kept_[index]; }

  /// What its avoider is shown then. Only of a vehicle that is to decide; valid between look() and act().
  Situation situation(std::size_t index) const;

  /// From now on vehicle `index`, while it avoids, obeys this command instead of its avoider's. `request`
  /// carries it out if there is one; otherwise the vehicle's own pilot does.
  void order(std::size_t index, const Command& command, const std::optional<BodyRequest>& request = {});
  /// Its avoider is asked again.
  void release(std::size_t index);

  /// True when the time is up, nobody is left under way, or the run has diverged.
  bool is_done() const;

  /// How the run broke, at the tick at which it did; nothing for as long as it is whole.
  const std::optional<Divergence>& divergence() const { return divergence_; }
  /// Throws RunDiverged if it has.
  void refuse_divergence() const;

  /// Steps until done. Throws RunDiverged.
  void run(std::span<FrameSink* const> sinks);

  /// From now on so many threads go through the vehicles together. The bits are the same on any number.
  void share_out(std::size_t threads);

  /// From now on as `changed` says, where that differs from `before`, which was simulated so far: methods
  /// with their parameters, limits, goals of legs, what vehicles tell each other, and when the run ends. A
  /// vehicle whose method or limits differ asks it at once, and the method remembers nothing; a changed
  /// exchange has carried nothing yet. Throws InputError for whatever else differs and for what the catalogs
  /// refuse; then nothing has changed. Orders stand. To be called between steps.
  void change(const Scenario& before, const Scenario& changed, const Catalogs& catalogs);

  /// Measures decisions from now on; two clock readings a decision.
  void time_decisions() { timing_ = true; }
  DecisionTimes decision_times() const;

  /// The last word of each of the others that vehicle `index` has heard, if their methods speak. Valid behind
  /// a step, of the tick before.
  std::vector<Heard> heard_by(std::size_t index) const;

  /// What became of the messages that were sent, where telling takes time.
  std::optional<AcousticCounts> message_counts() const { return exchange_.counts(); }

  /// Measures the stages of each step from now on; two clock readings a part of the fleet. Threads add up.
  void time_stages() { timing_stages_ = true; }
  StageTimes stage_times() const;

  /// From now on, or no longer: frames hold what each method draws of its thinking and the messages under
  /// way. It costs time and memory, and changes nothing else.
  void show_thoughts(bool shown) {
    showing_ = shown;
    if (shown) drawings_.resize(agents_.size());
  }

  /// Shows `observer` every decision of an avoider from now on, one at a time in the order of the vehicles;
  /// null: nobody.
  void observe(DecisionObserver* observer) { observer_ = observer; }

  Tick tick() const { return tick_; }
  double time() const { return seconds(tick_, period_); }
  std::span<const Agent> agents() const { return agents_; }

 private:
  /// Those of a part who decide together, in their order.
  struct Company {
    static constexpr std::size_t most = Avoider::most_together;

    std::size_t count{};
    std::array<std::size_t, most> members;  // indices
    std::array<Avoider*, most> avoiders;
    std::array<Situation, most> situations;
    std::array<Command, most> commands;
    std::array<Sight, most> sights;  // of the members, where none are kept
  };

  /// Those of a part who move together, in their order.
  struct Convoy {
    static constexpr std::size_t most = lanes::most_bodies;

    std::size_t count{};
    std::array<std::size_t, most> members;  // indices
    std::array<Vehicle::Errand, most> errands;
  };

  /// Whoever goes through parts of the fleet: what it finds, and memory to work in.
  struct Hand {
    std::vector<Heard> heard;           // by whoever decides, of those who speak
    std::vector<AcousticRange> ranges;  // likewise
    Link link;
    Sight passing;  // of whoever decides alone, where none is kept
    Company company;
    Convoy convoy;
    std::vector<Near> near;
    int rendezvous_reached{};  // by all of its parts
    bool anyone_speaks{};      // likewise
    std::optional<Divergence> divergence;
    DecisionTimes times;
    StageTimes stages;
  };

  /// What a stage does for one vehicle, and then for all of a part together.
  template <Stage stage, void (Simulation::*work)(std::size_t index, Hand& hand),
            void (Simulation::*together)(Hand& hand) = nullptr>
  struct Work {};

  template <class... Works>
  void in_parts(Works... /*in this order*/);
  void look(bool keeping);
  void make_room(bool keeping);
  void locate(std::size_t index, Hand& hand);
  void tell(std::size_t index, Hand& hand);
  void deliver();
  void sort_places();
  void perceive(std::size_t index, Hand& hand);
  void look_round(std::size_t index, std::vector<Near>& near, Sight& sight);
  void decide(std::size_t index, Hand& hand);
  void decide_together(Hand& hand);
  void control(std::size_t index, Hand& hand);
  void record(std::size_t index, Hand& hand);
  void collect_words();
  void show(std::span<FrameSink* const> sinks);
  void move(std::size_t index, Hand& hand);
  void move_together(Hand& hand);
  void notice(std::size_t index, std::string_view impossible, Tick when, Hand& hand);

  /// From outside, instead of what the avoider commands and, if there is a request, the pilot asks for.
  struct Order {
    std::optional<Command> command;
    std::optional<BodyRequest> request;
  };

  /// All at once and for as long as the exchange is the same, and nobody looks: then who tells is all there
  /// is.
  bool everyone_tells() const { return places_.empty(); }
  bool everyone_is_at(const Agent& agent) const;
  static bool waits_for_method(const Agent& agent);
  std::optional<Command> attend(std::size_t index, Hand& hand);
  void listen(std::size_t index, Hand& hand, Situation& shown);
  void hear(std::size_t index, std::vector<Heard>& heard) const;
  bool is_deciding(const Agent& agent) const;
  bool joins(std::size_t index) const;
  void join(std::size_t index, Hand& hand);
  template <class Decide>
  void timed(std::size_t count, Hand& hand, const Decide& decide);
  void obey(Agent& agent, const Command& command);
  const Order* order_of(std::size_t index) const;
  Scene scene_of(std::size_t index) const;
  Viewpoint viewpoint_of(const Agent& agent) const;
  Situation situation(std::size_t index, const Sight& sight) const;
  Command decided(std::size_t index, Hand& hand);
  Command ask(std::size_t index, Hand& hand);
  ActuatorValues demanded(std::size_t index, Hand& hand);

  double period_;
  Tick last_tick_;
  Sea sea_;
  ObstacleField obstacles_;

  Tick tick_{0};
  std::optional<Divergence> divergence_;
  std::vector<Agent> agents_;
  std::vector<Order> orders_;  // by vehicle; empty before the first
  Mailbox mailbox_;
  Exchange exchange_;
  std::vector<Mover> movers_;  // all vehicles, unless everyone tells, then what drifts
  std::vector<Vec3> places_;   // of the vehicles, unless everyone tells
  Vicinity found_at_;          // the vehicles, where perception finds them
  std::vector<Sight> kept_;    // by vehicle, of its last decision; empty where nobody wants them
  std::vector<OfOneHand<Hand>> hands_;
  Boxed<Crew> crew_;  // nothing: one hand alone
  std::vector<VehicleFrame> frame_;
  std::vector<Drawing> drawings_;       // by vehicle, of its last decision; empty before anyone looks
  std::vector<MessageFlight> flights_;  // empty unless showing
  std::vector<SpokenWord> words_;       // of the present tick
  DecisionObserver* observer_{nullptr};
  int rendezvous_reached_{};  // by all
  bool stop_when_done_;
  bool looked_at_{false};  // by sensors, so that it matters where those are who tell
  bool keeping_{false};
  bool showing_all_{false};  // obstacles, also those that the method does not look at: somebody else may
  bool watched_{false};      // by sinks
  bool showing_{false};
  bool timing_{false};
  bool timing_stages_{false};
};

}  // namespace fairway
