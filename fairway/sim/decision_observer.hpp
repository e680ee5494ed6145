// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "fairway/avoidance/command.hpp"
#include "fairway/avoidance/situation.hpp"

namespace fairway {

/// Is shown every decision of an avoider as it is made. For looking at runs: it cannot change them.
class DecisionObserver {
 public:
  virtual ~DecisionObserver() = default;

  /// Vehicle `index` was shown `situation` and answered `command`. Valid during the call only.
  virtual void see(std::size_t index, const Situation& situation, const Command& command) = 0;
};

}  // namespace fairway
