// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "fairway/avoidance/drawing.hpp"
#include "fairway/avoidance/situation.hpp"
#include "fairway/core/echo.hpp"
#include "fairway/core/message_flight.hpp"
#include "fairway/view/word_reader.hpp"

namespace fairway {

// What vehicles thought as JSON text, as the page's `Thoughts` have it: arrays, numbers rounded to 1e-5.
// Metres, metres per second and radians, NED.

/// A stroke with a number that is not finite has nothing to show and is left out.
std::string text_of(std::span<const Stroke> strokes);
std::string text_of(std::span<const Track> tracks);
std::string text_of(std::span<const Echo> echoes);

/// One message; its times to the bit.
std::string text_of(const MessageFlight& flight);

/// One word; the time to the bit.
std::string text_of(const SpokenWord& word, const ReadWord& read);

/// `"time_s":1.5,"vehicle":2`, the time to the bit.
std::string text_of_place(double time, std::size_t vehicle);

}  // namespace fairway
