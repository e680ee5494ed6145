// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "fairway/avoidance/algorithm.hpp"
#include "fairway/core/prefetch.hpp"

namespace fairway {

/// Any algorithm together with its memory and its randomness. A value: a copy is a snapshot, and two
/// equal avoiders shown the same situations give the same commands for ever.
class Avoider {
 public:
  /// Throws InputError for a parameter outside its range.
  template <AvoidanceAlgorithm A>
  explicit Avoider(A algorithm, Rng rng = Rng{0})
      : self_{std::make_unique<Model<A>>(std::move(algorithm))}, rng_{rng} {
    check_params(static_cast<const Model<A>&>(*self_).algorithm.params);
  }

  /// `wrapper` around `inner`. Wrappers nest. Throws InputError likewise.
  template <AvoidanceWrapper W>
  Avoider(W wrapper, Avoider inner, Rng rng = Rng{0})
      : self_{std::make_unique<Wrapped<W>>(std::move(wrapper), std::move(inner))}, rng_{rng} {
    if constexpr (requires(const W& w) { check_params(w.params); })
      check_params(static_cast<const Wrapped<W>&>(*self_).wrapper.params);
  }

  Avoider(const Avoider& other) : self_{other.self_->clone()}, rng_{other.rng_} {}
  Avoider(Avoider&&) noexcept = default;
  Avoider& operator=(Avoider other) noexcept {
    std::swap(self_, other.self_);
    rng_ = other.rng_;
    return *this;
  }
  ~Avoider() = default;

  const AlgorithmInfo& info() const { return self_->info(); }

  /// How many of the tracks, the nearest first, it looks at: any others change no command of it. All of them
  /// unless the algorithm says otherwise (`most_tracks()`).
  std::size_t most_tracks() const { return self_->most_tracks(); }

  /// How far from the own position it looks for obstacles, to their surface [m]: any others change no command
  /// of it, nor what it draws. Infinite unless the algorithm says otherwise (`farthest_obstacle()`, of a
  /// wrapper `farthest_obstacle(inner)`); minus infinity where it ignores them.
  double farthest_obstacle() const { return self_->farthest_obstacle(); }

  /// Whether it has something to say of its own, and what it would say now; see `Speaks`.
  bool speaks() const { return self_->speaks(); }
  Speech speech() const { return self_->speech(); }

  /// How its algorithm reads a word; nothing where it does not say how (`ReadsWords`).
  std::optional<Reading> reading(const Heard& word) const { return self_->reading(word); }

  /// Decides, then holds the decision to the limits, so that no algorithm has to. What the vehicle cannot
  /// carry out of it (see `shortfall`) stands in the note unless the method says something itself, and what
  /// was to avoid somebody so is Mode::infeasible. A situation that is not usable (NaN, no period) is
  /// answered with zero velocity, Mode::infeasible and a note that says what is wrong with it. Never throws.
  [[nodiscard]] Command decide(const Situation& situation, Sketch* sketch = nullptr) noexcept {
    if (const std::string_view trouble = why_unusable(situation); !trouble.empty())
      return {.mode = Mode::infeasible, .note = trouble};
    return decide_usable(situation, sketch);
  }

  /// decide() of a situation that is known to be usable: that of a wrapper, which changed no track of it.
  [[nodiscard]] Command decide_usable(const Situation& situation, Sketch* sketch) noexcept {
    Context context{rng_, sketch};
    Command command = self_->decide(situation, context);
    hold(situation, command);
    return command;
  }

  /// Whether any of its layers thinks in the horizontal plane.
  bool thinks_in_plane() const noexcept { return self_->thinks_in_plane(); }

  /// What it keeps between own sphere and every surface, as far as its layers say [m].
  double kept_margin() const { return self_->kept_margin(); }

  /// So many of `decide_many` are asked at once: the lanes of the widest registers.
  static constexpr std::size_t most_together = 8;

  /// Whether its algorithm decides for many at once, of whom some may be others like it.
  bool decides_for_many() const noexcept { return self_->decides_with(*self_); }

  /// What `avoiders[i]->decide(situations[i])` would be, in `commands[i]`, to the bit; sooner where several
  /// that come one after another are alike and their algorithm decides for many at once. Nobody is asked
  /// twice.
  static void decide_many(std::span<Avoider* const> avoiders, std::span<const Situation> situations,
                          std::span<Command> commands) noexcept;

  /// Asks the memory for the method, which will be asked soon, and the beginning of what it remembers.
  void fetch() const noexcept {
    constexpr std::size_t enough = 192;  // [B]
    prefetch(self_.get(), enough);
  }

  /// Decides and takes it back: memory and randomness are as before, but what deciding has allocated is kept.
  /// So no later decision on a situation with no more in it allocates, not even the first.
  void rehearse(const Situation& situation) {
    const std::unique_ptr<Interface> before = self_->clone();
    const Rng rng = rng_;
    (void)decide(situation);
    self_->restore(*before);
    rng_ = rng;
  }

 private:
  struct Interface {
    Interface() = default;
    Interface(const Interface&) = default;
    Interface& operator=(const Interface&) = delete;
    virtual ~Interface() = default;
    virtual Command decide(const Situation&, Context&) noexcept = 0;
    virtual std::unique_ptr<Interface> clone() const = 0;
    virtual void restore(const Interface& clone) = 0;  ///< to what the clone of this remembers
    virtual const AlgorithmInfo& info() const = 0;
    virtual std::size_t most_tracks() const { return std::numeric_limits<std::size_t>::max(); }
    virtual double farthest_obstacle() const { return std::numeric_limits<double>::infinity(); }
    virtual bool thinks_in_plane() const noexcept = 0;
    virtual double kept_margin() const { return 0.0; }
    virtual bool speaks() const { return false; }
    virtual Speech speech() const { return {}; }
    virtual std::optional<Reading> reading(const Heard& /*word*/) const { return {}; }
    virtual bool decides_with(const Interface& /*other*/) const noexcept { return false; }
    virtual void decide_many(std::span<const Situation* const>, std::span<Command* const>) noexcept {}
  };

  template <AvoidanceAlgorithm A>
  struct Model final : Interface {
    explicit Model(A a) : algorithm{std::move(a)} {}
    Command decide(const Situation& s, Context& c) noexcept override {
      return algorithm.decide(s, memory, c);
    }
    std::unique_ptr<Interface> clone() const override { return std::make_unique<Model>(*this); }
    void restore(const Interface& clone) override { memory = static_cast<const Model&>(clone).memory; }
    const AlgorithmInfo& info() const override { return A::info; }
    bool thinks_in_plane() const noexcept override { return A::info.planar; }
    std::size_t most_tracks() const override {
      if constexpr (requires { algorithm.most_tracks(); }) return algorithm.most_tracks();
      return Interface::most_tracks();
    }
    double farthest_obstacle() const override {
      if constexpr (requires { algorithm.farthest_obstacle(); }) return algorithm.farthest_obstacle();
      return A::info.ignores_obstacles ? -Interface::farthest_obstacle() : Interface::farthest_obstacle();
    }
    double kept_margin() const override {
      if constexpr (requires { algorithm.kept_margin(); }) return algorithm.kept_margin();
      return Interface::kept_margin();
    }
    bool speaks() const override { return Speaks<A>; }
    Speech speech() const override {
      if constexpr (Speaks<A>) return algorithm.speech(memory);
      return {};
    }
    std::optional<Reading> reading(const Heard& word) const override {
      if constexpr (ReadsWords<A>) return algorithm.reading(word);
      return {};
    }
    bool decides_with(const Interface& other) const noexcept override {
      if constexpr (requires { algorithm.decides_with(algorithm); })
        return &other.info() == &A::info &&
               algorithm.decides_with(static_cast<const Model&>(other).algorithm);
      return false;
    }
    void decide_many(std::span<const Situation* const> situations,
                     std::span<Command* const> commands) noexcept override {
      if constexpr (requires { algorithm.decide_many(situations, commands); })
        algorithm.decide_many(situations, commands);
    }

    A algorithm;
    typename A::Memory memory{};
  };

  template <AvoidanceWrapper W>
  struct Wrapped;

  /// Holds an algorithm's answer to what the vehicle may do, and judges it by what it can.
  static void hold(const Situation& s, Command& command) noexcept;

  std::unique_ptr<Interface> self_;
  Rng rng_;
};

template <AvoidanceWrapper W>
struct Avoider::Wrapped final : Avoider::Interface {
  Wrapped(W w, Avoider a) : wrapper{std::move(w)}, inner{std::move(a)} {}
  Command decide(const Situation& s, Context& c) noexcept override {
    return wrapper.decide(s, inner, memory, c);
  }
  std::unique_ptr<Interface> clone() const override { return std::make_unique<Wrapped>(*this); }
  void restore(const Interface& clone) override {
    const auto& before = static_cast<const Wrapped&>(clone);
    memory = before.memory;
    inner.self_->restore(*before.inner.self_);
    inner.rng_ = before.inner.rng_;
  }
  const AlgorithmInfo& info() const override { return W::info; }
  bool thinks_in_plane() const noexcept override { return W::info.planar || inner.thinks_in_plane(); }
  double farthest_obstacle() const override {
    if constexpr (requires { wrapper.farthest_obstacle(inner); }) return wrapper.farthest_obstacle(inner);
    return Interface::farthest_obstacle();
  }
  double kept_margin() const override {
    double own = 0.0;
    if constexpr (requires { wrapper.kept_margin(); }) own = wrapper.kept_margin();
    return std::max(own, inner.kept_margin());
  }
  bool speaks() const override { return inner.speaks(); }
  Speech speech() const override { return inner.speech(); }
  std::optional<Reading> reading(const Heard& word) const override { return inner.reading(word); }

  W wrapper;
  Avoider inner;
  typename W::Memory memory{};
};

}  // namespace fairway
