// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/film_thoughts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "fairway/view/film_text.hpp"
#include "fairway/view/testing/unpack.hpp"

namespace fairway {
namespace {

using nlohmann::json;

constexpr double always = std::numeric_limits<double>::infinity();

/// Plays one vehicle's thoughts, a frame every tenth of a second.
class Play {
 public:
  explicit Play(std::size_t most_bytes = 1'000'000) : thoughts{{scenario, &avoiders}, 1, most_bytes} {}

  Play& frame(const std::vector<Stroke>& strokes, const std::vector<MessageFlight>& flights = {},
              const std::vector<SpokenWord>& words = {}) {
    VehicleFrame vehicle;
    vehicle.strokes = strokes;
    thoughts.see({tick_, seconds(tick_, 0.1), 0.1, {&vehicle, 1}, flights, words});
    tick_ = next(tick_);
    return *this;
  }
  json all(const char* list) const {
    const std::string text = thoughts.between(-1.0, always);
    return text.empty() ? json::array() : json::parse(text).at(list);
  }

  Scenario scenario{.vehicles = {{.id = 3, .avoider = Choice{.name = "pledge"}}}};
  Catalog avoiders = builtin_avoiders();
  FilmThoughts thoughts;

 private:
  Tick tick_{0};
};

std::vector<Stroke> arrow(double north) {
  Drawing drawing;
  drawing.velocity({north, 0, 0}, "chosen");
  return {drawing.strokes().begin(), drawing.strokes().end()};
}

TEST(FilmThoughts, AreRecordedWhenTheyChangeAndAtTheVeryTime) {
  Play play;
  play.frame({}).frame(arrow(1)).frame(arrow(1)).frame(arrow(2)).frame({}).frame({});
  const json sketches = play.all("sketches");
  ASSERT_EQ(sketches.size(), 3u);
  EXPECT_EQ(sketches[0]["time_s"].get<double>(), 1 * 0.1);
  EXPECT_EQ(sketches[1]["time_s"].get<double>(), 3 * 0.1);
  EXPECT_EQ(sketches[0]["strokes"][0]["points"], json::parse("[[1,0,0]]"));
  EXPECT_EQ(sketches[2]["strokes"], json::array());
}

TEST(FilmThoughts, HoldEveryWordAsItsMethodReadsIt) {
  const SpokenWord garbage{0, 0.1, {.bytes = {0x0a, 0x1f}, .size = 2}};
  Play play;
  play.frame({}).frame({}, {}, {garbage}).frame({}).frame({}, {}, {{0, 0.3, garbage.speech}});
  const json words = play.all("words");
  ASSERT_EQ(words.size(), 2u);
  EXPECT_EQ(words[0], json::parse(R"({"time_s":0.1,"vehicle":0,
      "word":{"sent_s":0.1,"text":"not a word of pledge","awaited":[]}})"));
  EXPECT_EQ(words[1]["word"]["sent_s"].get<double>(), 0.3);

  WordReader unread{play.scenario, nullptr};
  EXPECT_EQ(unread.read(garbage).text, "says the bytes 0a1f");
  play.scenario.vehicles[0].avoider.edit().name = "of another program";
  WordReader unknown{play.scenario, &play.avoiders};
  EXPECT_EQ(unknown.read(garbage).text, "says the bytes 0a1f");
}

TEST(FilmThoughts, BeyondTheirSizeKeepTheLastWordOfEachSpan) {
  Play play{10'000};
  for (int i = 0; i < 1000; ++i) play.frame({}, {}, {{0, 0.1 * i, {.bytes = {1}, .size = 1}}});
  const json words = play.all("words");
  EXPECT_GT(play.thoughts.spacing(), 1u);
  EXPECT_GT(words.size(), 10u);
  EXPECT_LT(words.size(), 200u);
  for (const json& word : words)
    EXPECT_LE(word["word"]["sent_s"].get<double>(), word["time_s"].get<double>());
}

TEST(FilmThoughts, WhereNobodyThinksAnythingAreNothing) {
  Play play;
  play.frame({}).frame({});
  EXPECT_EQ(play.thoughts.between(-1.0, always), "");
  EXPECT_FALSE(play.thoughts.has_sketches());
}

TEST(FilmThoughts, BeyondTheirSizeAreKeptLessOftenAndNeverStayLongerThanThat) {
  Play play{10'000};
  const int frames = 3000, busy = 2500;
  for (int i = 0; i < frames; ++i) play.frame(i < busy ? arrow(i) : std::vector<Stroke>{});
  const std::size_t spacing = play.thoughts.spacing();
  EXPECT_GE(spacing, 16u);
  const json sketches = play.all("sketches");
  EXPECT_GT(sketches.size(), 20u);
  EXPECT_LE(play.thoughts.between(-1.0, always).size(), 20'000u);
  EXPECT_EQ(sketches.back()["strokes"], json::array());
  EXPECT_LE(sketches.back()["time_s"], 0.1 * (busy + static_cast<double>(spacing)));
  for (std::size_t i = 0; i + 1 < sketches.size(); ++i) {
    const double shown = sketches[i]["strokes"][0]["points"][0][0];
    EXPECT_NEAR(shown, sketches[i]["time_s"].get<double>() / 0.1, 1e-6) << "what was drawn at that time";
    EXPECT_LE(sketches[i + 1]["time_s"].get<double>() - sketches[i]["time_s"].get<double>(),
              0.1 * 2.0 * static_cast<double>(spacing));
  }
}

TEST(FilmThoughts, HoldAMessageOnceHoweverLongItIsUnderWay) {
  Play play;
  MessageFlight first{.from = 0, .to = 1, .sent = 0.1, .begins = 0.2, .arrives = 0.45};
  const MessageFlight aside{.from = 0, .to = 2, .sent = 0.1, .begins = 0.3, .arrives = 0.5};
  const MessageFlight later{.from = 1, .to = 0, .sent = 0.3, .begins = 0.4, .arrives = 0.6};
  play.frame({}).frame({}, {first, aside}).frame({}, {first, aside});
  first.unheard = true;
  play.frame({}, {first, aside, later}).frame({}, {aside, later}).frame({}, {later});
  const json flights = play.all("flights");
  ASSERT_EQ(flights.size(), 3u);
  EXPECT_EQ(flights[0],
            json::parse(R"({"from":0,"to":1,"sent_s":0.1,"begins_s":0.2,"arrives_s":0.45,"unheard":true})"));
  EXPECT_EQ(flights[1]["to"], 2);
  EXPECT_FALSE(flights[1]["unheard"]);
  EXPECT_EQ(flights[2]["from"], 1);
}

TEST(FilmThoughts, BeyondTheirSizeTellOfWholeTransmissionsOnly) {
  Play play{20'000};
  for (int i = 0; i < 1000; ++i) {
    const double sent = i * 0.1;
    play.frame({}, {{.from = 0, .to = 1, .sent = sent, .begins = sent, .arrives = sent + 0.05},
                    {.from = 0, .to = 2, .sent = sent, .begins = sent, .arrives = sent + 0.05}});
  }
  const json flights = play.all("flights");
  EXPECT_GE(play.thoughts.transmission_stride(), 16u);
  EXPECT_GT(flights.size(), 10u);
  ASSERT_EQ(flights.size() % 2, 0u);
  for (std::size_t i = 0; i < flights.size(); i += 2)
    EXPECT_EQ(flights[i]["sent_s"], flights[i + 1]["sent_s"]);
}

TEST(FilmText, IsTheStrokesAsThePageReadsThem) {
  Drawing drawing;
  drawing.half_space({0.123456789, 0, 0}, {0, -1, 0}, "plane of \"robot\" 3");
  drawing.sphere({1, 2, 3}, 4.5, "reach");
  const std::array<std::uint32_t, 1> pixel{0x010203};
  drawing.image({.rgb = pixel, .side = 1, .reach = 2.0, .yaw = 0.5}, "zones");
  const json strokes = json::parse(text_of(drawing.strokes()));
  EXPECT_EQ(strokes[0], json::parse(R"({"kind":"half_space","meaning":"plane of \"robot\" 3",
                                        "points":[[0.12346,0,0],[0,-1,0]]})"));
  EXPECT_EQ(strokes[1],
            json::parse(R"({"kind":"sphere","meaning":"reach","points":[[1,2,3]],"radius":4.5})"));
  EXPECT_EQ(strokes[2],
            json::parse(R"({"kind":"image","meaning":"zones","side":1,"reach":2,"yaw":0.5,"rgb":"AQID"})"));
}

TEST(FilmText, LeavesOutWhatCannotBeShownAndStaysJson) {
  Drawing drawing;
  drawing.velocity({std::nan(""), 0, 0}, "nowhere");
  drawing.velocity({-0.0, 1e-9, 1e12}, "far \xff");
  const json strokes = json::parse(text_of(drawing.strokes()));
  ASSERT_EQ(strokes.size(), 1u);
  EXPECT_EQ(strokes[0]["points"], json::parse("[[0,0,1e12]]"));

  Track track;
  track.position_covariance = Vec3{1, 9, 4}.asDiagonal();
  const std::vector<Track> tracks{track};
  EXPECT_DOUBLE_EQ(json::parse(text_of(tracks))[0]["sigma_m"], 3.0);
}

}  // namespace
}  // namespace fairway
