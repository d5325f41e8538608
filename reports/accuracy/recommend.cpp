#include "reports/accuracy/recommend.h"

#include <fmt/format.h>

#include <algorithm>

namespace wedgesim::reports::accuracy {
namespace {

constexpr double kLargeOnCasters = 0.1;  // RMSE

std::string words_of(const Measured& measured) {
  return fmt::format("{} (RMSE {:.4f}, {:.1f} ms)", measured.choice.text, error_of(measured),
                     1e3 * seconds_of(measured));
}

bool fits(const Measured& measured, const Wish& wish) {
  return (!wish.max_error || error_of(measured) <= *wish.max_error) &&
         (!wish.budget_seconds || seconds_of(measured) <= *wish.budget_seconds);
}

std::string wish_words(const Wish& wish) {
  std::string words;
  if (wish.max_error) words = fmt::format("RMSE up to {:g}", *wish.max_error);
  if (wish.budget_seconds) {
    words += fmt::format("{}{:g} ms", words.empty() ? "" : " in ", 1e3 * *wish.budget_seconds);
  }
  return words;
}

// The neighbours of a choice on the front say why not less and why not more.
std::string reason(const std::vector<Measured>& methods, std::size_t chosen, const Wish& wish) {
  const std::vector<std::size_t> front = pareto_front(methods);
  const auto place = std::ranges::find(front, chosen);
  std::string why = fmt::format("{} for {}", words_of(methods[chosen]), wish_words(wish));
  const Errors& casters = methods[chosen].on(Region::casters);
  if (casters.rmse > kLargeOnCasters) {
    why += fmt::format("; on casters its RMSE is {:.2f}", casters.rmse);
  }
  if (place != front.begin() && place != front.end()) {
    why += fmt::format("; what is faster is less exact: {}", words_of(methods[*(place - 1)]));
  }
  if (place != front.end() && place + 1 != front.end()) {
    why += fmt::format("; what is more exact is slower: {}", words_of(methods[*(place + 1)]));
  }
  return why;
}

std::string nearest_misses(const std::vector<Measured>& methods, const Wish& wish) {
  const std::vector<std::size_t> front = pareto_front(methods);
  if (front.empty()) return "no method renders the scene";
  std::string why = "no method reaches " + wish_words(wish);
  if (wish.budget_seconds) {
    why += fmt::format("; the fastest is {}", words_of(methods[front.front()]));
  }
  if (wish.max_error) why += fmt::format("; the most exact is {}", words_of(methods[front.back()]));
  return why;
}

}  // namespace

double error_of(const Measured& measured) {
  const Errors& receivers = measured.on(Region::receivers);
  return receivers.values > 0 ? receivers.rmse : measured.on(Region::surfaces).rmse;
}

double seconds_of(const Measured& measured) { return measured.timing.all_threads; }

double bytes_of(const Measured& measured) { return static_cast<double>(measured.accesses.bytes); }

std::vector<std::size_t> pareto_front(const std::vector<Measured>& methods) {
  return pareto_front(methods, seconds_of);
}

std::vector<std::size_t> pareto_front(const std::vector<Measured>& methods, Cost cost) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    if (!methods[i].refused && cost(methods[i]) > 0.0) order.push_back(i);
  }
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    if (cost(methods[a]) != cost(methods[b])) return cost(methods[a]) < cost(methods[b]);
    return error_of(methods[a]) < error_of(methods[b]);
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (front.empty() || error_of(methods[i]) < error_of(methods[front.back()])) front.push_back(i);
  }
  return front;
}

Recommendation recommend(const std::vector<Measured>& methods, const Wish& wish) {
  std::optional<std::size_t> best;
  for (const std::size_t i : pareto_front(methods)) {
    if (!fits(methods[i], wish)) continue;
    best = i;
    if (wish.max_error) break;  // the first is the fastest, the last the most exact
  }
  if (!best) return {best, nearest_misses(methods, wish)};
  return {best, reason(methods, *best, wish)};
}

}  // namespace wedgesim::reports::accuracy
