// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <barrier>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "bindings/python/user_algorithms.hpp"
#include "fairway/environment/fleet_environment.hpp"

namespace fairway::python {

using environment::Axes;
using environment::DrawScenario;
using environment::EnvironmentOptions;
using environment::FleetEnvironment;
using environment::RewardWeights;

/// Threads that wait for work and share it out among themselves. Which thread takes what is open, so pieces
/// of work share nothing.
class Crew {
 public:
  /// `threads` of them, the caller among them; 0: as many as the machine has, and never more.
  explicit Crew(unsigned threads);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// Calls work(context, i) for every i below `count` and waits for all. It does not throw. Allocates
  /// nothing.
  using Work = void (*)(void* context, std::size_t index) noexcept;
  void share(Work work, void* context, std::size_t count);

 private:
  void wait_for_work();
  void take_part();

  std::barrier<> barrier_;  // where work begins, and where it has ended
  bool closing_{false};
  Work work_{nullptr};
  void* context_{nullptr};
  std::size_t count_{0};
  std::atomic<std::size_t> next_{0};
  std::vector<std::jthread> threads_;  // end first
};

/// Several environments of one scenario, side by side, with what they show in arrays: environments x learners
/// x numbers. Results are the same on any number of threads.
class FleetEnvironments {
 public:
  /// Each environment has instances of `algorithms` of its own. Environment i begins with the scenario's seed
  /// plus i unless told. Throws as FleetEnvironment.
  FleetEnvironments(const Scenario& scenario, const DrawScenario& draw, const EnvironmentOptions& options,
                    std::size_t count, unsigned threads, bool autoreset, const pybind11::object& algorithms);

  /// Begins episodes where `chosen` is not 0, or in all where it is empty. Of `seeds`, none or one for each
  /// environment. Throws, with the environment's number, what one of them throws.
  void reset(std::span<const std::uint8_t> chosen, std::span<const std::optional<std::uint64_t>> seeds);

  /// A step of each; `actions` are environments x learners x 3. With autoreset, an environment whose episode
  /// is over begins the next one instead, whatever the action, at no reward. An action of another one that is
  /// not finite is refused before any environment steps.
  void step(std::span<const double> actions);
  void step(std::span<const Command> commands);
  void advise();
  void advise(std::span<Command> commands);

  FleetEnvironment& at(std::size_t index) { return *places_[index]->environment; }
  std::size_t count() const { return places_.size(); }
  std::size_t learner_count() const { return places_.front()->environment->learners().size(); }
  std::size_t observation_size() const;

  /// Raises again what a user's algorithm raised, if one did. With the interpreter's lock held.
  void rethrow();

  /// What the last reset() or step() came to: environments, or environments x learners.
  struct Shown {
    std::vector<float> observations;  ///< x numbers
    std::vector<double> rewards;
    std::vector<double> returns;  ///< sum of the rewards of all learners, by environment
    std::vector<std::uint8_t> terminated;
    std::vector<std::uint8_t> truncated;
    std::vector<double> time;         ///< [s]
    std::vector<std::uint64_t> seed;  ///< of the episode
    std::vector<double> goal_distance;
    std::vector<double> separation;
    std::vector<double> clearance;
    std::vector<std::uint8_t> deciding;
    std::vector<std::uint8_t> arrived;
    std::vector<std::uint8_t> stuck;
    std::vector<std::uint8_t> collided;
    std::vector<double> advice;  ///< x 3, of advise()
  };
  const Shown& shown() const { return shown_; }

 private:
  struct Place {
    std::unique_ptr<UserAlgorithms> algorithms;
    std::unique_ptr<FleetEnvironment> environment;
    std::exception_ptr failure;
  };
  template <class Each>
  void for_each(Each each);
  void show(std::size_t index, bool is_new);

  std::vector<std::unique_ptr<Place>> places_;
  Shown shown_;
  bool autoreset_;
  Crew crew_;
};

}  // namespace fairway::python
