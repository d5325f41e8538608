#include "reports/accuracy/peak_memory.h"

#include <malloc.h>

#include <fstream>
#include <string>

namespace wedgesim::reports::accuracy {
namespace {

// A line "KEY:  N kB" of the process's status.
std::size_t status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    std::size_t kilobytes = 0;
    if (word == key + ":" && status >> kilobytes) return 1024 * kilobytes;
  }
  return 0;
}

}  // namespace

PeakMemory::PeakMemory() {
  malloc_trim(0);
  std::ofstream reset("/proc/self/clear_refs");
  if (reset << "5" << std::flush) before_ = status_bytes("VmRSS");  // the peak begins anew
}

std::size_t PeakMemory::bytes() const {
  const std::size_t peak = before_ == 0 ? 0 : status_bytes("VmHWM");
  return peak > before_ ? peak - before_ : 0;
}

}  // namespace wedgesim::reports::accuracy
