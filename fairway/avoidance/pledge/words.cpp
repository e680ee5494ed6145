// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/words.hpp"

#include <cmath>

#include "fairway/avoidance/pledge/bits.hpp"
#include "fairway/avoidance/pledge/reference.hpp"

namespace fairway::pledge {
namespace {

constexpr std::uint32_t version = 2;  // modulo 4
constexpr std::uint32_t says_state = 0, says_plan = 1;
constexpr int vehicle_bits = 5;
static_assert(most_vehicles == 1U << static_cast<unsigned>(vehicle_bits));

constexpr Scale coarse_across{12, 0.1, -204.8}, coarse_depth{12, 0.1, -0.5};
constexpr Scale centre_across{10, 0.32, -163.84};
constexpr Scale radius{6, 0.25, 0.0}, arrival{5, 0.25, 0.0};
constexpr Scale speed{6, 0.02, 0.0}, climb{6, 0.01, 0.0}, turn{4, 1.0, 0.0};

void put_members(BitWriter& bits, const Members& members) {
  bits.put(static_cast<std::uint32_t>(members.to_ulong()), static_cast<int>(most_members));
}
Members get_members(BitReader& bits) { return bits.get(static_cast<int>(most_members)); }

/// A start is told in tenths of a second, modulo 58 h.
constexpr int start_bits = 21;
constexpr std::int64_t start_period = std::int64_t{1} << start_bits;

void put_epoch(BitWriter& bits, const Epoch& epoch) {
  bits.put(epoch ? 1U : 0U, 1);
  bits.put(epoch ? static_cast<std::uint32_t>(epoch.tenths & (start_period - 1)) : 0U, start_bits);
  bits.put(epoch ? std::uint32_t{epoch.author} : 0U, 3);
}

/// The one nearest to `now` that is told so.
Epoch get_epoch(BitReader& bits, double now) {
  const bool is_any = bits.get(1) != 0;
  const auto told = static_cast<std::int64_t>(bits.get(start_bits));
  const auto author = static_cast<std::uint8_t>(bits.get(3));
  if (!is_any) return {};
  const auto present = static_cast<std::int64_t>(std::floor(now / tenth));
  const std::int64_t ahead = (told - present) & (start_period - 1);
  return {present + (ahead < start_period / 2 ? ahead : ahead - start_period), author};
}

bool can_be_meant(const Epoch& epoch, double now) {
  const double ahead = tenth * static_cast<double>(epoch.tenths) - now;
  return !epoch || (ahead > -soonest_forgotten - clock_period && ahead < farthest_start + clock_period);
}

void put_header(BitWriter& bits, std::uint32_t kind, const Header& header) {
  bits.put(version, 2);
  bits.put(kind, 1);
  bits.put(std::uint32_t{header.sender}, vehicle_bits);
  bits.put(std::uint32_t{header.round}, 2);
  put_epoch(bits, header.epoch);
  bits.put(told_time(header.sent), clock_bits);
  bits.put(static_cast<std::uint32_t>(header.status), 2);
  put_members(bits, header.acknowledged);
  put_members(bits, header.departed);
  put_members(bits, header.heard);
}

Header get_header(BitReader& bits, double now) {
  Header header;
  header.sender = static_cast<std::uint8_t>(bits.get(vehicle_bits));
  header.round = static_cast<std::uint8_t>(bits.get(2));
  header.epoch = get_epoch(bits, now);
  header.sent = time_of(bits.get(clock_bits), now);
  header.status = static_cast<Status>(bits.get(2));
  header.acknowledged = get_members(bits);
  header.departed = get_members(bits);
  header.heard = get_members(bits);
  return header;
}

void put_member(BitWriter& bits, const Member& member, const Vec2& datum) {
  put_place(bits, member.anchor, datum);
  put_place(bits, member.destination, datum, coarse_across, coarse_depth);
  bits.put(member.arrival, arrival);
  bits.put(radius.at_least(member.radius), radius);
  bits.put(member.speed, speed);
  bits.put(member.climb, climb);
  bits.put(member.descent, climb);
  bits.put(member.turn, turn);
  bits.put(std::uint32_t{member.version}, 4);
}

Member get_member(BitReader& bits, const Vec2& datum) {
  Member member;
  member.anchor = get_place(bits, datum);
  member.destination = get_place(bits, datum, coarse_across, coarse_depth);
  member.arrival = bits.get(arrival);
  member.radius = bits.get(radius);
  member.speed = bits.get(speed);
  member.climb = bits.get(climb);
  member.descent = bits.get(climb);
  member.turn = bits.get(turn);
  member.version = static_cast<std::uint8_t>(bits.get(4));
  return member;
}

}  // namespace

Speech encode(const StateWord& word, const Vec2& datum) noexcept {
  Speech speech;
  BitWriter bits{body_of(speech)};
  put_header(bits, says_state, word.header);
  put_member(bits, word.member, datum);
  return sealed(speech);
}

Speech encode(const PlanWord& word, const Vec2& datum) noexcept {
  Speech speech;
  BitWriter bits{body_of(speech)};
  put_header(bits, says_plan, word.header);
  bits.put(word.plan.centre.x() - datum.x(), centre_across);
  bits.put(word.plan.centre.y() - datum.y(), centre_across);
  bits.put(word.plan.to_port ? 1U : 0U, 1);
  bits.put(std::uint32_t{word.plan.scale}, 2);
  put_members(bits, word.plan.participants);
  for (const Code& code : word.plan.codes) bits.put(std::uint32_t{code.packed()}, 8);
  bits.put(word.plan.digest, 24);
  return sealed(speech);
}

std::optional<Word> decode(const Speech& speech, const Vec2& datum, double now) noexcept {
  if (!is_intact(speech)) return {};
  BitReader bits{speech.view()};
  if (bits.get(2) != version) return {};
  const std::uint32_t kind = bits.get(1);
  const Header header = get_header(bits, now);
  if (!can_be_meant(header.epoch, now)) return {};
  if (kind == says_state) return StateWord{header, get_member(bits, datum)};
  if (!header.epoch) return {};
  PlanWord word{header, {.epoch = header.epoch}};
  const double north = bits.get(centre_across), east = bits.get(centre_across);
  word.plan.centre = datum + Vec2{north, east};
  word.plan.to_port = bits.get(1) != 0;
  word.plan.scale = static_cast<std::uint8_t>(bits.get(2));
  word.plan.participants = get_members(bits);
  for (Code& code : word.plan.codes) code = Code::of(static_cast<std::uint8_t>(bits.get(8)));
  word.plan.digest = bits.get(24);
  return word;
}

Member as_told(const Member& member, const Vec2& datum) noexcept {
  const std::optional<Word> word = decode(encode(StateWord{{}, member}, datum), datum, 0.0);
  return std::get<StateWord>(*word).member;
}

double speed_as_told(double wanted, double most) noexcept { return speed.nearest(wanted, most); }
double climb_as_told(double wanted, double most) noexcept { return climb.nearest(wanted, most); }

Vec2 centre_as_told(const Vec2& centre, const Vec2& datum) noexcept {
  const auto told = [](double value) { return centre_across.value(centre_across.code(value)); };
  return datum + Vec2{told(centre.x() - datum.x()), told(centre.y() - datum.y())};
}

bool can_be_told(const Vec3& place, const Vec2& datum) noexcept {
  const auto is_near = [](const Scale& scale, double value) {
    return std::fabs(scale.value(scale.code(value)) - value) < 0.04;
  };
  return is_near(across, place.x() - datum.x()) && is_near(across, place.y() - datum.y()) &&
         is_near(depth, place.z());
}

std::string_view misfit_of(const Member& member, const Vec2& datum) noexcept {
  const Member told = as_told(member, datum);
  if (!can_be_told(member.anchor, datum)) return "it is too far from the datum for its words";
  if (!can_be_told(member.destination, datum)) return "its goal is too far from the datum for its words";
  if (!(told.radius > member.radius - 1e-6)) return "its sphere is too large for its words";
  if (!(told.turn > member.turn - 1.0)) return "it turns too slowly for its words";
  const double down = member.destination.z() - member.anchor.z();
  const bool is_level = std::fabs(down) < level_within;
  const bool goes = told.speed > 0.0 && (is_level || (down > 0.0 ? told.descent : told.climb) > 0.0);
  return goes ? "" : "it goes too slowly for its words";
}

std::uint32_t digest_of(const std::array<Member, most_members>& members, const Members& participants,
                        const Vec2& datum) noexcept {
  std::uint32_t sum = 0x811c9dc5U;
  for (std::size_t i = 0; i < most_members; ++i) {
    if (!participants[i]) continue;
    std::array<std::uint8_t, Speech::most_bytes> bytes{};
    BitWriter bits{bytes};
    bits.put(static_cast<std::uint32_t>(i), 8);
    put_member(bits, members[i], datum);
    sum = hash(bytes, sum);
  }
  return (sum ^ sum >> 24U) & 0xffffffU;
}

}  // namespace fairway::pledge
