#include "base/counter.h"

namespace wedgesim {

std::string_view name_of(Unit unit) {
  switch (unit) {
    case Unit::accesses:
      return "accesses";
    case Unit::pixels:
      return "pixels";
    case Unit::visits:
      return "visits";
    case Unit::words:
      return "words";
    case Unit::bytes:
      return "bytes";
    case Unit::tiles:
      return "tiles";
    case Unit::wedges:
      return "wedges";
    case Unit::cycles:
      return "cycles";
  }
  return "";
}

void Group::reset() {
  for (Counter* counter : counters_) *counter = 0;
}

}  // namespace wedgesim
