// SPDX-License-Identifier: Apache-2.0
#include "fairway/report/page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "fairway/core/testing/refusal.hpp"

namespace fairway {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
namespace fs = std::filesystem;

std::size_t occurrences(const std::string& text, const std::string& of) {
  std::size_t count = 0;
  for (auto at = text.find(of); at != std::string::npos; at = text.find(of, at + of.size())) ++count;
  return count;
}

// What a browser would hand to JSON.parse.
std::string data_of(const std::string& page) {
  const std::string open = "<script id=\"fairway-data\" type=\"application/json\">";
  const auto from = page.find(open);
  EXPECT_NE(from, std::string::npos);
  const auto begin = from + open.size();
  return page.substr(begin, page.find("</script", begin) - begin);
}

std::string read(const fs::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

class WrittenPage : public testing::Test {
 protected:
  fs::path folder = fs::temp_directory_path() / ("fairway_page_test_" + std::to_string(::getpid()));
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }
};

TEST(PageTemplate, HasOneMarkerAndReachesForNoNetwork) {
  const std::string page = embedded::report_template();
  EXPECT_THAT(page, StartsWith("<!doctype html>"));
  EXPECT_EQ(occurrences(page, "__FAIRWAY_DATA__"), 1u);
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  for (const char* reference : {"src=\"http", "href=\"http", "url(http", "@import", "//# sourceMappingURL"}) {
    EXPECT_THAT(page, Not(HasSubstr(reference)));
  }
}

TEST(PageTemplate, IsTheFileInTheRepositoryByteForByte) {
  EXPECT_EQ(embedded::report_template(), read(fs::path{FAIRWAY_SOURCE_DIR} / "fairway/report/template.html"));
}

TEST(RenderedPage, HoldsTheDocument) {
  const std::string json = R"({"title":"Cubes \u00e0 20 m","sections":[]})";
  const std::string page = render_page(json);
  EXPECT_EQ(data_of(page), json);
  EXPECT_EQ(page.size(), embedded::report_template().size() - 16 + json.size());  // 16: the marker
}

TEST(RenderedPage, CannotBeLeftByTextInTheDocument) {
  const nlohmann::json document = {{"title", "</script><script>alert(1)</script>"},
                                   {"subtitle", "<!-- <script> \\</ <</ <"},
                                   {"version", "__FAIRWAY_DATA__"},
                                   {"<!--</key", "<"}};
  const std::string page = render_page(document.dump());
  const std::string data = data_of(page);
  EXPECT_THAT(data, Not(HasSubstr("</")));
  EXPECT_THAT(data, Not(HasSubstr("<!")));
  EXPECT_EQ(nlohmann::json::parse(data), document);
}

TEST_F(WrittenPage, IsTheRenderedOneAndLeavesNothingBesideIt) {
  const fs::path path = folder / "report.html";
  write_page(R"({"title":"first"})", path.string());
  write_page(R"({"title":"second"})", path.string());
  EXPECT_EQ(read(path), render_page(R"({"title":"second"})"));
  EXPECT_EQ(std::distance(fs::directory_iterator{folder}, fs::directory_iterator{}), 1);
}

TEST_F(WrittenPage, IsRefusedWithTheReasonWhereItCannotBe) {
  for (const fs::path& path : {folder / "absent" / "report.html", folder}) {
    EXPECT_THAT(refusal_by([&] { write_page("{}", path.string()); }),
                StartsWith(path.string() + ": cannot be written: "));
  }
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace fairway
