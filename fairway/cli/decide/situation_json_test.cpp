// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/decide/situation_json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "fairway/core/testing/refusal.hpp"

namespace fairway {
namespace {

using testing::HasSubstr;

constexpr std::string_view full = R"({"time":2.5,"period":0.1,
 "own":{"id":3,"position":[1,2,3],"velocity":[0.5,0,-0.1],"yaw":0.25,"radius":1.5,"priority":-7},
 "goal":{"position":[10,20,30],"cruise_speed":0.4},"preferred_velocity":[0.1,0.2,0.3],
 "limits":{"max_speed":0.5,"max_climb_rate":0.2,"max_acceleration":0.3,"max_turn_rate":0.4,
  "min_depth":1,"max_depth":90,"min_speed":0.25,"sternway":false,"sway":false},
 "params":{"time_horizon_s":5,"full":true,"kind":"fast"},
 "tracks":[{"id":9,"position":[5,2,3],"velocity":[0,0,0],"radius":1},
           {"id":8,"position":[1,4,3],"velocity":[0,1,0],"radius":2,
            "yaw":1,"age":0.5,"priority":4,"destination":[7,8,9],
            "position_covariance":[[4,1,0],[1,2,0],[0,0,0]]},
           {"id":4,"position":[1,2,7],"velocity":[0,0,0],"radius":1}],
 "obstacles":[{"kind":"sphere","position":[9,9,9],"radius":2},
              {"kind":"segment","from":[1,1,1],"to":[2,2,2]},
              {"kind":"polygon","vertices":[[0,0,0],[4,0,0],[4,4,0]]},
              {"kind":"polygon","vertices":[[0,0,0],[5,0,0],[5,5,0]]}]})";

TEST(SituationJsonTest, EveryKeyArrivesWhereItBelongs) {
  const DecideRequest request = parse_situation(full, 1);
  const Situation s = request.situation();
  EXPECT_EQ(s.time, 2.5);
  EXPECT_EQ(s.period, 0.1);
  EXPECT_EQ(s.own.id, VehicleId{3});
  EXPECT_EQ(s.own.position, Vec3(1, 2, 3));
  EXPECT_EQ(s.own.velocity, Vec3(0.5, 0, -0.1));
  EXPECT_EQ(s.own.yaw, 0.25);
  EXPECT_EQ(s.own.radius, 1.5);
  EXPECT_EQ(s.own.priority, -7);
  EXPECT_EQ(s.goal.position, Vec3(10, 20, 30));
  EXPECT_EQ(s.goal.cruise_speed, 0.4);
  EXPECT_EQ(s.goal.velocity, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(s.limits, (Limits{0.5, 0.2, 0.3, 0.4, 1, 90, 0.25, false, false}));
  EXPECT_EQ(request.params,
            (ParamValues{{"time_horizon_s", 5.0}, {"full", true}, {"kind", std::string("fast")}}));

  ASSERT_EQ(s.tracks.size(), 3U);
  EXPECT_EQ(s.tracks[0].id, TrackId{8}) << "nearest first";
  EXPECT_EQ(s.tracks[1].id, TrackId{4}) << "equally near: the smaller id";
  EXPECT_EQ(s.tracks[2].id, TrackId{9});
  EXPECT_EQ(s.tracks[0].yaw, 1.0);
  EXPECT_EQ(s.tracks[0].age, 0.5);
  EXPECT_EQ(s.tracks[0].radius, 2.0);
  EXPECT_EQ(s.tracks[0].priority, 4);
  EXPECT_EQ(s.tracks[0].destination, Vec3(7, 8, 9));
  EXPECT_EQ(s.tracks[0].position_covariance, (Mat3{{4, 1, 0}, {1, 2, 0}, {0, 0, 0}}));
  EXPECT_EQ(s.tracks[1].priority, 4) << "the id unless given";
  EXPECT_EQ(s.tracks[1].position_covariance, Mat3::Zero());
  EXPECT_FALSE(s.tracks[1].destination);

  ASSERT_EQ(s.obstacles.size(), 4U);
  EXPECT_EQ(s.obstacles[0].radius, 2.0);
  EXPECT_EQ(s.obstacles[1].to, Vec3(2, 2, 2));
  EXPECT_EQ(s.obstacles[2].vertices[1], Vec3(4, 0, 0));
  EXPECT_EQ(s.obstacles[3].vertices[2], Vec3(5, 5, 0));
}

constexpr std::string_view least =
    R"({"period":0.1,"own":{"id":3,"position":[0,0,0],"velocity":[0,0,0],"yaw":0,"radius":1},
 "goal":{"position":[9,0,0]},"limits":{"max_speed":0.5}})";

TEST(SituationJsonTest, WhatIsNotSaidHasItsDefault) {
  const DecideRequest request = parse_situation(least, 1);
  const Situation s = request.situation();
  EXPECT_EQ(s.time, 0.0);
  EXPECT_EQ(s.own.priority, 3);
  EXPECT_EQ(s.goal.cruise_speed, 0.5);
  EXPECT_FALSE(s.goal.velocity);
  EXPECT_EQ(s.limits, Limits{.max_speed = 0.5});
  EXPECT_TRUE(s.tracks.empty());
  EXPECT_TRUE(s.obstacles.empty());
  EXPECT_TRUE(request.params.empty());
}

TEST(SituationJsonTest, AMovedRequestStillShowsItsVertices) {
  DecideRequest request = parse_situation(full, 1);
  const DecideRequest moved = std::move(request);
  EXPECT_EQ(moved.situation().obstacles[2].vertices[1], Vec3(4, 0, 0));
}

/// The message about line 17 after `from` has been replaced by `to`.
std::string refusal(std::string_view from, std::string_view to, std::string_view base = full) {
  std::string text{base};
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  return refusal_by([&] { parse_situation(text, 17); });
}

TEST(SituationJsonTest, ARefusalNamesLineAndPath) {
  EXPECT_EQ(refusal("[5,2,3]", "[5,2]"),
            "line 17: tracks[0].position: expected three numbers [n, e, d], got a list of 2");
  EXPECT_EQ(refusal("[5,2,3]", "[5,2,\"3\"]"),
            "line 17: tracks[0].position[2]: expected a number in [-1e+30, 1e+30], got the text \"3\"");
  EXPECT_EQ(refusal("[4,0,0]", "null"),
            "line 17: obstacles[2].vertices[1]: expected three numbers [n, e, d], got null");
  EXPECT_EQ(refusal("\"yaw\":0.25", "\"yaw\":\"north\""),
            "line 17: own.yaw: expected a number in [-1e+30, 1e+30], got the text \"north\"");
  EXPECT_EQ(refusal("\"own\"", "\"won\""), "line 17: won: unknown key; did you mean own?");
  EXPECT_EQ(refusal("max_turn_rate", "max_turn_rat"),
            "line 17: limits.max_turn_rat: unknown key; did you mean max_turn_rate?");
  EXPECT_EQ(refusal("\"max_speed\":0.5,", ""), "line 17: limits: the key max_speed is missing");
  EXPECT_EQ(refusal("\"period\":0.1,", ""), "line 17: the key period is missing");
  EXPECT_EQ(refusal("\"period\":0.1", "\"period\":0"),
            "line 17: period: expected a number in (0, inf], got 0");
  EXPECT_EQ(refusal("\"id\":9", "\"id\":-1"),
            "line 17: tracks[0].id: expected a whole number in [0, 4294967295], got -1");
  EXPECT_EQ(refusal("\"id\":9", "\"id\":1.5"),
            "line 17: tracks[0].id: expected a whole number in [0, 4294967295], got 1.5");
  EXPECT_EQ(refusal("\"radius\":2", "\"radius\":-2"),
            "line 17: tracks[1].radius: expected a number in [0, 1e+30], got -2");
  EXPECT_EQ(refusal("\"full\":true", "\"full\":[1]"),
            "line 17: params.full[0]: expected a mapping of parameters, got 1");
  EXPECT_EQ(refusal("\"sphere\"", "\"ball\""),
            "line 17: obstacles[0].kind: expected sphere, segment or polygon, got the text \"ball\"");
  EXPECT_EQ(refusal("\"kind\":\"sphere\",", ""), "line 17: obstacles[0]: the key kind is missing");
  EXPECT_EQ(refusal("\"from\"", "\"radius\":1,\"from\""),
            "line 17: obstacles[1].radius: unknown key; known: kind, from, to, charted");
  EXPECT_EQ(refusal("\"min_depth\":1", "\"min_depth\":99"),
            "line 17: limits: min_depth is below max_depth; depth counts downwards");
  EXPECT_EQ(refusal("\"cruise_speed\"", "\"speed\":1,\"cruise_speed\""),
            "line 17: goal: cruise_speed and speed are the same; keep one");
  EXPECT_EQ(refusal("\"yaw\":0.25", "\"yaw\":{\"uniform\":[0,1]}"),
            "line 17: own.yaw: expected a number in [-1e+30, 1e+30], got a mapping with the key uniform");
  EXPECT_EQ(
      refusal("\"time_horizon_s\":5", "\"time_horizon_s\":{\"normal\":[5,1]}"),
      "line 17: params.time_horizon_s: expected a number in [-1e+100, 1e+100], got a mapping with the key "
      "normal");
}

TEST(SituationJsonTest, ANumberHasTheBitsThatAreWritten) {
  const auto yaw_of = [](std::string_view written) {
    std::string text{least};
    return parse_situation(text.replace(text.find("\"yaw\":0"), 7, "\"yaw\":" + std::string(written)), 1)
        .without_others.own.yaw;
  };
  EXPECT_EQ(yaw_of("0.1"), 0.1);
  EXPECT_EQ(yaw_of("-1E-3"), -1e-3);
  EXPECT_EQ(yaw_of("12345678901234567890"), 12345678901234567890.0);
  EXPECT_EQ(yaw_of("123456789012345678901234567890"), 123456789012345678901234567890.0);
  EXPECT_EQ(yaw_of("1e-320"), 1e-320);
  EXPECT_EQ(yaw_of("1e-400"), 0.0);
  EXPECT_TRUE(std::signbit(yaw_of("-0.0")));
}

TEST(SituationJsonTest, ACovarianceIsSymmetricAndNowhereNegative) {
  constexpr std::string_view rows = "[[4,1,0],[1,2,0],[0,0,0]]";
  const std::string path = "line 17: tracks[1].position_covariance";
  EXPECT_EQ(refusal(rows, "4"), path + ": expected three rows of three numbers, got 4");
  EXPECT_EQ(refusal(rows, "[[4,1,0],[1,2,0]]"),
            path + ": expected three rows of three numbers, got a list of 2");
  EXPECT_EQ(refusal(rows, "[[4,1,0],[1,2],[0,0,0]]"),
            path + "[1]: expected three numbers [n, e, d], got a list of 2");
  EXPECT_EQ(refusal(rows, "[[4,1,0],[2,2,0],[0,0,0]]"), path + ": expected a symmetric matrix");
  EXPECT_EQ(refusal(rows, "[[4,3,0],[3,2,0],[0,0,0]]"),
            path + ": the variance along some direction is negative");  // 4 x 2 < 3 x 3
  EXPECT_EQ(refusal(rows, "[[-1,0,0],[0,2,0],[0,0,0]]"),
            path + ": the variance along some direction is negative");
}

TEST(SituationJsonTest, NobodyIsThereTwice) {
  EXPECT_EQ(refusal("\"id\":9", "\"id\":4"), "line 17: tracks[2]: id 4 is that of tracks[0]");
  EXPECT_EQ(refusal("\"id\":9", "\"id\":3"), "line 17: tracks[0]: id 3 is own.id");
  EXPECT_EQ(refusal("\"time\":2.5", "\"time\":2.5,\"time\":1"), "line 17: time: given twice");
}

TEST(SituationJsonTest, PolygonsRunCounterClockwise) {
  EXPECT_THAT(refusal("[4,0,0],[4,4,0]", "[4,4,0],[4,0,0]"),
              HasSubstr("line 17: obstacles[2].vertices: they run clockwise"));
  EXPECT_EQ(refusal(",[4,4,0]", ""), "line 17: obstacles[2].vertices: expected at least three, got 2");
  EXPECT_THAT(refusal("[4,4,0]", "[8,0,0]"), HasSubstr("they lie on one line"));
}

TEST(SituationJsonTest, WhatIsNotJsonIsRefused) {
  EXPECT_EQ(refusal("\"time\":2.5", "\"time\":NaN"), "line 17: not JSON at column 9");
  EXPECT_EQ(refusal("\"time\":2.5", "\"time\":-Infinity"), "line 17: not JSON at column 10");
  EXPECT_THAT(refusal("\"time\":2.5", "\"time\":1e999"), HasSubstr("line 17: not JSON at column 13"));
  EXPECT_THAT(refusal("}]}", "}]"), HasSubstr("line 17: not JSON"));
  EXPECT_THAT(refusal("2.5", std::string(100'000, '[')), HasSubstr("line 17: nested deeper than 16 levels"));
  EXPECT_EQ(refusal("\"time\":2.5", "\"t\xff\":2.5"), "line 17: not JSON at column 4");
  EXPECT_THAT(refusal(least, "[]", least), HasSubstr("line 17: expected a mapping: time, period, own"));
}

}  // namespace
}  // namespace fairway
