// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/params.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/core/testing/refusal.hpp"
#include "fairway/core/text.hpp"

namespace fairway {
enum class Paint { red, green };
template <>
struct EnumNames<Paint> {
  static constexpr std::array names{"red", "green"};
};

namespace {

struct Hull {
  double length_m = 1.6;
  int ribs_count = 4;
  bool afloat = true;
  Paint paint = Paint::green;

  static consteval auto fields() {
    return std::tuple{field<&Hull::length_m>({0.1, 10}, "over all"),
                      field<&Hull::ribs_count>({1, 9}, "frames"), field<&Hull::afloat>("whether it swims"),
                      field<&Hull::paint>("its colour")};
  }
};

std::string refusal(std::string_view name, const ParamValue& value) {
  Hull hull;
  return refusal_by([&] { set_param(hull, name, value); });
}

TEST(Params, AreSetByName) {
  Hull hull;
  set_param(hull, "length_m", 2.5);
  set_param(hull, "ribs_count", 7.0);
  set_param(hull, "afloat", false);
  set_param(hull, "paint", std::string("red"));
  EXPECT_EQ(hull.length_m, 2.5);
  EXPECT_EQ(hull.ribs_count, 7);
  EXPECT_FALSE(hull.afloat);
  EXPECT_EQ(hull.paint, Paint::red);
}

TEST(Params, AWrongUnitSuffixNamesTheRightOne) {
  EXPECT_EQ(refusal("length_cm", 5.0), "length_cm: unknown parameter; did you mean length_m?");
  EXPECT_EQ(refusal("length", 5.0), "length: unknown parameter; did you mean length_m?");
}

TEST(Params, ARefusalSaysWhatWasGivenAndWhatIsAccepted) {
  EXPECT_EQ(refusal("length_m", 11.0), "length_m: is 11; expected a number in [0.1, 10]");
  EXPECT_EQ(refusal("length_m", std::string("long")),
            "length_m: is \"long\"; expected a number in [0.1, 10]");
  EXPECT_EQ(refusal("length_m", std::nan("")), "length_m: is nan; expected a number in [0.1, 10]");
  EXPECT_EQ(refusal("ribs_count", 2.5), "ribs_count: is 2.5; expected a whole number in [1, 9]");
  EXPECT_EQ(refusal("afloat", 1.0), "afloat: is 1; expected true or false");
  EXPECT_EQ(refusal("paint", std::string("blue")), "paint: is \"blue\"; expected one of red, green");
}

TEST(Params, DescribeThemselves) {
  const std::vector<ParamInfo> infos = describe_params<Hull>();
  ASSERT_EQ(infos.size(), 4U);
  EXPECT_EQ(infos[0].unit, "m");
  EXPECT_EQ(infos[1].type, "integer");
  EXPECT_EQ(std::get<bool>(infos[2].value), true);
  EXPECT_THAT(infos[3].choices, testing::ElementsAre("red", "green"));
  EXPECT_EQ(std::get<std::string>(infos[3].value), "green");
}

TEST(Text, NumbersReadBackToTheSameBits) {
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, -2.5e17, 5e-324}) {
    EXPECT_EQ(std::get<double>(parse_value(number_text(value))), value);
  }
  EXPECT_EQ(std::get<bool>(parse_value("true")), true);
  EXPECT_EQ(std::get<std::string>(parse_value("5 m")), "5 m");
}

struct Rib {
  double at_m = 0.0;
  bool cracked = false;

  static consteval auto fields() {
    return std::tuple{field<&Rib::at_m>({0, 10}, "from the bow"), field<&Rib::cracked>("whether it holds")};
  }
};

struct Skeleton {
  std::vector<Rib> ribs{{1.0}, {2.0}, {3.0}};
  double keel_m = 5.0;

  static consteval auto fields() {
    return std::tuple{field<&Skeleton::ribs>("in order"), field<&Skeleton::keel_m>({0, 9}, "its length")};
  }
};

std::string skeleton_refusal(std::string_view name, const ParamValue& value) {
  Skeleton skeleton;
  return refusal_by([&] { set_param(skeleton, name, value); });
}

TEST(ListParams, AnItemOfTheDefaultCanBeChanged) {
  Skeleton skeleton;
  set_param(skeleton, "ribs[1].at_m", 7.0);
  set_param(skeleton, "ribs[2].cracked", true);
  EXPECT_EQ(skeleton.ribs[1].at_m, 7.0);
  EXPECT_TRUE(skeleton.ribs[2].cracked);
  EXPECT_EQ(skeleton.ribs[0].at_m, 1.0);
}

TEST(ListParams, ALengthReplacesTheDefault) {
  Skeleton skeleton;
  set_param(skeleton, "ribs", 2.0);
  ASSERT_EQ(skeleton.ribs.size(), 2U);
  EXPECT_EQ(skeleton.ribs[1].at_m, 0.0);
}

TEST(ListParams, ARefusalNamesTheItem) {
  EXPECT_EQ(skeleton_refusal("ribs[3].at_m", 1.0), "ribs[3].at_m: the list has 3 items");
  EXPECT_EQ(skeleton_refusal("ribs[0].at_m", 11.0), "ribs[0].at_m: is 11; expected a number in [0, 10]");
  EXPECT_EQ(skeleton_refusal("ribs[0].at_cm", 1.0), "ribs[0].at_cm: unknown parameter; did you mean at_m?");
  EXPECT_EQ(skeleton_refusal("ribs[x].at_m", 1.0), "ribs[x].at_m: expected ribs[index].parameter");
  EXPECT_EQ(skeleton_refusal("ribs[0]at_m", 1.0), "ribs[0]at_m: expected ribs[index].parameter");
  EXPECT_EQ(skeleton_refusal("ribs", 65.0), "ribs: is 65; expected a list of up to 64 items");
  EXPECT_EQ(skeleton_refusal("ribs", std::string("three")),
            "ribs: is \"three\"; expected a list of up to 64 items");
}

TEST(ListParams, AreDescribedWithTheirItems) {
  const std::vector<ParamInfo> infos = describe_params<Skeleton>();
  ASSERT_EQ(infos.size(), 2U);
  EXPECT_EQ(infos[0].type, "list");
  EXPECT_EQ(std::get<double>(infos[0].value), 3.0);
  ASSERT_EQ(infos[0].items.size(), 2U);
  EXPECT_EQ(infos[0].items[0].name, "at_m");
}

template <Reflected P>
std::string check_of(const P& params) {
  return refusal_by([&] { EXPECT_EQ(&checked_params(params), &params); });
}

TEST(ParamsMadeInCpp, AreHeldToTheirRanges) {
  EXPECT_EQ(check_of(Hull{}), "accepted");
  EXPECT_EQ(check_of(Hull{.length_m = 10.0, .ribs_count = 9}), "accepted");
  EXPECT_EQ(check_of(Hull{.length_m = 10.5}), "length_m: is 10.5; expected a number in [0.1, 10]");
  EXPECT_EQ(check_of(Hull{.length_m = -1.0}), "length_m: is -1; expected a number in [0.1, 10]");
  EXPECT_EQ(check_of(Hull{.length_m = std::nan("")}), "length_m: is nan; expected a number in [0.1, 10]");
  EXPECT_EQ(check_of(Hull{.ribs_count = 0}), "ribs_count: is 0; expected a whole number in [1, 9]");
  EXPECT_EQ(check_of(Hull{.afloat = false}), "accepted");
  EXPECT_EQ(check_of(Hull{.paint = static_cast<Paint>(2)}), "paint: is 2; expected one of red, green");
}

TEST(ParamsMadeInCpp, AreNamedWithTheirPlaceInAList) {
  EXPECT_EQ(check_of(Skeleton{}), "accepted");
  EXPECT_EQ(check_of(Skeleton{.ribs = {}}), "accepted");
  EXPECT_EQ(check_of(Skeleton{.ribs = {{1.0}, {11.0}}}), "ribs[1].at_m: is 11; expected a number in [0, 10]");
  EXPECT_EQ(check_of(Skeleton{.ribs = std::vector<Rib>(65)}),
            "ribs: is 65; expected a list of up to 64 items");
  EXPECT_EQ(check_of(Skeleton{.keel_m = -1.0}), "keel_m: is -1; expected a number in [0, 9]");
}

}  // namespace
}  // namespace fairway
