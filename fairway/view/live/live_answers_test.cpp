// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/live/live_answers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/view/live/testing/sample_frames.hpp"

namespace fairway {
namespace {

using ::testing::HasSubstr;

class LiveAnswersTest : public ::testing::Test {
 protected:
  LiveRequest get(const std::string& target) const {
    return {.method = "GET", .target = target, .host = host};
  }
  LiveRequest post(const std::string& target) const {
    return {.method = "POST", .target = target, .host = host, .fairway = "1"};
  }
  unsigned status(const LiveRequest& request) const { return answers.answer(request).status; }
  bool is_paused() { return run.part(0, 0)["state"]["paused"]; }

  const std::string host = "127.0.0.1:8080";
  const testing::SampleFrames frames;
  LiveRun run{frames.scenario, {}};
  const LiveAnswers answers{"<p>page</p>", 8080, run};
};

TEST_F(LiveAnswersTest, ShowsThePageAndParts) {
  const LiveAnswer page = answers.answer(get("/"));
  EXPECT_EQ(page.status, 200U);
  EXPECT_EQ(page.type, "text/html; charset=utf-8");
  EXPECT_EQ(page.body, "<p>page</p>");

  const LiveAnswer part = answers.answer(get("/part?from=0&generation=0"));
  EXPECT_EQ(part.status, 200U);
  EXPECT_EQ(part.type, "application/json");
  EXPECT_EQ(part.body, run.part(0, 0).dump());
}

TEST_F(LiveAnswersTest, PausesResumesAndStepsOnlyWhatIsPaused) {
  EXPECT_EQ(status(post("/step")), 409U);
  EXPECT_EQ(status(post("/pause")), 204U);
  EXPECT_TRUE(is_paused());
  EXPECT_EQ(status(post("/step")), 204U);
  EXPECT_EQ(status(post("/resume")), 204U);
  EXPECT_FALSE(is_paused());
}

TEST_F(LiveAnswersTest, ANameThatIsNotOursIsRefusedWhateverItResolvesTo) {
  LiveRequest request = get("/");
  request.host = "localhost:8080";
  EXPECT_EQ(status(request), 200U);
  for (const char* name :
       {"", "127.0.0.1", "127.0.0.1:80", "127.0.0.1:80800", "localhost", "rebound.example:8080",
        "127.0.0.1:8080,127.0.0.1:8080", "127.0.0.1:8080.example", "[::1]:8080"}) {
    request.host = name;
    EXPECT_EQ(status(request), 403U) << name;
  }
}

TEST_F(LiveAnswersTest, APageOfAnotherOriginIsRefused) {
  LiveRequest request = post("/pause");
  for (const char* origin : {"null", "http://evil.example", "http://127.0.0.1:9000", "https://127.0.0.1:8080",
                             "http://localhost:8080", "http://127.0.0.1:8080,http://evil.example"}) {
    request.origin = origin;
    EXPECT_EQ(status(request), 403U) << origin;
    LiveRequest reading = get("/part?from=0&generation=0");
    reading.origin = origin;
    EXPECT_EQ(status(reading), 403U) << origin;
  }
  request.origin = "http://127.0.0.1:8080";
  request.fetch_site = "same-origin";
  EXPECT_EQ(status(request), 204U);
  for (const char* site : {"cross-site", "same-site", "same-origin,cross-site", "?"}) {
    request.fetch_site = site;
    EXPECT_EQ(status(request), 403U) << site;
  }
  request.fetch_site = "none";  // typed by the user
  EXPECT_EQ(status(request), 204U);
}

TEST_F(LiveAnswersTest, NothingIsChangedWithoutTheHeaderThatOnlyOurPageCanSend) {
  for (const char* value : {"", "0", "1,1", "true"}) {
    LiveRequest request = post("/pause");
    request.fairway = value;
    EXPECT_EQ(status(request), 403U) << value;
  }
  EXPECT_FALSE(is_paused());
}

TEST_F(LiveAnswersTest, OtherMethodsAreRefusedByNameAndChangeNothing) {
  for (const char* method : {"HEAD", "OPTIONS", "PUT", "DELETE", "POST", "get", ""}) {
    LiveRequest request = get("/");
    request.method = method;
    const LiveAnswer answer = answers.answer(request);
    EXPECT_EQ(answer.status, 405U) << method;
    EXPECT_EQ(answer.allow, "GET");
  }
  for (const char* method : {"GET", "HEAD", "OPTIONS", "PUT"}) {
    LiveRequest request = post("/pause");
    request.method = method;
    const LiveAnswer answer = answers.answer(request);
    EXPECT_EQ(answer.status, 405U) << method;
    EXPECT_EQ(answer.allow, "POST");
  }
  EXPECT_FALSE(is_paused());
}

TEST_F(LiveAnswersTest, ThereIsNothingElse) {
  for (const char* target : {"", "//", "/index.html", "/part/", "/../etc/passwd", "/%2e%2e/", "/favicon.ico",
                             "http://127.0.0.1:8080/", "*", "/Pause", "/pause/"}) {
    EXPECT_EQ(status(get(target)), 404U) << target;
    EXPECT_EQ(status(post(target)), 404U) << target;
  }
}

TEST_F(LiveAnswersTest, ABadQueryIsAnsweredWithOneLineThatSaysWhatWasExpected) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "expected part?from=K&generation=G"},
      {"?", "expected part?from=K&generation=G"},
      {"?from=1", "expected part?from=K&generation=G"},
      {"?from=&generation=0", "from is not a count"},
      {"?from=-1&generation=0", "from is not a count"},
      {"?from=1e3&generation=0", "from is not a count"},
      {"?from=+1&generation=0", "from is not a count"},
      {"?from=99999999999999999999999&generation=0", "from is not a count"},
      {"?from=0&generation=x", "generation is not a count"},
      {"?from=0&from=0&generation=0", "from is given twice"},
      {"?from=0&generation=0&most=9", "unknown name in the query; known: from, generation"},
      {"?from=0&&generation=0", "unknown name"}};
  for (const auto& [query, words] : cases) {
    const LiveAnswer answer = answers.answer(get(std::string("/part") + query));
    EXPECT_EQ(answer.status, 400U) << query;
    EXPECT_THAT(answer.body, HasSubstr(words)) << query;
    EXPECT_EQ(std::ranges::count(answer.body, '\n'), 1) << query;
  }
}

TEST_F(LiveAnswersTest, ThePageOfARunStillToBeMadeMayAskItsServerAndNobodyElse) {
  const std::string page =
      live_page(frames.scenario, {.version = "1", .command = "run", .period = 0.1, .explanation = {}});
  const std::size_t policy = page.find("Content-Security-Policy\" content=\"");
  ASSERT_NE(policy, std::string::npos);
  const std::string rules = page.substr(policy, page.find("\">", policy) - policy);
  EXPECT_THAT(rules, HasSubstr("default-src 'none'"));
  const std::size_t asking = rules.find("connect-src 'self'");
  ASSERT_NE(asking, std::string::npos);
  EXPECT_EQ(rules.find("connect-src", asking + 1),
            std::string::npos);  // the first one counts, and browsers complain
  EXPECT_THAT(page, Not(HasSubstr("__FAIRWAY_DATA__")));
}

}  // namespace
}  // namespace fairway
