// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/tables/closures_tsv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/line_reader.hpp"
#include "setsquare/io/bytes/shortest_number.hpp"
#include "setsquare/io/bytes/text_beginning.hpp"
#include "setsquare/io/bytes/text_scanner.hpp"
#include "setsquare/io/logs/record_stream.hpp"

namespace setsquare {
namespace {

constexpr std::string_view kHeader =
    "stamp_i\tstamp_j\tx_m\ty_m\ttheta_rad\taxes\taccepted\tweight\treason";

constexpr std::array<std::pair<ClosureAxes, std::string_view>, 3> kAxesNames = {
    {{ClosureAxes::kXY, "xy"}, {ClosureAxes::kX, "x"}, {ClosureAxes::kY, "y"}}};

std::string_view name_of(ClosureAxes axes) {
  const auto is_it = [axes](const auto& entry) { return entry.first == axes; };
  return std::find_if(kAxesNames.begin(), kAxesNames.end(), is_it)->second;
}

std::optional<ClosureAxes> axes_from(std::string_view name) {
  for (const auto& [axes, axes_name] : kAxesNames) {
    if (axes_name == name) return axes;
  }
  return std::nullopt;
}

void append_row(std::string& text, const LoopClosure& closure) {
  text += to_string(closure.stamp_i) + '\t' + to_string(closure.stamp_j);
  for (const double number : {closure.T_i_j.x_m, closure.T_i_j.y_m, closure.T_i_j.theta_rad}) {
    text += '\t';
    append_shortest(text, number);
  }
  text += '\t';
  text += name_of(closure.axes);
  text += closure.is_accepted ? "\t1\t" : "\t0\t";
  append_shortest(text, closure.weight);
  text += '\t';
  for (const char c : closure.reason) text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  text += '\n';
}

std::optional<std::array<std::string_view, 9>> cells_of(std::string_view line) {
  std::array<std::string_view, 9> cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t end = line.find('\t');
    const bool is_last = i + 1 == cells.size();
    if ((end == std::string_view::npos) != is_last) return std::nullopt;
    cells[i] = line.substr(0, end);
    if (!is_last) line.remove_prefix(end + 1);
  }
  return cells;
}

std::optional<Timestamp> stamp_from(std::string_view cell) {
  const auto stamp = timestamp_from_decimal(cell);
  if (!stamp || !is_possible(*stamp)) return std::nullopt;
  return stamp;
}

std::optional<double> number_from(std::string_view cell) {
  TextScanner text(cell);
  const auto number = text.finite_number();
  return text.is_at_end() ? number : std::nullopt;
}

std::optional<LoopClosure> closure_from(std::string_view line) {
  const auto cells = cells_of(line);
  if (!cells) return std::nullopt;
  const auto stamp_i = stamp_from((*cells)[0]);
  const auto stamp_j = stamp_from((*cells)[1]);
  const auto x_m = number_from((*cells)[2]);
  const auto y_m = number_from((*cells)[3]);
  const auto theta_rad = number_from((*cells)[4]);
  const auto axes = axes_from((*cells)[5]);
  const std::string_view accepted = (*cells)[6];
  const auto weight = number_from((*cells)[7]);
  if (!stamp_i || !stamp_j || !x_m || !y_m || !theta_rad || !axes || !weight) return std::nullopt;
  if ((accepted != "0" && accepted != "1") || *weight < 0.0 || *weight > 1.0) return std::nullopt;
  return LoopClosure{*stamp_i,
                     *stamp_j,
                     {*x_m, *y_m, *theta_rad},
                     *axes,
                     accepted == "1",
                     *weight,
                     std::string((*cells)[8])};
}

FormatError not_expected(const std::string& name,
                         const LineReader& lines,
                         const std::string& what) {
  return {name, fmt::format("line {}", lines.line_number()), "expected " + what};
}

}  // namespace

std::string tsv_from_closures(std::span<const LoopClosure> closures) {
  std::string text(kHeader);
  text += '\n';
  for (const LoopClosure& closure : closures) append_row(text, closure);
  return text;
}

std::vector<LoopClosure> read_closures_tsv(std::unique_ptr<ByteSource> source,
                                           const std::string& name) {
  InputBuffer input(unpack(std::move(source)));
  begin_text(input, name);
  LineReader lines(input);
  std::vector<LoopClosure> closures;
  bool has_header = false;
  while (const auto line = lines.next()) {
    if (TextScanner(*line).is_at_end()) continue;
    if (!std::exchange(has_header, true)) {
      if (*line == kHeader) continue;
      throw not_expected(name, lines, "the header of a table of closures");
    }
    auto closure = closure_from(*line);
    if (!closure) {
      throw not_expected(
          name,
          lines,
          "\"stamp_i stamp_j x_m y_m theta_rad axes accepted weight reason\", by tabs");
    }
    closures.push_back(std::move(*closure));
  }
  const std::string damage = input.source().damage();
  if (!damage.empty()) throw FormatError(name, "", damage);
  if (!has_header) throw FormatError(name, "", "no header of a table of closures");
  return closures;
}

std::vector<LoopClosure> read_closures_tsv(const std::string& path) {
  return read_closures_tsv(open_file_source(path), path);
}

}  // namespace setsquare
