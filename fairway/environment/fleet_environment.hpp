// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fairway/environment/observation.hpp"
#include "fairway/environment/reward.hpp"
#include "fairway/metrics/run_metrics.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::environment {

/// The case of a seed. Called by several threads at once.
using DrawScenario = std::function<Scenario(std::uint64_t seed)>;

/// What an environment is, besides its scenario.
struct EnvironmentOptions {
  std::vector<std::string> learners;  ///< names of vehicles; empty: all of them
  ObservationShape observation;       ///< counts below 0: as many as the scenario has, 8 and 4 at most
  RewardWeights reward;
  int action_repeat{1};         ///< decisions that one action is held for
  bool scaled_actions{true};    ///< parts of the largest speed; else m/s
  bool end_on_collision{true};  ///< of a learner
  bool skip_deployment{true};   ///< an episode begins when the first learner is under way
};

/// Episodes of one scenario in which some vehicles, the learners, do what they are told from outside, and the
/// others keep their avoiders. A step lasts from one decision to the next. The same seed and the same actions
/// give the same bits. Nothing is allocated in step() after the first step of an episode.
class FleetEnvironment {
 public:
  /// `scenario` is one of those that `draw` makes: its vehicles are there in all of them, and its seed is
  /// that of the first episode unless told. `catalogs` and `guard`, which sees every frame if it is not null,
  /// outlive this. Throws InputError for an unknown learner, a count out of range, and all that a scenario
  /// may be refused for.
  FleetEnvironment(Scenario scenario, DrawScenario draw, const Catalogs& catalogs, EnvironmentOptions options,
                   FrameSink* guard = nullptr);
  FleetEnvironment(const FleetEnvironment&) = delete;
  FleetEnvironment& operator=(const FleetEnvironment&) = delete;

  /// Begins an episode: with `seed` just what `fairway run --seed` makes; without one its seed follows from
  /// the last one that was given, or from the scenario's own, and from how many episodes there were since.
  void reset(std::optional<std::uint64_t> seed);

  /// One decision of every learner, an action of three for each, row by row. Clipped to [-1, 1] where scaled,
  /// and always to the vehicle's limits. The episode is neither new nor over: reset() comes first.
  /// Throws std::invalid_argument for what is not finite.
  void step(std::span<const double> actions);

  /// Throws std::invalid_argument for actions of which step() would say that they are not finite.
  static void refuse_nonsense(std::span<const double> actions);

  /// A step with commands as an avoider gives them, which may hold or have a heading: one for each learner.
  void step(std::span<const Command> commands);

  /// What learner `row` sees now, into `numbers`, as long as options().observation.size().
  void observe(std::size_t row, std::span<float> numbers) const;

  /// What an avoider would be shown in its place; nothing when it is not to decide. Valid until the next
  /// step.
  std::optional<Situation> situation(std::size_t row) const;

  /// What the learners' own avoiders of the scenario would do, as actions. They remember, so ask at each step
  /// of an episode or at none. Throws InputError where one commands a heading or a turn rate with which its
  /// vehicle would do other than with the velocity alone.
  void advise(std::span<double> actions);

  /// The same as commands.
  void advise(std::span<Command> commands);

  /// A learner in this episode. Distances are of the truth, at the present instant unless said otherwise.
  struct Learner {
    double reward{};         ///< of the last step
    double goal_distance{};  ///< from the end of its present leg [m]
    double separation{};     ///< least in the last step, centre to centre [m]; infinite if alone
    double clearance{};      ///< least in the last step, sphere to obstacle [m]; infinite if none
    double max_speed{};      ///< that actions are parts of, in this episode [m/s]
    Phase phase{};
    bool deciding{};  ///< the next action is heeded
    bool collided{};  ///< in this episode
  };
  std::span<const Learner> learners() const { return learners_; }

  bool has_begun() const { return simulation_.has_value(); }
  bool is_over() const { return terminated_ || truncated_; }
  bool terminated() const { return terminated_; }  ///< all learners arrived, or one collided
  bool truncated() const { return truncated_; }    ///< time is up, or who has not arrived is stuck
  double time() const { return time_; }
  std::uint64_t seed() const { return scenario_.seed; }

  /// Everything that a run is measured by, of this episode so far; of a whole run once it is over.
  std::vector<Measure> measures() const { return metrics_->measures(); }

  std::span<const Agent> vehicles() const { return simulation_->agents(); }
  const Scenario& scenario() const { return scenario_; }
  const EnvironmentOptions& options() const { return options_; }

 private:
  struct Place {
    std::size_t agent{};             ///< index in the simulation
    Vec3 leg_end = Vec3::Zero();     ///< what progress is counted towards [m, NED]
    Vec3 wanted = Vec3::Zero();      ///< as asked, in the chosen axes [m/s]
    std::optional<Command> command;  ///< asked instead
    bool touching{};
  };

  /// Says what was asked, so that `Avoider` holds it to the limits as it does every algorithm.
  struct Asked {
    static constexpr AlgorithmInfo info{.name = "asked", .title = "What is asked from outside", .source = ""};
    using Params = NoParams;
    using Memory = NoMemory;

    Params params;
    const Command* command{nullptr};
    Command decide(const Situation&, Memory&, Context&) const noexcept { return *command; }
  };

  const Agent& agent(std::size_t row) const { return simulation_->agents()[places_[row].agent]; }
  bool is_deciding(std::size_t row) const {
    return !is_over() && simulation_->is_deciding(places_[row].agent);
  }
  void find_learners();
  void count_neighbours();
  void begin(std::uint64_t seed);
  void deploy();
  void advance();
  void give_orders();
  void pass_tick();
  void judge(std::size_t row);
  void turn_to_leg(std::size_t row);
  double separation_of(std::size_t index) const;
  double clearance_of(std::size_t index) const;
  void decide_end();

  DrawScenario draw_;
  const Catalogs& catalogs_;
  EnvironmentOptions options_;
  std::vector<FrameSink*> sinks_;

  Scenario scenario_;
  std::optional<Simulation> simulation_;
  std::optional<RunMetrics> metrics_;
  std::vector<DriftingObstacle> obstacles_;
  std::vector<Avoider> advisers_;
  std::vector<Command> advice_;
  std::vector<Place> places_;
  std::vector<Learner> learners_;
  Command asked_;
  Avoider limiter_{Asked{{}, &asked_}};

  std::uint64_t seed_{};      ///< last given
  std::uint64_t episodes_{};  ///< since then
  std::int64_t last_tick_{};
  double time_{};
  bool terminated_{true};
  bool truncated_{false};
};

}  // namespace fairway::environment
