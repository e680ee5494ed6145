// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/word_reader.hpp"

#include <algorithm>

#include "fairway/core/error.hpp"
#include "fairway/record/word_messages.hpp"
#include "fairway/sim/agent.hpp"

namespace fairway {

std::string unread_text(const Speech& speech) { return "says the bytes " + hexadecimal(speech); }

const Avoider* WordReader::method_of(std::size_t vehicle) {
  if (avoiders_ == nullptr) return nullptr;
  const auto [known, is_new] = methods_.try_emplace(vehicle);
  std::optional<Avoider>& method = known->second;
  if (is_new) {
    const VehicleSpec& spec = scenario_.vehicles[vehicle];
    try {
      method = make_avoider(spec, spec.limits, scenario_, *avoiders_);
    } catch (const InputError&) {  // of a program with methods of its own
    }
  }
  return method ? &*method : nullptr;
}

ReadWord WordReader::read(const SpokenWord& word) {
  const std::vector<VehicleSpec>& vehicles = scenario_.vehicles;
  const Avoider* method = method_of(word.from);
  std::optional<Reading> reading;
  if (method != nullptr)
    reading = method->reading({VehicleId{vehicles[word.from].id}, word.sent, word.speech});
  if (!reading) return {.text = unread_text(word.speech), .awaited = {}};
  ReadWord read{.text = std::move(reading->text), .awaited = {}};
  for (const VehicleId id : reading->awaited) {
    const auto found = std::ranges::find(vehicles, number(id), &VehicleSpec::id);
    if (found != vehicles.end()) read.awaited.push_back(static_cast<std::size_t>(found - vehicles.begin()));
  }
  return read;
}

}  // namespace fairway
