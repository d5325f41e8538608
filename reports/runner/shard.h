#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace wedgesim::reports {

/// One of the parts that a study is split into: its points in the study's order, in runs as equal
/// as they can be.
struct Shard {
  std::int64_t number = 1;  // from 1
  std::int64_t of = 1;

  /// The positions [first, second) of this part.
  std::pair<std::int64_t, std::int64_t> positions(std::int64_t points) const;
  /// "shard-2-of-3"
  std::string name() const;
};

/// "2/3". \throws InputError naming --shard
Shard parse_shard(std::string_view text);

/// The part that a scheduler gives this process: a task of a Slurm array, or a rank of Open MPI.
/// \param variable  reads the environment; null where there is none of that name
/// \return          with the words that say where it comes from
std::optional<std::pair<Shard, std::string>> shard_of_scheduler(
    const std::function<const char*(const char*)>& variable);

}  // namespace wedgesim::reports
