// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/core/testing/refusal.hpp"
#include "fairway/record/recording.hpp"

namespace fairway::testing {

/// What comes of bytes that are no recording.
constexpr auto accepted = "accepted";
inline std::string refusal(ByteView bytes) {
  return refusal_by([&] { Recording::parse(bytes, "run.mcap"); });
}

}  // namespace fairway::testing
