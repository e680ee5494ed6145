// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/live/live_server.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "fairway/core/testing/refusal.hpp"

namespace fairway {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A client that says what it likes.
class Caller {
 public:
  explicit Caller(std::uint16_t port) : socket_{::socket(AF_INET, SOCK_STREAM, 0)} {
    sockaddr_in place{
        .sin_family = AF_INET, .sin_port = htons(port), .sin_addr = {htonl(INADDR_LOOPBACK)}, .sin_zero = {}};
    const timeval patience{.tv_sec = 30, .tv_usec = 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    if (::connect(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0)
      ADD_FAILURE() << "refused";
  }
  ~Caller() { ::close(socket_); }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  void say(const std::string& text) const { ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL); }

  /// What comes until the other side hangs up, or until `end` has come.
  std::string hear(const std::string& end = "\1") const {
    std::string text;
    std::array<char, 4096> some{};
    while (text.find(end) == std::string::npos) {
      const ssize_t count = ::recv(socket_, some.data(), some.size(), 0);
      if (count <= 0) return text + (count == 0 ? "|hung up" : "|nothing more");
      text.append(some.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

 private:
  int socket_;
};

const std::string request = "GET / HTTP/1.1\r\nHost: here\r\n\r\n";

LiveAnswer echo(const LiveRequest& asked) {
  if (asked.target == "/throw") throw std::runtime_error("on purpose");
  return {.status = 200, .body = asked.method + " " + asked.target + " of " + asked.host + ".\n"};
}

TEST(LiveServer, AnswersOneRequestAfterTheOtherWithTheHeadersThatKeepOthersOut) {
  LiveServer server{0};
  server.serve(echo);
  const Caller caller{server.port()};
  caller.say(request);
  const std::string answer = caller.hear("here.\n");
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 200 OK\r\n"));
  for (const char* header : {"X-Content-Type-Options: nosniff", "X-Frame-Options: DENY",
                             "Cache-Control: no-store", "Cross-Origin-Resource-Policy: same-origin"}) {
    EXPECT_THAT(answer, HasSubstr(header));
  }
  EXPECT_THAT(answer, Not(HasSubstr("Access-Control")));
  caller.say(request);
  EXPECT_THAT(caller.hear("here.\n"), HasSubstr("GET / of here."));
}

TEST(LiveServer, AHeaderGivenTwiceIsNeitherOfTheTwo) {
  LiveServer server{0};
  server.serve(echo);
  const Caller caller{server.port()};
  caller.say("GET / HTTP/1.1\r\nHost: here\r\nhost: there\r\n\r\n");
  EXPECT_THAT(caller.hear(".\n"), HasSubstr("GET / of here,there."));
}

TEST(LiveServer, WhatCannotBeAnsweredIsSaidAndTheNextOneIs) {
  LiveServer server{0};
  server.serve(echo);
  const Caller caller{server.port()};
  caller.say("GET /throw HTTP/1.1\r\nHost: here\r\n\r\n");
  EXPECT_THAT(caller.hear("answered\n"), StartsWith("HTTP/1.1 500 "));
  caller.say(request);
  EXPECT_THAT(caller.hear("here.\n"), HasSubstr("200 OK"));
}

TEST(LiveServer, WhatIsTooLongOrNoRequestIsRefusedAndTheConnectionEnds) {
  LiveServer server{0};
  server.serve(echo);
  const std::pair<std::string, const char*> cases[] = {
      {"GET / HTTP/1.1\r\nX: " + std::string(8192, 'x'), "431"},
      {"GET /" + std::string(8192, 'x'), "431"},
      {"POST /pause HTTP/1.1\r\nContent-Length: 5\r\n\r\nhello", "413"},
      {"what is this\r\n\r\n", "400"}};
  for (const auto& [text, status] : cases) {
    const Caller caller{server.port()};
    caller.say(text);
    const std::string answer = caller.hear();
    EXPECT_THAT(answer, StartsWith(std::string("HTTP/1.1 ") + status)) << text.substr(0, 40);
  }
}

TEST(LiveServer, OneConnectionTooManyDropsTheOneThatHasBeenIdleForLongest) {
  LiveServer server{0, {.connections = 2}};
  server.serve(echo);
  const Caller first{server.port()};
  first.say(request);
  first.hear("here.\n");
  const Caller second{server.port()};
  second.say(request);
  second.hear("here.\n");
  first.say(request);
  first.hear("here.\n");
  const Caller third{server.port()};
  third.say(request);
  EXPECT_THAT(third.hear("here.\n"), HasSubstr("200 OK"));
  EXPECT_EQ(second.hear(), "|hung up");
  first.say(request);
  EXPECT_THAT(first.hear("here.\n"), HasSubstr("200 OK"));
}

TEST(LiveServer, WhoNeverReadsKeepsNobodyWaiting) {
  const std::string much(1U << 25U, 'x');
  LiveServer server{0, {.connections = 3}};
  server.serve([&](const LiveRequest& asked) {
    return asked.target == "/much" ? LiveAnswer{.status = 200, .body = much} : echo(asked);
  });
  std::vector<std::unique_ptr<Caller>> silent;
  for (int k = 0; k < 4; ++k) {
    silent.push_back(std::make_unique<Caller>(server.port()));
    silent.back()->say("GET /much HTTP/1.1\r\nHost: here\r\n\r\n");
  }
  const Caller caller{server.port()};
  caller.say(request);
  EXPECT_THAT(caller.hear("here.\n"), HasSubstr("200 OK"));
}

TEST(LiveServer, WhoBeginsARequestAndNeverEndsItIsDropped) {
  LiveServer server{0, {.patience = std::chrono::seconds(1)}};
  server.serve(echo);
  const Caller caller{server.port()};
  caller.say("GET / HT");
  EXPECT_EQ(caller.hear(), "|hung up");
}

TEST(LiveServer, APortThatIsTakenIsOneClearLine) {
  const LiveServer server{0};
  EXPECT_THAT(refusal_by([&] { const LiveServer second{server.port()}; }),
              HasSubstr("cannot be served: Address already in use"));
}

}  // namespace
}  // namespace fairway
