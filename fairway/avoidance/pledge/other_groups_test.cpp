// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/other_groups.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/pledge/testing/fleet.hpp"

namespace fairway::pledge {
namespace {

/// Vehicle 0 of nine hears vehicle 1, the first member of the other group, which goes by a plan of its own.
struct Hearer {
  Terms terms{.count = 9, .tubes = {.radius = 1.0, .told = 0.1}};
  OtherGroups others{0, terms};
  Member member = as_told(crossing({0, 0, 5}, {20, 0, 5}), terms.datum);
  Plan plan{.epoch = {100, 0}, .participants = 0b0001, .digest = digest_of({member}, 0b0001, terms.datum)};
  double sent{0.0};

  Header header(Status status, bool departed) const {
    return {.sender = 1, .epoch = plan.epoch, .sent = sent, .status = status, .departed = Members{departed}};
  }
  void hear(const Word& word) {
    others.hear(word, Speech{});
    sent += 1.0;
  }
};

TEST(OtherGroups, AWayIsKnownOnceItsPlanAndTheStatesThatThisWasMadeFromAre) {
  Hearer hearer;
  hearer.hear(StateWord{hearer.header(Status::held, false), hearer.member});
  EXPECT_TRUE(hearer.others.bystanders()[1].known);
  hearer.hear(StateWord{hearer.header(Status::moving, true), hearer.member});
  EXPECT_FALSE(hearer.others.bystanders()[1].known) << "it is not there any more";
  EXPECT_TRUE(hearer.others.passing().empty()) << "by which way nobody has said";
  hearer.hear(PlanWord{hearer.header(Status::moving, true), hearer.plan});
  ASSERT_EQ(hearer.others.passing().size(), 1U);
  EXPECT_EQ(hearer.others.passing()[0].vehicle, 1U);
  EXPECT_EQ(hearer.others.passing()[0].way.knots().front().position, hearer.member.anchor);

  hearer.hear(StateWord{hearer.header(Status::held, false), hearer.member});
  EXPECT_TRUE(hearer.others.passing().empty());
  EXPECT_TRUE(hearer.others.bystanders()[1].known);
}

TEST(OtherGroups, OfAPlanThatWasMadeFromOtherStatesNoWayIsKnown) {
  Hearer hearer;
  hearer.plan.digest ^= 1U;
  hearer.hear(StateWord{hearer.header(Status::moving, true), hearer.member});
  hearer.hear(PlanWord{hearer.header(Status::moving, true), hearer.plan});
  EXPECT_TRUE(hearer.others.passing().empty());
}

TEST(OtherGroups, WhoGoesByAnOlderPlanThanItSpeaksOfIsOnTheWayThatIsKnownIfItHasNotRestedSince) {
  Hearer hearer;
  hearer.hear(StateWord{hearer.header(Status::moving, true), hearer.member});
  hearer.hear(PlanWord{hearer.header(Status::moving, true), hearer.plan});
  ASSERT_EQ(hearer.others.passing().size(), 1U);
  hearer.plan.epoch.tenths += 100;
  hearer.hear(StateWord{hearer.header(Status::moving, false), hearer.member});
  EXPECT_EQ(hearer.others.passing().size(), 1U);
  ++hearer.member.version;
  hearer.hear(StateWord{hearer.header(Status::moving, false), hearer.member});
  EXPECT_TRUE(hearer.others.passing().empty());
  EXPECT_FALSE(hearer.others.bystanders()[1].known);
}

TEST(OtherGroups, AWayIsToldByEveryWordButOneAboutANewerPlan) {
  Hearer hearer;
  hearer.hear(StateWord{hearer.header(Status::moving, true), hearer.member});
  hearer.hear(PlanWord{hearer.header(Status::moving, true), hearer.plan});
  const auto hear_in_round = [&](std::uint8_t round, auto word) {
    word.header.round = round;
    word.header.sent = hearer.sent;
    for (std::uint8_t other = 3; other < 9; other += 2)
      hearer.others.hear(StateWord{{.sender = other, .round = round, .sent = hearer.sent}, hearer.member},
                         {});
    hearer.hear(word);
  };
  const PlanWord newer{hearer.header(Status::moving, false), {.epoch = {200, 0}, .participants = 0b0010}};
  // the others own round 1, and vehicle 0 round 2
  hearer.others.rounds.go_on();
  hear_in_round(1, newer);
  hearer.others.rounds.go_on();
  hear_in_round(2, newer);
  EXPECT_FALSE(hearer.others.may_depart()) << "it may have departed again in round 1";
  hear_in_round(2, StateWord{hearer.header(Status::moving, false), hearer.member});
  EXPECT_TRUE(hearer.others.may_depart());
}

TEST(OtherGroups, NobodyDepartsBeforeAllOthersAreAtAPlaceOrOnAWayThatIsKnown) {
  Hearer hearer;
  const auto all_but_one_rest = [&] {
    for (const std::uint8_t vehicle : {std::uint8_t{3}, std::uint8_t{5}, std::uint8_t{7}})
      hearer.others.hear(StateWord{{.sender = vehicle, .sent = hearer.sent}, hearer.member}, Speech{});
  };
  all_but_one_rest();
  EXPECT_FALSE(hearer.others.may_depart());
  hearer.hear(StateWord{hearer.header(Status::moving, true), hearer.member});
  EXPECT_FALSE(hearer.others.may_depart());
  hearer.hear(PlanWord{hearer.header(Status::moving, true), hearer.plan});
  EXPECT_TRUE(hearer.others.may_depart());
  ++hearer.member.version;
  hearer.plan.epoch.tenths += 100;
  hearer.hear(StateWord{hearer.header(Status::moving, false), hearer.member});
  EXPECT_FALSE(hearer.others.may_depart());
}

}  // namespace
}  // namespace fairway::pledge
