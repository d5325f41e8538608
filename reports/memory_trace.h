#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>

#include "model/memory/memory_record.h"

namespace wedgesim::reports {

/// Who reads a memory trace: pandas and people (`csv`), DRAMSys (`.stl`), DRAMsim3, or Ramulator 2
/// (LoadStoreTrace). docs/memory.md describes each.
enum class MemoryTraceFormat { csv, dramsys, dramsim3, ramulator };

/// \throws InputError listing the formats; `option` is where `name` stands
MemoryTraceFormat memory_trace_format(std::string_view name, std::string_view option);

struct MemoryTraceOptions {
  MemoryTraceFormat format = MemoryTraceFormat::csv;
  int block_mhz = 500;             // the clock of the records' cycles
  int memory_mhz = 1600;           // dramsim3: the clock (1 / tCK) that it counts in
  int request_bytes = 64;          // dramsim3, ramulator: what one line stands for; a power of two
  std::string configuration = {};  // csv: its hash
  std::string trace = {};          // csv: the trace's checksum
};

/// Writes a memory trace to a stream, record by record. The formats without sizes get a line for
/// each request that a record touches.
class MemoryTraceWriter {
 public:
  /// \throws InputError naming the option that is out of range
  MemoryTraceWriter(std::ostream& out, MemoryTraceOptions options);

  /// \param record  its cycle is not before that of the record before
  void write(const model::memory::MemoryRecord& record);

  /// What a reader of the trace will count: the records' bytes, or the requests' where the format
  /// knows no sizes. The same if every record is whole requests.
  std::uint64_t bytes() const { return bytes_; }

 private:
  void write_requests(const model::memory::MemoryRecord& record);

  std::ostream& out_;
  const MemoryTraceOptions options_;
  model::memory::Cycle last_cycle_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace wedgesim::reports
