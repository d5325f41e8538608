#pragma once

#include <cstddef>

namespace wedgesim::reports::accuracy {

/// The most resident memory of this process beyond what it had when the watch began, bytes.
/// Freed memory is handed back first, so that what was used before does not hide what is used now.
class PeakMemory {
 public:
  PeakMemory();
  /// 0 where the system does not tell.
  std::size_t bytes() const;

 private:
  std::size_t before_ = 0;  // 0: not known
};

}  // namespace wedgesim::reports::accuracy
