// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>

#include "fairway/core/error.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/core/text.hpp"
#include "fairway/record/cdr.hpp"
#include "fairway/record/frame_hash.hpp"
#include "fairway/record/layout.hpp"
#include "fairway/record/mcap_reader.hpp"
#include "fairway/record/mcap_writer.hpp"
#include "fairway/record/messages.hpp"
#include "fairway/record/schemas.hpp"
#include "fairway/record/sketch_messages.hpp"
#include "fairway/record/testing/parsed.hpp"
#include "fairway/record/testing/sample_run.hpp"

// Nothing but InputError may come of a file, whatever is in it.

namespace fairway {
namespace {

using testing::accepted;
using testing::bytes_in;
using ::testing::HasSubstr;
using testing::refusal;
using ::testing::StartsWith;

// Files whose checksums are right and whose content is not.
struct Forgery {
  std::string format = std::to_string(layout::format);
  std::string vehicles = R"([{"id":1,"name":"a","model":"m","topic":"/a"}])";
  std::string end_hash = "0";
  std::string frame_count = "0";
  std::map<std::string, std::string> run;  // instead of what stands there
  std::map<std::string, std::string> end;  // likewise
  std::string yaml = "name: s\n";
  bool scenario = true;
  bool perception = false;  // its topics are there
  std::string perception_told = "false";
  bool sketches = false;  // likewise
  std::string sketches_told = "false";
  std::function<void(McapWriter&)> messages = [](McapWriter&) {};

  std::string refusal_of() const {
    const TemporaryFolder folder;
    const std::string path = folder.file("run.mcap");
    McapWriter mcap{path, "ros2", "someone else"};
    const auto add = [&mcap](const MessageSchema& schema, const char* topic) {
      mcap.add_channel(mcap.add_schema(schema.name, "ros2msg", schema.text), topic, "cdr");
    };
    add(frame_schema(), "/fairway/frame");
    add(odometry_schema(), "/a/odometry");
    add(vehicle_status_schema(), "/a/status");
    if (perception) {
      add(perception_schema(), "/fairway/perception");
      add(tracks_schema(), "/a/tracks");
      add(echoes_schema(), "/a/echoes");
    }
    if (sketches) {
      add(sketch_schema(), "/a/sketch");
      add(flights_schema(), "/fairway/flights");
    }
    mcap.add_metadata("fairway", laid_over(run, {{"format", format},
                                                 {"version", "9.9"},
                                                 {"scenario", "s"},
                                                 {"seed", "1"},
                                                 {"period_s", "0.1"},
                                                 {"stride", "1"},
                                                 {"perception", perception_told},
                                                 {"sketches", sketches_told},
                                                 {"vehicles", vehicles}}));
    if (scenario) mcap.attach("scenario.yaml", "application/yaml", yaml);
    messages(mcap);
    mcap.add_metadata("fairway.end", laid_over(end, {{"frame_count", frame_count},
                                                     {"run_frame_count", frame_count},
                                                     {"run_hash", end_hash}}));
    mcap.finish();
    return refusal(bytes_in(path));
  }

  static McapWriter::Map laid_over(std::map<std::string, std::string> entries, const McapWriter::Map& usual) {
    entries.insert(usual.begin(), usual.end());
    return {entries.begin(), entries.end()};
  }
};

/// A message on the channel of that place among those of a forgery; `encode` takes the buffer and the stamp.
template <class... Parts, class... Given>
void write(McapWriter& mcap, std::uint16_t channel, void (*encode)(Bytes&, Stamp, Parts...),
           const Given&... given) {
  Bytes message;
  encode(message, Stamp{0}, given...);
  mcap.write(channel, 0, message);
}

void write_frame(McapWriter& mcap, std::int64_t tick, std::uint64_t hash = 1, double time = 0.0) {
  write(mcap, 0, encode_frame, FrameMark{.tick = Tick{tick}, .time = time, .period = 0.1, .hash = hash});
}
void write_odometry(McapWriter& mcap) { write(mcap, 1, encode_odometry, "a", VehicleState{}); }
void write_status(McapWriter& mcap, std::int64_t tick) {
  write(mcap, 2, encode_status, Tick{tick}, VehicleFrame{});
}
void write_perception(McapWriter& mcap, std::int64_t tick, std::uint64_t hash) {
  write(mcap, 3, encode_perception, PerceptionMark{Tick{tick}, hash});
}
void write_tracks(McapWriter& mcap) { write(mcap, 4, encode_tracks, std::span<const Track>{}); }

// where perception is not recorded
void write_sketch(McapWriter& mcap, std::span<const Stroke> strokes = {}) {
  write(mcap, 3, encode_sketch, strokes);
}
/// A stroke whose meaning is bytes, which the encoder refuses.
void write_sketch_without_text(McapWriter& mcap) {
  const std::vector<Stroke> strokes{{.meaning = "me@ning"}};
  Bytes message;
  encode_sketch(message, Stamp{0}, strokes);
  std::ranges::replace(message, std::byte{'@'}, std::byte{0xFF});
  mcap.write(3, 0, message);
}
void write_flights(McapWriter& mcap) { write(mcap, 4, encode_flights, std::span<const MessageFlight>{}); }

/// The frame at tick 4 of one vehicle at rest, whose hash is right.
void write_whole_frame(McapWriter& mcap) {
  const VehicleFrame vehicle;
  write_frame(mcap, 4, frame_hash({.tick = Tick{4}, .vehicles = {&vehicle, 1}}));
  write_odometry(mcap);
  write_status(mcap, 4);
}

TEST(ForgedRecording, IsRefusedForWhatIsWrongInIt) {
  EXPECT_EQ(Forgery{}.refusal_of(), accepted);
  EXPECT_THAT(
      (Forgery{.format = "4"}.refusal_of()),
      HasSubstr("a recording of format 4, made by fairway 9.9; expected format 3: use a newer fairway"));
  EXPECT_THAT(
      (Forgery{.format = "2"}.refusal_of()),
      HasSubstr("a recording of format 2, made by fairway 9.9; expected format 3: run its scenario again"));
  EXPECT_THAT((Forgery{.format = "x"}.refusal_of()), HasSubstr("format is 'x'; expected a number"));
  EXPECT_THAT((Forgery{.vehicles = "[{"}.refusal_of()), HasSubstr("list of vehicles"));
  EXPECT_THAT((Forgery{.vehicles = R"([{"id":"a"}])"}.refusal_of()), HasSubstr("list of vehicles"));
  EXPECT_THAT((Forgery{.vehicles = "7"}.refusal_of()), HasSubstr("list of vehicles"));
  EXPECT_THAT((Forgery{.vehicles = R"([{"id":1,"name":"b","model":"m","topic":"/b"}])"}.refusal_of()),
              HasSubstr("topic /b/odometry is missing"));
  EXPECT_THAT((Forgery{.frame_count = "1"}.refusal_of()), HasSubstr("frames are missing"));
  EXPECT_THAT((Forgery{.scenario = false}.refusal_of()), HasSubstr("the scenario is missing"));
}

TEST(ForgedRecording, IsRefusedForTextThatIsNotUtf8) {
  const auto no_text = HasSubstr("run.mcap: damaged recording: a text is not UTF-8");
  for (const char* key : {"version", "scenario", "vehicles", "program", "machine", "unheard_of"})
    EXPECT_THAT((Forgery{.run = {{key, "caf\xE9"}}}.refusal_of()), no_text) << key;
  EXPECT_THAT((Forgery{.end = {{"diverged", "\xFF"}}}.refusal_of()), no_text);
  EXPECT_THAT((Forgery{.yaml = "name: \xFF\n"}.refusal_of()),
              HasSubstr("run.mcap (scenario):1:7: holds a byte that is not UTF-8"));
  EXPECT_EQ((Forgery{.run = {{"scenario", "Søløve"}}}.refusal_of()), accepted);
}

TEST(ForgedRecording, IsRefusedForNumbersThatNoRunHas) {
  const auto with = [](const char* key, const char* value) {
    return Forgery{.run = {{key, value}}}.refusal_of();
  };
  for (const char* period : {"nan", "inf", "0", "-1"})
    EXPECT_THAT(with("period_s", period),
                HasSubstr("period_s is '" + std::string(period) + "'; expected a positive number"));
  for (const char* seed : {"nan", "-1", "1.5", ""})
    EXPECT_THAT(with("seed", seed), HasSubstr("seed is '" + std::string(seed) + "'; expected a number"));
  for (const char* stride : {"0", "-1"})
    EXPECT_THAT(with("stride", stride),
                HasSubstr("stride is " + std::string(stride) + "; expected 1 or more"));
  EXPECT_THAT((Forgery{.end = {{"run_frame_count", "9"}}}.refusal_of()),
              HasSubstr("of 9 frames it has 0; expected one in 1"));
}

TEST(ForgedRecording, IsRefusedForWhatItsScenarioTellsOtherwise) {
  EXPECT_EQ((Forgery{.yaml = "seed: 1\nstep_s: 0.1\n"}.refusal_of()), accepted);
  EXPECT_THAT((Forgery{.yaml = "seed: 2\n"}.refusal_of()),
              HasSubstr("seed is 1, and its scenario has seed: 2"));
  EXPECT_THAT((Forgery{.yaml = "seed: one\n"}.refusal_of()), HasSubstr("its scenario has seed: one"));
  EXPECT_THAT((Forgery{.yaml = "step_s: 0.2\n"}.refusal_of()),
              HasSubstr("period_s is 0.1, and its scenario has step_s: 0.2"));
}

TEST(ForgedRecording, IsRefusedForARunThatBrokeAndWasStopped) {
  EXPECT_EQ((Forgery{.end = {{"stopped", "true"}}}.refusal_of()), accepted);
  EXPECT_EQ((Forgery{.end = {{"diverged", "diverged: a at 1 s: why"}}}.refusal_of()), accepted);
  EXPECT_THAT((Forgery{.end = {{"diverged", "diverged: a at 1 s: why"}, {"stopped", "true"}}}.refusal_of()),
              HasSubstr("its run broke and was stopped"));
}

TEST(ForgedRecording, IsRefusedInOneLine) {
  EXPECT_EQ((Forgery{.run = {{"seed", "1\n2\x1B[31m"}}}.refusal_of()),
            "run.mcap: damaged recording: seed is '1?2?[31m'; expected a number");
}

TEST(ForgedRecording, IsRefusedForTimesThatDoNotAscend) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const double time : {-1.0, infinite, -infinite, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THAT((Forgery{.messages = [&](McapWriter& m) { write_frame(m, 4, 1, time); }}.refusal_of()),
                HasSubstr("the frame at tick 4 is at " + number_text(time) +
                          " s; expected times that ascend from 0"));
  const auto falling = [](McapWriter& m) {
    for (const int tick : {4, 5})
      write_frame(m, tick, 1, 5.0 - tick), write_odometry(m), write_status(m, tick);
  };
  EXPECT_THAT((Forgery{.messages = falling}.refusal_of()), HasSubstr("the frame at tick 5 is at 0 s"));
}

TEST(ForgedRecording, IsRefusedForFramesThatAreNotWhole) {
  const auto with = [](std::function<void(McapWriter&)> messages) {
    return Forgery{.messages = std::move(messages)}.refusal_of();
  };
  EXPECT_THAT(with([](McapWriter& m) { write_odometry(m); }), HasSubstr("a vehicle before the first frame"));
  EXPECT_THAT(with([](McapWriter& m) { write_frame(m, 4); }), HasSubstr("tick 4 has not all its vehicles"));
  EXPECT_THAT(with([](McapWriter& m) { write_frame(m, 4), write_odometry(m), write_odometry(m); }),
              HasSubstr("tick 4 has not all its vehicles"));
  EXPECT_THAT(with([](McapWriter& m) { write_frame(m, 4), write_odometry(m), write_status(m, 5); }),
              HasSubstr("tick 4 has not all its vehicles"));
  EXPECT_THAT(with([](McapWriter& m) {
                for (int i = 0; i < 2; ++i) write_frame(m, 4), write_odometry(m), write_status(m, 4);
              }),
              HasSubstr("ticks do not ascend"));
  EXPECT_THAT(with([](McapWriter& m) { write_frame(m, 4), write_odometry(m), write_status(m, 4); }),
              HasSubstr("the frame at tick 4 has not its recorded hash"));
}

TEST(ForgedRecording, IsRefusedForPerceptionThatIsNotWhole) {
  const auto with = [](std::function<void(McapWriter&)> messages) {
    return Forgery{
        .frame_count = "1", .perception = true, .perception_told = "true", .messages = std::move(messages)}
        .refusal_of();
  };
  const VehicleFrame vehicle;
  const std::uint64_t right = perception_hash({.tick = Tick{4}, .vehicles = {&vehicle, 1}});
  EXPECT_THAT(with([&](McapWriter& m) { write_whole_frame(m), write_perception(m, 4, right); }),
              HasSubstr("metadata entry 'perception_hash' is missing"));
  EXPECT_THAT(with([](McapWriter& m) { write_whole_frame(m), write_perception(m, 4, 1); }),
              HasSubstr("the frame at tick 4 has not its recorded hash"));
  EXPECT_THAT(with([](McapWriter& m) { write_whole_frame(m); }),
              HasSubstr("tick 4 has not all that was perceived"));
  EXPECT_THAT(with([&](McapWriter& m) { write_whole_frame(m), write_perception(m, 5, right); }),
              HasSubstr("tick 4 has not all that was perceived"));
  EXPECT_THAT(with([](McapWriter& m) { write_tracks(m), write_whole_frame(m); }),
              HasSubstr("what a vehicle perceives or draws before the first frame"));
  EXPECT_THAT((Forgery{.perception_told = "true"}.refusal_of()), HasSubstr("topic /a/tracks is missing"));
  EXPECT_EQ((Forgery{.perception = true}.refusal_of()), accepted);
}

TEST(ForgedRecording, IsRefusedForSketchesThatAreNotWhole) {
  const auto with = [](std::function<void(McapWriter&)> messages) {
    return Forgery{
        .frame_count = "1", .sketches = true, .sketches_told = "true", .messages = std::move(messages)}
        .refusal_of();
  };
  const std::vector<Stroke> unknown{{.kind = static_cast<Stroke::Kind>(7)}};
  EXPECT_THAT(with([](McapWriter& m) { write_whole_frame(m), write_sketch(m); }),
              HasSubstr("tick 4 has not all that was drawn"));
  EXPECT_THAT(with([](McapWriter& m) { write_whole_frame(m), write_flights(m); }),
              HasSubstr("tick 4 has not all that was drawn"));
  EXPECT_THAT(with([](McapWriter& m) { write_sketch(m), write_whole_frame(m); }),
              HasSubstr("what a vehicle perceives or draws before the first frame"));
  EXPECT_THAT(with([&](McapWriter& m) { write_whole_frame(m), write_sketch(m, unknown); }),
              HasSubstr("a kind of stroke is 7; expected 0 to 6"));
  EXPECT_THAT(with([](McapWriter& m) { write_whole_frame(m), write_sketch_without_text(m); }),
              HasSubstr("a text is not UTF-8"));
  EXPECT_EQ(with([](McapWriter& m) { write_whole_frame(m), write_sketch(m), write_flights(m); }), accepted);
  EXPECT_THAT((Forgery{.sketches_told = "true"}.refusal_of()), HasSubstr("topic /a/sketch is missing"));
  EXPECT_EQ((Forgery{.sketches = true}.refusal_of()), accepted);
}

TEST(ForgedRecording, WithRandomMessagesIsRefused) {
  Rng rng{3};
  for (int round = 0; round < 300; ++round) {
    const std::string text = Forgery{.messages = [&](McapWriter& mcap) {
                               write_frame(mcap, 1);
                               write_odometry(mcap);
                               Bytes message;
                               encode_status(message, Stamp{0}, Tick{1}, {});
                               message[4 + rng.index(message.size() - 4)] =
                                   static_cast<std::byte>(rng.index(256));
                               message.resize(message.size() - rng.index(2) * rng.index(message.size()));
                               mcap.write(2, 0, message);
                             }}.refusal_of();
    EXPECT_THAT(text, StartsWith("run.mcap: damaged recording: "));
  }
}

}  // namespace
}  // namespace fairway
