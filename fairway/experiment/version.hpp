// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace fairway {

/// Part of every run's key. Raise it when the same scenario and seed give other numbers than before:
/// stores then run those cases again instead of mixing old results with new ones.
inline constexpr int results_epoch = 5;

/// Written into stores, to tell where they come from; no result depends on it.
#ifdef FAIRWAY_VERSION
inline constexpr std::string_view fairway_version = FAIRWAY_VERSION;
#else
inline constexpr std::string_view fairway_version = "unknown";
#endif

}  // namespace fairway
