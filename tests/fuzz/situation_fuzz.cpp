// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "fairway/cli/decide/situation_json.hpp"
#include "fairway/core/error.hpp"

namespace fairway {
namespace {

/// Reads one line of `fairway decide`. What is accepted must be usable. True if it was accepted; only
/// InputError is caught.
bool read_situation(std::string_view text) {
  try {
    const DecideRequest request = parse_situation(text, 1);
    if (!is_usable(request.situation())) __builtin_trap();
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace
}  // namespace fairway

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fairway::read_situation({reinterpret_cast<const char*>(data), size});
  return 0;
}

#ifndef FAIRWAY_LIBFUZZER

#include "tests/fuzz/mutate.hpp"

namespace fairway {
namespace {

const std::vector<std::string> samples{
    R"({"time":0,"period":0.1,"own":{"id":0,"position":[1,2,3],"velocity":[0.1,0,0],"yaw":0,"radius":1,)"
    R"("priority":2},"goal":{"position":[9,0,3]},)"
    R"("preferred_velocity":[0.3,0.1,0],"limits":{"max_speed":0.5,"max_climb_rate":0.1},)"
    R"("params":{"time_horizon_s":5,"on":true,"kind":"a"},)"
    R"("tracks":[{"id":1,"position":[4,0,0],"velocity":[0,0,0],"radius":1},)"
    R"({"id":2,"position":[4,1,0],"velocity":[0,0,0],"radius":1,"age":2}],)"
    R"("obstacles":[{"kind":"sphere","position":[9,9,9],"radius":2},)"
    R"({"kind":"segment","from":[1,1,1],"to":[2,2,2]},)"
    R"({"kind":"polygon","vertices":[[0,0,0],[4,0,0],[4,4,0]]}]})",
    R"({"period":1,"own":{"id":7,"position":[0,0,0],"velocity":[0,0,0],"yaw":-3,"radius":0},)"
    R"("goal":{"position":[1,0,0],"speed":1},"limits":{"max_speed":0}})"};

// clang-format off
const std::vector<std::string> words{
    "-1", "0", "-0", "1e999", "1e308", "1e-320", "NaN", "Infinity", "18446744073709551616", "4294967295",
    "4294967296", "1.5", "true", "null", "\"\"", "\"\\u0000\"", "\"\\ud800\"", "\\", "[", "]", "{", "}",
    "[[[[", "{\"a\":", ",", ":", "\"", "\t", "\n", "\xff", "\xc3\xa9", "/*", "[0,0,0]", "\"id\":1,",
    "\"radius\":1,", "\"yaw\":0,", "\"destination\":[1,1,1],", "\"kind\":\"polygon\"", "vertices", "period",
    "max_depth", "[4,4,0],[4,0,0]"};
// clang-format on

TEST(SituationFuzzTest, NothingButARefusalComesOfBadInput) {
  expect_refusals_alone(samples, words, read_situation, 100'000, 1'000);
}

}  // namespace
}  // namespace fairway

#endif
