#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/counter.h"
#include "model/memory/dram_config.h"

namespace wedgesim::model::memory {

/// A point in time in cycles of the memory's command clock; never negative.
using DramCycle = std::int64_t;

/// One command as it goes to a channel.
struct DramCommand {
  enum class Kind : std::uint8_t { activate, precharge, read, write, refresh };
  Kind kind = Kind::activate;
  unsigned channel = 0;
  unsigned bank = 0;      // not for a refresh
  std::uint64_t row = 0;  // of an activate
  DramCycle cycle = 0;
};
using DramListener = std::function<void(const DramCommand&)>;

/// Of all channels together.
struct DramStatistics {
  Group group;
  Counter reads{group, "reads", Unit::accesses, "Read accesses"};
  Counter writes{group, "writes", Unit::accesses, "Write accesses"};
  Counter read_bursts{group, "read_bursts", Unit::accesses, "Bursts read"};
  Counter write_bursts{group, "write_bursts", Unit::accesses, "Bursts written"};
  Counter bytes{group, "bytes", Unit::bytes, "Bytes of all bursts, asked for or not"};
  Counter row_hits{group, "row_hits", Unit::accesses, "Bursts whose row was open"};
  Counter row_misses{group, "row_misses", Unit::accesses, "Bursts whose bank had no open row"};
  Counter row_conflicts{group, "row_conflicts", Unit::accesses,
                        "Bursts whose bank had another row open"};
  Counter refreshes{group, "refreshes", Unit::accesses,
                    "Refreshes of a channel, as far as accesses followed them"};
  Counter data_bus_cycles{group, "data_bus_cycles", Unit::cycles,
                          "Memory cycles with data on a channel's bus, over channels"};
};

/// One channel: bursts in the order they come. The commands of a burst go out as early as the
/// rules of DramConfig allow, so a bank is prepared while another still delivers; columns and
/// activates keep their order. A refresh of all banks falls due every refi cycles; it goes before
/// the first burst whose column would not be earlier.
class DramChannel {
 public:
  DramChannel(const DramConfig& config, unsigned channel, DramStatistics& statistics,
              const DramListener& listener);

  /// \param at  the cycle in which the burst arrives
  /// \return the cycle after its last data
  DramCycle burst(unsigned bank, std::uint64_t row, bool write, DramCycle at);

 private:
  struct Bank {
    bool open = false;
    std::uint64_t row = 0;
    DramCycle activate_from = 0, read_from = 0, write_from = 0, precharge_from = 0;
  };
  struct BankGroup {
    DramCycle activate_from = 0, column_from = 0, read_from = 0;
  };
  /// When the commands of a burst would go out.
  struct Plan {
    bool precharges = false, activates = false;
    DramCycle precharge = 0, activate = 0, column = 0;
  };

  Plan plan(const Bank& bank, const BankGroup& group, std::uint64_t row, bool write,
            DramCycle from) const;
  DramCycle column_from(const BankGroup& group, bool write) const;
  void do_precharge(unsigned bank, DramCycle cycle);
  void do_activate(unsigned bank, std::uint64_t row, DramCycle cycle);
  DramCycle do_column(unsigned bank, bool write, DramCycle cycle);
  void refresh();
  void issue(DramCommand::Kind kind, unsigned bank, std::uint64_t row, DramCycle cycle) const;
  BankGroup& group_of(unsigned bank) { return groups_[bank & group_mask_]; }

  const DramConfig t_;
  const unsigned channel_;
  const unsigned group_mask_;
  DramStatistics& statistics_;
  const DramListener& listener_;

  std::vector<Bank> banks_;
  std::vector<BankGroup> groups_;
  DramCycle activate_from_ = 0, column_from_ = 0, read_from_ = 0;
  std::array<DramCycle, 4> window_from_{};  // earliest fourth activate after each of the last four
  std::size_t window_next_ = 0;
  DramCycle read_bus_from_ = 0, write_bus_from_ = 0;
  DramCycle refresh_due_;
  std::vector<DramCycle> queue_;  // columns of the last bursts, a ring
  std::size_t queue_next_ = 0;
};

}  // namespace wedgesim::model::memory
