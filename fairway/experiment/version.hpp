// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace fairway {

/// Part of every run's key. Raise it when the same scenario and seed give other numbers than before:
/// stores then run those cases again instead of mixing old results with new ones.
inline constexpr int results_epoch = 33;

/// The commit that this was built from, "-dirty" behind it where files had been changed; "unknown" outside of
/// git.
std::string_view fairway_commit();

/// Written into stores, to tell where they come from; no result depends on it.
#ifdef FAIRWAY_VERSION
inline constexpr std::string_view fairway_version = FAIRWAY_VERSION;
#else
inline constexpr std::string_view fairway_version = "unknown";
#endif

/// What this program was built for and by, for recordings to say: the same bits come of any.
#if defined(__x86_64__)
#define FAIRWAY_PROCESSOR "x86_64"
#elif defined(__aarch64__)
#define FAIRWAY_PROCESSOR "aarch64"
#elif defined(__wasm__)
#define FAIRWAY_PROCESSOR "wasm"
#else
#define FAIRWAY_PROCESSOR "another processor"
#endif
#if defined(__clang__)
#define FAIRWAY_COMPILER "clang " __clang_version__
#else
#define FAIRWAY_COMPILER "g++ " __VERSION__
#endif
inline constexpr std::string_view fairway_machine = FAIRWAY_PROCESSOR ", " FAIRWAY_COMPILER;
#undef FAIRWAY_PROCESSOR
#undef FAIRWAY_COMPILER

}  // namespace fairway
