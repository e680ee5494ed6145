// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/envelope.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/avoidance/trackable/turn_law.hpp"
#include "fairway/control/craft.hpp"
#include "fairway/control/foresight_error.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

constexpr double beyond_any = 100.0;      // [m/s], [rad/s]: as much as it has
constexpr double steady_error = 0.02;     // of the speed, when a velocity is followed
constexpr double soon = 0.2;              // before a hull pushed aside has turned [s]
constexpr double least_linear = 1e-6;     // share of what resists a slip
constexpr double small_change = 0.1;      // of a speed or turn rate, for a lag
constexpr double reached = 0.632;         // 1 - 1 / e
constexpr double least_way = 1e-3;        // slower is no way [m/s]
constexpr double cruise_share = 0.9;      // of the greatest speed, so that something is left to turn by
constexpr double slow_share = 0.4;        // likewise, of a slow turn
constexpr double wide_share = 0.25;       // of the greatest turn rate, of a wide turn
constexpr double stopped_share = 0.05;    // of the speed from which it stops
constexpr double read_allowance = 1.02;   // of a turn rate that is read from the table
constexpr double lags_of_plateau = 3.0;   // after which what is left of a turn rate is its tail
constexpr double least_tail_share = 0.5;  // of the lag of a turn: a shorter tail is none
constexpr double error_allowance = 1.1;   // for what the trials do not show: steps, other speeds before

double surge_of(const Craft& craft) { return craft.surge(); }
double turn_rate_of(const Craft& craft) { return craft.turn_rate(); }

class Trials {
 public:
  Trials(const Vehicle& vehicle, const Autopilot& autopilot, const Limits& limits, double step)
      : at_rest_{vehicle, autopilot, step},
        limits_{limits},
        most_{limit_or(limits.max_speed, beyond_any)},
        turn_{limit_or(limits.max_turn_rate, beyond_any)} {
    VehicleState x;
    x.v_b.x() = std::min(limits.min_speed, most_);
    at_rest_.vehicle.set_state(x);
  }

  std::optional<Envelope> envelope() {
    envelope_.least = limits_.min_speed;
    under_way_ = at_rest_;
    envelope_.ahead = std::min(most_, under_way_->settle({.surge_mps = most_}, surge_of));
    if (!(envelope_.ahead > least_way)) return {};
    measure_speeds();
    measure_changes_of_speed();
    measure_turns();
    measure_stop_in_a_turn();
    measure_following();
    envelope_.foresight_error = foresight_error(*under_way_, envelope_, turn_);
    return envelope_;
  }

 private:
  BodyRequest cruise() const { return {.surge_mps = envelope_.ahead}; }
  double cruise_speed() const { return std::max(cruise_share * envelope_.ahead, envelope_.least); }

  /// The greatest steady value, none that goes the other way.
  template <class Value>
  double greatest(Craft craft, const BodyRequest& request, Value value) const {
    return std::max(0.0, craft.settle(request, value));
  }

  void measure_speeds() {
    if (limits_.sternway)
      envelope_.astern = greatest(at_rest_, {.surge_mps = -most_}, [](const Craft& c) { return -c.surge(); });
    if (limits_.sway)
      envelope_.sideways = greatest(at_rest_, {.sway_mps = most_}, [](const Craft& c) { return c.sway(); });
    const double climb = limit_or(limits_.max_climb_rate, most_);
    envelope_.down = climb_rate(climb);
    envelope_.up = climb_rate(-climb);
  }

  /// While going ahead at nine tenths of the greatest speed, beyond what it does unasked.
  double climb_rate(double wanted) const {
    const auto sinking = [](const Craft& c) { return c.sinking(); };
    const auto asked = [&](double heave) {
      return BodyRequest{.surge_mps = cruise_speed(), .heave_mps = heave};
    };
    Craft climbing = *under_way_, level = *under_way_;
    const double rate = std::abs(climbing.settle(asked(wanted), sinking) - level.settle(asked(0.0), sinking));
    return rate < least_way ? 0.0 : std::min(rate, std::abs(wanted));
  }

  void measure_changes_of_speed() {
    const double top = envelope_.ahead, least = std::min(envelope_.least, 0.9 * top);
    Craft starting = at_rest_;
    const double time = starting.time_to(cruise(), surge_of, 0.8 * top);
    envelope_.acceleration = std::max(0.8 * top - least, 0.0) / std::max(time, starting.step);

    Craft stopping = *under_way_;
    const Vec2 from = stopping.place();
    stopping.time_to({.surge_mps = envelope_.least}, surge_of, slow());
    envelope_.deceleration = deceleration_over((stopping.place() - from).norm());

    Craft slower = *under_way_;
    const double lower = (1.0 - small_change) * top;
    envelope_.surge_lag = slower.time_to({.surge_mps = lower}, surge_of, top + reached * (lower - top));
    if (envelope_.acceleration <= 0.0) envelope_.acceleration = envelope_.deceleration;
  }

  /// So slow is stopped.
  double slow() const { return std::max(1.05 * envelope_.least, stopped_share * envelope_.ahead); }

  /// Of who has stopped from its greatest speed on a `way` [m].
  double deceleration_over(double way) const {
    const double top = envelope_.ahead, end = slow();
    return std::max(top * top - end * end, 0.0) / (2.0 * std::max(way, least_way));
  }

  void measure_turns() {
    constexpr auto last = Envelope::turn_rate_count - 1;
    std::array<double, Envelope::turn_rate_count>& rates = envelope_.turn_rates;
    const double apart = envelope_.ahead / last;
    rates[0] = greatest_turn_rate(envelope_.least);
    for (std::size_t i = 1; i <= last; ++i) {
      rates[i] = greatest_turn_rate(static_cast<double>(i) * apart);
      for (const double part : {0.25, 0.5, 0.75}) lower(i, part, apart);
    }
    measure_turning();
  }

  /// Lowers a turn rate of the table until what is read between it and the one before is none that the
  /// vehicle does not reach there: a hull with fins turns far better above some speed.
  void lower(std::size_t i, double part, double apart) {
    const double before = envelope_.turn_rates[i - 1], speed = (static_cast<double>(i - 1) + part) * apart;
    if (speed < envelope_.least) return;
    double& rate = envelope_.turn_rates[i];
    const double measured = greatest_turn_rate(speed);
    if (before + part * (rate - before) > read_allowance * measured)
      rate = std::max(0.0, before + (measured - before) / part);
  }

  /// To the side to which it is the smaller.
  double greatest_turn_rate(double speed) const {
    Craft to_starboard = *under_way_;
    to_starboard.settle({.surge_mps = speed}, surge_of);
    Craft to_port = to_starboard;
    const double starboard = to_starboard.settle({.surge_mps = speed, .yaw_rate_radps = turn_}, turn_rate_of);
    const double port = -to_port.settle({.surge_mps = speed, .yaw_rate_radps = -turn_}, turn_rate_of);
    return std::clamp(std::min(starboard, port), 0.0, turn_);
  }

  /// What it makes of a turn at its greatest speed.
  void measure_turning() {
    const double rate = envelope_.turn_rates.back();
    Craft craft = *under_way_;
    craft.settle(cruise(), surge_of);
    measure_turn_lag(craft, rate);
    measure_turn_tail(craft, envelope_.ahead, cruise_share * rate);
    if (envelope_.least > 0.0) measure_slow_turn_tail();
    measure_slip();
    measure_sway_lag(craft);
  }

  void measure_slow_turn_tail() {
    Craft craft = *under_way_;
    craft.settle({.surge_mps = envelope_.least}, surge_of);
    const BodyRequest turn{.surge_mps = envelope_.least,
                           .yaw_rate_radps = cruise_share * envelope_.turn_rates[0]};
    measure_turn_tail(craft, turn.surge_mps, turn.yaw_rate_radps);
  }

  /// In steady turns: v (a + b |v|) = u r. Met are a slow one as tight as the law orders and, of a wide slow
  /// one and a tight fast one, that by which it slips more where both cannot be.
  void measure_slip() {
    const SteadyTurn tight = steady_turn(slow_share, cruise_share);
    const double rate = envelope_.turn_rates.back();
    if (!(tight.slip > least_way && rate > 0.0)) return;
    double b = tight.resisted / tight.slip;
    for (const SteadyTurn& other :
         {steady_turn(slow_share, wide_share), steady_turn(cruise_share, cruise_share)}) {
      const double apart = other.slip - tight.slip;
      if (std::abs(apart) > least_way) b = std::min(b, (other.resisted - tight.resisted) / apart);
    }
    b = std::max(b, 0.0);
    const double a = tight.resisted - b * tight.slip, asked = envelope_.ahead * rate;
    const double slip = 2.0 * asked / (a + std::sqrt(a * a + 4.0 * b * asked));
    envelope_.pivot = slip / rate;
    envelope_.slip_square = b * slip / (a + b * slip);
  }

  struct SteadyTurn {
    double slip;      ///< outwards [m/s]
    double resisted;  ///< speed times turn rate, by the slip [1/s]
  };
  /// At shares of the greatest speed and of the greatest turn rate there.
  SteadyTurn steady_turn(double speed_share, double turn_share) const {
    const double speed = std::max(speed_share * envelope_.ahead, envelope_.least);
    const double rate = turn_share * std::min(envelope_.turn_rate(speed), turn_);
    const BodyRequest turn{.surge_mps = speed, .yaw_rate_radps = rate};
    Craft craft = *under_way_;
    craft.settle({.surge_mps = speed}, surge_of);
    craft.settle(turn, turn_rate_of);
    const double slip = -craft.settle(turn, [](const Craft& c) { return c.sway(); });
    return {slip, craft.surge() * craft.turn_rate() / std::max(slip, least_way)};
  }

  void measure_turn_lag(const Craft& steady, double rate) {
    Craft craft = steady;
    const double small = small_change * rate;
    envelope_.turn_lag =
        craft.time_to({.surge_mps = envelope_.ahead, .yaw_rate_radps = small}, turn_rate_of, reached * small);
    craft = steady;
    const int window = std::max(1, static_cast<int>(0.2 / craft.step));
    double before = 0.0;
    for (int k = 1; k * craft.step < std::max(10.0, 5.0 * envelope_.turn_lag); ++k) {
      craft.obey({.surge_mps = envelope_.ahead, .yaw_rate_radps = rate});
      if (k % window != 0) continue;
      const double now = craft.turn_rate();
      envelope_.turn_acceleration =
          std::max(envelope_.turn_acceleration, (now - before) / (window * craft.step));
      before = now;
    }
  }

  /// What heading a turn lacks in the end, beyond that of the lag and of the turn acceleration, by its rate,
  /// and to what share of the rate it comes by these two. Of an autopilot that comes to the rate only as it
  /// learns what that takes.
  void measure_turn_tail(Craft craft, double speed, double rate) {
    if (!(rate > 0.0 && envelope_.turn_acceleration > 0.0)) return;
    const double takes_up = rate / envelope_.turn_acceleration;
    double lacks = 0.0, time = 0.0, plateau = 1.0;
    while (time < Craft::longest) {
      craft.obey({.surge_mps = speed, .yaw_rate_radps = rate});
      if (time < lags_of_plateau * envelope_.turn_lag + takes_up)
        plateau = std::min(1.0, craft.turn_rate() / rate);
      lacks += craft.step * (1.0 - craft.turn_rate() / rate);
      time += craft.step;
    }
    const double tail = lacks - envelope_.turn_lag - 0.5 * takes_up;
    if (!(tail > least_tail_share * envelope_.turn_lag)) return;
    envelope_.turn_tail = std::max(envelope_.turn_tail, tail);
    envelope_.turn_plateau = std::min(envelope_.turn_plateau, plateau);
  }

  /// Told at half of its greatest speed to stop, and to turn as fast as the law ever orders until that is
  /// nearly so: by what share it brakes less than without the turn, of the side on which that is more.
  void measure_stop_in_a_turn() {
    const double rate = trackable::TurnLaw{envelope_, turn_}.law().top_turn_rate;
    const double speed = std::max(0.5 * envelope_.ahead, envelope_.least);
    Craft steady = *under_way_;
    steady.settle({.surge_mps = speed}, surge_of);
    const double begins = steady.surge();
    for (const double side : {1.0, -1.0}) {
      Craft turning = steady, straight = steady;
      const auto takes_up = [&](const Craft& craft) { return side * craft.turn_rate(); };
      const double time = turning.time_to({.surge_mps = envelope_.least, .yaw_rate_radps = side * rate},
                                          takes_up, reached * rate);
      double passed = 0.0;
      while (passed < time) {
        straight.obey({.surge_mps = envelope_.least});
        passed += straight.step;
      }
      const double slower = begins - straight.surge(), in_turn = begins - turning.surge();
      if (!(slower > least_way)) continue;
      const double lost = envelope_.deceleration * std::clamp(1.0 - in_turn / slower, 0.0, 1.0);
      envelope_.deceleration_lost = std::max(envelope_.deceleration_lost, lost);
    }
  }

  /// Pushed sideways at once, as it slips in its fastest turn, and left to itself.
  void measure_sway_lag(Craft craft) {
    VehicleState x = craft.vehicle.state();
    const double push =
        envelope_.pivot > 0.0 ? envelope_.pivot * envelope_.turn_rates.back() : 0.5 * envelope_.ahead;
    x.v_b.y() += push;
    craft.vehicle.set_state(x);
    double time = 0.0;
    while (time < soon) {
      craft.obey({.surge_mps = envelope_.ahead});
      time += craft.step;
    }
    const double left = std::clamp(craft.sway() / push, 1e-3, 0.999);
    const double square = envelope_.slip_square, linear = 1.0 - square;
    const double lags =
        linear > least_linear ? math::log((linear + square * left) / left) / linear : 1.0 / left - 1.0;
    envelope_.sway_lag = time / lags;
  }

  void measure_following() {
    for (std::size_t i = 0; i < Envelope::change_count; ++i) {
      const double change = static_cast<double>(i + 1) * pi / Envelope::change_count;
      envelope_.following_errors[i] = error_allowance * std::max(error_of(change), error_of(-change));
    }
  }

  /// The greatest distance from a point that has turned by `change` [rad] at once.
  double error_of(double change) const {
    const trackable::TurnLaw law{envelope_, turn_};
    const double speed = cruise_speed();
    Craft craft = *under_way_;
    craft.settle({.surge_mps = speed}, surge_of);
    const Vec2 from = craft.place();
    const double course = craft.yaw() + change;
    const Vec2 velocity = speed * Vec2{math::cos(course), math::sin(course)};
    double greatest = 0.0;
    double time = 0.0;
    while ((time += craft.step) < Craft::longest) {
      const double error = wrap_angle(course - craft.yaw());
      const bool begins = time < Craft::settling;  // a full turn is to one side
      const trackable::TurnOrder order =
          law.order(speed, begins ? std::copysign(error, change) : error, craft.surge());
      craft.obey({.surge_mps = order.surge, .yaw_rate_radps = order.turn_rate});
      greatest = std::max(greatest, (craft.place() - from - time * velocity).norm());
      const Vec2 made_good = craft.vehicle.state().v_n().head<2>();
      if ((made_good - velocity).norm() < steady_error * speed) break;
    }
    return greatest;
  }

  Craft at_rest_;
  std::optional<Craft> under_way_;  // at the greatest speed
  Limits limits_;
  double most_;
  double turn_;
  Envelope envelope_;
};

}  // namespace

std::optional<Envelope> measured_envelope(const Vehicle& vehicle, const Autopilot& autopilot,
                                          const Limits& limits, double step) {
  return Trials{vehicle, autopilot, limits, step}.envelope();
}

}  // namespace fairway
