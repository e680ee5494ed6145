// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/avoidance/drawing.hpp"
#include "fairway/core/message_flight.hpp"
#include "fairway/record/bytes.hpp"
#include "fairway/record/messages.hpp"

namespace fairway {

// CDR messages of sketches and of messages under way; `out` is emptied first. O(size).

/// Pixels keep their lower 24 bits, which are all of their colour. Throws InputError for a meaning that is
/// not UTF-8.
void encode_sketch(Bytes& out, Stamp stamp, std::span<const Stroke> strokes);
void encode_flights(Bytes& out, Stamp stamp, std::span<const MessageFlight> flights);

// The way back, to the bit: append to `strokes` or `flights`. Throw Malformed for anything that is not such a
// message.
void decode_sketch(ByteView message, std::vector<Stroke>& strokes);
void decode_flights(ByteView message, std::vector<MessageFlight>& flights);

}  // namespace fairway
