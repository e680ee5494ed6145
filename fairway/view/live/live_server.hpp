// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "fairway/view/live/live_answers.hpp"

namespace fairway {

struct LiveServerLimits {
  std::size_t connections = 64;       ///< one more, and the one that has been idle for longest is dropped
  std::uint32_t head_bytes = 8192;    ///< of a request line and its headers; no request has a body
  std::chrono::seconds patience{30};  ///< with a request, or the reading of an answer, that does not get on
};

/// Answers HTTP on the loopback address, and on no other, in a thread of its own. One that reads slowly, asks
/// for too much or hangs up in the middle costs the others nothing.
class LiveServer {
 public:
  /// Takes the port, or with 0 any that is free. Throws InputError if it cannot be had.
  explicit LiveServer(std::uint16_t port, LiveServerLimits limits = {});
  /// Drops whoever is connected.
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  std::uint16_t port() const;

  /// Answers from now on, by calls to `answer` from one thread. To be called once.
  void serve(std::function<LiveAnswer(const LiveRequest&)> answer);

 private:
  struct Loop;
  std::unique_ptr<Loop> loop_;
};

}  // namespace fairway
