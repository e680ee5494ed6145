// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/output_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

#include "fairway/core/testing/refusal.hpp"
#include "fairway/core/testing/temporary_folder.hpp"
#include "fairway/record/output_file.hpp"

namespace fairway {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr FileKind notes{.name = "a file of notes", .begins = "notes\n", .holds = "by us", .is_table = true};
constexpr FileKind page{.name = "a page", .begins = "<", .holds = ""};

class OutputCheckTest : public ::testing::Test {
 protected:
  OutputCheckTest() {
    write_file(file("notes"), "notes\nwritten by us");
    write_file(file("foreign"), "thesis");
    write_file(file("empty"), "");
  }
  std::string file(const std::string& name) const { return folder_.file(name); }

  std::string judged(const std::vector<Output>& outputs, bool force = false) const {
    const std::vector<std::string> inputs{file("notes")};
    return refusal_by([&] { check_outputs(outputs, inputs, force); });
  }
  std::string judged(const std::string& path, bool force = false) const {
    return judged({{"--out", path, notes}}, force);
  }

  TemporaryFolder folder_;
};

TEST_F(OutputCheckTest, ANewFileAnEmptyOneAndOneOfItsKindAreFine) {
  write_file(file("former"), "notes\nwritten by us");
  for (const char* name : {"new", "empty", "former"}) EXPECT_EQ(judged(file(name)), "accepted");
  EXPECT_EQ(judged(""), "accepted");
}

TEST_F(OutputCheckTest, AnInputIsRefusedByWhateverPathEvenByForce) {
  fs::create_symlink("notes", file("link"));
  fs::create_hard_link(file("notes"), file("hard"));
  fs::create_directory(file("folder"));
  for (const char* name : {"notes", "./notes", "folder/../notes", "link", "hard"}) {
    for (const bool force : {false, true})
      EXPECT_EQ(judged(file(name), force),
                "--out " + file(name) + ": is an input, too; expected another file");
  }
}

TEST_F(OutputCheckTest, AFileOfAnotherKindIsRefusedWithoutForce) {
  EXPECT_EQ(judged(file("foreign")),
            "--out " + file("foreign") +
                ": is there and is not a file of notes; expected another file, or --force to replace it");
  EXPECT_EQ(judged(file("foreign"), true), "accepted");
  write_file(file("foreign"), "notes\nby somebody");
  EXPECT_THAT(judged(file("foreign")), HasSubstr("is not a file of notes"));
  write_file(file("foreign"), "written by us, notes\n");
  EXPECT_THAT(judged(file("foreign")), HasSubstr("is not a file of notes"));
}

TEST_F(OutputCheckTest, WhatMarksAKindIsSearchedForAsFarAsTheKindSays) {
  write_file(file("late"), "notes\n" + std::string(10'000, '.') + "by us");
  EXPECT_FALSE(is_of_kind(file("late"), notes));
  FileKind long_notes = notes;
  long_notes.searched_bytes = 20'000;
  EXPECT_TRUE(is_of_kind(file("late"), long_notes));
}

TEST_F(OutputCheckTest, TwoOutputsAreTwoFiles) {
  EXPECT_THAT(judged({{"--a", file("new"), notes}, {"--b", file("./new"), notes}}),
              HasSubstr("./new: is what --a writes; expected another file"));
  EXPECT_THAT(judged({{"--a", "no_such_file", notes}, {"--b", "./no_such_file", notes}}),
              HasSubstr("is what --a writes"));
  EXPECT_EQ(judged({{"--a", "", notes}, {"--b", file("new"), notes}, {"--c", "", notes}}), "accepted");
  EXPECT_EQ(judged({{"--a", "/dev/null", notes}, {"--b", "/dev/null", notes}}), "accepted");
  EXPECT_EQ(judged({{"--a", file("new"), notes}, {"--b", file("newer"), notes}}), "accepted");
}

TEST_F(OutputCheckTest, PlacesWhereNoFileCanBeAreRefused) {
  fs::create_directory(file("folder"));
  EXPECT_THAT(judged(file("folder")), HasSubstr("folder: is a folder; expected a file to write"));
  EXPECT_THAT(judged(file("nowhere/a")), HasSubstr("nowhere/a: cannot be written: "));
  EXPECT_THAT(judged(file("nowhere/")), HasSubstr("cannot be written: there is no such folder"));
  EXPECT_THAT(judged(file("foreign/a"), true), HasSubstr("foreign is no folder"));
}

TEST_F(OutputCheckTest, PipesAndDevicesAreWrittenAndSocketsAreNot) {
  ASSERT_EQ(::mkfifo(file("pipe").c_str(), 0600), 0);
  EXPECT_EQ(judged(file("pipe")), "accepted");
  EXPECT_EQ(judged("/dev/null"), "accepted");
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{.sun_family = AF_UNIX, .sun_path = {}};
  std::strncpy(address.sun_path, file("socket").c_str(), sizeof(address.sun_path) - 1);
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  ::close(socket);
  EXPECT_THAT(judged(file("socket"), true), HasSubstr("is neither a file nor a pipe"));
}

TEST_F(OutputCheckTest, ATableMayGoToStandardOutputAndNothingElse) {
  EXPECT_EQ(judged("-"), "accepted");
  EXPECT_THAT(judged({{"--out", "-", page}}), HasSubstr("does not go to standard output"));
  write_file(file("foreign"), "thesis");
  EXPECT_TRUE(is_of_kind(file("notes"), notes));
  EXPECT_FALSE(is_of_kind(file("notes"), page));
  EXPECT_FALSE(is_of_kind(file("none"), page));
}

TEST_F(OutputCheckTest, WhatMayNotBeWrittenIsRefused) {
  write_file(file("kept"), "notes\nwritten by us");
  ::chmod(file("kept").c_str(), 0444);
  ::chmod(file(".").c_str(), 0777);
  const pid_t pid = ::fork();  // root may write everywhere, nobody may not
  if (pid == 0) {
    constexpr uid_t nobody = 65534;
    if (::geteuid() == 0 && ::setuid(nobody) != 0) ::_exit(2);
    ::_exit(judged(file("kept")) == "--out " + file("kept") + ": cannot be written: Permission denied" ? 0
                                                                                                       : 1);
  }
  int status = 0;
  ::waitpid(pid, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace fairway
