// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <thread>
#include <vector>

namespace fairway {

/// What lies so far apart is in lines of a cache of its own: two that write to the same line take it from
/// each other each time [bytes].
inline constexpr std::size_t own_line = 128;

/// What one hand of a crew alone writes to, apart from what others write to.
template <class T>
struct alignas(own_line) OfOneHand : T {};

/// Threads that go through the parts of a piece of work together. Each hand has a share of them, the same
/// one in each piece of as many parts, so that what it worked on is in its own cache still; whoever is done
/// with its own takes from the next hand's share, so that nobody waits for one who is not there. What comes
/// out must not depend on who did which.
class Crew {
 public:
  /// `hands` at least 1, the one who calls among them; fewer where the system gives no more threads.
  explicit Crew(std::size_t hands = 1) : shares_(hands) {
    if (hands < 2) return;
    threads_.reserve(hands - 1);
    try {
      for (std::size_t hand = 1; hand < hands; ++hand) threads_.emplace_back([this, hand] { serve(hand); });
    } catch (const std::exception&) {  // what comes out is the same by fewer
    }
  }
  /// As many others.
  Crew(const Crew& other) : Crew{other.hands()} {}
  Crew& operator=(const Crew&) = delete;
  ~Crew() {
    calls_.dismissed = true;
    call();
    for (std::thread& thread : threads_) thread.join();
  }

  std::size_t hands() const { return threads_.size() + 1; }

  /// Calls `work(part, hand)` once for each part from 0 to `parts` - 1, with the number of the hand that does
  /// it, and returns when all is done. `work` must not throw. Does not allocate.
  template <class Work>
  void go_through(std::size_t parts, const Work& work) {
    if (threads_.empty() || parts < 2) {
      for (std::size_t part = 0; part < parts; ++part) work(part, std::size_t{0});
      return;
    }
    // nobody takes a part while it is being said what to do
    const std::uint64_t before = shares_[0].next | lowest_bits;
    for (Share& share : shares_) tell(share.next, before);
    Call* const call_work = [](const void* of, std::size_t part, std::size_t hand) {
      (*static_cast<const Work*>(of))(part, hand);
    };
    tell(work_, call_work);
    tell(of_, static_cast<const void*>(&work));
    tell(parts_, parts);
    tell(done_.parts, std::size_t{0});
    for (std::size_t share = 0; share < shares_.size(); ++share)
      tell(shares_[share].next, (before + 1) | first_of(share, parts));
    call();
    take_parts(0);
    const auto is_done = [&] { return done_.parts == parts; };
    if (!look_out_for(is_done))
      for (std::size_t done = done_.parts; done != parts; done = done_.parts) done_.parts.wait(done);
  }

 private:
  static constexpr std::uint64_t lowest_bits = 0xFFFF'FFFFU;
  static constexpr std::uint64_t any_piece = 0;

  using Call = void(const void* of, std::size_t part, std::size_t hand);

  struct Share {
    std::atomic<std::uint64_t> next{0};  // which piece of work it is, and in the lowest bits which part of it
  };

  // somebody looks at these all the time
  struct alignas(own_line) Done {
    std::atomic<std::size_t> parts{0};
  };
  struct alignas(own_line) Calls {
    std::atomic<std::uint32_t> count{0};
    std::atomic<bool> dismissed{false};
  };

  std::size_t first_of(std::size_t share, std::size_t parts) const { return parts * share / shares_.size(); }

  /// Whoever reads it sees all that was told before.
  template <class T>
  static void tell(std::atomic<T>& what, T value) {
    what.store(value, std::memory_order_release);
  }

  void call() {
    ++calls_.count;
    calls_.count.notify_all();
  }

  void serve(std::size_t hand) {
    while (true) {
      const std::uint32_t heard = calls_.count;
      if (calls_.dismissed) return;
      take_parts(hand);
      if (!look_out_for([&] { return calls_.count != heard; })) calls_.count.wait(heard);
    }
  }

  /// Whether it comes soon: to be woken up takes longer than most of what is waited for.
  template <class Event>
  static bool look_out_for(const Event& event) {
    constexpr int glances = 30000;
    for (int glance = 0; glance < glances; ++glance)
      if (event()) return true;
    return false;
  }

  /// Whoever is still at the others' shares as a new piece of work begins leaves them: its call is there, and
  /// leads to the hand's own share first.
  void take_parts(std::size_t hand) {
    std::uint64_t piece = any_piece;
    for (std::size_t k = 0; k < shares_.size(); ++k)
      piece = take_parts_of((hand + k) % shares_.size(), hand, piece);
  }

  /// Which piece of work it was, all bits of the part set. Whoever succeeds in counting on from a part has
  /// it: the piece cannot have ended meanwhile.
  std::uint64_t take_parts_of(std::size_t share, std::size_t hand, std::uint64_t piece) {
    std::atomic<std::uint64_t>& next_part = shares_[share].next;
    while (true) {
      std::uint64_t next = next_part;
      const std::uint64_t seen = next | lowest_bits;
      if (piece != any_piece && seen != piece) return piece;
      Call* const work = work_;
      const void* of = of_;
      const std::size_t parts = parts_;
      const std::size_t part = next & lowest_bits;
      if (part >= first_of(share + 1, parts)) return seen;
      if (!next_part.compare_exchange_strong(next, next + 1)) continue;
      work(of, part, hand);
      if (++done_.parts == parts) done_.parts.notify_one();
    }
  }

  std::vector<OfOneHand<Share>> shares_;  // one for each hand that was asked for
  std::vector<std::thread> threads_;
  std::atomic<Call*> work_{};
  std::atomic<const void*> of_{};
  std::atomic<std::size_t> parts_{0};
  Done done_;
  Calls calls_;
};

/// The same by whoever calls, as hand 0, where there is no crew.
template <class Work>
void go_through(Crew* crew, std::size_t parts, const Work& work) {
  if (crew != nullptr) return crew->go_through(parts, work);
  for (std::size_t part = 0; part < parts; ++part) work(part, std::size_t{0});
}

/// So many vehicles are one part: enough that to share parts out costs little, and few enough that a fleet of
/// some dozen has several.
inline constexpr std::size_t part_size = 32;
constexpr std::size_t parts_of(std::size_t count) { return (count + part_size - 1) / part_size; }

/// Calls `work(i, hand)` once for each i from 0 to `count` - 1, those of a part by one hand.
template <class Work>
void for_each(Crew* crew, std::size_t count, const Work& work) {
  go_through(crew, parts_of(count), [&](std::size_t part, std::size_t hand) {
    for (std::size_t i = part * part_size; i < std::min(count, (part + 1) * part_size); ++i) work(i, hand);
  });
}

}  // namespace fairway
