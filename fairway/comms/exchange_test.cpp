// SPDX-License-Identifier: Apache-2.0
#include "fairway/comms/exchange.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

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

TEST(Exchange, SaysWhenEachHasItsNextTurnAndHowLongThatMayTake) {
  constexpr double period = 0.05;
  constexpr std::size_t count = 4;
  for (const bool slots : {true, false}) {
    Exchange exchange{"acoustic", {{"update_rate_hz", 0.3}, {"slots", slots}}, count, period, Rng{1}};
    Mailbox said;
    for (std::uint32_t i = 0; i < count; ++i) said.push_back({.from = VehicleId{i}});
    std::array<double, count> told{}, last{};
    std::array<int, count> turns{};
    double longest = 0.0;  // between two turns
    std::vector<MessageFlight> flights;
    for (std::int64_t tick = 0; tick < 1000; ++tick) {
      for (Message& message : said) message.sent = Tick{tick};
      exchange.pass_on(Tick{tick}, said, std::vector<Vec3>(count, Vec3::Zero()));
      flights.clear();
      exchange.add_under_way(flights);
      for (std::size_t i = 0; i < count; ++i) {
        const double now = seconds(Tick{tick}, period);
        const bool speaks = std::ranges::any_of(
            flights, [&](const MessageFlight& f) { return f.from == i && std::abs(f.sent - now) < 1e-9; });
        if (speaks && turns[i]++ > 0) {
          EXPECT_NEAR(now, told[i], 1e-9) << i;
          longest = std::max(longest, now - last[i]);
        }
        if (speaks) last[i] = now;
        told[i] = slots ? exchange.next_turn(i, Tick{tick})
                        : period * std::ceil(exchange.next_turn(i, Tick{tick}) / period - 1e-9);
      }
    }
    for (const int n : turns) EXPECT_GT(n, 10);
    EXPECT_NEAR(longest, exchange.turn_period(), slots ? 1e-9 : period);
  }
  EXPECT_EQ((Exchange{"perfect", {}, 2, period, Rng{1}}).turn_period(), period);
  EXPECT_NEAR((Exchange{"perfect", {}, 2, period, Rng{1}}).next_turn(1, Tick{4}), 5 * period, 1e-12);
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
