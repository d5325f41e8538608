#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace wedgesim::traces {

/// The version of the file layout and of the schema's meaning; a reader takes this one alone.
inline constexpr std::uint32_t kVersion = 1;

/// A carriage return and a line feed, so that a transfer as text is noticed.
inline constexpr std::array<char, 8> kMagic = {'W', 'T', 'R', 'A', 'C', 'E', '\r', '\n'};

/// The first 32 bytes of a trace file, little endian; the FlatBuffer (payload) follows and is the
/// rest of the file. docs/trace.md, "The file".
struct FileHeader {
  std::array<char, 8> magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t reserved = 0;
  std::uint64_t payload_bytes = 0;
  std::uint64_t checksum = 0;  // checksum_of(payload)
};
static_assert(sizeof(FileHeader) == 32);
static_assert(std::endian::native == std::endian::little, "the file's words are read in place");

/// Payloads and tables within them are aligned to this, relative to the file's begin.
inline constexpr std::size_t kPayloadAlignment = 16;

/// FlatBuffers' offsets are 31 bits.
inline constexpr std::uint64_t kMaxPayloadBytes = (std::uint64_t{1} << 31) - 2;

/// XXH3 of 64 bits, seed 0.
std::uint64_t checksum_of(std::span<const std::byte> payload);

}  // namespace wedgesim::traces
