// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/catalog.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fairway/avoidance/orca2d/orca2d.hpp"
#include "fairway/core/testing/refusal.hpp"

namespace fairway {
namespace {

TEST(Catalog, RefusesAnUnknownAlgorithmAndNamesTheNearest) {
  const Catalog catalog = builtin_avoiders();
  EXPECT_THAT(refusal_by([&] { (void)catalog.make("orca_3d"); }), testing::HasSubstr("did you mean orca3d?"));
  EXPECT_THAT(refusal_by([&] { (void)catalog.make("apf+stop_and_wit"); }),
              testing::HasSubstr("stop_and_wait"));
  EXPECT_THAT(refusal_by([&] { (void)catalog.make("apf+orca3d"); }), testing::HasSubstr("wraps nothing"));
}

TEST(Catalog, RefusesAnUnknownParameterAndNamesTheNearest) {
  const Catalog catalog = builtin_avoiders();
  EXPECT_THAT(refusal_by([&] {
                (void)catalog.make("orca3d", {{"time_horizon", 5.0}});
              }),
              testing::HasSubstr("time_horizon: unknown parameter of orca3d; did you mean time_horizon_s?"));
  EXPECT_THAT(refusal_by([&] {
                (void)catalog.make("apf", {{"w2_rato", 5.0}});
              }),
              testing::HasSubstr("did you mean w2_ratio?"));
}

TEST(Catalog, RefusesAValueOutOfRangeAndSaysWhatIsAccepted) {
  const Catalog catalog = builtin_avoiders();
  EXPECT_THAT(refusal_by([&] {
                (void)catalog.make("orca3d", {{"responsibility_ratio", 1.5}});
              }),
              testing::AllOf(testing::HasSubstr("1.5"), testing::HasSubstr("[0, 1]")));
  EXPECT_THAT(refusal_by([&] {
                (void)catalog.make("orca3d", {{"max_neighbours_count", 2.5}});
              }),
              testing::HasSubstr("a whole number"));
  EXPECT_THAT(refusal_by([&] {
                (void)catalog.make("apf", {{"speed_law", std::string("fast")}});
              }),
              testing::HasSubstr("one of clamped, bang_bang"));
}

TEST(Catalog, KnowsWrappersByTheirShortNames) {
  EXPECT_EQ(builtin_avoiders().make("apf+saw").info().name, "stop_and_wait");
  EXPECT_EQ(builtin_avoiders().make("apf+cbf").info().name, "safety_filter");
}

TEST(Catalog, ListsTheParametersOfAllLayersOnce) {
  const std::vector<ParamInfo> params = builtin_avoiders().params("apf+stop_and_wait");
  EXPECT_EQ(std::ranges::count(params, std::string("crit_dist_m"), &ParamInfo::name), 1);
  EXPECT_EQ(std::ranges::count(params, std::string("w2_ratio"), &ParamInfo::name), 1);
}

TEST(Catalog, PutsTrackableBehindTheLastLayerThatDecides) {
  const Catalog catalog = builtin_avoiders();
  EXPECT_EQ(catalog.tracked("orca2d"), "orca2d+trackable");
  EXPECT_EQ(catalog.tracked("orca2d+way_round"), "orca2d+trackable+way_round");
  EXPECT_EQ(catalog.tracked("orca3d+inflate"), "orca3d+trackable+inflate");
  EXPECT_EQ(catalog.tracked("orca3d+saw"), "orca3d+saw+trackable");
  EXPECT_EQ(catalog.tracked("way_round"), "trackable+way_round");
  EXPECT_NO_THROW((void)catalog.make(catalog.tracked("way_round")));
}

TEST(Catalog, LeavesWhoFollowsByItselfAndWhoAvoidsNobody) {
  const Catalog catalog = builtin_avoiders();
  for (const std::string_view name : {"direct", "trackable", "orca2d+trackable", "orca2d+trackable+way_round",
                                      "apf+safety_filter", "orca3d+cbf"})
    EXPECT_EQ(catalog.tracked(name), name);
  EXPECT_EQ(Catalog{}.add<Orca2d>().tracked("orca2d"), "orca2d");  // there is no wrapper to take
}

TEST(Catalog, PutsWayRoundOutermostForWhoFindsNoWay) {
  const Catalog catalog = builtin_avoiders();
  EXPECT_EQ(catalog.guided("orca2d"), "orca2d+way_round");
  EXPECT_EQ(catalog.guided("orca3d+inflate"), "orca3d+inflate+way_round");
  EXPECT_EQ(catalog.guided("stop_and_wait"), "stop_and_wait+way_round");
  EXPECT_EQ(catalog.guided("direct+safety_filter"), "direct+safety_filter+way_round");
  for (const std::string_view name : {"direct", "avoa_improved", "orca2d+trackable", "pledge", "inflate",
                                      "orca2d+way_round", "orca2d+way_round+trackable"})
    EXPECT_EQ(catalog.guided(name), name);
  EXPECT_EQ(Catalog{}.add<Orca2d>().guided("orca2d"), "orca2d");  // there is no wrapper to take
}

TEST(Catalog, SaysWhatAMethodTakesForGranted) {
  using testing::ElementsAre;
  const Catalog catalog = builtin_avoiders();
  EXPECT_THAT(catalog.needs_of("direct"), ElementsAre());
  EXPECT_THAT(catalog.needs_of("orca3d"), ElementsAre("sway"));
  EXPECT_THAT(catalog.needs_of("orca2d"), ElementsAre("sway", "plane"));
  EXPECT_THAT(catalog.needs_of("avoa"), ElementsAre("plane"));
  EXPECT_THAT(catalog.needs_of("orca2d+stop_and_wait"), ElementsAre("sway", "stopping", "plane"));
  EXPECT_THAT(catalog.needs_of("orca2d+trackable"), ElementsAre("plane"));
}

TEST(Catalog, AnAliasIsOfWhatIsThereAndItsNameIsFree) {
  using testing::HasSubstr;
  Catalog catalog = builtin_avoiders();
  EXPECT_THAT(refusal_by([&] { catalog.alias("orca3d", "direct"); }), HasSubstr("is there already"));
  EXPECT_THAT(refusal_by([&] { catalog.alias("cbf", "direct"); }), HasSubstr("is there already"));
  EXPECT_THAT(refusal_by([&] { catalog.alias("a", "b"); }), HasSubstr("unknown algorithm \"b\""));
  EXPECT_THAT(refusal_by([&] { catalog.alias("a", "a"); }), HasSubstr("unknown algorithm \"a\""));
  EXPECT_THAT(refusal_by([&] { catalog.alias("a+b", "direct"); }), HasSubstr("'+'"));
  catalog.alias("filter", "cbf");
  EXPECT_EQ(catalog.find("filter").info.name, "safety_filter");
}

TEST(Catalog, RefusesANameThatLayersCouldNotBeCalledBy) {
  for (const std::string_view name : {"a+b", "+", ""}) {
    AlgorithmInfo info = Orca2d::info;
    info.name = name;
    EXPECT_THAT(
        refusal_by([&] { Catalog{}.add({.info = info, .params = {}, .make = {}, .make_around = {}}); }),
        testing::HasSubstr("'+'"));
  }
}

}  // namespace
}  // namespace fairway
