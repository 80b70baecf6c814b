// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// To begin a new format: raise kFormat (sections.hpp), and let for_each_section() give older
// formats the sections that they had; the files in tests/io/map_files say whether they are read.
#include "setsquare/io/map_file/map_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/core/save_file.hpp"
#include "setsquare/io/bytes/seekable_file.hpp"
#include "setsquare/io/map_file/fields.hpp"
#include "setsquare/io/map_file/sections.hpp"

namespace setsquare {

namespace map_file {

/// Map::kept_scans with each scan once, whoever shares it.
struct KeptTable {
  struct Entry {
    std::size_t index = 0;  ///< Of Map::scans.
    std::size_t scan = 0;   ///< Of the table's scans.
  };
  std::vector<std::shared_ptr<const Scan>> scans;
  std::vector<Entry> kept;
};

/// Where the track departs from the odometry (MotionCovariance), which it seldom does.
struct Departure {
  std::size_t keyframe = 0;
  double sigma_m = 0.0;
  double sigma_rad = 0.0;
};

/// What a file holds in another form than the map does.
struct Tables {
  KeptTable kept;
  std::vector<Departure> departures;
};

template <typename Archive>
void describe(Archive& archive, Is<KeptTable::Entry> auto& entry) {
  auto& [index, scan] = entry;
  archive(index, scan);
}

template <typename Archive>
void describe(Archive& archive, Is<Departure> auto& departure) {
  auto& [keyframe, sigma_m, sigma_rad] = departure;
  archive(keyframe, sigma_m, sigma_rad);
}

}  // namespace map_file

namespace {

using map_file::Departure;
using map_file::FieldReader;
using map_file::FieldWriter;
using map_file::KeptTable;
using map_file::Section;
using map_file::Sections;
using map_file::Tables;

KeptTable table_of(const std::vector<KeptScan>& kept_scans) {
  KeptTable table;
  std::unordered_map<const Scan*, std::size_t> places;
  for (const KeptScan& kept : kept_scans) {
    const auto [place, is_new] = places.try_emplace(kept.scan.get(), table.scans.size());
    if (is_new) table.scans.push_back(kept.scan);
    table.kept.push_back({kept.index, place->second});
  }
  return table;
}

/// Nothing is returned where an entry names no scan.
std::optional<std::vector<KeptScan>> kept_scans_of(const KeptTable& table) {
  std::vector<KeptScan> kept_scans;
  kept_scans.reserve(table.kept.size());
  for (const auto& [index, scan] : table.kept) {
    if (scan >= table.scans.size()) return std::nullopt;
    kept_scans.push_back({index, table.scans[scan]});
  }
  return kept_scans;
}

std::vector<Departure> departures_of(const MapTrack& track) {
  std::vector<Departure> departures;
  for (std::size_t k = 0; k < track.motions.size(); ++k) {
    const MotionCovariance& motion = track.motions[k].covariance;
    if (motion.departure_sigma_m == 0.0 && motion.departure_sigma_rad == 0.0) continue;
    departures.push_back({k, motion.departure_sigma_m, motion.departure_sigma_rad});
  }
  return departures;
}

/// False where one is of a keyframe that the track does not have.
bool add_departures(const std::vector<Departure>& departures, MapTrack& track) {
  for (const auto& [keyframe, sigma_m, sigma_rad] : departures) {
    if (keyframe >= track.motions.size()) return false;
    MotionCovariance& motion = track.motions[keyframe].covariance;
    motion.departure_sigma_m = sigma_m;
    motion.departure_sigma_rad = sigma_rad;
  }
  return true;
}

/// Sections that a map may do without: it cannot be gone on with then, or there is nothing to tell.
constexpr std::array<std::string_view, 4> kOptional{"SESS", "DEPA", "FORG", "GAPS"};
/// Sections that programs which do not know them may leave out.
constexpr std::array<std::string_view, 3> kSkippable{"DEPA", "FORG", "GAPS"};

/// The sections in their order, and what is in each; the kept scans stand in their table.
template <typename SomeMap, typename SomeRecord, typename SomeTables, typename Visit>
void for_each_section(SomeMap& map, SomeRecord& record, SomeTables& tables, const Visit& visit) {
  auto& [scans,
         keyframes,
         headings,
         frames,
         pieces,
         sessions,
         track,
         closures,
         open_stretches,
         undecided_turns,
         scanners,
         gyro,
         odometry,
         sweep,
         num_with_odometry,
         num_forgotten,
         forgotten_poses,
         graph,
         kept_scans,
         audit,
         doubts] = map;
  static_cast<void>(kept_scans);
  visit("RUNS", record);
  visit("POSE", scans);
  visit("KEYS", keyframes, headings, frames);
  visit("TRAC", pieces, open_stretches, undecided_turns);
  visit("SESS", sessions, track);
  visit("CLOS", closures);
  visit("GRAF", graph);
  visit("SENS", scanners, gyro, odometry, sweep, num_with_odometry);
  visit("AUDI", audit, doubts);
  // Written where there is something to tell: other maps are as before.
  if (!std::is_const_v<SomeMap> || !tables.departures.empty()) visit("DEPA", tables.departures);
  if (!std::is_const_v<SomeMap> || num_forgotten > 0) visit("FORG", num_forgotten);
  if (!std::is_const_v<SomeMap> || !forgotten_poses.empty()) visit("GAPS", forgotten_poses);
  visit("SCAN", tables.kept.scans, tables.kept.kept);
}

/// The sections of a file, each to be taken once.
class UnreadSections {
 public:
  UnreadSections(Sections file, const std::string& name)
      : sections_(std::move(file.sections)), name_(name) {}

  [[nodiscard]] bool holds(const char* id) const {
    return std::ranges::find(sections_, id, &Section::id) != sections_.end();
  }

  /// Reads the fields of a section. Throws FormatError where it is not there or is not what it
  /// should be.
  template <typename... Fields>
  void read(const char* id, Fields&... fields) {
    const auto found = std::ranges::find(sections_, id, &Section::id);
    if (found == sections_.end()) fail(fmt::format("has no section {}", id));
    FieldReader reader(found->bytes);
    reader(fields...);
    if (const std::string fault = reader.fault(); !fault.empty()) {
      fail(fmt::format("section {} holds {}", id, fault));
    }
    sections_.erase(found);
  }

  /// Throws FormatError where one is left that is required, or was read already.
  void require_none_left(const auto& is_known) const {
    for (const Section& section : sections_) {
      if (is_known(section.id)) fail(fmt::format("has section {} twice", section.id));
      if (section.is_required) {
        fail(fmt::format("has a section {} that this Setsquare does not know: a newer one wrote it",
                         section.id));
      }
    }
  }

  [[noreturn]] void fail(const std::string& reason) const { throw FormatError(name_, "", reason); }

 private:
  std::vector<Section> sections_;
  const std::string& name_;
};

std::string bytes_of_regular_file(const std::string& path) {
  const SeekableFile file(path);
  std::string bytes(file.size(), '\0');
  bytes.resize(file.read_at(0, bytes));
  return bytes;
}

}  // namespace

std::string map_file_at(const std::string& path) {
  const std::filesystem::path named(path);
  std::error_code ignored;
  return std::filesystem::is_directory(named, ignored) ? (named / kMapFileName).string() : path;
}

std::string map_file_bytes(const Map& map, const MapRecord& record) {
  const Tables tables{table_of(map.kept_scans), departures_of(map.track)};
  std::size_t num_sections = 0;
  for_each_section(
      map, record, tables, [&](const char* /*id*/, const auto&... /*fields*/) { ++num_sections; });
  map_file::SectionsWriter file(num_sections);
  for_each_section(map, record, tables, [&](const char* id, const auto&... fields) {
    FieldWriter writer;
    writer(fields...);
    const bool is_required = std::ranges::find(kSkippable, id) == kSkippable.end();
    file.add({id, is_required, writer.take()});
  });
  return file.take();
}

void save_map_file(const Map& map, const std::string& path, const MapRecord& record) {
  save_file(path, map_file_bytes(map, record));
}

SavedMap map_from_bytes(std::string_view bytes, const std::string& name) {
  UnreadSections sections(map_file::sections_from_bytes(bytes, name), name);
  SavedMap saved;
  Tables tables;
  std::vector<std::string> known;
  for_each_section(saved.map, saved.record, tables, [&](const char* id, auto&... fields) {
    known.emplace_back(id);
    if (std::ranges::find(kOptional, id) != kOptional.end() && !sections.holds(id)) return;
    sections.read(id, fields...);
  });
  sections.require_none_left(
      [&](const std::string& id) { return std::ranges::find(known, id) != known.end(); });
  auto kept_scans = kept_scans_of(tables.kept);
  if (!kept_scans) sections.fail("section SCAN names a scan that it does not hold");
  saved.map.kept_scans = std::move(*kept_scans);
  if (!add_departures(tables.departures, saved.map.track)) {
    sections.fail("section DEPA names a keyframe that the track does not have");
  }
  try {
    validate(saved.map);
  } catch (const ParameterError& error) {
    sections.fail(std::string("holds no map: ") + error.what());
  }
  return saved;
}

SavedMap load_map_file(const std::string& path) {
  const std::string file = map_file_at(path);
  return map_from_bytes(bytes_of_regular_file(file), file);
}

bool is_map_file(std::string_view beginning) { return beginning.starts_with(map_file::kMagic); }

}  // namespace setsquare
