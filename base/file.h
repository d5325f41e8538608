#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <span>
#include <string_view>

namespace wedgesim {

/// Refuses to write over what is read: by the same name, another one, or a link.
/// \throws InputError if `output` is one of the files `inputs`
void require_not_read(const std::filesystem::path& output,
                      std::span<const std::filesystem::path> inputs);

/// Refuses two outputs in one file. Devices may take several.
/// \throws InputError if two of `outputs` are the same file; empty paths are none
void require_apart(std::span<const std::filesystem::path> outputs);

/// Refuses what write_atomically could not write, before long work and before another output is
/// there. Leaves nothing behind.
/// \throws InputError as write_atomically does
void require_writable(const std::filesystem::path& path);

/// Writes a file whole or not at all: `write` gets a temporary path in the same folder, which is
/// renamed to `path` when it returns and removed when it throws. Makes missing folders. A device,
/// pipe or symbolic link is not replaced: the finished bytes are copied into it.
/// \throws InputError if the folder or the file cannot be written
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for what goes through a stream.
void write_stream(const std::filesystem::path& path,
                  const std::function<void(std::ostream& out)>& write);

/// The same for bytes at hand.
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

/// A file mapped read-only into memory for the life of the object.
class MappedFile {
 public:
  /// \throws InputError if the file is missing, unreadable, or not a regular file
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&&) = delete;
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::span<const std::byte> bytes() const { return bytes_; }
  std::string_view text() const {
    return {reinterpret_cast<const char*>(bytes_.data()), bytes_.size()};
  }

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace wedgesim
