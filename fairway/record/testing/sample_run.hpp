// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "fairway/core/rng.hpp"
#include "fairway/core/testing/allocations.hpp"
#include "fairway/core/testing/temporary_folder.hpp"
#include "fairway/record/hash_checker.hpp"
#include "fairway/record/mcap_reader.hpp"
#include "fairway/record/recording.hpp"
#include "fairway/record/recording_writer.hpp"

namespace fairway::testing {

/// A made-up run in which every quantity is used: random values, extremes, vehicle i with i actuators.
class SampleRun {
 public:
  explicit SampleRun(std::size_t vehicle_count = 3, std::size_t frame_count = 5) {
    for (std::size_t i = 0; i < vehicle_count; ++i) {
      const auto id = static_cast<std::uint32_t>(i + 1);
      info.vehicles.push_back({VehicleId{id}, "auv_" + std::to_string(id), i == 0 ? "otter" : "sparus2"});
    }
    Rng rng{42};
    const auto draw = [&rng] { return Vec3{rng.normal(), rng.normal(), rng.normal()}; };
    actuators.resize(frame_count * vehicle_count);
    for (std::size_t k = 0; k < frame_count * vehicle_count; ++k) {
      const std::size_t i = k % vehicle_count;
      VehicleFrame v;
      v.id = info.vehicles[i].id;
      v.state.p_n = 100.0 * draw();
      v.state.q_nb = quaternion_of({rng.normal(), rng.uniform(-1.5, 1.5), rng.normal()});
      v.state.v_b = draw();
      v.state.omega_b = draw();
      v.command.velocity = draw();
      v.command.mode = static_cast<Mode>(rng.index(EnumNames<Mode>::names.size()));
      v.command.astern = rng.index(2) == 1;
      if (rng.index(2) == 1) v.command.heading = rng.normal();
      if (rng.index(2) == 1) v.command.turn_rate = rng.normal();
      if (rng.index(2) == 1) v.command.wrench = (Wrench() << draw(), draw()).finished();
      v.phase = static_cast<Phase>(rng.index(EnumNames<Phase>::names.size()));
      v.goal = 100.0 * draw();
      v.goal_speed = rng.uniform(0.0, 2.0);
      v.power = rng.uniform(0.0, 500.0);
      v.wrench << draw(), draw();
      for (std::size_t a = 0; a < i; ++a) actuators[k].push_back(rng.normal());
      vehicles.push_back(v);
    }
    for (std::size_t k = 0; k < vehicles.size(); ++k) vehicles[k].actuators = actuators[k];
  }

  /// From now on vehicles perceive: every vehicle all the others, anew in every second frame, and the first
  /// as many echoes as the frame's index, at most eight.
  void perceive() {
    info.perception = true;
    Rng rng{43};
    const auto draw = [&rng] { return Vec3{rng.normal(), rng.normal(), rng.normal()}; };
    const auto draw_matrix = [&] { return (Mat3() << draw(), draw(), draw()).finished(); };
    const std::size_t n = info.vehicles.size();
    tracks.resize(vehicles.size());
    echoes.resize(vehicles.size());
    for (std::size_t k = 0; k < vehicles.size(); ++k) {
      if (k / n % 2 == 1) {
        tracks[k] = tracks[k - n];
        echoes[k] = echoes[k - n];
      } else {
        for (std::size_t i = 0; i + 1 < n; ++i) {
          Track& track = tracks[k].emplace_back();
          track = {.id = TrackId{first_drifter_id + static_cast<std::uint32_t>(i)},
                   .position = 100.0 * draw(),
                   .velocity = draw(),
                   .yaw = rng.normal(),
                   .radius = rng.uniform(0.0, 3.0),
                   .age = rng.uniform(0.0, 9.0),
                   .priority = static_cast<std::int32_t>(rng.index(9)) - 4,
                   .reacts = rng.index(2) == 1,
                   .position_covariance = draw_matrix(),
                   .velocity_covariance = draw_matrix()};
          if (rng.index(2) == 1) track.destination = 100.0 * draw();
        }
        const std::size_t heard = k % n == 0 ? std::min<std::size_t>(k / n, 8) : 0;
        for (std::size_t i = 0; i < heard; ++i) echoes[k].push_back({rng.uniform(0.0, 50.0), rng.normal()});
      }
      vehicles[k].tracks = tracks[k];
      vehicles[k].echoes = echoes[k];
    }
  }

  /// From now on vehicles draw: one stroke of each kind, vehicle i without the first i, anew in every second
  /// frame; and as many messages are under way as the half of the frame's index, at most four.
  void sketch() {
    info.sketches = true;
    Rng rng{44};
    const auto draw = [&rng] { return Vec3{rng.normal(), rng.normal(), rng.normal()}; };
    const std::size_t n = info.vehicles.size();
    strokes.resize(vehicles.size());
    flights.resize(size());
    for (std::size_t k = 0; k < vehicles.size(); ++k) {
      if (k / n % 2 == 1) {
        strokes[k] = strokes[k - n];
      } else {
        for (std::size_t kind = k % n; kind < EnumNames<Stroke::Kind>::names.size(); ++kind) {
          Stroke& stroke = strokes[k].emplace_back();
          stroke.kind = static_cast<Stroke::Kind>(kind);
          stroke.meaning = "\"" + std::string(rng.index(4), 'x') + "\" of frame " + std::to_string(k / n);
          for (std::uint64_t i = rng.index(5); i > 0; --i) stroke.points.push_back(draw());
          stroke.size = rng.normal();
          stroke.yaw = rng.normal();
          stroke.side = static_cast<std::int32_t>(rng.index(9)) - 4;
          for (std::uint64_t i = rng.index(5); i > 0; --i)
            stroke.rgb.push_back(static_cast<std::uint32_t>(rng.index(0x100'0000)));
        }
      }
      vehicles[k].strokes = strokes[k];
    }
    for (std::size_t f = 0; f < flights.size(); ++f) {
      for (std::size_t i = 0; i < std::min<std::size_t>(f / 2, 4); ++i) {
        const auto from = static_cast<std::uint32_t>(f);
        flights[f].push_back({from, from + 1, rng.normal(), rng.normal(), rng.normal(), rng.index(2) == 1});
      }
    }
  }

  /// From now on methods speak: in every second frame the vehicle of its index, from the first again behind
  /// the last, says as many bytes as the frame's index and one more, at most 25; in frames before the third
  /// nobody.
  void speak() {
    Rng rng{45};
    words.resize(size());
    for (std::size_t f = 2; f < words.size(); f += 2) {
      SpokenWord& word = words[f].emplace_back();
      word.from = static_cast<std::uint32_t>(f % info.vehicles.size());
      word.sent = frame(f).time;
      word.speech.size = static_cast<std::uint8_t>(std::min(f + 1, Speech::most_bytes));
      for (std::size_t i = 0; i < word.speech.size; ++i)
        word.speech.bytes[i] = static_cast<std::uint8_t>(rng.index(256));
    }
  }

  SampleRun(const SampleRun&) = delete;
  SampleRun& operator=(const SampleRun&) = delete;

  std::size_t size() const { return info.vehicles.empty() ? 0 : vehicles.size() / info.vehicles.size(); }

  VehicleFrame& at(std::size_t frame, std::size_t vehicle) {
    return vehicles[frame * info.vehicles.size() + vehicle];
  }

  Track& track(std::size_t frame, std::size_t vehicle, std::size_t i) {
    return tracks[frame * info.vehicles.size() + vehicle][i];
  }

  Stroke& stroke(std::size_t frame, std::size_t vehicle, std::size_t i) {
    return strokes[frame * info.vehicles.size() + vehicle][i];
  }

  Frame frame(std::size_t i) const {
    const Tick tick{static_cast<std::int64_t>(i)};
    const std::size_t n = info.vehicles.size();
    return {.tick = tick,
            .time = seconds(tick, info.period),
            .period = info.period,
            .vehicles = std::span{vehicles}.subspan(i * n, n),
            .flights = flights.empty() ? std::span<const MessageFlight>{} : flights[i],
            .words = words.empty() ? std::span<const SpokenWord>{} : words[i]};
  }

  void record(const std::string& path, std::int64_t stride = 1) const {
    RecordingWriter writer{path, info, stride};
    for (std::size_t i = 0; i < size(); ++i) writer.write(frame(i));
    writer.close();
  }

  RecordingInfo info{.version = "1.2.3",
                     .scenario_name = "crossing, \"two\"",
                     .scenario_yaml = "name: crossing\nvehicles: []\n",
                     .seed = std::numeric_limits<std::uint64_t>::max(),
                     .period = 0.1,
                     .vehicles = {}};
  std::vector<VehicleFrame> vehicles;          // frame after frame
  std::vector<std::vector<double>> actuators;  // likewise
  std::vector<std::vector<Track>> tracks;
  std::vector<std::vector<Echo>> echoes;
  std::vector<std::vector<Stroke>> strokes;
  std::vector<std::vector<MessageFlight>> flights;  // by frame
  std::vector<std::vector<SpokenWord>> words;       // likewise
};

/// A sample run with what one of its functions adds.
template <void (SampleRun::*more)()>
struct SampleRunWith : SampleRun {
  explicit SampleRunWith(std::size_t vehicle_count = 3, std::size_t frame_count = 5)
      : SampleRun{vehicle_count, frame_count} {
    (this->*more)();
  }
};

using PerceivingRun = SampleRunWith<&SampleRun::perceive>;
using SketchingRun = SampleRunWith<&SampleRun::sketch>;
using SpeakingRun = SampleRunWith<&SampleRun::speak>;

inline Bytes bytes_in(const std::string& file) {
  std::ifstream stream{file, std::ios::binary};
  const std::string text{std::istreambuf_iterator<char>{stream}, {}};
  const ByteView view = bytes_of(text);
  return {view.begin(), view.end()};
}

/// The recording of a run, as read back.
inline Recording recorded(const SampleRun& run, std::int64_t stride = 1) {
  const TemporaryFolder folder;
  run.record(folder.file("run.mcap"), stride);
  return Recording::read(folder.file("run.mcap"));
}

/// The recording of a run, as it lies in its file.
inline Bytes recorded_bytes(const SampleRun& run) {
  const TemporaryFolder folder;
  run.record(folder.file("run.mcap"));
  return bytes_in(folder.file("run.mcap"));
}

/// When each topic of such a file was written, in order [frames].
inline std::map<std::string, std::vector<std::uint64_t>> writings(const Bytes& recording) {
  const McapReader mcap{recording};
  std::map<std::string, std::vector<std::uint64_t>> times;
  mcap.for_each_message([&](const McapReader::Message& m) {
    times[mcap.channels().at(m.channel).topic].push_back(m.time / 100'000'000);
  });
  return times;
}

/// How often writing a run allocates from a frame on.
inline long allocations_from(std::size_t first, const SampleRun& run) {
  const TemporaryFolder folder;
  RecordingWriter writer{folder.file("run.mcap"), run.info};
  for (std::size_t i = 0; i < first; ++i) writer.write(run.frame(i));
  long allocated = 0;
  for (std::size_t i = first; i < run.size(); ++i) {
    const Frame frame = run.frame(i);
    const long before = allocation_count();
    writer.write(frame);
    allocated += allocation_count() - before;
  }
  return allocated;
}

/// What a checker has found when it has seen a run, or the first frames of it.
inline HashChecker checked(const Recording& recording, const SampleRun& run,
                           std::size_t frame_count = std::numeric_limits<std::size_t>::max()) {
  HashChecker checker{recording};
  for (std::size_t i = 0; i < std::min(frame_count, run.size()); ++i) checker.write(run.frame(i));
  return checker;
}

}  // namespace fairway::testing
