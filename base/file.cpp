#include "base/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "base/error.h"
#include "base/temporaries.h"

namespace wedgesim {
namespace fs = std::filesystem;
namespace {

// A device, a pipe or a link (/dev/stdout is one) is written into, never replaced.
bool is_written_into(const fs::path& path) {
  std::error_code error;
  return fs::is_symlink(path, error) || fs::is_other(path, error);
}

void require_file_name(const fs::path& path) {
  if (!path.has_filename()) throw InputError(path.string(), "is no file name", "a file name");
  std::error_code error;
  if (fs::is_directory(path, error)) {
    throw InputError(path.string(), "is a folder", "a file name");
  }
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// The extension stays, because image writers choose the format by it.
fs::path temporary_of(const fs::path& folder, const fs::path& path) {
  return folder /
         fmt::format(".{}.{}{}", path.stem().string(), getpid(), path.extension().string());
}

void copy_into(const fs::path& from, const fs::path& path) {
  std::ifstream in(from, std::ios::binary);
  std::ofstream out(path, std::ios::binary);
  if (fs::file_size(from) > 0) out << in.rdbuf();
  out.close();
  if (!out) throw InputError(path.string(), "cannot be written", "a writable file with room");
}

}  // namespace

namespace {

// By any name: a link, or a way through folders that are not there yet.
bool same_file(const fs::path& a, const fs::path& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code error;  // what is not there is not the same
  if (fs::equivalent(a, b, error) && !error) return true;
  const fs::path first = fs::weakly_canonical(a, error);
  return !error && first == fs::weakly_canonical(b, error) && !error;
}

}  // namespace

void require_not_read(const fs::path& output, std::span<const fs::path> inputs) {
  for (const fs::path& input : inputs) {
    std::error_code error;
    if (!fs::exists(input, error) || !same_file(output, input)) continue;
    throw InputError(output.string(), "is read, too: it would be written over", "another file");
  }
}

void require_apart(std::span<const fs::path> outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!same_file(outputs[i], outputs[k]) || is_written_into(outputs[i])) continue;
      throw InputError(outputs[i].string(), "is written twice", "a file for each output");
    }
  }
}

void require_writable(const fs::path& path) {
  require_file_name(path);
  std::error_code error;
  if (is_written_into(path)) {
    if (!fs::exists(path, error) || access(path.c_str(), W_OK) == 0) return;
    throw InputError(path.string(), std::strerror(errno), "a writable file");
  }
  fs::path folder = folder_of(path);
  while (!fs::exists(folder, error) && folder.has_relative_path()) {
    folder = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  }
  if (!fs::is_directory(folder, error)) {
    throw InputError(path.string(), "its folder cannot be made", "a writable folder");
  }
  const fs::path temporary = temporary_of(folder, path);
  const RemovedOnSignal removed(temporary);
  const bool written = std::ofstream(temporary, std::ios::binary).is_open();
  fs::remove(temporary, error);
  if (!written) throw InputError(path.string(), "cannot be written", "a writable folder");
}

void write_atomically(const fs::path& path,
                      const std::function<void(const fs::path& temporary)>& write) {
  require_file_name(path);
  const bool into = is_written_into(path);
  std::error_code error;
  const fs::path folder = into ? fs::temp_directory_path() : folder_of(path);
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder, error)) {
    throw InputError(path.string(), "its folder cannot be made", "a writable folder");
  }
  const fs::path temporary = temporary_of(folder, path);
  const RemovedOnSignal removed(temporary);
  try {
    write(temporary);
    if (into) {
      copy_into(temporary, path);
      fs::remove(temporary);
    } else {
      fs::rename(temporary, path);
    }
  } catch (const fs::filesystem_error& e) {
    fs::remove(temporary, error);
    throw InputError(path.string(), e.code().message(), "a writable file");
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
}

void write_stream(const fs::path& path, const std::function<void(std::ostream& out)>& write) {
  write_atomically(path, [&](const fs::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    write(out);
    out.close();
    if (!out) throw InputError(path.string(), "cannot be written", "a writable file with room");
  });
}

void write_file(const fs::path& path, std::span<const std::byte> bytes) {
  write_stream(path, [&](std::ostream& out) {
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
  });
}

void write_file(const fs::path& path, std::string_view text) {
  write_file(path, std::as_bytes(std::span(text.data(), text.size())));
}

MappedFile::MappedFile(const fs::path& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // no wait at a pipe
  if (file < 0) throw InputError(path.string(), std::strerror(errno), "a readable file");
  struct stat status = {};
  if (fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) {
    close(file);
    throw InputError(path.string(), "is not a regular file", "a readable file");
  }
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > 0) {
    void* data = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    if (data == MAP_FAILED) {
      close(file);
      throw InputError(path.string(), std::strerror(errno), "a file that can be mapped");
    }
    bytes_ = {static_cast<const std::byte*>(data), size};
  }
  close(file);
}

MappedFile::MappedFile(MappedFile&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

}  // namespace wedgesim
