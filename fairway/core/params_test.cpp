// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/params.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
  try {
    set_param(hull, name, value);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
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

}  // namespace
}  // namespace fairway
