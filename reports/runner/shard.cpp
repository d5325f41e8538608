#include "reports/runner/shard.h"

#include <fmt/format.h>

#include <charconv>

#include "base/error.h"

namespace wedgesim::reports {
namespace {

std::optional<std::int64_t> whole(std::string_view text) {
  std::int64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end) return {};
  return number;
}

}  // namespace

std::pair<std::int64_t, std::int64_t> Shard::positions(std::int64_t points) const {
  return {points * (number - 1) / of, points * number / of};
}

std::string Shard::name() const { return fmt::format("shard-{}-of-{}", number, of); }

Shard parse_shard(std::string_view text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto number = whole(text.substr(0, slash));
  const auto of = whole(text.substr(std::min(slash + 1, text.size())));
  if (!number || !of || *of < 1 || *of > 1000000 || *number < 1 || *number > *of) {
    throw InputError("--shard", fmt::format("'{}'", text), "i/n, i from 1 to n");
  }
  return {*number, *of};
}

std::optional<std::pair<Shard, std::string>> shard_of_scheduler(
    const std::function<const char*(const char*)>& variable) {
  const auto number = [&variable](const char* name) -> std::optional<std::int64_t> {
    const char* text = variable(name);
    return text == nullptr ? std::nullopt : whole(text);
  };
  const auto task = number("SLURM_ARRAY_TASK_ID");
  const auto least = number("SLURM_ARRAY_TASK_MIN");
  const auto most = number("SLURM_ARRAY_TASK_MAX");
  if (task && least && most && *least <= *task && *task <= *most) {
    const std::int64_t step =
        std::max<std::int64_t>(1, number("SLURM_ARRAY_TASK_STEP").value_or(1));
    return std::pair(Shard{(*task - *least) / step + 1, (*most - *least) / step + 1},
                     fmt::format("task {} of a Slurm array", *task));
  }
  const auto rank = number("OMPI_COMM_WORLD_RANK");
  const auto size = number("OMPI_COMM_WORLD_SIZE");
  if (rank && size && *size > 1 && 0 <= *rank && *rank < *size) {
    return std::pair(Shard{*rank + 1, *size}, fmt::format("rank {} of Open MPI", *rank));
  }
  return {};
}

}  // namespace wedgesim::reports
