// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ros/bridge/testing/message_laws.hpp"
#include "ros/ros1/middleware.hpp"
#include "ros/ros1/parameters.hpp"

namespace fairway {
namespace bridge {
INSTANTIATE_TYPED_TEST_SUITE_P(Ros1, Messages, ros1::Middleware, );
}

namespace ros1 {
namespace {

TEST(Parameters, AreSettingsAsTheyWereWritten) {
  XmlRpc::XmlRpcValue parameters;
  parameters["frame"] = "ned";
  parameters["seed"] = 7;
  parameters["advisory"] = true;
  parameters["params"]["time_horizon_s"] = 5.1;
  EXPECT_EQ(settings_of(parameters),
            (bridge::Settings{
                {"advisory", "true"}, {"frame", "ned"}, {"params.time_horizon_s", "5.1"}, {"seed", "7"}}));
  EXPECT_TRUE(settings_of(XmlRpc::XmlRpcValue{}).empty());
}

TEST(Parameters, TakeATeamAsAListAsWordsOrAsAFolder) {
  XmlRpc::XmlRpcValue list, words, folder;
  list["team"][0] = "auv_2";
  list["team"][1] = "auv_3";
  words["team"] = "auv_2 auv_3";
  folder["team"]["auv_2"]["radius_m"] = 3.5;
  folder["team"]["auv_3"]["priority"] = 2;
  const bridge::Settings both{{"team", "auv_2 auv_3"}};
  EXPECT_EQ(settings_of(list), both);
  EXPECT_EQ(settings_of(words), both);
  EXPECT_EQ(settings_of(folder),
            (bridge::Settings{
                {"team", "auv_2 auv_3"}, {"team.auv_2.radius_m", "3.5"}, {"team.auv_3.priority", "2"}}));
}

TEST(Parameters, TakeOverridesAsAListOrBetweenSemicolons) {
  XmlRpc::XmlRpcValue text, list, wrong;
  text["overrides"] = "a=1;b=x=2";
  list["overrides"][0] = "a=1";
  list["overrides"][1] = "b=x=2";
  const bridge::Settings both{{"override.a", "1"}, {"override.b", "x=2"}};
  EXPECT_EQ(settings_of(text), both);
  EXPECT_EQ(settings_of(list), both);
  wrong["overrides"] = "duration_s";
  EXPECT_THROW(settings_of(wrong), std::runtime_error);
}

}  // namespace
}  // namespace ros1
}  // namespace fairway
