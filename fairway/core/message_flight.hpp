// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "fairway/core/record.hpp"
#include "fairway/core/speech.hpp"

namespace fairway {

/// A message on its way from one vehicle to another.
struct MessageFlight {
  std::uint32_t from{};
  std::uint32_t to{};
  double sent{};
  double begins{};
  double arrives{};
  bool unheard{};

  static consteval auto members() {
    using R = MessageFlight;
    return std::tuple{
        member<&R::from>("index", "index of the sender"),
        member<&R::to>("index", "index of the receiver"),
        member<&R::sent>("s", "when its transmission began [s]"),
        member<&R::begins>("s", "when it begins to be heard [s]"),
        member<&R::arrives>("s", "when all of it has been heard [s]"),
        member<&R::unheard>("", "the receiver transmits meanwhile, or another message is in its way there"),
    };
  }

  friend bool operator==(const MessageFlight&, const MessageFlight&) = default;
};

/// What a vehicle's method said of its own in a turn, whether or not anybody hears it. The flights of that
/// message have the same sender and the same `sent`.
struct SpokenWord {
  std::uint32_t from{};  ///< index of the sender
  double sent{};         ///< when its transmission began [s]
  Speech speech{};

  friend bool operator==(const SpokenWord&, const SpokenWord&) = default;
};

}  // namespace fairway
