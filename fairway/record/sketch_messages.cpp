// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/sketch_messages.hpp"

#include "fairway/core/error.hpp"
#include "fairway/core/text.hpp"
#include "fairway/record/message_parts.hpp"

namespace fairway {

namespace {

constexpr std::size_t pixel_size = 3;

void put_pixels(CdrWriter& cdr, Bytes& out, std::span<const std::uint32_t> rgb) {
  cdr.number(static_cast<std::uint32_t>(pixel_size * rgb.size()));
  for (const std::uint32_t pixel : rgb) {
    for (const unsigned shift : {16U, 8U, 0U}) out.push_back(static_cast<std::byte>(pixel >> shift));
  }
}

void get_pixels(CdrReader& cdr, std::vector<std::uint32_t>& rgb) {
  const ByteView bytes = cdr.bytes();
  if (bytes.size() % pixel_size != 0) damaged("part of a pixel");
  rgb.reserve(bytes.size() / pixel_size);
  for (std::size_t i = 0; i < bytes.size(); i += pixel_size) {
    const auto part = [&](std::size_t k) { return std::to_integer<std::uint32_t>(bytes[i + k]); };
    rgb.push_back(part(0) << 16U | part(1) << 8U | part(2));
  }
}

void put_stroke(CdrWriter& cdr, Bytes& out, const Stroke& stroke) {
  if (not_utf8(stroke.meaning))
    throw InputError(
        "a stroke whose meaning is not UTF-8 cannot be recorded; expected text in that encoding");
  cdr.number(static_cast<std::uint8_t>(stroke.kind));
  cdr.text(stroke.meaning);
  cdr.number(static_cast<std::uint32_t>(stroke.points.size()));
  for (const Vec3& point : stroke.points) cdr.array(values(point));
  cdr.number(stroke.size);
  cdr.number(stroke.yaw);
  cdr.number(stroke.side);
  put_pixels(cdr, out, stroke.rgb);
}

Stroke get_stroke(CdrReader& cdr) {
  Stroke stroke;
  stroke.kind = enumerator<Stroke::Kind>(cdr.number<std::uint8_t>(), "kind of stroke");
  stroke.meaning = cdr.text();
  for (auto left = cdr.number<std::uint32_t>(); left > 0; --left) {
    Vec3 point;
    cdr.array(values(point));
    stroke.points.push_back(point);
  }
  stroke.size = cdr.number<double>();
  stroke.yaw = cdr.number<double>();
  stroke.side = cdr.number<std::int32_t>();
  get_pixels(cdr, stroke.rgb);
  return stroke;
}

}  // namespace

void encode_sketch(Bytes& out, Stamp stamp, std::span<const Stroke> strokes) {
  CdrWriter cdr{out};
  put_header(cdr, stamp);
  cdr.number(static_cast<std::uint32_t>(strokes.size()));
  for (const Stroke& stroke : strokes) put_stroke(cdr, out, stroke);
}

void encode_flights(Bytes& out, Stamp stamp, std::span<const MessageFlight> flights) {
  CdrWriter cdr{out};
  put_header(cdr, stamp);
  cdr.number(static_cast<std::uint32_t>(flights.size()));
  for (const auto& [from, to, sent, begins, arrives, unheard] : flights) {
    cdr.number(from);
    cdr.number(to);
    for (const double time : {sent, begins, arrives}) cdr.number(time);
    cdr.boolean(unheard);  // what the schema calls drowned
  }
}

void decode_sketch(ByteView message, std::vector<Stroke>& strokes) {
  CdrReader cdr{message};
  skip_header(cdr);
  for (auto left = cdr.number<std::uint32_t>(); left > 0; --left) strokes.push_back(get_stroke(cdr));
  cdr.finish();
}

void decode_flights(ByteView message, std::vector<MessageFlight>& flights) {
  CdrReader cdr{message};
  skip_header(cdr);
  for (auto left = cdr.number<std::uint32_t>(); left > 0; --left) {
    MessageFlight flight;
    flight.from = cdr.number<std::uint32_t>();
    flight.to = cdr.number<std::uint32_t>();
    flight.sent = cdr.number<double>();
    flight.begins = cdr.number<double>();
    flight.arrives = cdr.number<double>();
    flight.unheard = cdr.boolean();
    flights.push_back(flight);
  }
  cdr.finish();
}

}  // namespace fairway
