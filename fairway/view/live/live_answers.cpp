// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/live/live_answers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <stdexcept>

#include "fairway/report/page.hpp"

namespace fairway {
namespace {

LiveAnswer live_refusal(unsigned status, std::string line) {
  return {.status = status, .body = std::move(line) + "\n"};
}

/// "123" and nothing around it.
std::optional<std::size_t> count_of(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// What a reader of parts has, as the query says it.
struct PartQuery {
  std::optional<std::size_t> from;
  std::optional<std::size_t> generation;
};

/// Empty, or what is wrong with the query.
std::string parse_query(std::string_view query, PartQuery& asked) {
  while (!query.empty()) {
    const std::string_view pair = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(query.size(), pair.size() + 1));
    const std::size_t equals = std::min(pair.find('='), pair.size());
    const std::string_view name = pair.substr(0, equals);
    const std::string_view value = pair.substr(std::min(pair.size(), equals + 1));
    if (name != "from" && name != "generation") return "unknown name in the query; known: from, generation";
    std::optional<std::size_t>& number = name == "from" ? asked.from : asked.generation;
    if (number) return fmt::format("{} is given twice", name);
    number = count_of(value);
    if (!number) return fmt::format("{} is not a count of frames or drops: expected 0, 1, 2, ...", name);
  }
  if (!asked.from || !asked.generation) return "expected part?from=K&generation=G";
  return "";
}

}  // namespace

LiveAnswers::LiveAnswers(std::string page, std::uint16_t port, LiveRun& run)
    : page_{std::move(page)},
      numeric_{fmt::format("127.0.0.1:{}", port)},
      named_{fmt::format("localhost:{}", port)},
      run_{run} {}

bool LiveAnswers::is_ours(const LiveRequest& request) const {
  const bool host = request.host == numeric_ || request.host == named_;
  const bool origin = request.origin.empty() || request.origin == "http://" + request.host;
  const bool site =
      request.fetch_site.empty() || request.fetch_site == "same-origin" || request.fetch_site == "none";
  return host && origin && site;
}

LiveAnswer LiveAnswers::part(std::string_view query) const {
  PartQuery asked;
  if (std::string wrong = parse_query(query, asked); !wrong.empty()) {
    return live_refusal(400, std::move(wrong));
  }
  return {
      .status = 200, .type = "application/json", .body = run_.part(*asked.from, *asked.generation).dump()};
}

LiveAnswer LiveAnswers::steer(std::string_view path) const {
  if (path == "/pause") run_.pause();
  if (path == "/resume") run_.resume();
  if (path == "/step" && !run_.step()) return live_refusal(409, "only a run that is paused can be stepped");
  return {};
}

LiveAnswer LiveAnswers::answer(const LiveRequest& request) const {
  if (!is_ours(request)) return live_refusal(403, "only the page that this server shows may ask it");

  const std::string_view target = request.target;
  const std::string_view path = target.substr(0, target.find('?'));
  const std::string_view query = target.substr(std::min(target.size(), path.size() + 1));
  const bool shows = path == "/" || path == "/part";
  const bool steers = path == "/pause" || path == "/resume" || path == "/step";
  if (!shows && !steers) return live_refusal(404, "there is nothing here");

  const std::string_view method = shows ? "GET" : "POST";
  if (request.method != method) {
    LiveAnswer refusal = live_refusal(405, fmt::format("expected {}", method));
    refusal.allow = method;
    return refusal;
  }
  if (steers && request.fairway != "1") return live_refusal(403, "expected the header X-Fairway: 1");
  if (steers) return steer(path);
  if (path == "/part") return part(query);
  return {.status = 200, .type = "text/html; charset=utf-8", .body = page_};
}

std::string live_page(const Scenario& scenario, const PlaybackInfo& info) {
  constexpr std::string_view policy = "Content-Security-Policy\" content=\"";
  std::string page = filled(embedded::view_template(), playback_document(scenario, info, nullptr).dump());
  const std::size_t at = page.find(policy);
  if (at == std::string::npos) throw std::logic_error("page template without a content security policy");
  return page.insert(at + policy.size(), "connect-src 'self'; ");
}

}  // namespace fairway
