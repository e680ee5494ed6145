// SPDX-License-Identifier: Apache-2.0
// Linked to a program, this ends it with an error if the program, from beginning to end, allocated, threw or
// locked more often than making an Avoider and printing a line take. A thousand steps of which one allocated
// would show.
#include <cstdio>
#include <cstdlib>

#include "fairway/embed/testing/interruptions.hpp"

namespace {

/// Made before main() begins, and gone after it has ended.
struct Watch {
  Watch() = default;
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  ~Watch() {
    if (!fairway::counts_interruptions()) return;
    const fairway::Interruptions after = fairway::interruptions();
    const long allocations = after.allocations - before.allocations;
    std::fprintf(stderr, "%ld allocations, %ld throws, %ld locks\n", allocations,
                 after.throws - before.throws, after.locks - before.locks);
    constexpr long due = 2;  // the Avoider, the buffer of standard output
    if (allocations > due || after.throws != before.throws || after.locks != before.locks) std::_Exit(1);
  }

  fairway::Interruptions before = fairway::interruptions();
};

const Watch watch;

}  // namespace
