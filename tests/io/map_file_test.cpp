// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/map_file/map_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>

#include "setsquare/core/error.hpp"
#include "setsquare/core/save_file.hpp"
#include "setsquare/io/map_file/sections.hpp"
#include "tests/io/made_map.hpp"
#include "tests/support/seed.hpp"
#include "tests/support/temporary_folder.hpp"

namespace setsquare::map_file_test {

using map_file::Section;
using map_file::Sections;
using ::testing::HasSubstr;
using testing::made_map;
using testing::text_of;

std::string bytes_of(const SavedMap& saved) { return map_file_bytes(saved.map, saved.record); }

/// What reading the bytes complains of; empty where they are a map.
std::string complaint_about(const std::string& bytes) {
  try {
    static_cast<void>(map_from_bytes(bytes, "m.setsquare"));
  } catch (const FormatError& error) {
    return error.what();
  }
  return {};
}

TEST(MapFile, EveryFieldComesBackBitForBit) {
  for (std::uint64_t seed = testing::test_seed(), i = 0; i < 50; ++i) {
    const SavedMap saved = made_map(seed + i, 1 + i);
    const std::string bytes = bytes_of(saved);
    const SavedMap loaded = map_from_bytes(bytes, "");
    ASSERT_EQ(text_of(loaded), text_of(saved)) << "seed " << seed + i;
    EXPECT_EQ(bytes_of(loaded), bytes) << "seed " << seed + i;
  }
}

TEST(MapFile, AnEmptyMapComesBack) {
  const SavedMap empty;
  EXPECT_EQ(text_of(map_from_bytes(bytes_of(empty), "")), text_of(empty));
}

TEST(MapFile, ScansThatShareTheirMemoryShareItAgain) {
  SavedMap saved = made_map(3, 30);
  auto& kept = saved.map.kept_scans;
  kept.push_back({1, kept.front().scan});
  kept.push_back({2, std::make_shared<Scan>(*kept.front().scan)});
  const SavedMap loaded = map_from_bytes(bytes_of(saved), "");
  ASSERT_EQ(loaded.map.kept_scans.size(), kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    for (std::size_t j = 0; j < kept.size(); ++j) {
      EXPECT_EQ(loaded.map.kept_scans[i].scan == loaded.map.kept_scans[j].scan,
                kept[i].scan == kept[j].scan);
    }
  }
}

TEST(MapFile, AFlippedBitAnywhereInASmallFileIsNoticed) {
  const std::string bytes = bytes_of(made_map(5, 6));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const int flips : {1 << (i % 8), 0xff}) {
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(damaged[i] ^ flips);
      ASSERT_NE(complaint_about(damaged), "") << "byte " << i << " of " << bytes.size();
    }
  }
}

TEST(MapFile, RandomBitsOfALargeFileAreNoticed) {
  auto generator = testing::make_generator();
  std::string bytes = bytes_of(made_map(testing::test_seed(), 3000));
  ASSERT_GT(bytes.size(), 300'000U);
  for (int i = 0; i < 300; ++i) {
    const std::size_t bit = generator() % (8 * bytes.size());
    const char flip = static_cast<char>(1 << (bit % 8));
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ flip);
    ASSERT_NE(complaint_about(bytes), "") << "bit " << bit << ", seed " << testing::test_seed();
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ flip);
  }
  EXPECT_EQ(complaint_about(bytes), "");
}

TEST(MapFile, TruncatedOrContinuedAnywhereIsNoticed) {
  const std::string bytes = bytes_of(made_map(5, 6));
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    ASSERT_NE(complaint_about(bytes.substr(0, length)), "") << length << " of " << bytes.size();
  }
  EXPECT_THAT(complaint_about(bytes + '\0'), HasSubstr("goes on behind its end"));
  EXPECT_THAT(complaint_about(bytes + bytes), HasSubstr("goes on behind its end"));
}

TEST(MapFile, WhatIsNoMapIsSaidInWords) {
  EXPECT_EQ(complaint_about(""), "m.setsquare: is empty");
  EXPECT_EQ(complaint_about("FLASER 180 1.0"), "m.setsquare: is no map of Setsquare");
  const std::string bytes = bytes_of(made_map(5, 6));
  EXPECT_EQ(complaint_about(bytes.substr(0, 15)), "m.setsquare: is cut short, or damaged");
  std::string damaged = bytes;
  damaged[100] = static_cast<char>(damaged[100] ^ 1);
  EXPECT_EQ(complaint_about(damaged), "m.setsquare: is damaged (section RUNS)");
  EXPECT_TRUE(is_map_file(bytes.substr(0, 8)));
  EXPECT_FALSE(is_map_file("SETSQ"));
  EXPECT_THROW(static_cast<void>(load_map_file("/nowhere/m.setsquare")), FileError);
}

/// The sections of a map, to be put together otherwise.
Sections sections_of(const SavedMap& saved) {
  return map_file::sections_from_bytes(bytes_of(saved), "");
}

std::string complaint_about(const Sections& file) {
  return complaint_about(map_file::bytes_from_sections(file));
}

TEST(MapFile, ANewerFormatIsRefusedWithAWord) {
  Sections file = sections_of(made_map(5, 6));
  file.format = 7;
  EXPECT_EQ(complaint_about(file),
            "m.setsquare: was written by a newer Setsquare (format 7; this one reads up to 1)");
}

TEST(MapFile, SectionsOfLaterVersionsAreSkippedWhereTheyAreOptional) {
  const SavedMap saved = made_map(5, 6);
  const Sections file = sections_of(saved);
  for (std::size_t place = 0; place <= file.sections.size(); ++place) {
    Sections later = file;
    const auto before = later.sections.begin() + static_cast<std::ptrdiff_t>(place);
    Section& added = *later.sections.insert(before, {"NEWS", false, std::string(1000, 'x')});
    const SavedMap loaded = map_from_bytes(map_file::bytes_from_sections(later), "");
    EXPECT_EQ(text_of(loaded), text_of(saved));
    added.is_required = true;
    EXPECT_THAT(complaint_about(later),
                HasSubstr("section NEWS that this Setsquare does not know"));
  }
}

TEST(MapFile, ASectionThatIsAbsentTwiceOrOfAnotherLengthIsNoticed) {
  const Sections file = sections_of(made_map(5, 6));
  for (std::size_t i = 0; i < file.sections.size(); ++i) {
    const std::string id = file.sections[i].id;
    Sections other = file;
    other.sections.erase(other.sections.begin() + static_cast<std::ptrdiff_t>(i));
    if (id == "SESS") {  // A map that does not tell its track is whole: it cannot be gone on with.
      EXPECT_TRUE(map_from_bytes(map_file::bytes_from_sections(other), "").map.sessions.empty());
    } else {
      EXPECT_THAT(complaint_about(other), HasSubstr("has no section " + id));
    }
    other = file;
    other.sections.push_back(file.sections[i]);
    EXPECT_THAT(complaint_about(other), HasSubstr("has section " + id + " twice"));
    other = file;
    other.sections[i].bytes += '\0';
    EXPECT_THAT(complaint_about(other), HasSubstr("section " + id + " holds too many bytes"));
    other = file;
    other.sections[i].bytes.pop_back();
    EXPECT_THAT(complaint_about(other), HasSubstr("section " + id + " holds"));
  }
}

/// A map that older programs read: its file has one section more than another, which is not
/// required.
void expect_one_more(const char* id, const Sections& than, const SavedMap& saved) {
  const Sections file = sections_of(saved);
  ASSERT_EQ(file.sections.size(), than.sections.size() + 1);
  const auto told = std::ranges::find(file.sections, id, &Section::id);
  ASSERT_NE(told, file.sections.end());
  EXPECT_FALSE(told->is_required) << "older programs read the map";
  EXPECT_EQ(text_of(map_from_bytes(map_file::bytes_from_sections(file), "")), text_of(saved));
}

TEST(MapFile, WhatWasForgottenIsToldWhereThereIsAny) {
  SavedMap saved = made_map(5, 6);
  const Sections without = sections_of(saved);
  saved.map.num_forgotten = 7;
  expect_one_more("FORG", without, saved);
}

TEST(MapFile, WherePosesWereForgottenIsToldWhereAnyWere) {
  SavedMap saved = made_map(5, 6);
  const Sections without = sections_of(saved);
  saved.map.forgotten_poses = {{.next_scan = 2, .num_scans = 70, .way_m = 3.5},
                               {.next_scan = 4, .num_scans = 1, .way_m = 0.25}};
  expect_one_more("GAPS", without, saved);
  EXPECT_EQ(text_of(saved).find("forgotten_poses[1]") == std::string::npos, false);
}

TEST(MapFile, WhereTheTrackDepartsFromTheOdometryIsToldWhereItDoes) {
  SavedMap saved = made_map(5, 6);
  const Sections without = sections_of(saved);
  MotionCovariance& motion = saved.map.track.motions.back().covariance;
  motion.departure_sigma_m = 0.4;
  motion.departure_sigma_rad = 0.2;
  expect_one_more("DEPA", without, saved);
  Sections file = sections_of(saved);
  const auto told = std::ranges::find(file.sections, "DEPA", &Section::id);
  told->bytes[8] = 77;  // The keyframe, behind the number of those that are told.
  EXPECT_THAT(complaint_about(file), HasSubstr("section DEPA names a keyframe"));
}

/// Eight bytes of every section are made a huge number, wherever they stand: counts among them.
TEST(MapFile, AnyCountInAHostileFileIsHeldAgainstWhatIsLeft) {
  const Sections file = sections_of(made_map(5, 6));
  for (const std::uint64_t huge : {~std::uint64_t{0}, std::uint64_t{1} << 40}) {
    for (std::size_t i = 0; i < file.sections.size(); ++i) {
      for (std::size_t at = 0; at + 8 <= file.sections[i].bytes.size(); ++at) {
        Sections hostile = file;
        std::memcpy(hostile.sections[i].bytes.data() + at, &huge, sizeof(huge));
        static_cast<void>(complaint_about(hostile));  // Neither a crash nor bad_alloc.
      }
    }
  }
}

TEST(MapFile, ASmallFileCannotBecomeALargeOne) {
  Sections file;
  file.sections.push_back({"POSE", true, std::string(100'000'000, '\0')});
  const std::string bytes = map_file::bytes_from_sections(file);
  EXPECT_GT(bytes.size(), 100'000'000U) << "packed to nothing it would be refused";
  EXPECT_EQ(map_file::sections_from_bytes(bytes, "").sections[0].bytes, file.sections[0].bytes);
}

TEST(MapFile, IndicesOfNothingAreRefused) {
  const auto expect_refused = [](const char* part, const auto& change) {
    SavedMap saved = made_map(5, 6);
    change(saved.map);
    EXPECT_THAT(complaint_about(bytes_of(saved)), HasSubstr(part));
  };
  const auto nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused("keyframes[0]", [](Map& map) { map.keyframes[0] = 6; });
  expect_refused("headings", [](Map& map) { map.headings.emplace_back(); });
  expect_refused("headings[0]", [](Map& map) { map.headings[0].frame = 2; });
  expect_refused("closures[1]", [](Map& map) { map.closures[1].scan_j = 6; });
  expect_refused("pieces[2]", [](Map& map) { map.pieces[2] = {5, 2, true}; });
  expect_refused("pieces[3]", [](Map& map) { map.pieces.push_back({0, 1, true}); });
  expect_refused("pieces[0]", [](Map& map) { map.pieces[0] = {5, ~std::size_t{0}, true}; });
  expect_refused("sessions[1]", [](Map& map) { map.sessions[1].first_scan = 2; });
  expect_refused("sessions[1]", [](Map& map) { map.sessions[1].num_scans = ~std::size_t{0}; });
  expect_refused("T_odom_sensor", [](Map& map) { map.track.T_odom_sensor.pop_back(); });
  expect_refused("T_odom_sensor[2]", [&](Map& map) { map.track.T_odom_sensor[2].y_m = nan; });
  expect_refused("motions", [](Map& map) { map.track.motions.emplace_back(); });
  expect_refused("open_stretches[0]", [](Map& map) { map.open_stretches[0].first_scan = 6; });
  expect_refused("undecided_turns[0]", [](Map& map) { map.undecided_turns[0].last_scan = 6; });
  expect_refused("doubts[0]", [](Map& map) { map.doubts[0].num_scans = 7; });
  expect_refused("kept_scans[0]", [](Map& map) { map.kept_scans[0].index = 6; });
  expect_refused("constraints[0]", [](Map& map) { map.graph.constraints[0].to = 4; });
  expect_refused("scans[3]", [&](Map& map) { map.scans[3].T_map_base.x_m = nan; });
  expect_refused("bearing_step_rad", [](Map& map) {
    Scan without_step;
    without_step.ranges_m = {1.0, 2.0};
    map.kept_scans[0].scan = std::make_shared<Scan>(without_step);
  });
}

/// The files there are those of made_map(seed 1, 8 scans), each written by a Setsquare that wrote
/// the format of its name. They stay for ever.
TEST(MapFile, FilesOfEveryFormatAreRead) {
  const std::filesystem::path folder = SETSQUARE_MAP_FILES;
  for (std::uint32_t format = 1; format <= map_file::kFormat; ++format) {
    const auto path = folder / ("format_" + std::to_string(format) + ".setsquare");
    EXPECT_EQ(text_of(load_map_file(path.string())), text_of(made_map(1, 8))) << path;
  }
}

TEST(MapFile, IsFoundInTheFolderOfAMap) {
  const testing::TemporaryFolder folder;
  const SavedMap saved = made_map(9, 12);
  save_map_file(saved.map, (folder.path() / kMapFileName).string(), saved.record);
  EXPECT_EQ(text_of(load_map_file(folder.path().string())), text_of(saved));
}

/// A process that saves one map file and then the other, as save_map_file() does when it has made
/// the bytes, until it is killed after so much of its own time, however busy the machine is.
pid_t save_until_killed(const std::string& path,
                        const std::string& one,
                        const std::string& other,
                        int after_us) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  std::signal(SIGPROF, [](int) { ::kill(::getpid(), SIGKILL); });
  const itimerval timer = {.it_interval = {}, .it_value = {.tv_sec = 0, .tv_usec = after_us}};
  ::setitimer(ITIMER_PROF, &timer, nullptr);
  while (true) {
    save_file(path, other);
    save_file(path, one);
  }
}

TEST(MapFile, KilledWhileItIsSavedIsTheOldOneOrTheNewOne) {
  const testing::TemporaryFolder folder;
  const std::string path = (folder.path() / kMapFileName).string();
  const std::string one = bytes_of(made_map(1, 2000));
  const std::string other = bytes_of(made_map(2, 3000));
  save_file(path, one);
  auto generator = testing::make_generator();
  std::size_t num_left_behind = 0;
  for (int i = 0; i < 40; ++i) {
    const int after_us = 1 + static_cast<int>(generator() % 30000);
    const pid_t child = save_until_killed(path, one, other, after_us);
    ASSERT_GT(child, 0);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    const std::string whole = bytes_of(load_map_file(path));
    ASSERT_TRUE(whole == one || whole == other) << "seed " << testing::test_seed();
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
      if (entry.path() == path) continue;
      ++num_left_behind;
      std::filesystem::remove(entry.path());
    }
  }
  EXPECT_GT(num_left_behind, 0U) << "not once was it killed while it wrote";
}

}  // namespace setsquare::map_file_test
