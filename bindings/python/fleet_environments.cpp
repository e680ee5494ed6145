// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/fleet_environments.hpp"

#include <algorithm>
#include <utility>

namespace fairway::python {

namespace {

std::ptrdiff_t crew_size(unsigned threads) {
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  return threads > 0 ? std::min(threads, cores) : cores;
}

}  // namespace

Crew::Crew(unsigned threads) : barrier_{crew_size(threads)} {
  for (std::ptrdiff_t i = 1; i < crew_size(threads); ++i) threads_.emplace_back([this] { wait_for_work(); });
}

Crew::~Crew() {
  closing_ = true;
  if (!threads_.empty()) barrier_.arrive_and_wait();
}

void Crew::take_part() {
  for (std::size_t i = next_.fetch_add(1); i < count_; i = next_.fetch_add(1)) work_(context_, i);
}

void Crew::wait_for_work() {
  for (barrier_.arrive_and_wait(); !closing_; barrier_.arrive_and_wait()) {
    take_part();
    barrier_.arrive_and_wait();
  }
}

void Crew::share(Work work, void* context, std::size_t count) {
  work_ = work;
  context_ = context;
  count_ = count;
  next_ = 0;
  const bool alone = threads_.empty() || count == 1;
  if (!alone) barrier_.arrive_and_wait();
  take_part();
  if (!alone) barrier_.arrive_and_wait();
}

FleetEnvironments::FleetEnvironments(const Scenario& scenario, const DrawScenario& draw,
                                     const EnvironmentOptions& options, std::size_t count, unsigned threads,
                                     bool autoreset, const pybind11::object& algorithms)
    : autoreset_{autoreset}, crew_{count > 1 ? threads : 1} {
  if (count == 0) throw InputError("there is to be at least one environment");
  for (std::size_t i = 0; i < count; ++i) {
    auto place = std::make_unique<Place>();
    place->algorithms = std::make_unique<UserAlgorithms>(algorithms);
    FrameSink* const guard = algorithms.is_none() ? nullptr : &place->algorithms->guard();
    place->environment =
        std::make_unique<FleetEnvironment>(scenario, draw, place->algorithms->catalogs(), options, guard);
    places_.push_back(std::move(place));
  }
  const std::size_t rows = count * learner_count();
  shown_.observations.resize(rows * observation_size());
  shown_.advice.resize(rows * 3);
  for (auto* numbers : {&shown_.rewards, &shown_.goal_distance, &shown_.separation, &shown_.clearance})
    numbers->resize(rows);
  for (auto* flags : {&shown_.deciding, &shown_.arrived, &shown_.stuck, &shown_.collided})
    flags->resize(rows);
  for (auto* numbers : {&shown_.returns, &shown_.time}) numbers->resize(count);
  for (auto* flags : {&shown_.terminated, &shown_.truncated}) flags->resize(count);
  shown_.seed.resize(count);
}

std::size_t FleetEnvironments::observation_size() const {
  return places_.front()->environment->options().observation.size();
}

/// Calls each(i) for every environment, on the crew, and then throws what the first of them threw.
template <class Each>
void FleetEnvironments::for_each(Each each) {
  struct Task {
    FleetEnvironments& all;
    Each& each;
  } task{*this, each};
  crew_.share(
      [](void* context, std::size_t index) noexcept {
        Task& shared = *static_cast<Task*>(context);
        try {
          shared.each(index);
        } catch (...) {
          shared.all.places_[index]->failure = std::current_exception();
        }
      },
      &task, places_.size());
  std::exception_ptr first;
  for (const auto& place : places_) {
    const std::exception_ptr failure = std::exchange(place->failure, nullptr);
    if (!first) first = failure;
  }
  if (first) std::rethrow_exception(first);
}

void FleetEnvironments::reset(std::span<const std::uint8_t> chosen,
                              std::span<const std::optional<std::uint64_t>> seeds) {
  for_each([&](std::size_t i) {
    if (!chosen.empty() && chosen[i] == 0) return;
    std::optional<std::uint64_t> seed = seeds.empty() ? std::nullopt : seeds[i];
    FleetEnvironment& environment = at(i);
    if (!seed && !environment.has_begun()) seed = environment.scenario().seed + i;
    environment.reset(seed);
    show(i, true);
  });
}

void FleetEnvironments::step(std::span<const double> actions) {
  const std::size_t size = learner_count() * 3;
  for (std::size_t i = 0; i < count(); ++i) {
    if (!at(i).is_over()) FleetEnvironment::refuse_nonsense(actions.subspan(i * size, size));
  }
  for_each([&](std::size_t i) {
    const bool is_new = autoreset_ && at(i).is_over();
    is_new ? at(i).reset({}) : at(i).step(actions.subspan(i * size, size));
    show(i, is_new);
  });
}

void FleetEnvironments::step(std::span<const Command> commands) {
  const std::size_t size = learner_count();
  for_each([&](std::size_t i) {
    const bool is_new = autoreset_ && at(i).is_over();
    is_new ? at(i).reset({}) : at(i).step(commands.subspan(i * size, size));
    show(i, is_new);
  });
}

void FleetEnvironments::advise() {
  const std::size_t size = learner_count() * 3;
  for_each([&](std::size_t i) { at(i).advise(std::span{shown_.advice}.subspan(i * size, size)); });
}

void FleetEnvironments::advise(std::span<Command> commands) {
  const std::size_t size = learner_count();
  for_each([&](std::size_t i) { at(i).advise(commands.subspan(i * size, size)); });
}

void FleetEnvironments::show(std::size_t index, bool is_new) {
  const FleetEnvironment& environment = at(index);
  const std::span<const FleetEnvironment::Learner> learners = environment.learners();
  const std::size_t width = observation_size();
  double sum = 0.0;
  for (std::size_t i = 0; i < learners.size(); ++i) {
    const FleetEnvironment::Learner& learner = learners[i];
    const std::size_t row = index * learners.size() + i;
    environment.observe(i, std::span{shown_.observations}.subspan(row * width, width));
    shown_.rewards[row] = learner.reward;
    sum += learner.reward;
    shown_.goal_distance[row] = learner.goal_distance;
    shown_.separation[row] = learner.separation;
    shown_.clearance[row] = learner.clearance;
    shown_.deciding[row] = learner.deciding ? 1 : 0;
    shown_.arrived[row] = learner.phase == Phase::arrived ? 1 : 0;
    shown_.stuck[row] = learner.phase == Phase::stuck ? 1 : 0;
    shown_.collided[row] = learner.collided ? 1 : 0;
  }
  shown_.returns[index] = sum;
  shown_.terminated[index] = !is_new && environment.terminated() ? 1 : 0;
  shown_.truncated[index] = !is_new && environment.truncated() ? 1 : 0;
  shown_.time[index] = environment.time();
  shown_.seed[index] = environment.seed();
}

void FleetEnvironments::rethrow() {
  std::exception_ptr first;
  for (const auto& place : places_) {
    try {
      place->algorithms->rethrow();
    } catch (...) {  // what others raised in the same step is let go
      if (!first) first = std::current_exception();
    }
  }
  if (first) std::rethrow_exception(first);
}

}  // namespace fairway::python
