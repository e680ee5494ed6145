// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/core/message_flight.hpp"
#include "fairway/record/bytes.hpp"
#include "fairway/record/messages.hpp"

namespace fairway {

/// CDR message of a word, stamped with when it was said; `out` is emptied first. Throws InputError for a time
/// outside what a stamp holds.
void encode_word(Bytes& out, const SpokenWord& word);

/// The way back, to the bit. Throws Malformed for anything that is not such a message, and for no bytes or
/// more than a speech has.
SpokenWord decode_word(ByteView message);

/// The bytes of a speech as people write them: "0a1f".
std::string hexadecimal(const Speech& speech);

}  // namespace fairway
