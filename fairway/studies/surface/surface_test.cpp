// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/surface/surface.hpp"

#include <gtest/gtest.h>

#include "fairway/experiment/measure_run.hpp"
#include "fairway/studies/surface/findings.hpp"
#include "fairway/studies/surface/zones.hpp"

namespace fairway::surface {
namespace {

const Method& method(std::string_view name) { return *std::ranges::find(all_methods(), name, &Method::name); }

/// One run of a method on a course as proposed.
Cell sailed(Course course, Vessel vessel, std::string_view name, std::uint64_t seed = 1) {
  Layout layout = layout_of(course);
  if (vessel == Vessel::at_once) layout.water = {};
  Cell cell{.place = std::string(name_of(course)), .method = std::string(name), .mode = "test"};
  cell.results = {measure_run(passage(course, layout, vessel, method(name), seed), builtin_catalogs())};
  return cell;
}

double time_of(const Cell& cell) { return cell.value(0, "navigation_time_s"); }

TEST(SurfaceCourse, AVariationIsThatOfItsSeed) {
  for (const Course course : courses) {
    const Layout one = varied(course, 7), again = varied(course, 7), other = varied(course, 8);
    EXPECT_EQ(one.buoys, again.buoys);
    EXPECT_EQ(one.water.current_n, again.water.current_n);
    EXPECT_NE(one.buoys, other.buoys);
    EXPECT_EQ(one.vessel.has_value(), layout_of(course).vessel.has_value());
  }
}

TEST(SurfaceCourse, NobodyBeginsInABuoy) {
  std::size_t buoys = 0;
  for (const Course course : courses) {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
      const Layout layout = varied(course, seed);
      for (const ObstacleSpec& spec : layout.obstacles()) {
        EXPECT_GT((spec.position - layout.start).norm(), spec.radius + vessel_radius + 0.25);
        EXPECT_GT((spec.position - goal).norm(), spec.radius + vessel_radius);
        ++buoys;
      }
    }
  }
  EXPECT_GT(buoys, 500U * std::size(courses));
}

TEST(SurfaceStudy, AvoaTakesThePublishedTimesOnTheOpenCourses) {
  for (const Vessel vessel : vessels) {
    for (const Course course : {Course::cluttered, Course::orthogonal, Course::diagonal}) {
      const Cell cell = sailed(course, vessel, "avoa");
      EXPECT_TRUE(succeeded(cell, 0)) << name_of(course);
      const double printed = *published(course, "avoa", "navigation_time_s");
      EXPECT_NEAR(time_of(cell), printed, 0.15 * printed) << name_of(course);
    }
  }
}

TEST(SurfaceStudy, AvoaImprovedComesOutOfEveryU) {
  for (const Course course : {Course::u_wall, Course::u_narrow, Course::u_deep}) {
    const Cell cell = sailed(course, Vessel::zarco, "avoa_improved");
    EXPECT_TRUE(succeeded(cell, 0)) << name_of(course);
    EXPECT_LT(time_of(cell), 35.0) << name_of(course);
  }
}

TEST(SurfaceStudy, TebTakesThePublishedTimesAtItsDefaultSpeedAlone) {
  for (const Course course : {Course::orthogonal, Course::diagonal}) {
    const double printed = *published(course, "teb_0.4", "navigation_time_s");
    EXPECT_NEAR(time_of(sailed(course, Vessel::zarco, "teb_0.4")), printed, 0.15 * printed);
    EXPECT_LT(time_of(sailed(course, Vessel::zarco, "teb_1.5_dynamic")), 0.5 * printed);
  }
}

TEST(SurfaceStudy, TebCollidesHeadOnAsPublished) {
  EXPECT_TRUE(touched(sailed(Course::head_on, Vessel::zarco, "teb_0.4"), 0));
}

TEST(SurfaceStudy, AgreementIsUnderAnAssumption) {
  const std::vector<Cell> cells{sailed(Course::diagonal, Vessel::zarco, "avoa")};
  const std::vector<StudyRow> rows = published_rows(cells);
  EXPECT_GT(std::ranges::count(rows, Verdict::reproduced_assuming, &StudyRow::verdict), 0);
  EXPECT_EQ(std::ranges::count(rows, Verdict::reproduced, &StudyRow::verdict), 0);
}

TEST(SurfaceStudy, EveryZoneFigureIsDrawn) {
  const auto figures = zone_figures();
  ASSERT_EQ(figures.size(), 3U);
  for (const nlohmann::json& figure : figures) {
    ASSERT_FALSE(figure["blocks"].empty());
    for (const nlohmann::json& block : figure["blocks"]) {
      ASSERT_EQ(block["kind"], "raster") << block;
      EXPECT_EQ(block["rgb"].get<std::string>().size(), 6U * 101 * 101);
    }
  }
}

}  // namespace
}  // namespace fairway::surface
