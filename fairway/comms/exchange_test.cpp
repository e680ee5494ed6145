// SPDX-License-Identifier: Apache-2.0
#include "fairway/comms/exchange.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

Mailbox two_vehicles() { return {{.from = VehicleId{0}}, {.from = VehicleId{1}}}; }

TEST(Exchange, PerfectHandsEverythingToEveryoneAtOnce) {
  Exchange exchange{"perfect", {}, 2, 0.05, Rng{1}};
  Mailbox said = two_vehicles();
  said[1].position = {1, 2, 3};
  said[1].sent = Tick{7};
  exchange.pass_on(Tick{7}, said, std::vector<Vec3>(2));
  ASSERT_EQ(exchange.heard_by(0, said).size(), 2U);
  EXPECT_EQ(exchange.heard_by(0, said)[1].position, Vec3(1, 2, 3));
  EXPECT_EQ(exchange.heard_by(0, said)[1].sent, Tick{7});
}

TEST(Exchange, NoneCarriesNothing) {
  Exchange exchange{"none", {}, 2, 0.05, Rng{1}};
  const Mailbox said = two_vehicles();
  exchange.pass_on(Tick{0}, said, std::vector<Vec3>(2));
  EXPECT_TRUE(exchange.heard_by(0, said).empty());
  EXPECT_FALSE(exchange.carries_anything());
}

TEST(Exchange, AnUnknownKindIsRefusedWithTheNearest) {
  EXPECT_THROW((Exchange{"perfekt", {}, 2, 0.05, Rng{1}}), InputError);
  EXPECT_THROW((Exchange{"none", {{"range_m", 3.0}}, 2, 0.05, Rng{1}}), InputError);
}

TEST(Exchange, AcousticSaysHowMuchIsUnforeseen) {
  const Exchange exchange{"acoustic", {{"unforeseen_acceleration_mps2", 0.3}}, 2, 0.05, Rng{1}};
  EXPECT_EQ(exchange.unforeseen_acceleration(), 0.3);
  EXPECT_TRUE(exchange.carries_anything());
  EXPECT_EQ((Exchange{"perfect", {}, 2, 0.05, Rng{1}}).unforeseen_acceleration(), 0.0);
}

TEST(Exchange, EveryKindThatIsListedCanBeMade) {
  for (const KindInfo& kind : exchange_kinds()) {
    ParamValues values;
    for (const ParamInfo& param : kind.params) values.emplace_back(param.name, param.value);
    EXPECT_NO_THROW((Exchange{kind.name, values, 2, 0.05, Rng{1}})) << kind.name;
  }
}

}  // namespace
}  // namespace fairway
