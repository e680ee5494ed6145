// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/words.hpp"

#include <cmath>

#include "fairway/avoidance/pledge/bits.hpp"

namespace fairway::pledge {
namespace {

constexpr std::uint32_t version = 1;
constexpr std::uint32_t says_state = 1, says_plan = 2;

constexpr Scale coarse_across{12, 0.1, -204.8}, coarse_depth{12, 0.1, -0.5};
constexpr Scale centre_across{10, 0.32, -163.84};
constexpr Scale radius{6, 0.25, 0.0}, arrival{5, 0.25, 0.0};
constexpr Scale speed{6, 0.02, 0.0}, climb{6, 0.01, 0.0}, turn{4, 1.0, 0.0};

void put_members(BitWriter& bits, const Members& members) {
  bits.put(static_cast<std::uint32_t>(members.to_ulong()), static_cast<int>(most_members));
}
Members get_members(BitReader& bits) { return bits.get(static_cast<int>(most_members)); }

/// All but the status of the header, which stands first.
void put_header(BitWriter& bits, std::uint32_t kind, const Header& header) {
  bits.put(version, 2);
  bits.put(kind, 2);
  bits.put(std::uint32_t{header.sender}, 4);
  bits.put(std::uint32_t{header.epoch}, 8);
  bits.put(told_time(header.sent), clock_bits);
  bits.put(static_cast<std::uint32_t>(header.status), 2);
  put_members(bits, header.acknowledged);
  put_members(bits, header.departed);
  put_members(bits, header.heard);
}

Header get_header(BitReader& bits, double now) {
  Header header;
  header.sender = static_cast<std::uint8_t>(bits.get(4));
  header.epoch = static_cast<std::uint8_t>(bits.get(8));
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
  bits.put(member.radius, radius);
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
  bits.put(told_time(word.plan.start), clock_bits);
  bits.put(word.plan.centre.x() - datum.x(), centre_across);
  bits.put(word.plan.centre.y() - datum.y(), centre_across);
  bits.put(word.plan.to_port ? 1U : 0U, 1);
  put_members(bits, word.plan.participants);
  for (const Code& code : word.plan.codes) bits.put(std::uint32_t{code.packed()}, 8);
  bits.put(word.plan.digest, 24);
  return sealed(speech);
}

std::optional<Word> decode(const Speech& speech, const Vec2& datum, double now) noexcept {
  if (!is_intact(speech)) return {};
  BitReader bits{speech.view()};
  if (bits.get(2) != version) return {};
  const std::uint32_t kind = bits.get(2);
  const Header header = get_header(bits, now);
  if (header.sender >= most_members) return {};
  if (kind == says_state) return StateWord{header, get_member(bits, datum)};
  if (kind != says_plan || header.epoch == 0) return {};
  PlanWord word{header, {.epoch = header.epoch}};
  word.plan.start = time_of(bits.get(clock_bits), now);
  const double north = bits.get(centre_across), east = bits.get(centre_across);
  word.plan.centre = datum + Vec2{north, east};
  word.plan.to_port = bits.get(1) != 0;
  word.plan.participants = get_members(bits);
  for (Code& code : word.plan.codes) code = Code::of(static_cast<std::uint8_t>(bits.get(8)));
  word.plan.digest = bits.get(24);
  return word;
}

Member as_told(const Member& member, const Vec2& datum) noexcept {
  const std::optional<Word> word = decode(encode(StateWord{{}, member}, datum), datum, 0.0);
  return std::get<StateWord>(*word).member;
}

Vec2 centre_as_told(const Vec2& centre, const Vec2& datum) noexcept {
  const auto told = [](double value) { return centre_across.value(centre_across.code(value)); };
  return datum + Vec2{told(centre.x() - datum.x()), told(centre.y() - datum.y())};
}

bool fits(const Member& member, const Vec2& datum) noexcept {
  const Member told = as_told(member, datum);
  return (told.anchor - member.anchor).norm() < 0.05 && (told.destination - member.destination).norm() < 0.2;
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
