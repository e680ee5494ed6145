// SPDX-License-Identifier: Apache-2.0
#include "fairway/scenario/angle.hpp"
#include "fairway/scenario/parts.hpp"

namespace fairway::yaml {
namespace {

/// No vehicle's parameters make it faster.
constexpr Bounds start_speeds = from_to(-50.0, 50.0);

/// `entry`, which also keeps where it was written.
template <class Keep>
Key<VehicleSpec> placed(Key<VehicleSpec> entry, const Keep& keep) {
  entry.read = [read = entry.read, keep](const Value& value, VehicleSpec& vehicle) {
    read(value, vehicle);
    keep(value, vehicle);
  };
  return entry;
}

Key<VehicleSpec> position() {
  return placed(
      key("position_m", &VehicleSpec::position, vector(anywhere),
          "Where it is [n, e, d]; d is 0 for what floats.", Needed::yes),
      [](const Value& value, VehicleSpec& v) { v.where.edit().start = value.tree().where.location(); });
}

Block<VehicleSpec> start_block() {
  return joined<VehicleSpec>(
      {{position()},
       angle("yaw", "_deg", "_rad", &VehicleSpec::yaw, from_to(-360.0, 360.0),
             "Its heading, 0 north, 90 east. Default {}."),
       {key("speed_mps", &VehicleSpec::speed, number(start_speeds), "Its speed ahead. Default {}."),
        key("delay_s", &VehicleSpec::start_delay_s, number(from_to(0.0, 1e7)),
            "Before its mission begins. Default {}.")}});
}

Block<Limits> limits_block() {
  constexpr double none = Limits::none;
  return joined<Limits>(
      {{key("max_speed_mps", &Limits::max_speed, unless(none, number(from_to(0.0, 100.0))), "Over ground."),
        key("max_climb_rate_mps", &Limits::max_climb_rate, unless(none, number(from_to(0.0, 100.0))),
            "Up or down; 0 for a surface vehicle."),
        key("max_acceleration_mps2", &Limits::max_acceleration, unless(none, number(from_to(0.0, 1000.0))),
            "For the methods that reason about reachable velocities.")},
       angle("max_turn_rate", "_degps", "_radps", &Limits::max_turn_rate, from_to(0.0, 3600.0),
             "For the methods that reason about reachable velocities."),
       {key("min_depth_m", &Limits::min_depth, unless(-none, number(from_to(-12000.0, 12000.0))),
            "No command leads above it."),
        key("max_depth_m", &Limits::max_depth, unless(none, number(from_to(-12000.0, 12000.0))),
            "No command leads below it."),
        key("min_speed_mps", &Limits::min_speed, unless(0.0, number(from_to(0.0, 100.0))),
            "Through the water; it cannot go slower, nor stop. Default: the model's; a smaller one changes "
            "nothing."),
        key("sternway", &Limits::sternway, unless(true, flag()),
            "Whether it can go astern. Default: as the model; true gives it nothing that the model has not."),
        key("sway", &Limits::sway, unless(true, flag()), "Whether it can go sideways; likewise.")}});
}

Block<FailureSpec> failure_block() {
  return {key("kind", &FailureSpec::kind, enumeration<FailureKind>("failure"),
              "silent: it tells nobody anything any more. stops: its actuators get nothing any more. leaves: "
              "it goes on as it went, whatever its avoider commands.",
              Needed::yes),
          key("under_way_s", &FailureSpec::under_way_s, number(from_to(0.0, 1e7)),
              "So long after it set out on its first transit. Default {}.")};
}

Form<Limits> limits() {
  Form<Limits> form = block_form(limits_block());
  form.read = [read = form.read](const Value& value) {
    const Limits limits = read(value);
    if (limits.min_depth > limits.max_depth)
      value.refuse("min_depth_m is below max_depth_m; depth counts downwards");
    return limits;
  };
  return form;
}

/// Without "required": what a vehicle leaves out may stand in `defaults`.
Tree relaxed(const Tree& schema) {
  Tree relaxed = Tree::map();
  for (std::size_t i = 0; i < schema.keys.size(); ++i) {
    if (schema.keys[i] != "required") relaxed.set(schema.keys[i], schema.items[i]);
  }
  return relaxed;
}

}  // namespace

const Block<VehicleSpec>& vehicle_block() {
  static const Block<VehicleSpec> block{
      key("id", &VehicleSpec::id, identifier(),
          "A number of its own. Default: its place in the list, from 0."),
      key("name", &VehicleSpec::name, name(), "Default: robot and its id."),
      key("model", &VehicleSpec::model, choice("name", Needed::yes), "How it moves; `fairway list vehicles`.",
          Needed::yes),
      key("avoider", &VehicleSpec::avoider, choice("algorithm", Needed::yes),
          "How it avoids; `fairway list algorithms`. direct avoids nobody.", Needed::yes),
      key("tracking", &VehicleSpec::tracking, unless(Tracking::automatic, enumeration<Tracking>("tracking")),
          "auto: where the vehicle cannot go sideways, the avoider is wrapped by trackable. raw: it is used "
          "as "
          "its paper prints it. trackable: it is wrapped on any vehicle. Default auto."),
      key("steering", &VehicleSpec::steering, choice("kind", Needed::no),
          "How a velocity is steered. Default: the model's usual way."),
      key("allocation", &VehicleSpec::allocation, choice("method", Needed::yes),
          "How commanded forces are shared out among the thrusters: bounded or pseudo_inverse. Default "
          "bounded."),
      key("autopilot", &VehicleSpec::autopilot, choice("kind", Needed::no),
          "How the thrusters are driven to a velocity: velocity_controller with its bandwidths."),
      group("start", start_block(), "Where and how it begins.", Needed::yes),
      key("radius_m", &VehicleSpec::radius_m, number(from_to(0.0, 1000.0)),
          "Of the sphere that others keep clear of. Default {}."),
      key("priority_count", &VehicleSpec::priority, integer(),
          "The smaller number has the right of way. Default: its id."),
      key("cooperative", &VehicleSpec::cooperative, unless(true, flag()),
          "false: it tells nobody anything, and nobody may count on it to give way. Default true."),
      key("failure", &VehicleSpec::failure, unless({}, block_form(failure_block())),
          "What breaks on board under way. Default: nothing."),
      placed(
          key("limits", &VehicleSpec::limits, limits(),
              "What it may do. A limit that is not given does not bind."),
          [](const Value& value, VehicleSpec& v) { v.where.edit().limits = value.tree().where.location(); }),
      placed(
          key("mission", &VehicleSpec::mission, mission(), "Its legs, in order. It then holds its position."),
          [](const Value& value, VehicleSpec& v) { v.where.edit().mission = places_of_legs(value); }),
  };
  return block;
}

Form<VehicleSpec> vehicle() {
  Tree schema = relaxed(schema_of(vehicle_block()));
  Tree& start = *schema.find("properties")->find("start");
  start = relaxed(start);
  return {.read =
              [](const Value& value) {
                VehicleSpec vehicle;
                // the id first: the name and the priority follow it
                const auto index = value.path().rfind('[');
                if (index != std::string::npos)
                  vehicle.id = static_cast<std::uint32_t>(std::stoul(value.path().substr(index + 1)));
                if (const auto id = value.find("id")) vehicle.id = id->whole<std::uint32_t>();
                vehicle.name = "robot" + std::to_string(vehicle.id);
                vehicle.priority = static_cast<std::int32_t>(vehicle.id);
                vehicle.tracking = Tracking::automatic;
                read_block(value, vehicle_block(), vehicle);
                return vehicle;
              },
          .write = [](const VehicleSpec& vehicle) { return write_block(vehicle_block(), vehicle); },
          .schema = std::move(schema)};
}

}  // namespace fairway::yaml
