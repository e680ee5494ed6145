// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/recording_info.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/core/testing/temporary_folder.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway {
namespace {

/// What check_methods() says of a recording by `program`, whose vehicles have `algorithm`.
std::string refusal_of(const std::string& program, const std::string& algorithm, const Catalogs& catalogs) {
  const TemporaryFolder folder;
  Scenario scenario =
      load_scenario(std::string(FAIRWAY_SOURCE_DIR) + "/scenarios/head_on.yaml", {{"duration_s", "1"}});
  for (VehicleSpec& vehicle : scenario.vehicles) vehicle.avoider = Choice{.name = algorithm};
  RecordingInfo info = recording_info(scenario);
  info.program = program;
  RecordingWriter writer{folder.file("run.mcap"), info};
  writer.close();
  const Recording recording = Recording::read(folder.file("run.mcap"));
  EXPECT_EQ(recording.info().program, program);
  return refusal_by(
      [&] { check_methods(recording, recorded_scenario(recording, "run.mcap"), catalogs, "run.mcap"); });
}

TEST(ARecordedRun, IsRefusedWhereItsMethodIsNotAndSaysWhereItIs) {
  const Catalogs catalogs = builtin_catalogs();
  EXPECT_EQ(refusal_of("fairway", "orca3d+stop_and_wait", catalogs), "accepted");
  EXPECT_EQ(refusal_of("fairway", "orca3d+saw", catalogs), "accepted");
  EXPECT_EQ(refusal_of("Python", "mine", catalogs),
            "run.mcap: the algorithm \"mine\" is not in this program; it was registered in Python: open the "
            "recording there, with fairway.explain(..., algorithms={\"mine\": ...}) or fairway.view(...)");
  EXPECT_EQ(
      refusal_of("own_method", "keep_right+stop_and_wait", catalogs),
      "run.mcap: the algorithm \"keep_right\" is not in this program; use \"own_method\", which recorded it");
  EXPECT_EQ(refusal_of("fairway", "orca3d+as_coded", catalogs),
            "run.mcap: the algorithm \"as_coded\" is not in this program; it is of a study alone, or of "
            "another version of fairway");
}

TEST(ARecordedRun, IsAcceptedWhereItsMethodIs) {
  Catalogs catalogs = builtin_catalogs();
  AlgorithmInfo info = Direct::info;
  info.name = "mine";
  catalogs.avoiders.add({.info = info, .params = {}, .make = {}, .make_around = {}});
  EXPECT_EQ(refusal_of("own_method", "mine+stop_and_wait", catalogs), "accepted");
}

}  // namespace
}  // namespace fairway
