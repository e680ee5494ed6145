// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bindings/web/changing_run.hpp"
#include "fairway/metrics/run_metrics.hpp"
#include "fairway/record/hash_checker.hpp"
#include "fairway/scenario/load.hpp"
#include "fairway/view/film.hpp"

namespace fairway::web {

/// From this instant on a run has these changes too.
struct ChangeOnTheWay {
  double at_s{};
  Overrides set;
};

/// What a page has of a scenario, and changes in it.
struct Order {
  std::string yaml;
  std::string file;  ///< its name in messages and in the command
  Overrides set;
  std::optional<std::uint64_t> seed;
  std::shared_ptr<const Recording>
      recording;      ///< of which the scenario is, and with which its run is compared; or none
  bool filmed{true};  ///< to be shown; otherwise for its numbers alone
  std::vector<std::size_t> thinkers;    ///< whose thoughts are filmed, by index
  std::vector<ChangeOnTheWay> changes;  ///< ascending
};

/// The run that a recording in these bytes is of, which is compared with it. Throws InputError for what is no
/// whole recording.
Order order_of_recording(std::string_view bytes, const std::string& file);

/// A running simulation with what a page shows of it, and the hash of all frames so far.
class Session final : private FrameSink {
 public:
  /// Throws InputError, with its place in the YAML, for what cannot be simulated, and for a change that no
  /// run makes on its way.
  explicit Session(Order order);

  /// The playback's document of this run, without a film (viewer/README.md).
  nlohmann::json document() const;

  /// At most `steps`; fewer where the run ends. How many were made. O(steps). Throws InputError where a
  /// method searches by a library that is not here.
  std::size_t run(std::size_t steps);

  /// What may be moved in the scenario as it is after its last change (layout.hpp).
  nlohmann::json layout() const;

  /// {"part", "state"} as the live page's server answers: at most 500 frames from `first` on, or null where
  /// there are none. The columns of the part are apart, as bytes(). With "thoughts_anew" its thoughts are
  /// from the beginning, in place of those before.
  nlohmann::json part(std::size_t first, std::size_t generation);
  /// Of the last part.
  const std::string& bytes() const { return bytes_; }

  /// From now on the film has what these vehicles think, from the beginning. O(run so far).
  void think(std::vector<std::size_t> vehicles);

  /// What was measured so far, as `fairway run --json` prints it: {"outcome", "diverged", "fleet",
  /// "vehicles"}.
  nlohmann::json outcome() const;

  /// The bytes of the recording that `fairway run --out` writes of this run, simulated once more for it.
  /// O(run). Throws InputError for a run that is changed on its way: no scenario makes it again.
  std::string recording() const;

  /// Why a vehicle, by name, id or index, decided as it did at `time` [s]: the explanation of the playback's
  /// document. O(run). Throws InputError for a vehicle or time that there is not, and for a time after a
  /// change on the way.
  nlohmann::json explanation(std::string_view vehicle, double time) const;

  /// Of all frames so far, as a recording has it.
  std::uint64_t run_hash() const { return run_hash_; }

  /// frame_hash() of each frame so far.
  const std::vector<std::uint64_t>& frame_hashes() const { return frame_hashes_; }

  bool is_done() const { return done_; }
  double time() const { return run_.simulation().time(); }

  /// The command line that makes this run natively, up to its first change on the way.
  std::string command() const;

 private:
  void write(const Frame& frame) override;
  bool wants_tracks() const override { return false; }
  std::string divergence_text(const Simulation& simulation) const;
  void refuse_absent() const;
  std::vector<Stretch> stretches() const;
  std::string recorded() const;
  Film& begin_film();
  const Scenario& scenario() const { return stretches_.front().scenario; }

  Order order_;
  std::vector<Stretch> stretches_;
  ChangingRun run_;
  RunMetrics metrics_;
  std::optional<Film> film_;
  std::optional<HashChecker> checker_;
  std::vector<FrameSink*> sinks_;
  bool thoughts_anew_{false};
  std::string bytes_;
  std::vector<std::uint64_t> frame_hashes_;
  std::uint64_t run_hash_{};
  double last_time_{};  // of the newest frame [s]
  bool done_{false};
};

/// The names that a scenario may choose from, and the JSON schema of its keys: {"algorithms": [{"name",
/// "title", "wraps"}], "vehicles": [{"name", "title"}], "exchanges": [{"name", "title"}], "schema"}.
nlohmann::json names();

/// What `fairway describe NAME --json` says of a method, vehicle, metric or kind of exchange, perception or
/// navigation. Throws InputError for a name that there is not, with the nearest one.
nlohmann::json described(const std::string& name);

}  // namespace fairway::web
