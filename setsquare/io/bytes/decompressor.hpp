// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// One face for the four libraries that unpack bytes: for whole files (unpacking_source) and for the
// chunks of recordings (block_unpacker).
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace setsquare {

enum class Packing {
  kGzip,   ///< RFC 1952.
  kBzip2,  ///< As the command bzip2 writes it.
  kLz4,    ///< LZ4's frame format.
  kZstd,   ///< RFC 8878.
};

inline constexpr std::array kPackings = {
    Packing::kGzip, Packing::kBzip2, Packing::kLz4, Packing::kZstd};

/// "gzip", "bzip2", "lz4", "zstd".
[[nodiscard]] std::string_view name_of(Packing packing);

/// How many bytes packing_at() looks at.
inline constexpr std::size_t kMagicBytes = 4;

/// How bytes that begin like this are packed; nothing where they are not.
[[nodiscard]] std::optional<Packing> packing_at(std::string_view beginning);

/// Unpacks one frame (member, stream) piece by piece. All it has allocated is used again for the
/// next frame.
class Decompressor {
 public:
  enum class Outcome {
    kGoesOn,    ///< It wants more packed bytes, or more room.
    kFrameEnd,  ///< Call begin_frame() before the next step.
    kCorrupt,   ///< reason() says why; the frame cannot be unpacked further.
  };

  struct Step {
    std::size_t num_taken = 0;  ///< Packed bytes used.
    std::size_t num_given = 0;  ///< Unpacked bytes written.
    Outcome outcome = Outcome::kGoesOn;
  };

  virtual ~Decompressor() = default;

  /// Forgets the frame before.
  virtual void begin_frame() = 0;

  /// Unpacks as much of `packed` as fits into `bytes`. A step that meets damage may give less than
  /// what stood before it: small steps come nearer.
  [[nodiscard]] virtual Step unpack(std::string_view packed, std::span<char> bytes) = 0;

  /// What the library says of kCorrupt; may be empty.
  [[nodiscard]] virtual std::string reason() const { return {}; }
};

/// Ready for its first frame.
[[nodiscard]] std::unique_ptr<Decompressor> make_decompressor(Packing packing);

}  // namespace setsquare
