#include "model/memory/dram_channel.h"

#include <algorithm>

namespace wedgesim::model::memory {
namespace {

void raise(DramCycle& from, DramCycle at_least) { from = std::max(from, at_least); }

}  // namespace

DramChannel::DramChannel(const DramConfig& config, unsigned channel, DramStatistics& statistics,
                         const DramListener& listener)
    : t_(config),
      channel_(channel),
      group_mask_(static_cast<unsigned>(config.bank_groups) - 1),
      statistics_(statistics),
      listener_(listener),
      banks_(static_cast<std::size_t>(config.banks)),
      groups_(static_cast<std::size_t>(config.bank_groups)),
      refresh_due_(config.refi),
      queue_(static_cast<std::size_t>(config.queue_bursts)) {}

DramCycle DramChannel::burst(unsigned bank, std::uint64_t row, bool write, DramCycle at) {
  const DramCycle from = std::max(at, queue_[queue_next_]);
  Plan commands = plan(banks_[bank], group_of(bank), row, write, from);
  while (commands.column >= refresh_due_) {
    refresh();
    commands = plan(banks_[bank], group_of(bank), row, write, from);
  }
  if (commands.precharges) do_precharge(bank, commands.precharge);
  if (commands.activates) do_activate(bank, row, commands.activate);
  queue_[queue_next_] = commands.column;
  queue_next_ = (queue_next_ + 1) % queue_.size();
  (commands.precharges  ? statistics_.row_conflicts
   : commands.activates ? statistics_.row_misses
                        : statistics_.row_hits) += 1;
  return do_column(bank, write, commands.column);
}

DramChannel::Plan DramChannel::plan(const Bank& bank, const BankGroup& group, std::uint64_t row,
                                    bool write, DramCycle from) const {
  Plan plan;
  plan.column = std::max(from, column_from(group, write));
  if (bank.open && bank.row == row) {
    raise(plan.column, write ? bank.write_from : bank.read_from);
    return plan;
  }
  plan.activates = true;
  plan.activate = std::max(from, bank.activate_from);
  if (bank.open) {
    plan.precharges = true;
    plan.precharge = std::max(from, bank.precharge_from);
    plan.activate = plan.precharge + t_.rp;
  }
  raise(plan.activate, activate_from_);
  raise(plan.activate, group.activate_from);
  raise(plan.activate, window_from_[window_next_]);
  raise(plan.column, plan.activate + (write ? t_.rcd_write : t_.rcd_read));
  return plan;
}

/// What the columns before allow.
DramCycle DramChannel::column_from(const BankGroup& group, bool write) const {
  DramCycle from = std::max(column_from_, group.column_from);
  if (!write) {
    raise(from, read_from_);
    raise(from, group.read_from);
  }
  raise(from, write ? write_bus_from_ - t_.write_latency : read_bus_from_ - t_.read_latency);
  return from;
}

void DramChannel::do_precharge(unsigned bank, DramCycle cycle) {
  banks_[bank].open = false;
  banks_[bank].activate_from = cycle + t_.rp;
  issue(DramCommand::Kind::precharge, bank, 0, cycle);
}

void DramChannel::do_activate(unsigned bank, std::uint64_t row, DramCycle cycle) {
  banks_[bank] = {.open = true,
                  .row = row,
                  .read_from = cycle + t_.rcd_read,
                  .write_from = cycle + t_.rcd_write,
                  .precharge_from = cycle + t_.ras};
  activate_from_ = cycle + t_.rrd_s;
  group_of(bank).activate_from = cycle + t_.rrd_l;
  window_from_[window_next_] = cycle + t_.faw;
  window_next_ = (window_next_ + 1) % window_from_.size();
  issue(DramCommand::Kind::activate, bank, row, cycle);
}

DramCycle DramChannel::do_column(unsigned bank, bool write, DramCycle cycle) {
  const DramCycle data = cycle + (write ? t_.write_latency : t_.read_latency);
  const DramCycle end = data + t_.burst_cycles;
  BankGroup& group = group_of(bank);
  column_from_ = cycle + t_.ccd_s;
  group.column_from = cycle + t_.ccd_l;
  raise(banks_[bank].precharge_from, write ? end + t_.wr : cycle + t_.rtp);
  if (write) {
    read_from_ = end + t_.wtr_s;
    group.read_from = end + t_.wtr_l;
  }
  read_bus_from_ = end + (write ? t_.turnaround : 0);
  write_bus_from_ = end + (write ? 0 : t_.turnaround);
  statistics_.data_bus_cycles += static_cast<std::uint64_t>(t_.burst_cycles);
  issue(write ? DramCommand::Kind::write : DramCommand::Kind::read, bank, 0, cycle);
  return end;
}

void DramChannel::refresh() {
  DramCycle cycle = refresh_due_;
  for (unsigned bank = 0; bank < banks_.size(); ++bank) {
    if (banks_[bank].open) do_precharge(bank, std::max(refresh_due_, banks_[bank].precharge_from));
    raise(cycle, banks_[bank].activate_from);
  }
  for (Bank& bank : banks_) bank.activate_from = cycle + t_.rfc;
  refresh_due_ += t_.refi;
  statistics_.refreshes += 1;
  issue(DramCommand::Kind::refresh, 0, 0, cycle);
}

void DramChannel::issue(DramCommand::Kind kind, unsigned bank, std::uint64_t row,
                        DramCycle cycle) const {
  if (listener_) listener_({kind, channel_, bank, row, cycle});
}

}  // namespace wedgesim::model::memory
