// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which sanitizers the compiler, g++ or clang, builds with: each is 1 or 0.

#if defined(__SANITIZE_ADDRESS__)
#define FAIRWAY_ADDRESS_SANITIZED 1
#elif defined(__has_feature)
#define FAIRWAY_ADDRESS_SANITIZED __has_feature(address_sanitizer)
#else
#define FAIRWAY_ADDRESS_SANITIZED 0
#endif

#if defined(__SANITIZE_THREAD__)
#define FAIRWAY_THREAD_SANITIZED 1
#elif defined(__has_feature)
#define FAIRWAY_THREAD_SANITIZED __has_feature(thread_sanitizer)
#else
#define FAIRWAY_THREAD_SANITIZED 0
#endif
