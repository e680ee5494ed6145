// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/delay_check/trajectory.hpp"

#include "fairway/avoidance/pledge/bits.hpp"
#include "fairway/core/math.hpp"

namespace fairway::delay_check {
namespace {

using pledge::BitReader;
using pledge::BitWriter;
using pledge::Scale;

constexpr std::uint32_t version = 1;
constexpr Scale radius{6, 0.25, 0.0};

void put(BitWriter& bits, const Trajectory& t, const Vec2& datum) {
  pledge::put_place(bits, t.to, datum);
  bits.put(pledge::told_time(t.departs), pledge::clock_bits);
  bits.put(pledge::told_time(t.ends), pledge::clock_bits);
}

Trajectory get(BitReader& bits, const Vec2& datum, double now) {
  Trajectory t;
  t.to = pledge::get_place(bits, datum);
  t.departs = pledge::time_of(bits.get(pledge::clock_bits), now);
  t.ends = pledge::time_of(bits.get(pledge::clock_bits), now);
  return t;
}

}  // namespace

pledge::Reference Trajectory::reference() const noexcept {
  if (ends <= departs) return pledge::Reference{to};
  pledge::Reference way;
  way.add({departs, from});
  way.add({ends, to});
  return way;
}

Speech encode(const Word& word, const Vec2& datum, double now) noexcept {
  const bool has_ended = word.committed.ends <= now;
  const Trajectory committed = has_ended ? Trajectory::standing(word.committed.to, now) : word.committed;
  Speech speech;
  BitWriter bits{pledge::body_of(speech)};
  bits.put(version, 2);
  bits.put(radius.at_least(word.radius), radius);
  bits.put(word.next ? 1U : 0U, 1);
  pledge::put_place(bits, committed.from, datum);
  put(bits, committed, datum);
  if (word.next) put(bits, *word.next, datum);
  return pledge::sealed(speech);
}

std::optional<Word> decode(const Speech& speech, const Vec2& datum, double now) noexcept {
  if (!pledge::is_intact(speech)) return {};
  BitReader bits{speech.view()};
  if (bits.get(2) != version) return {};
  Word word;
  word.radius = bits.get(radius);
  const bool has_next = bits.get(1) != 0;
  const Vec3 from = pledge::get_place(bits, datum);
  word.committed = get(bits, datum, now);
  word.committed.from = from;
  if (has_next) {
    word.next = get(bits, datum, now);
    word.next->from = word.committed.reference().at(word.next->departs);
  }
  return word;
}

Word as_told(const Word& word, const Vec2& datum, double now) noexcept {
  return *decode(encode(word, datum, now), datum, now);
}

}  // namespace fairway::delay_check
