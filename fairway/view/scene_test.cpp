// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "fairway/core/error.hpp"
#include "fairway/core/testing/temporary_folder.hpp"
#include "fairway/dynamics/catalog.hpp"
#include "fairway/view/playback.hpp"
#include "fairway/view/scene_hull.hpp"
#include "fairway/view/testing/unpack.hpp"

namespace fairway {
namespace {

using nlohmann::json;
using testing::shipped;

/// True if nothing in it would become a null by not being finite.
bool all_finite(const json& value) {
  if (value.is_number_float()) return std::isfinite(value.get<double>());
  if (!value.is_structured()) return true;
  return std::ranges::all_of(value, all_finite);
}

TEST(Scene, OfEveryShippedScenarioIsWholeAndFinite) {
  std::size_t scenarios = 0, obstacles = 0, waves = 0, sonars = 0, currents = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{FAIRWAY_SOURCE_DIR "/scenarios"}) {
    if (entry.is_directory()) continue;
    const Scenario scenario = load_scenario(entry.path().string());
    const json scene = scene_of(scenario);
    EXPECT_TRUE(all_finite(scene)) << entry.path();
    EXPECT_EQ(json::parse(scene.dump()), scene) << entry.path();
    ASSERT_EQ(scene["vehicles"].size(), scenario.vehicles.size());
    for (const json& vehicle : scene["vehicles"]) {
      EXPECT_GT(vehicle["length_m"], 0.0);
      EXPECT_GT(vehicle["beam_m"], 0.0);
    }
    ++scenarios;
    obstacles += scene["obstacles"].size();
    waves += scene["waves"].size();
    sonars += scene["sonar"].is_object() ? 1 : 0;
    currents += scene["current_depths_m"].size();
  }
  EXPECT_GE(scenarios, 30u);
  EXPECT_GT(obstacles, 10u);
  EXPECT_GT(waves, 10u);
  EXPECT_GT(sonars, 0u);
  EXPECT_GT(currents, 0u);
}

TEST(Scene, HasAHullForEveryVehicleThatComesWithFairway) {
  const VehicleCatalog catalog = builtin_vehicles();
  for (const VehicleCatalog::Entry& entry : catalog.entries()) {
    VehicleSpec spec;
    spec.model.edit().name = std::string{entry.info.name};
    const bool has_body = entry.info.name != "kinematic";
    EXPECT_EQ(hull_of(spec).shape == "point", !has_body) << entry.info.name;
  }
}

TEST(Scene, ShowsAPointAsLargeAsWhatOthersKeepClearOf) {
  VehicleSpec spec;
  spec.model.edit().name = "kinematic";
  spec.radius_m = 2.5;
  EXPECT_EQ(hull_of(spec).length, 5.0);
}

TEST(Scene, ShowsATransportSystemInItsOwnLayout) {
  VehicleSpec spec;
  spec.model.edit().name = "minerva_transport";
  EXPECT_EQ(hull_of(spec).parts.size(), 4u);
  EXPECT_NEAR(hull_of(spec).length, 2 * 2.26 + 1.44, 1e-12);
  spec.model.edit().params = {
      {"layout", 2.0}, {"layout[0].x_m", 2.0}, {"layout[1].x_m", -2.0}, {"layout[1].yaw_deg", 180.0}};
  const Hull hull = hull_of(spec);
  ASSERT_EQ(hull.parts.size(), 2u);
  EXPECT_EQ(hull.parts[1].x, -2.0);
  EXPECT_NEAR(hull.parts[1].yaw, pi, 1e-12);
  EXPECT_NEAR(hull.length, 2 * 2.0 + 1.44, 1e-12);
  EXPECT_NEAR(hull.beam, 1.0, 1e-12) << "the payload is wider than a vehicle";
}

TEST(Scene, HasTheWavesThatTheRunMeets) {
  const Scenario scenario = shipped("otter_in_waves");
  const json waves = scene_of(scenario)["waves"];
  ASSERT_FALSE(waves.empty());
  const Sea sea{scenario.water, Rng{scenario.seed}};
  const double n = 3.0, e = -4.0, t = 12.5;
  double elevation = 0.0;
  for (const json& w : waves) {
    const double along = w["direction"][0].get<double>() * n + w["direction"][1].get<double>() * e;
    elevation += w["amplitude_m"].get<double>() *
                 std::cos(w["number_radpm"].get<double>() * along - w["frequency_radps"].get<double>() * t +
                          w["phase_rad"].get<double>());
  }
  EXPECT_NEAR(elevation, sea.water_at({n, e, 0}, t).elevation, 1e-12);
}

TEST(Scene, HasTheSonarOfThePerception) {
  const json sonar = scene_of(shipped("sonar_crossing"))["sonar"];
  EXPECT_GT(sonar["max_range_m"], sonar["min_range_m"]);
  EXPECT_GT(sonar["half_field_rad"], 0.0);
  EXPECT_LE(sonar["half_field_rad"], pi / 2);
}

TEST(Playback, OnDiskHoldsItsDocument) {
  const Scenario scenario = shipped("head_on", {{"duration_s", "5"}});
  Film film{scenario};
  testing::run_scenario_into(scenario, {&film});
  const json document =
      playback_document(scenario, {"1.2.3", "fairway view </script>", scenario.step_s, {}}, &film);
  EXPECT_EQ(document["film"]["count"], film.size());
  EXPECT_EQ(document["seed"], std::to_string(scenario.seed));
  EXPECT_TRUE(document["explanation"].is_null());

  const TemporaryFolder folder;
  const std::string path = folder.file("page.html");
  write_playback(path, document);
  std::ifstream file{path, std::ios::binary};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};
  const std::string open = "<script id=\"fairway-data\" type=\"application/json\">";
  const std::size_t begin = page.find(open) + open.size();
  EXPECT_EQ(json::parse(page.substr(begin, page.find("</script", begin) - begin)), document);
}

TEST(Playback, IsRefusedWhereItCannotBe) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_playback(folder.file("nowhere/page.html"), {}), InputError);
}

TEST(Playback, OfALiveRunHasNoFilmYet) {
  const json document = playback_document(shipped("head_on"), {"1", "", 0.1, {}}, nullptr);
  EXPECT_TRUE(document["film"].is_null());
  EXPECT_EQ(document["columns"].size(), 16u);
}

}  // namespace
}  // namespace fairway
