// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/envelope.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/avoidance/trackable/foresight.hpp"
#include "fairway/control/craft.hpp"
#include "fairway/control/vehicle_limits.hpp"
#include "fairway/core/envelope_numbers.hpp"
#include "fairway/dynamics/catalog.hpp"

namespace fairway {
namespace {

constexpr double envelope_step = 0.05;

Envelope envelope_of(const char* name, const Limits& mission = {}, const ParamValues& params = {}) {
  const Vehicle vehicle = builtin_vehicles().make(name, params);
  return *measured_envelope(vehicle, Autopilot{vehicle}, narrowed(mission, vehicle), envelope_step);
}

Craft craft_of(const char* name) {
  const Vehicle vehicle = builtin_vehicles().make(name);
  return {vehicle, Autopilot{vehicle}, envelope_step};
}

/// Every vehicle that an autopilot drives.
class EveryEnvelope : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Vehicles, EveryEnvelope,
                         ::testing::Values("zarco", "otter_by_thrust", "sparus2", "kinematic", "remus100",
                                           "minerva", "minerva_transport"));

TEST_P(EveryEnvelope, IsTheSameEachTime) { EXPECT_EQ(envelope_of(GetParam()), envelope_of(GetParam())); }

TEST_P(EveryEnvelope, StaysWithinTheLimitsOfTheMission) {
  const Envelope full = envelope_of(GetParam());
  const Limits half{.max_speed = 0.6 * full.ahead, .max_turn_rate = 0.5 * full.turn_rate(0.6 * full.ahead)};
  const Envelope held = envelope_of(GetParam(), half);
  EXPECT_LE(held.ahead, half.max_speed);
  EXPECT_GT(held.ahead, 0.95 * half.max_speed);
  for (const double rate : held.turn_rates) EXPECT_LE(rate, half.max_turn_rate);
}

TEST_P(EveryEnvelope, PromisesNoTurnRateThatTheVehicleDoesNotReachBetweenTheSpeedsOfItsTable) {
  const Vehicle fresh = builtin_vehicles().make(GetParam());
  for (const double most : {0.6, 1.0}) {
    const Limits mission{.max_speed = most * envelope_of(GetParam()).ahead};
    const Envelope envelope = envelope_of(GetParam(), mission);
    for (const double share : {0.4, 0.6, 0.8, 0.9, 0.98}) {
      const double speed = share * envelope.ahead;
      if (speed < envelope.least) continue;
      Vehicle vehicle = fresh;
      Autopilot autopilot{vehicle};
      for (int k = 0; k < 2400; ++k) {
        const BodyRequest turn{.surge_mps = speed,
                               .yaw_rate_radps = k < 1200 ? 0.0 : envelope.turn_rate(speed)};
        const VehicleState& x = vehicle.state();
        vehicle.step(autopilot.control(turn, x.v_b, x.omega_b, envelope_step, x.q_nb), Water{},
                     envelope_step);
      }
      EXPECT_GE(vehicle.state().omega_b.z(), 0.95 * envelope.turn_rate(speed))
          << speed << " of " << envelope.ahead;
    }
  }
}

TEST_P(EveryEnvelope, BoundsTheErrorOfFollowingACourseThatNoTrialHad) {
  const Vehicle fresh = builtin_vehicles().make(GetParam());
  const Limits limits = narrowed({}, fresh);
  const Envelope envelope = envelope_of(GetParam());
  EXPECT_EQ(why_unusable(envelope), "");
  const trackable::TurnLaw law{envelope, limits.max_turn_rate};
  for (const double change : {0.3, -0.8, 1.3, -1.9, 2.4}) {
    for (const double share : {0.6, 0.9}) {
      const double speed = std::max(share * envelope.ahead, envelope.least);
      Craft craft{fresh, Autopilot{fresh}, envelope_step};
      for (int k = 0; k < 1200; ++k) craft.obey({.surge_mps = speed});
      const Vec3 from = craft.vehicle.state().p_n;
      const Vec3 velocity{speed * std::cos(change), speed * std::sin(change), 0.0};
      double greatest = 0.0;
      for (int k = 1; k * envelope_step < 60.0; ++k) {
        const trackable::TurnOrder order = law.order(speed, wrap_angle(change - craft.yaw()), craft.surge());
        craft.obey({.surge_mps = order.surge, .yaw_rate_radps = order.turn_rate});
        if (std::abs(wrap_angle(change - craft.yaw())) < 0.02) break;
        const Vec3 error = craft.vehicle.state().p_n - from - k * envelope_step * velocity;
        greatest = std::max(greatest, horizontal_norm(error));
      }
      EXPECT_LE(greatest, envelope.following_error(change)) << change << " at " << speed;
    }
  }
}

TEST(Envelope, OfAKinematicVehicleIsItsParameters) {
  const Envelope envelope = envelope_of("kinematic");
  EXPECT_NEAR(envelope.ahead, 0.5, 1e-3);
  EXPECT_NEAR(envelope.astern, 0.5, 1e-3);
  EXPECT_EQ(envelope.sideways, 0.0);
  EXPECT_NEAR(envelope.down, 0.5, 1e-3);
  EXPECT_NEAR(envelope.turn_rate(0.3), 0.45, 1e-3);
  EXPECT_NEAR(envelope.turn_acceleration, 0.5, 0.01);
  EXPECT_NEAR(envelope.turn_lag, 0.2, 0.051);  // one step of the trial
  EXPECT_NEAR(envelope.pivot, 0.0, 1e-9);
  EXPECT_NEAR(envelope_of("kinematic", {}, {{"max_sway_mps", 0.2}}).sideways, 0.2, 1e-3);
}

TEST(Envelope, OfZarcoGoesAsFastAsItsThrustersPush) {
  const Envelope envelope = envelope_of("zarco");
  EXPECT_NEAR(envelope.ahead, 1.898, 0.01);  // 20 u + 20 u^2 = 110 N
  EXPECT_GT(envelope.pivot, 0.1);            // it slips outwards in a turn
  EXPECT_EQ(envelope.sideways, 0.0);
  EXPECT_EQ(envelope.down, 0.0);
}

TEST(Envelope, OfABodyWithFinsHasALeastSpeedAndNoWayAstern) {
  const Envelope envelope = envelope_of("remus100");
  EXPECT_NEAR(envelope.least, 0.96, 0.01);
  EXPECT_EQ(envelope.astern, 0.0);
  EXPECT_GT(envelope.turn_rate(envelope.ahead), 2.0 * envelope.turn_rate(envelope.least));
}

TEST(Envelope, TellsHowMuchOfTheBrakingATurnTakes) {
  // both are by the same two thrusters, and the turn is served first; a kinematic vehicle has a setpoint each
  const Envelope sparus = envelope_of("sparus2", {.max_speed = 0.5});
  EXPECT_GT(sparus.deceleration_lost, 0.6 * sparus.deceleration);
  EXPECT_LE(sparus.deceleration_lost, sparus.deceleration);
  const Envelope kinematic = envelope_of("kinematic");
  EXPECT_LT(kinematic.deceleration_lost, 0.02 * kinematic.deceleration);
}

/// How far a vehicle that goes north gets while it is told to stop with its bow to the east, and
/// how far it is foreseen to get. [m]
struct Stop {
  double way;
  double foreseen;
};

Stop stop_of(const char* name, double speed, const Envelope& envelope) {
  constexpr double window = 8.0;
  Craft craft = craft_of(name);
  const Vehicle& vehicle = craft.vehicle;
  for (int k = 0; k < 2000; ++k) craft.obey({.surge_mps = speed});
  const trackable::TurnLaw law{envelope, Limits::none};
  const trackable::Plan east{.direction = Vec2::UnitY()};
  const Vec3 from = vehicle.state().p_n;
  Stop stop{};
  for (int k = 0; k * envelope_step < window; ++k) {
    const VehicleState& x = vehicle.state();
    encounters::OwnedSituation e = encounters::open_water();
    e.situation.own.velocity = x.v_n();
    e.situation.own.yaw = yaw_of(x.q_nb);
    e.situation.own.yaw_rate = x.omega_b.z();
    const trackable::Foresight foresight{
        law, e.situation, unit_at(e.situation.own.yaw), {.hold = 0.8, .window = window}};
    if (k == 0) {
      const auto path = foresight.path(east);
      stop.foreseen = path.points[path.count - 1].norm();
    }
    const trackable::TurnOrder order = foresight.order(east);
    craft.obey({.surge_mps = order.surge, .yaw_rate_radps = order.turn_rate});
  }
  stop.way = (vehicle.state().p_n - from).norm();
  return stop;
}

TEST(Envelope, WhoTurnsAndBrakesByTheSameThrustersStopsOnTheWayThatIsForeseen) {
  Envelope envelope = envelope_of("sparus2", {.max_speed = 0.5});
  const Stop brakes_first = stop_of("sparus2", 0.43, envelope);
  EXPECT_LT(brakes_first.way, brakes_first.foreseen);
  EXPECT_GT(brakes_first.way, brakes_first.foreseen - 0.3);
  envelope.deceleration_lost = 0.0;  // as if the turn took nothing: it turns at once
  const Stop turns_at_once = stop_of("sparus2", 0.43, envelope);
  EXPECT_GT(turns_at_once.way, brakes_first.way + 0.3);  // more than the usual margin
  EXPECT_GT(turns_at_once.way, turns_at_once.foreseen + 0.1);
}

TEST(Envelope, ZarcoBrakesBeforeItTurns) {
  Envelope envelope = envelope_of("zarco", {.max_speed = 1.5});
  const Stop brakes_first = stop_of("zarco", 0.75, envelope);
  EXPECT_LT(brakes_first.way, brakes_first.foreseen + 0.3);  // the usual margin
  envelope.deceleration_lost = 0.4 * envelope.deceleration;  // as if the turn took less: it turns at once
  const Stop turns_at_once = stop_of("zarco", 0.75, envelope);
  EXPECT_GT(turns_at_once.way, brakes_first.way + 0.3);
  EXPECT_GT(turns_at_once.way, turns_at_once.foreseen + 0.3);
}

TEST(Envelope, TellsHowMuchFartherAStopGoesThanItForesees) {
  EXPECT_LT(envelope_of("kinematic").foresight_error, 0.05);
  const Envelope slow = envelope_of("sparus2", {.max_speed = 0.5});
  const Envelope fast = envelope_of("sparus2");  // 3.2 m/s
  EXPECT_LT(slow.foresight_error, 0.5);
  EXPECT_GT(fast.foresight_error, 0.5);
  EXPECT_LT(fast.foresight_error, 0.8);
}

TEST(Envelope, OfWhoCannotStopTellsHowFarFromWhatItForeseesATurnBegins) {
  const double slow = envelope_of("remus100", {.max_speed = 1.5}).foresight_error;
  EXPECT_GT(slow, 0.5);
  EXPECT_LT(slow, 0.8);
  EXPECT_GT(envelope_of("remus100").foresight_error, 2.0 * slow);  // 2.5 m/s
}

/// Sideways to starboard in a steady turn [m/s].
double sway_of(const char* name, const BodyRequest& turn) {
  Craft craft = craft_of(name);
  for (int k = 0; k < 1600; ++k) craft.obey(turn);
  return craft.sway();
}

TEST(Envelope, TellsHowAHullSlipsInSlowTurnsAndFastOnesWideAndTight) {
  const auto foreseen = [](const Envelope& envelope, const BodyRequest& turn) {
    return envelope.steady_sway(turn.surge_mps, turn.yaw_rate_radps);
  };
  const BodyRequest turns[]{{.surge_mps = 0.25, .yaw_rate_radps = 0.2},
                            {.surge_mps = 0.8, .yaw_rate_radps = -0.1},
                            {.surge_mps = 0.8, .yaw_rate_radps = -0.5},
                            {.surge_mps = 1.2, .yaw_rate_radps = 0.2}};
  for (const char* name : {"sparus2", "zarco"}) {
    const Envelope envelope = envelope_of(name);
    for (const BodyRequest& turn : turns) {
      const double sway = sway_of(name, turn);
      EXPECT_NEAR(foreseen(envelope, turn), sway, 0.05 * std::abs(sway)) << name << turn.surge_mps;
    }
  }
  Envelope in_proportion = envelope_of("sparus2");
  in_proportion.slip_square = 0.0;
  EXPECT_LT(std::abs(foreseen(in_proportion, turns[0])), 0.3 * std::abs(sway_of("sparus2", turns[0])));
}

TEST(Envelope, ASlipDiesAwayByWhatResistsIt) {
  Envelope envelope{.ahead = 2.0, .pivot = 0.5, .sway_lag = 1.5, .turn_rates = {0.4, 0.4, 0.4, 0.4}};
  const auto left = [&](double time) {  // of the slip in the tightest turn at the greatest speed
    constexpr double step = 1e-3;
    const Slip slip = envelope.slip(step);
    double sway = envelope.steady_sway(2.0, 0.4);
    for (int k = 0; k * step < time; ++k) sway = slip.after(sway, 2.0, 0.0);
    return sway / -0.2;
  };
  EXPECT_NEAR(left(3.0), std::exp(-3.0 / 1.5), 1e-3);
  envelope.slip_square = 1.0;
  EXPECT_NEAR(left(3.0), 1.0 / (1.0 + 3.0 / 1.5), 1e-3);
  EXPECT_NEAR(envelope.steady_sway(0.5, 0.4), 0.5 * envelope.steady_sway(2.0, 0.4), 1e-12);
  EXPECT_EQ(envelope.steady_sway(0.5, 0.0), 0.0);
}

/// How much farther ahead remus100, which has a least speed, gets than foreseen, on half a circle as tight as
/// it goes at its least speed, of which it has `turned` for so long [s] already. [m]
double wider_than_foreseen(const Envelope& envelope, double turned) {
  Craft craft = craft_of("remus100");
  Vehicle& vehicle = craft.vehicle;
  VehicleState under_way;
  under_way.v_b.x() = envelope.least;
  vehicle.set_state(under_way);
  for (int k = 0; k < 2000; ++k) craft.obey({.surge_mps = envelope.least});
  const trackable::TurnLaw law{envelope, Limits::none};
  const double rate = law.greatest_turn_rate(envelope.least);
  for (double t = 0.0; t < turned; t += envelope_step)
    craft.obey({.surge_mps = envelope.least, .yaw_rate_radps = rate});
  encounters::OwnedSituation e = encounters::open_water();
  e.situation.own.velocity = vehicle.state().v_n();
  e.situation.own.yaw = yaw_of(vehicle.state().q_nb);
  e.situation.own.yaw_rate = vehicle.state().omega_b.z();
  const Vec2 ahead = unit_at(e.situation.own.yaw);
  const trackable::Foresight foresight{
      law, e.situation, unit_at(e.situation.own.yaw), {.hold = 0.8, .window = pi / rate}};
  const auto path = foresight.path({.speed = envelope.least, .turn_rate = rate});
  const Vec3 from = vehicle.state().p_n;
  double greatest = 0.0, time = 0.0;
  for (std::size_t i = 0; i < path.count; ++i) {
    for (; time < static_cast<double>(i + 1) * foresight.step(); time += envelope_step)
      craft.obey({.surge_mps = envelope.least, .yaw_rate_radps = rate});
    greatest = std::max(greatest, ahead.dot((vehicle.state().p_n - from).head<2>() - path.points[i]));
  }
  return greatest;
}

TEST(Envelope, ABodyWithFinsTurnsNoWiderThanIsForeseen) {
  const Envelope envelope = envelope_of("remus100", {.max_speed = 1.5});
  Envelope at_once = envelope, evenly = envelope, in_proportion = envelope;
  at_once.turn_tail = 0.0;    // as if it came to its turn rate by the lag alone
  evenly.turn_plateau = 1.0;  // as if it came to all of it alike, so that half is made in the first seconds
  in_proportion.slip_square = 0.0;  // as if it slipped in proportion to its speed
  for (const double turned : {0.0, 6.0, 12.0})
    EXPECT_LT(wider_than_foreseen(envelope, turned), 0.05) << turned;
  EXPECT_GT(wider_than_foreseen(at_once, 0.0), 0.3);  // more than the usual margin
  EXPECT_GT(wider_than_foreseen(evenly, 6.0), 0.3);
  EXPECT_GT(wider_than_foreseen(in_proportion, 6.0), 0.3);
}

TEST(Envelope, OfWhatIsNotANumberNothingIsKnown) {
  const Envelope envelope{.ahead = 1.0};
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(envelope.turn_rate(unknown)));
  EXPECT_TRUE(std::isnan(envelope.following_error(unknown)));
}

TEST(Envelope, OfWhatDoesNotGetUnderWayIsNone) {
  const Vehicle vehicle = builtin_vehicles().make("kinematic", {{"max_speed_mps", 0.0}});
  EXPECT_FALSE(measured_envelope(vehicle, Autopilot{vehicle}, narrowed({}, vehicle), envelope_step));
}

}  // namespace
}  // namespace fairway
