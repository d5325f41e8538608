#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "model/memory/dram.h"

namespace wedgesim::model::memory {

/// Judges the recorded commands of a DRAM by rules between pairs of them, without any state of the
/// model: no command may come before a rule allows, nor later than all of them do.
class DramRules {
 public:
  explicit DramRules(const DramConfig& config) : c_(config) {}

  /// Takes what one access recorded.
  /// \param arrival  memory cycle of its arrival
  /// \param places   where its bursts must go, in order
  /// \return the cycle after its last data
  std::int64_t take(const std::vector<DramCommand>& commands, std::int64_t arrival,
                    const std::vector<Dram::Place>& places) {
    std::int64_t done = 0;
    std::size_t burst = 0;
    for (const DramCommand& command : commands) {
      judge(command, arrival, commands);
      if (!is_column(command)) continue;
      EXPECT_LT(burst, places.size());
      const Dram::Place& place = places[burst++];
      EXPECT_EQ(command.channel, place.channel);
      EXPECT_EQ(command.bank, place.bank);
      EXPECT_EQ(open_row(command), place.row);
      done = std::max(done, time(command) + latency(command) + c_.burst_cycles);
    }
    EXPECT_EQ(burst, places.size());
    return done;
  }

 private:
  using Kind = DramCommand::Kind;
  static constexpr std::int64_t kNever = -1'000'000'000;  // as good as no rule
  static constexpr std::size_t kWindow = 400;             // commands looked back

  static std::int64_t time(const DramCommand& c) { return c.cycle; }
  static bool is_column(const DramCommand& c) {
    return c.kind == Kind::read || c.kind == Kind::write;
  }
  std::int64_t latency(const DramCommand& c) const {
    return c.kind == Kind::read ? c_.read_latency : c_.write_latency;
  }
  bool same_group(const DramCommand& a, const DramCommand& b) const {
    return a.bank % static_cast<unsigned>(c_.bank_groups) ==
           b.bank % static_cast<unsigned>(c_.bank_groups);
  }

  /// Least cycles from one command of a channel to one issued after it.
  std::int64_t gap(const DramCommand& a, const DramCommand& b) const {
    const bool bank = a.bank == b.bank;
    if (a.kind == Kind::refresh) {
      return b.kind == Kind::activate || b.kind == Kind::refresh ? c_.rfc : kNever;
    }
    if (is_column(a) && is_column(b)) return column_gap(a, b);
    if (a.kind == Kind::activate && b.kind == Kind::activate) {
      return std::max(
          {same_group(a, b) ? c_.rrd_l : c_.rrd_s, c_.rrd_s, bank ? c_.ras + c_.rp : 0});
    }
    if (a.kind == Kind::precharge && b.kind == Kind::refresh) return c_.rp;
    if (!bank) return kNever;
    if (a.kind == Kind::activate && b.kind == Kind::precharge) return c_.ras;
    if (a.kind == Kind::activate && b.kind == Kind::read) return c_.rcd_read;
    if (a.kind == Kind::activate && b.kind == Kind::write) return c_.rcd_write;
    if (a.kind == Kind::precharge && b.kind == Kind::activate) return c_.rp;
    if (a.kind == Kind::read && b.kind == Kind::precharge) return c_.rtp;
    if (a.kind == Kind::write && b.kind == Kind::precharge) {
      return c_.write_latency + c_.burst_cycles + c_.wr;
    }
    return kNever;
  }

  std::int64_t column_gap(const DramCommand& a, const DramCommand& b) const {
    const int turn = a.kind == b.kind ? 0 : c_.turnaround;
    std::int64_t cycles = latency(a) + c_.burst_cycles + turn - latency(b);  // of the data bus
    cycles = std::max<std::int64_t>(cycles, c_.ccd_s);
    if (same_group(a, b)) cycles = std::max<std::int64_t>(cycles, c_.ccd_l);
    if (a.kind == Kind::write && b.kind == Kind::read) {
      const int to_read = same_group(a, b) ? std::max(c_.wtr_l, c_.wtr_s) : c_.wtr_s;
      cycles = std::max<std::int64_t>(cycles, c_.write_latency + c_.burst_cycles + to_read);
    }
    return cycles;
  }

  void judge(const DramCommand& command, std::int64_t arrival,
             const std::vector<DramCommand>& commands) {
    Channel& channel = channels_[command.channel];
    std::vector<DramCommand>& past = channel.past;
    std::int64_t from = 0;
    if (for_refresh(command, commands)) {
      from = channel.due(c_.refi);
    } else {
      const auto depth = static_cast<std::size_t>(c_.queue_bursts);
      const auto& columns = channel.columns;
      from = std::max(arrival, columns.size() < depth ? 0 : columns[columns.size() - depth]);
    }
    for (std::size_t n = past.size() > kWindow ? past.size() - kWindow : 0; n < past.size(); ++n) {
      from = std::max(from, time(past[n]) + gap(past[n], command));
    }
    if (command.kind == Kind::activate) {
      EXPECT_FALSE(channel.rows.contains(command.bank));
      channel.rows[command.bank] = command.row;
      auto& activates = channel.activates;
      if (activates.size() >= 4) from = std::max(from, activates[activates.size() - 4] + c_.faw);
      activates.push_back(time(command));
    }
    if (command.kind == Kind::precharge) {
      EXPECT_EQ(channel.rows.erase(command.bank), 1U);
    }
    if (command.kind == Kind::refresh) {
      EXPECT_TRUE(channel.rows.empty());
      ++channel.refreshes;
    }
    if (is_column(command)) {
      EXPECT_TRUE(channel.rows.contains(command.bank));
      EXPECT_LT(time(command), channel.due(c_.refi));
      channel.columns.push_back(time(command));
    }
    EXPECT_EQ(time(command), from)
        << "channel " << command.channel << " bank " << command.bank << " kind "
        << static_cast<int>(command.kind) << " command " << past.size();
    past.push_back(command);
  }

  /// A refresh, or a precharge on its behalf: on its channel only precharges lie between.
  bool for_refresh(const DramCommand& command, const std::vector<DramCommand>& commands) const {
    auto next = std::find_if(commands.begin(), commands.end(),
                             [&](const DramCommand& other) { return &other == &command; });
    while (next != commands.end() &&
           (next->kind == Kind::precharge || next->channel != command.channel)) {
      ++next;
    }
    return next != commands.end() && next->kind == Kind::refresh;
  }

  std::uint64_t open_row(const DramCommand& command) {
    return channels_[command.channel].rows[command.bank];
  }

  struct Channel {
    std::vector<DramCommand> past;
    std::vector<std::int64_t> columns, activates;
    std::map<unsigned, std::uint64_t> rows;  // of the open banks
    std::int64_t refreshes = 0;
    std::int64_t due(int refi) const { return (refreshes + 1) * refi; }
  };
  const DramConfig c_;
  std::map<unsigned, Channel> channels_;
};

}  // namespace wedgesim::model::memory
