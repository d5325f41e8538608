#include "model/memory/cache.h"

#include <algorithm>
#include <bit>

#include "model/memory/config_check.h"

namespace wedgesim::model::memory {

Cache::Cache(const CacheConfig& config, std::string_view place) {
  check_power_of_two(place, "line_bytes", config.line_bytes, 8, 4096);
  line_shift_ = static_cast<unsigned>(std::countr_zero(static_cast<unsigned>(config.line_bytes)));
  if (config.size_bytes == 0) return;
  check_power_of_two(place, "size_bytes", config.size_bytes, config.line_bytes, 1 << 26);
  const int lines = config.size_bytes / config.line_bytes;
  check_power_of_two(place, "ways", config.ways, 1, std::min(lines, 64));
  ways_ = static_cast<std::size_t>(config.ways);
  lines_.resize(static_cast<std::size_t>(lines));
  set_mask_ = static_cast<std::uint64_t>(lines / config.ways) - 1;
}

Cache::Access Cache::miss(Line* set, std::uint64_t line, bool write) {
  misses_ += 1;
  Access result;
  if (lines_.empty()) {
    result.fill = !write;
    if (write) {
      write_backs_ += 1;
      result.write_back = line << line_shift_;
    }
    return result;
  }
  Line* const victim = std::min_element(
      set, set + ways_, [](const Line& a, const Line& b) { return a.used < b.used; });
  if (victim->line != kEmpty) evictions_ += 1;
  if (victim->dirty) {
    write_backs_ += 1;
    result.write_back = victim->line << line_shift_;
    result.write_back_ready = victim->ready;
    result.write_back_settled = victim->settled;
  }
  *victim = {line, time_, 0, 0, write};
  result.fill = true;
  result.slot = static_cast<std::size_t>(victim - lines_.data());
  return result;
}

}  // namespace wedgesim::model::memory
