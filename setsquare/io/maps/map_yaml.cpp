// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/maps/map_yaml.hpp"

#include <fmt/core.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/decimal_number.hpp"
#include "setsquare/io/bytes/shortest_number.hpp"

namespace setsquare {
namespace {

/// What a cell of a map of a place can measure.
bool is_resolution(double resolution_m) {
  constexpr double kFinest_m = 1e-4;
  constexpr double kCoarsest_m = 1e3;
  return resolution_m >= kFinest_m && resolution_m <= kCoarsest_m;
}

/// Takes the entries of the file's one mapping.
class MapYamlReader {
 public:
  MapYamlReader(const YAML::Node& root, const std::string& name) : root_(root), name_(name) {}

  [[nodiscard]] MapYaml read() const;

 private:
  [[noreturn]] void complain(const YAML::Mark& mark, const std::string& reason) const {
    const std::string line = mark.is_null() ? "" : fmt::format("line {}", mark.line + 1);
    throw FormatError(name_, line, reason);
  }
  /// Of a key that has lost its length: yaml-cpp is compiled again for each length.
  [[nodiscard]] YAML::Node entry(const char* key) const { return root_[key]; }
  [[nodiscard]] YAML::Node required(const char* key) const {
    const YAML::Node node = entry(key);
    if (!node) complain(YAML::Mark::null_mark(), fmt::format("{} is missing", key));
    return node;
  }
  [[nodiscard]] double number(const YAML::Node& node, const char* key) const {
    // Not by yaml-cpp, whose streams follow the program's locale.
    const auto value = node.IsScalar() ? decimal_from_text(node.Scalar()) : std::nullopt;
    if (!value || !std::isfinite(*value)) {
      complain(node.Mark(), fmt::format("{} must be a number", key));
    }
    return *value;
  }
  void read_origin(MapYaml& map) const;
  void read_thresholds(MapYaml& map) const;
  void read_negate(MapYaml& map) const;
  void read_mode(MapYaml& map) const;

  const YAML::Node& root_;
  const std::string& name_;
};

void MapYamlReader::read_origin(MapYaml& map) const {
  const YAML::Node origin = required("origin");
  if (!origin.IsSequence() || origin.size() != 3) {
    complain(origin.Mark(), "origin must be [x, y, yaw]");
  }
  std::array<double, 3> numbers{};
  std::size_t k = 0;
  for (const YAML::Node& node : origin) numbers[k++] = number(node, "origin");
  map.T_map_grid = {numbers[0], numbers[1], numbers[2]};
}

void MapYamlReader::read_thresholds(MapYaml& map) const {
  const YAML::Node occupied = entry("occupied_thresh");
  const YAML::Node free = entry("free_thresh");
  if (occupied) map.occupied_threshold = number(occupied, "occupied_thresh");
  if (free) map.free_threshold = number(free, "free_thresh");
  if (map.free_threshold < 0.0 || map.occupied_threshold > 1.0 ||
      map.free_threshold >= map.occupied_threshold) {
    complain((free ? free : occupied).Mark(),
             "free_thresh must be below occupied_thresh, both from 0 to 1");
  }
}

void MapYamlReader::read_negate(MapYaml& map) const {
  const YAML::Node negate = entry("negate");
  if (!negate) return;
  const std::string_view word = negate.IsScalar() ? std::string_view(negate.Scalar()) : "";
  map.is_negated = word == "1" || word == "true";
  if (!map.is_negated && word != "0" && word != "false") {
    complain(negate.Mark(), "negate must be 0 or 1");
  }
}

void MapYamlReader::read_mode(MapYaml& map) const {
  const YAML::Node mode = entry("mode");
  if (!mode) return;
  const std::string_view word = mode.IsScalar() ? std::string_view(mode.Scalar()) : "";
  if (word == "trinary") {
    map.mode = MapMode::kTrinary;
  } else if (word == "scale") {
    map.mode = MapMode::kScale;
  } else if (word == "raw") {
    map.mode = MapMode::kRaw;
  } else {
    complain(mode.Mark(), "mode must be trinary, scale or raw");
  }
}

MapYaml MapYamlReader::read() const {
  if (!root_.IsMap()) complain(YAML::Mark::null_mark(), "not the yaml file of a map");
  MapYaml map;
  const YAML::Node image = required("image");
  if (!image.IsScalar() || image.Scalar().empty()) {
    complain(image.Mark(), "image must be a file's name");
  }
  map.image = image.Scalar();
  const YAML::Node resolution = required("resolution");
  map.resolution_m = number(resolution, "resolution");
  if (!is_resolution(map.resolution_m)) {
    complain(resolution.Mark(), "resolution must be from 0.0001 to 1000 m");
  }
  read_origin(map);
  read_thresholds(map);
  read_negate(map);
  read_mode(map);
  return map;
}

/// The fewest digits that give the number back.
std::string shortest(double value) {
  std::string text;
  append_shortest(text, value == 0.0 ? 0.0 : value);
  return text;
}

/// A plain word where the letters allow it, else yaml's double quotes.
std::string quoted_where_needed(const std::string& text) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '/' || c == '_' || c == '-';
  };
  const bool starts_well = text.front() != '-' && text.front() != '.';
  if (starts_well && std::ranges::all_of(text, is_plain)) return text;
  YAML::Emitter emitter;
  emitter << YAML::DoubleQuoted << text;
  return emitter.c_str();
}

}  // namespace

MapYaml map_yaml_from_text(const std::string& text, const std::string& name) {
  try {
    const YAML::Node root = YAML::Load(text);
    return MapYamlReader(root, name).read();
  } catch (const YAML::Exception& error) {
    const std::string line =
        error.mark.is_null() ? "" : fmt::format("line {}", error.mark.line + 1);
    throw FormatError(name, line, error.msg);
  }
}

std::string text_from_map_yaml(const MapYaml& map) {
  const double numbers[] = {map.resolution_m,
                            map.T_map_grid.x_m,
                            map.T_map_grid.y_m,
                            map.T_map_grid.theta_rad,
                            map.occupied_threshold,
                            map.free_threshold};
  for (const double number : numbers) {
    if (!std::isfinite(number)) throw ParameterError("MapYaml", "must hold finite numbers only");
  }
  if (map.image.empty()) throw ParameterError("image", "must be a file's name");
  if (!is_resolution(map.resolution_m)) {
    throw ParameterError("resolution_m", "must be from 0.0001 to 1000 m");
  }
  if (!(map.free_threshold >= 0.0 && map.free_threshold < map.occupied_threshold &&
        map.occupied_threshold <= 1.0)) {
    throw ParameterError("free_threshold", "must be below occupied_threshold, both from 0 to 1");
  }
  const char* const mode = map.mode == MapMode::kTrinary ? "trinary"
                           : map.mode == MapMode::kScale ? "scale"
                                                         : "raw";
  return fmt::format(
      "image: {}\nmode: {}\nresolution: {}\norigin: [{}, {}, {}]\nnegate: {}\noccupied_thresh: {}\n"
      "free_thresh: {}\n",
      quoted_where_needed(map.image),
      mode,
      shortest(map.resolution_m),
      shortest(map.T_map_grid.x_m),
      shortest(map.T_map_grid.y_m),
      shortest(map.T_map_grid.theta_rad),
      map.is_negated ? 1 : 0,
      shortest(map.occupied_threshold),
      shortest(map.free_threshold));
}

}  // namespace setsquare
