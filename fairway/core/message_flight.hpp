// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "fairway/core/record.hpp"

namespace fairway {

/// A message on its way from one vehicle to another.
struct MessageFlight {
  std::uint32_t from{};
  std::uint32_t to{};
  double sent{};
  double begins{};
  double arrives{};
  bool drowned{};

  static consteval auto members() {
    using R = MessageFlight;
    return std::tuple{
        member<&R::from>("index", "index of the sender"),
        member<&R::to>("index", "index of the receiver"),
        member<&R::sent>("s", "when its transmission began [s]"),
        member<&R::begins>("s", "when it begins to be heard [s]"),
        member<&R::arrives>("s", "when all of it has been heard [s]"),
        member<&R::drowned>("", "the receiver transmits meanwhile and will not hear it"),
    };
  }

  friend bool operator==(const MessageFlight&, const MessageFlight&) = default;
};

}  // namespace fairway
