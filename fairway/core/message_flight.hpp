// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace fairway {

/// A message on its way from one vehicle to another.
struct MessageFlight {
  std::uint32_t from{};  ///< index of the sender
  std::uint32_t to{};    ///< index of the receiver
  double sent{};         ///< when its transmission began [s]
  double begins{};       ///< when it begins to be heard [s]
  double arrives{};      ///< when all of it has been heard [s]
  bool drowned{};        ///< the receiver transmits meanwhile and will not hear it

  friend bool operator==(const MessageFlight&, const MessageFlight&) = default;
};

}  // namespace fairway
