#include "reports/memory_trace.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <array>
#include <bit>
#include <ostream>

#include "base/check.h"
#include "base/error.h"

namespace wedgesim::reports {
namespace {

using model::memory::MemoryRecord;

constexpr std::array<std::string_view, 4> kNames{"csv", "dramsys", "dramsim3", "ramulator"};

void check(std::string_view key, int value, int low, int high, bool power_of_two) {
  const bool fits = value >= low && value <= high &&
                    (!power_of_two || std::has_single_bit(static_cast<unsigned>(value)));
  if (!fits) {
    throw InputError(
        "memory trace", fmt::format("'{}' is {}", key, value),
        fmt::format("{} from {} to {}", power_of_two ? "a power of two" : "an integer", low, high));
  }
}

std::string none_or(std::int64_t index) {
  return index == MemoryRecord::kNone ? std::string() : fmt::format("{}", index);
}

void write_header(std::ostream& out, const MemoryTraceOptions& options) {
  fmt::print(out,
             "# wedgesim memory trace, schema 1\n# block_mhz {}\n# configuration {}\n# trace {}\n"
             "cycle,client,op,addr,bytes,tile,wedge,cause\n",
             options.block_mhz, options.configuration, options.trace);
}

}  // namespace

MemoryTraceFormat memory_trace_format(std::string_view name, std::string_view option) {
  for (std::size_t n = 0; n < kNames.size(); ++n) {
    if (kNames[n] == name) return static_cast<MemoryTraceFormat>(n);
  }
  throw InputError(option, fmt::format("unknown value '{}'", name),
                   fmt::format("one of {}", fmt::join(kNames, ", ")));
}

MemoryTraceWriter::MemoryTraceWriter(std::ostream& out, MemoryTraceOptions options)
    : out_(out), options_(std::move(options)) {
  check("block_mhz", options_.block_mhz, 1, 10000, false);
  check("memory_mhz", options_.memory_mhz, 1, 10000, false);
  check("request_bytes", options_.request_bytes, 8, 4096, true);
  if (options_.format == MemoryTraceFormat::csv) write_header(out_, options_);
  if (options_.format == MemoryTraceFormat::dramsys) {
    fmt::print(out_, "# player clock: {} MHz\n", options_.block_mhz);
  }
}

void MemoryTraceWriter::write(const MemoryRecord& record) {
  CHECK_LE(last_cycle_, record.cycle);
  last_cycle_ = record.cycle;
  const std::string_view op = record.write ? "write" : "read";
  switch (options_.format) {
    case MemoryTraceFormat::csv:
      fmt::print(out_, "{},{},{},{:#x},{},{},{},{}\n", record.cycle, name_of(record.client), op,
                 record.address, record.bytes, none_or(record.tile), none_or(record.wedge),
                 name_of(record.cause));
      break;
    case MemoryTraceFormat::dramsys:
      fmt::print(out_, "{}: ({}) {} {:#x}\n", record.cycle, record.bytes, op, record.address);
      break;
    case MemoryTraceFormat::dramsim3:
    case MemoryTraceFormat::ramulator:
      write_requests(record);
      return;
  }
  bytes_ += record.bytes;
}

void MemoryTraceWriter::write_requests(const MemoryRecord& record) {
  const auto step = static_cast<std::uint64_t>(options_.request_bytes);
  const auto memory = static_cast<std::uint64_t>(options_.memory_mhz);
  const auto block = static_cast<std::uint64_t>(options_.block_mhz);
  const std::uint64_t cycle = (record.cycle * memory + block - 1) / block;
  for (std::uint64_t address = record.address / step * step;
       address < record.address + record.bytes; address += step) {
    if (options_.format == MemoryTraceFormat::dramsim3) {
      fmt::print(out_, "0x{:X} {} {}\n", address, record.write ? "WRITE" : "READ", cycle);
    } else {
      fmt::print(out_, "{} {:#x}\n", record.write ? "ST" : "LD", address);
    }
    bytes_ += step;
  }
}

}  // namespace wedgesim::reports
