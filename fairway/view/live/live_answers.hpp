// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "fairway/view/live/live_run.hpp"
#include "fairway/view/playback.hpp"

namespace fairway {

/// What a browser, or anybody else, asks of the live page's server. A header that is missing is empty; of one
/// that comes more than once, all values are joined by commas, so that it is none of those that are accepted.
struct LiveRequest {
  std::string method;
  std::string target;
  std::string host;
  std::string origin;
  std::string fetch_site;  ///< Sec-Fetch-Site
  std::string fairway;     ///< X-Fairway
};

struct LiveAnswer {
  unsigned status{204};
  std::string_view type{"text/plain; charset=utf-8"};
  std::string body;
  std::string_view allow;  ///< with status 405: the method that would do
};

/// What is answered to whom. A page of another origin gets nothing and changes nothing: it cannot send our
/// Host after binding its name to this address, nor, without a preflight that is never granted, the header
/// that a POST needs.
class LiveAnswers {
 public:
  /// `page` is what "/" shows, served at 127.0.0.1:`port`. The run must outlive it.
  LiveAnswers(std::string page, std::uint16_t port, LiveRun& run);

  /// GET / and /part?from=K&generation=G, POST /pause, /resume and /step, and nothing else.
  LiveAnswer answer(const LiveRequest& request) const;

 private:
  LiveAnswer part(std::string_view query) const;
  LiveAnswer steer(std::string_view path) const;
  bool is_ours(const LiveRequest& request) const;

  std::string page_;
  std::string numeric_;  // the two names of this server
  std::string named_;
  LiveRun& run_;
};

/// The page of a run that is still to be made: as that of a recording, without a film, and free to ask the
/// server that it came from.
std::string live_page(const Scenario& scenario, const PlaybackInfo& info);

}  // namespace fairway
