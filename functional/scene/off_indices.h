#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace wedgesim::functional {

/// \throws InputError: the face names a vertex that is not there
[[noreturn]] void refuse_index(const std::string& place, std::uint64_t face, std::int64_t index,
                               std::uint64_t vertices);

/// Looks at the indices of an OFF file, which Assimp moves silently into their range. What else may
/// be wrong with the file is Assimp's to say.
/// \throws InputError naming the first index out of range
void check_off_indices(const std::filesystem::path& path);

}  // namespace wedgesim::functional
