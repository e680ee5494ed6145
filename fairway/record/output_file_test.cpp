// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/output_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>
#include <memory>
#include <vector>

#include "fairway/core/error.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/core/testing/temporary_folder.hpp"

namespace fairway {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string bytes_of(const std::string& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator{folder}, fs::directory_iterator{}));
}

std::string refusal(const std::string& path) {
  return refusal_by([&] { write_file(path, "new"); });
}

class OutputFileTest : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string path_ = folder_.file("out.txt");
};

TEST_F(OutputFileTest, AppearsWhenItIsCommittedAndLeavesNothingBeside) {
  OutputFile file{path_};
  file.stream() << "one" << std::flush;
  EXPECT_FALSE(fs::exists(path_));
  EXPECT_EQ(bytes_of(file.part()), "one");
  EXPECT_THAT(file.part(), StartsWith(path_ + "."));
  file.stream() << std::string(200'000, 'x');
  file.commit();
  file.commit();
  EXPECT_EQ(bytes_of(path_), "one" + std::string(200'000, 'x'));
  EXPECT_EQ(files_in(folder_.file(".")), 1U);
}

TEST_F(OutputFileTest, WithoutACommitTheFormerFileIsAsItWas) {
  write_file(path_, "old");
  {
    OutputFile file{path_};
    file.stream() << "new";
  }
  EXPECT_EQ(bytes_of(path_), "old");
  EXPECT_EQ(files_in(folder_.file(".")), 1U);
}

TEST_F(OutputFileTest, AKilledProcessLeavesTheFormerFile) {
  write_file(path_, "old");
  const pid_t pid = ::fork();
  if (pid == 0) {
    OutputFile file{path_};
    file.stream() << "new" << std::flush;
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(pid, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(bytes_of(path_), "old");
}

TEST_F(OutputFileTest, RemovePartsRemovesWhatIsNotInItsPlaceYet) {
  write_file(path_, "old");
  std::vector<std::unique_ptr<OutputFile>> begun;
  for (int i = 0; i < 3; ++i) begun.push_back(std::make_unique<OutputFile>(path_));
  const std::string abandoned = begun.front()->part();
  begun.erase(begun.begin());
  std::ofstream{abandoned} << "of somebody else";
  remove_parts();
  for (const auto& file : begun) EXPECT_FALSE(fs::exists(file->part()));
  EXPECT_EQ(bytes_of(path_), "old");
  EXPECT_EQ(bytes_of(abandoned), "of somebody else");
}

TEST_F(OutputFileTest, MoreThanAreListedAreWrittenAllTheSame) {
  std::vector<std::unique_ptr<OutputFile>> begun;
  for (int i = 0; i < 100; ++i)
    begun.push_back(std::make_unique<OutputFile>(folder_.file(std::to_string(i))));
  for (const auto& file : begun) file->commit();
  remove_parts();
  EXPECT_EQ(files_in(folder_.file(".")), 100U);
}

TEST_F(OutputFileTest, TwoOfOneNameDoNotMix) {
  OutputFile a{path_};
  OutputFile b{path_};
  a.stream() << "aaa";
  b.stream() << "b";
  b.commit();
  EXPECT_EQ(bytes_of(path_), "b");
  a.commit();
  EXPECT_EQ(bytes_of(path_), "aaa");
}

TEST_F(OutputFileTest, ALinkStaysOneAndItsTargetIsReplaced) {
  fs::create_directory(folder_.file("elsewhere"));
  fs::create_symlink("elsewhere/real.txt", path_);
  write_file(path_, "through a link that led to nothing");
  write_file(path_, "again");
  EXPECT_TRUE(fs::is_symlink(path_));
  EXPECT_EQ(bytes_of(folder_.file("elsewhere/real.txt")), "again");
}

TEST_F(OutputFileTest, KeepsTheRightsOfTheFileThatItReplaces) {
  write_file(path_, "old");
  ::chmod(path_.c_str(), 0640);
  write_file(path_, "new");
  EXPECT_EQ(fs::status(path_).permissions(), fs::perms{0640});
}

TEST_F(OutputFileTest, APipeGetsTheBytesAndStaysAPipe) {
  const std::string pipe = folder_.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  auto reader = std::async(std::launch::async, [&] { return bytes_of(pipe); });
  write_file(pipe, "through");
  EXPECT_EQ(reader.get(), "through");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(OutputFileTest, ADeviceStaysADevice) {
  write_file("/dev/null", "nobody reads it");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(OutputFileTest, AFullDiskIsAnErrorAndNotAShortFile) {
  OutputFile file{"/dev/full"};
  file.stream() << std::string(100'000, 'x');
  EXPECT_THROW(file.check(), InputError);
  EXPECT_THROW(file.commit(), InputError);
  EXPECT_EQ(refusal("/dev/full"), "/dev/full: cannot be written: No space left on device");
}

TEST_F(OutputFileTest, WhatCannotBeReadToTheEndReplacesNothing) {
  write_file(path_, "old");
  OutputFile file{path_};
  std::ifstream unreadable{folder_.file("."), std::ios::binary};
  file.stream() << "half" << unreadable.rdbuf();
  EXPECT_THROW(file.commit(), InputError);
  EXPECT_EQ(bytes_of(path_), "old");
}

TEST_F(OutputFileTest, PlacesWhereNoFileCanBeAreRefused) {
  write_file(path_, "old");
  EXPECT_THAT(refusal(folder_.file("none/a.txt")),
              HasSubstr("none/a.txt: cannot be written: No such file or directory"));
  EXPECT_THAT(refusal(path_ + "/a.txt"), HasSubstr("cannot be written: Not a directory"));
  EXPECT_THAT(refusal(folder_.file(".")), HasSubstr("cannot be written: Is a directory"));
  EXPECT_EQ(bytes_of(path_), "old");
}

}  // namespace
}  // namespace fairway
