// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/reading.hpp"

#include <cmath>

#include "fairway/avoidance/pledge/words.hpp"
#include "fairway/core/text.hpp"

namespace fairway::pledge {
namespace {

/// To a tenth, without a negative zero.
std::string tenths_text(double value) { return number_text(std::round(10.0 * value) / 10.0 + 0.0); }

/// The vehicles that the members of a group are.
std::vector<VehicleId> vehicles_of(const Members& members, std::size_t group, const Groups& groups) {
  std::vector<VehicleId> vehicles;
  for (std::size_t i = 0; i < groups.size_of(group); ++i)
    if (members[i]) vehicles.push_back(VehicleId{static_cast<std::uint32_t>(groups.vehicle_of(group, i))});
  return vehicles;
}

/// "0 1 3", or "none".
std::string numbers_text(const std::vector<VehicleId>& vehicles) {
  std::string text;
  for (const VehicleId id : vehicles) text.append(text.empty() ? "" : " ").append(std::to_string(number(id)));
  return text.empty() ? "none" : text;
}

std::string whereabouts_text(Status status, const Member& member) {
  const std::string here = place_words(member.anchor), there = place_words(member.destination);
  switch (status) {
    case Status::held:
      return "is held at " + here + " and goes to " + there;
    case Status::moving:
      return "is on its way from " + here + " to " + there;
    case Status::arrived:
      return "has arrived and is held at " + here;
    case Status::lost:
      break;
  }
  return "is off its way at " + here + " and may be at " + there + " in " + instant_words(foretold);
}

std::string status_text(Status status) {
  switch (status) {
    case Status::held:
      return "is held";
    case Status::moving:
      return "is on its way";
    case Status::arrived:
      return "has arrived";
    case Status::lost:
      break;
  }
  return "is off its way";
}

/// Members of its group whose words the sender waits for, who is `self`. Who has not acknowledged a plan
/// waits for none of its acknowledgements.
Members awaited_by(const Header& header, const Members& everyone, std::size_t self) {
  if (header.status != Status::held) return {};
  Members unheard = everyone & ~header.heard;
  unheard.reset(self);
  const bool is_pending = header.epoch && header.sent < start_of(header.epoch);
  if (unheard.any() || !is_pending || !header.acknowledged[self]) return unheard;
  return everyone & ~header.acknowledged;
}

}  // namespace

std::string place_words(const Vec3& place) {
  return "[" + tenths_text(place.x()) + ", " + tenths_text(place.y()) + ", " + tenths_text(place.z()) +
         "] m NED";
}

std::string instant_words(double time) { return tenths_text(time) + " s"; }

Reading reading_of(const Heard& heard, const Vec2& datum, const Groups& groups) {
  const std::optional<Word> word = decode(heard.speech, datum, heard.sent);
  if (!word) return {.text = "not a word of pledge"};
  const Header& header = header_of(*word);
  if (header.sender >= groups.vehicles)
    return {.text = "a word of pledge by " + std::to_string(header.sender) + ", who is not of the team"};
  const std::size_t group = groups.group_of(header.sender);
  const auto names = [&](const Members& members) {
    return numbers_text(vehicles_of(members, group, groups));
  };

  Reading reading;
  std::string& text = reading.text;
  const bool is_own = number(heard.from) == header.sender;
  if (!is_own)
    text =
        "passes on what " + std::to_string(header.sender) + " said at " + instant_words(header.sent) + ": ";
  const auto* plan = std::get_if<PlanWord>(&*word);
  text += plan != nullptr ? status_text(header.status)
                          : whereabouts_text(header.status, std::get<StateWord>(*word).member);
  text += "; has heard " + names(header.heard);
  if (header.epoch) {
    text += "; plan of " + std::to_string(groups.vehicle_of(group, header.epoch.author)) + " for " +
            instant_words(start_of(header.epoch));
    if (plan != nullptr) text += ", by which go " + names(plan->plan.participants);
    text += ": acknowledged by " + names(header.acknowledged) + ", departed " + names(header.departed);
  }
  if (groups.count() > 1) text += "; in round " + std::to_string(header.round) + " modulo 4";

  const Members everyone{(1U << groups.size_of(group)) - 1U};
  if (is_own)
    reading.awaited =
        vehicles_of(awaited_by(header, everyone, groups.member_of(header.sender)), group, groups);
  return reading;
}

}  // namespace fairway::pledge
