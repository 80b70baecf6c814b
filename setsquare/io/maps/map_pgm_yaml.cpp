// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/maps/map_pgm_yaml.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/bytes/input_buffer.hpp"
#include "setsquare/io/maps/png_image.hpp"

namespace setsquare {
namespace {

/// Probability of being occupied for a share of white (0 to 1); nothing where unknown.
std::optional<double> probability_from(double share_of_white, const MapYaml& map) {
  if (map.mode == MapMode::kRaw) {
    const double percent = std::round(255.0 * share_of_white);
    if (percent > 100.0) return std::nullopt;
    return percent / 100.0;
  }
  const double darkness = map.is_negated ? share_of_white : 1.0 - share_of_white;
  if (darkness > map.occupied_threshold) return 1.0;
  if (darkness < map.free_threshold) return 0.0;
  if (map.mode == MapMode::kTrinary) return std::nullopt;
  return (darkness - map.free_threshold) / (map.occupied_threshold - map.free_threshold);
}

// map_saver's greys. 205 is unknown by the thresholds of MapYaml: (255 - 205) / 255 = 0.19608.
constexpr std::uint16_t kOccupiedGrey = 0;
constexpr std::uint16_t kFreeGrey = 254;
constexpr std::uint16_t kUnknownGrey = 205;

float log_odds_at(double probability) {
  return static_cast<float>(std::log(probability / (1.0 - probability)));
}

float log_odds_from(std::optional<double> probability) {
  constexpr double kCertain = 0.99;
  const double p = std::clamp(probability.value_or(0.5), 1.0 - kCertain, kCertain);
  return log_odds_at(p);
}

std::string text_of(const std::string& path) {
  constexpr std::size_t kMaxYamlBytes = 1 << 20;
  InputBuffer input(open_regular_file_source(path));
  if (input.ensure(kMaxYamlBytes)) throw FormatError(path, "", "too long for a map's yaml file");
  return std::string(input.available());
}

/// A map's image, whatever it is called.
PgmImage image_at(const std::string& path) {
  constexpr std::size_t kBeginning = 8;
  InputBuffer input(open_regular_file_source(path));
  const bool has_beginning = input.ensure(kBeginning);
  return has_beginning && is_png(input.available())
             ? read_png(open_regular_file_source(path), path)
             : read_pgm(open_regular_file_source(path), path);
}

}  // namespace

OccupancyGrid grid_from_pgm_yaml(const PgmImage& image, const MapYaml& map) {
  OccupancyGrid grid(map.T_map_grid, map.resolution_m, image.width, image.height);
  // A table: an image has far fewer values than pixels.
  std::vector<float> log_odds;
  for (std::int32_t value = 0; value <= image.white; ++value) {
    log_odds.push_back(log_odds_from(
        probability_from(static_cast<double>(value) / static_cast<double>(image.white), map)));
  }
  auto value = image.values.begin();
  for (std::int32_t row = image.height - 1; row >= 0; --row) {  // the image begins at its top
    for (std::int32_t column = 0; column < image.width; ++column) {
      grid.values()[grid.index({column, row})] = log_odds[*value++];
    }
  }
  return grid;
}

OccupancyGrid read_map_pgm_yaml(const std::string& yaml_path) {
  const MapYaml map = map_yaml_from_text(text_of(yaml_path), yaml_path);
  std::filesystem::path folder = std::filesystem::path(yaml_path).parent_path();
  if (folder.empty()) folder = ".";
  const std::string image_path = (folder / map.image).string();
  return grid_from_pgm_yaml(image_at(image_path), map);
}

MapFiles map_files_from_grid(const OccupancyGrid& grid, const std::string& image_name) {
  const Pose2& T_map_grid = grid.T_map_grid();
  if (T_map_grid.theta_rad != 0.0) {
    throw ParameterError("T_map_grid", "must not be turned: a map's readers ignore its yaw");
  }
  const MapYaml map{
      .image = image_name, .resolution_m = grid.resolution_m(), .T_map_grid = T_map_grid};
  const float occupied = log_odds_at(map.occupied_threshold);
  const float free = log_odds_at(map.free_threshold);
  PgmImage image{.width = grid.num_columns(), .height = grid.num_rows(), .values = {}};
  image.values.reserve(grid.values().size());
  for (std::int32_t row = grid.num_rows() - 1; row >= 0; --row) {  // the image begins at its top
    for (std::int32_t column = 0; column < grid.num_columns(); ++column) {
      const float log_odds = grid.log_odds({column, row});
      image.values.push_back(log_odds > occupied ? kOccupiedGrey
                             : log_odds < free   ? kFreeGrey
                                                 : kUnknownGrey);
    }
  }
  return {pgm_from_image(image), text_from_map_yaml(map)};
}

}  // namespace setsquare
