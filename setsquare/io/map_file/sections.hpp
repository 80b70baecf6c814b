// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The container of a map file: sections of bytes with names, lengths and checksums. It does not
// know what is in them; docs/formats.md describes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace setsquare::map_file {

/// What a file begins with.
inline constexpr std::string_view kMagic = "SETSQMAP";

/// The format that is written, and the newest that is read.
inline constexpr std::uint32_t kFormat = 1;

/// Bytes of a file under a name.
struct Section {
  std::string id;           ///< Four letters.
  bool is_required = true;  ///< Who does not know it cannot read the file.
  std::string bytes;
};

struct Sections {
  std::uint32_t format = kFormat;
  std::vector<Section> sections;
};

/// Makes a file section by section, so that one at a time takes memory. What packs well is packed.
class SectionsWriter {
 public:
  SectionsWriter(std::size_t num_sections, std::uint32_t format = kFormat);
  void add(const Section& section);
  /// The file, when all have been added.
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// A file of these sections.
[[nodiscard]] std::string bytes_from_sections(const Sections& file);

/// The sections of a file, in its order, all checksums right and nothing behind them. Throws
/// FormatError with `name` where the bytes are no such file, are damaged, or of a newer format.
[[nodiscard]] Sections sections_from_bytes(std::string_view bytes, const std::string& name);

}  // namespace setsquare::map_file
