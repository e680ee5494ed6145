// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway {

/// What this process has done so far that a control loop must not do, wherever in it: counted where the C
/// library is entered, so that nothing that is linked gets by. A file of its own for tests: it stands in for
/// functions of that library.
struct Interruptions {
  long allocations{};  ///< malloc and its kin, which operator new comes down to
  long throws{};
  long locks{};  ///< of mutexes and the like, waits, and guards of static variables

  friend bool operator==(const Interruptions&, const Interruptions&) = default;
};

Interruptions interruptions();

/// False under a sanitizer, which stands in for the same functions: then all counts stay zero.
bool counts_interruptions();

}  // namespace fairway
