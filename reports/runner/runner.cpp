#include "reports/runner/runner.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstring>
#include <memory>
#include <regex>
#include <thread>

#include "base/error.h"
#include "base/file.h"
#include "reports/runner/measure.h"
#include "reports/runner/schedule.h"
#include "reports/runner/store.h"
#include "reports/runner/value.h"
#include "reports/runner/worker.h"

namespace wedgesim::reports {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What a worker process does.
class Service {
 public:
  Service(const Study& study, const RunOptions& options) : study_(study), options_(options) {}

  void serve(const Json& job, const Worker::Answer& answer) {
    const auto frame = job.at("frame").get<std::size_t>();
    const auto configurations = job.at("configurations").get<std::vector<std::size_t>>();
    if (configurations.empty()) {
      render(frame, answer);
    } else {
      measure(frame, configurations, answer);
    }
  }

 private:
  void render(std::size_t frame, const Worker::Answer& answer) const {
    const auto start = Clock::now();
    try {
      options_.before_render(study_.frames[frame]);
      const RenderedFrame rendered =
          render_frame(study_.frames[frame], options_.folder, study_.pictures);
      answer({{"checksum", rendered.checksum},
              {"wedges", rendered.wedges},
              {"pictures", rendered.pictures},
              {"seconds", seconds_since(start)}});
    } catch (const std::exception& error) {
      answer({{"failure", error.what()}, {"seconds", seconds_since(start)}});
    }
  }

  void measure(std::size_t frame, const std::vector<std::size_t>& configurations,
               const Worker::Answer& answer) {
    const bool together = study_.configurations[configurations.front()].measure == Measure::count;
    if (together && configurations.size() > 1 && try_together(frame, configurations, answer))
      return;
    for (const std::size_t i : configurations) measure_one(frame, i, answer);
  }

  // Several points of one walk. False if one of them fails: then which, each has to say by itself.
  bool try_together(std::size_t frame, const std::vector<std::size_t>& configurations,
                    const Worker::Answer& answer) {
    std::vector<const Configuration*> all;
    for (const std::size_t i : configurations) all.push_back(&study_.configurations[i]);
    const auto start = Clock::now();
    try {
      for (const Configuration* configuration : all) options_.before(*configuration);
      const std::vector<Values> metrics = measurer(frame).measure(all);
      const double seconds = seconds_since(start) / static_cast<double>(all.size());
      for (std::size_t k = 0; k < all.size(); ++k) {
        answer({{"configuration", configurations[k]},
                {"metrics", to_json(metrics[k])},
                {"seconds", seconds}});
      }
      return true;
    } catch (const std::exception&) {
      return false;
    }
  }

  void measure_one(std::size_t frame, std::size_t i, const Worker::Answer& answer) {
    const auto start = Clock::now();
    Json result{{"configuration", i}};
    try {
      options_.before(study_.configurations[i]);
      result["metrics"] = to_json(measurer(frame).measure({&study_.configurations[i]}).front());
    } catch (const std::exception& error) {
      result["failure"] = error.what();
    }
    result["seconds"] = seconds_since(start);
    answer(result);
  }

  Measurer& measurer(std::size_t frame) {
    if (!measurer_ || frame_ != frame) {
      measurer_.reset();  // before the next maps as much memory
      measurer_ =
          std::make_unique<Measurer>(trace_path(options_.folder, study_.frames[frame].row.label));
      frame_ = frame;
    }
    return *measurer_;
  }

  const Study& study_;
  const RunOptions& options_;
  std::unique_ptr<Measurer> measurer_;
  std::size_t frame_ = 0;
};

void require_outputs(const Study& study, const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> inputs;
  std::vector<std::filesystem::path> outputs{folder};
  for (const char* file : {"results.sqlite", "results.csv", "results.json", "summary.txt",
                           "summary.md", "claims.md", "report.html", "timeline.json"}) {
    outputs.push_back(folder / file);
  }
  std::error_code error;
  for (const auto& map : std::filesystem::directory_iterator(folder / "maps", error)) {
    outputs.push_back(map.path());
  }
  for (const FrameSpec& frame : study.frames) {
    inputs.insert(inputs.end(), frame.files.begin(), frame.files.end());
    outputs.push_back(trace_path(folder, frame.row.label));
    if (!study.pictures) continue;
    for (auto& path : picture_paths(folder, frame.row.label)) outputs.push_back(std::move(path));
  }
  for (const std::filesystem::path& output : outputs) require_not_read(output, inputs);
}

// What a run that was killed left half written: ".STEM.PROCESS.EXTENSION" (base/file.h). Nobody
// else writes here now.
void remove_temporaries(const std::filesystem::path& folder) {
  static const std::regex name(R"(\..+\.[0-9]+\.(wtrace|png|exr|csv|json|txt|md|html))");
  std::error_code error;
  for (const std::filesystem::path& place : {folder, folder / "maps"}) {
    for (const auto& entry : std::filesystem::directory_iterator(place, error)) {
      if (!std::regex_match(entry.path().filename().string(), name)) continue;
      std::filesystem::remove(entry.path(), error);
    }
  }
}

/// The parent: gives jobs to workers and keeps their answers.
class Run {
 public:
  Run(const Study& study, const RunOptions& options)
      : study_(study),
        options_(options),
        store_(options.folder, options.sources),
        schedule_(study),
        rows_(study.frames.size()),
        at_work_(study.frames.size()) {}

  RunCounts run() {
    prepare();
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t most = options_.jobs == 0 ? cores : options_.jobs;
    for (;;) {
      while (hands_.size() < most && start_one()) {
      }
      if (hands_.empty()) break;
      wait();
      tell();
    }
    return counts_;
  }

 private:
  /// A worker with what it is at.
  struct Hand {
    std::unique_ptr<Worker> worker;
    std::optional<Job> job;  // with the points that are not answered yet
    std::optional<std::size_t> last;
    Clock::time_point begun;  // the job, or its next point
  };

  void prepare() {
    remove_temporaries(options_.folder);
    store_.begin(study_.head, static_cast<std::int64_t>(study_.points()));
    const std::map<std::string, FrameRow> known = store_.known_frames();
    for (auto& [frame, configurations] : points_by_frame(study_, options_.shard)) {
      counts_.points += configurations.size();
      const FrameSpec& spec = study_.frames[frame];
      const auto found = known.find(spec.row.key);
      wanted_.emplace(frame, std::move(configurations));
      if (found != known.end() && is_usable(spec, found->second)) {
        FrameRow row = found->second;
        row.label = spec.row.label;
        keep_frame(frame, row, store_.failure_state(row));
      } else {
        counts_.frames += 1;
        schedule_.add_render(frame);
      }
    }
  }

  bool is_usable(const FrameSpec& spec, const FrameRow& row) const {
    if (!row.failure.empty()) return !options_.retry;
    return (!study_.pictures || !row.pictures.empty()) &&
           holds_trace(trace_path(options_.folder, spec.row.label), row.checksum);
  }

  // A frame that is there: its points are kept already, or are to be measured; with `state` if it
  // could not be rendered.
  void keep_frame(std::size_t frame, const FrameRow& row, PointState state) {
    rows_[frame] = row;
    store_.keep(row, static_cast<std::int64_t>(frame));
    const std::map<std::string, PointState> states = store_.point_states(row.label);
    std::map<std::string, Position> kept;
    std::vector<std::size_t> missing;
    for (const std::size_t i : wanted_.at(frame)) {
      const std::string key = point_key(study_.configurations[i], row.checksum);
      const auto known = states.find(key);
      const bool is_kept =
          known != states.end() && (known->second == PointState::done || !options_.retry);
      if (is_kept) {
        kept.emplace(key, position(frame, i));
      } else {
        missing.push_back(i);
      }
    }
    counts_.kept += kept.size();
    store_.place(row.label, kept);
    if (row.failure.empty()) {
      schedule_.add_points(frame, missing);
    } else {
      for (const std::size_t i : missing) keep(frame, i, state, row.failure, {}, 0.0);
    }
  }

  Position position(std::size_t frame, std::size_t i) const {
    return static_cast<Position>(frame * study_.configurations.size() + i);
  }

  void keep(std::size_t frame, std::size_t i, PointState state, std::string message, Values metrics,
            double seconds) {
    const Configuration& configuration = study_.configurations[i];
    PointRow point;
    point.key = point_key(configuration, rows_[frame].checksum);
    point.frame = rows_[frame].label;
    point.measure = configuration.measure_name();
    point.configuration = configuration.values;
    point.state = state;
    point.message = std::move(message);
    point.metrics = std::move(metrics);
    point.seconds = seconds;
    store_.keep(point, position(frame, i));
    counts_.measured += 1;
  }

  // Gives the next job to a worker without one, or to a new one.
  bool start_one() {
    Hand hand;
    if (!start(hand)) return false;
    hands_.push_back(std::move(hand));
    return true;
  }

  bool start(Hand& hand) {
    hand.job = schedule_.next(hand.last, at_work_);
    if (!hand.job) return false;
    if (!hand.worker) {
      hand.worker = std::make_unique<Worker>(
          [service = std::make_shared<Service>(study_, options_)](
              const Json& job, const Worker::Answer& answer) { service->serve(job, answer); });
    }
    hand.worker->send({{"frame", hand.job->frame}, {"configurations", hand.job->configurations}});
    hand.last = hand.job->frame;
    at_work_[hand.job->frame] = true;
    hand.begun = Clock::now();
    return true;
  }

  double limit(const Hand& hand) const {
    const Job& job = *hand.job;
    const bool together =
        !job.renders() &&
        study_.configurations[job.configurations.front()].measure == Measure::count;
    const auto points = static_cast<double>(together ? job.configurations.size() : 1);
    return study_.time_limit_seconds * points;
  }

  void wait() {
    std::vector<pollfd> files;
    double patience = 0.5;
    for (const Hand& hand : hands_) {
      files.push_back({hand.worker->file(), POLLIN, 0});
      patience = std::min(patience, limit(hand) - seconds_since(hand.begun));
    }
    poll(files.data(), files.size(), std::max(0, static_cast<int>(1000.0 * patience) + 1));
    std::vector<Hand> still;
    for (std::size_t k = 0; k < hands_.size(); ++k) {
      Hand& hand = hands_[k];
      if (files[k].revents != 0) take_answers(hand);
      if (hand.job && !hand.worker->ended() && seconds_since(hand.begun) > limit(hand)) {
        hand.worker->end();
        lose(hand, PointState::overtime,
             fmt::format("took longer than {} s", study_.time_limit_seconds));
      } else if (hand.worker->ended()) {
        const std::string end = hand.worker->end();
        if (hand.job) lose(hand, PointState::crashed, "the worker ended by " + end);
      }
      if (!hand.job) at_work_[*hand.last] = false;
      if (hand.job || start(hand)) still.push_back(std::move(hand));
    }
    hands_ = std::move(still);
  }

  void take_answers(Hand& hand) {
    for (const Json& answer : hand.worker->answers()) {
      const double seconds = answer.at("seconds").get<double>();
      const std::string failure = answer.value("failure", "");
      if (hand.job->renders()) {
        FrameRow row = study_.frames[hand.job->frame].row;
        row.failure = failure;
        row.seconds = seconds;
        if (failure.empty()) {
          row.checksum = answer.at("checksum").get<std::uint64_t>();
          row.wedges = answer.at("wedges").get<std::int64_t>();
          row.pictures = answer.at("pictures").get<std::string>();
        }
        rendered(hand, row, PointState::failed);
      } else {
        const auto i = answer.at("configuration").get<std::size_t>();
        const PointState state = failure.empty() ? PointState::done : PointState::failed;
        keep(hand.job->frame, i, state, failure,
             failure.empty() ? values_of(answer.at("metrics")) : Values(), seconds);
        hand.begun = Clock::now();
        std::erase(hand.job->configurations, i);
        if (hand.job->configurations.empty()) hand.job.reset();
      }
    }
  }

  // With `state` if it failed.
  void rendered(Hand& hand, const FrameRow& row, PointState state) {
    counts_.rendered += 1;
    const std::size_t frame = hand.job->frame;
    hand.job.reset();
    keep_frame(frame, row, state);
  }

  // The worker is gone. Which of several points of one walk is to blame, each shows by itself.
  void lose(Hand& hand, PointState state, const std::string& message) {
    Job job = *hand.job;
    hand.worker.reset();
    if (job.renders()) {
      FrameRow row = study_.frames[job.frame].row;
      row.failure = message;
      row.seconds = seconds_since(hand.begun);
      rendered(hand, row, state);
      return;
    }
    hand.job.reset();
    const Configuration& first = study_.configurations[job.configurations.front()];
    if (first.measure == Measure::count && job.configurations.size() > 1) {
      schedule_.add_singly(job);
      return;
    }
    keep(job.frame, job.configurations.front(), state, message, {}, seconds_since(hand.begun));
    job.configurations.erase(job.configurations.begin());
    if (!job.configurations.empty()) schedule_.add_first(std::move(job));
  }

  void tell() {
    if (seconds_since(told_) < 0.4) return;
    told_ = Clock::now();
    const double elapsed = seconds_since(begun_);
    const double rate = static_cast<double>(counts_.measured) / elapsed;
    const std::size_t done = counts_.kept + counts_.measured;
    std::string text = fmt::format("{}: {} of {} points", study_.head.name, done, counts_.points);
    if (counts_.measured > 0) {
      text += fmt::format(", {:.1f} a second, {:.0f} s left", rate,
                          static_cast<double>(counts_.points - done) / rate);
    }
    if (counts_.rendered < counts_.frames) {
      text += fmt::format(", {} of {} frames rendered", counts_.rendered, counts_.frames);
    }
    options_.progress(text);
  }

  const Study& study_;
  const RunOptions& options_;
  Store store_;
  Schedule schedule_;
  std::map<std::size_t, std::vector<std::size_t>> wanted_;  // points of a frame
  std::vector<FrameRow> rows_;
  std::vector<bool> at_work_;  // frames
  std::vector<Hand> hands_;
  RunCounts counts_;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point told_ = begun_;
};

}  // namespace

std::vector<std::pair<std::size_t, std::vector<std::size_t>>> points_by_frame(const Study& study,
                                                                              const Shard& shard) {
  const auto [begin, end] = shard.positions(static_cast<std::int64_t>(study.points()));
  std::vector<std::pair<std::size_t, std::vector<std::size_t>>> frames;
  for (std::int64_t position = begin; position < end; ++position) {
    const std::size_t frame = static_cast<std::size_t>(position) / study.configurations.size();
    if (frames.empty() || frames.back().first != frame) frames.push_back({frame, {}});
    frames.back().second.push_back(static_cast<std::size_t>(position) %
                                   study.configurations.size());
  }
  return frames;
}

RunCounts run_study(const Study& study, const RunOptions& options) {
  require_outputs(study, options.folder);
  return Run(study, options).run();
}

}  // namespace wedgesim::reports
