#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "base/file.h"
#include "traces/trace.h"

namespace wedgesim::traces {

/// The trace in the bytes of a whole trace file, verified in full: header, checksum, FlatBuffer,
/// meaning (verify.h). The view's tables are spans into `file`.
/// \param file   aligned to kPayloadAlignment (format.h)
/// \param place  what errors name: the file
/// \throws       InputError, one line, for whatever is wrong
TraceView view_of(std::span<const std::byte> file, std::string_view place);

/// A trace file mapped into memory. Its view is valid as long as the object, wherever it is moved.
class TraceFile {
 public:
  /// \throws InputError if the file cannot be read or is not a sound trace
  explicit TraceFile(const std::filesystem::path& path);

  const TraceView& view() const { return view_; }

 private:
  MappedFile file_;
  TraceView view_;
};

}  // namespace wedgesim::traces
