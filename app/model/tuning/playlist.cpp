#include "model/tuning/playlist.h"

#include "model/tuning/random_numbers.h"

#include <numeric>
#include <utility>

namespace {
// Fisher-Yates.
std::vector<std::size_t> shuffled_round(std::int64_t round, std::size_t count, std::uint64_t seed) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    constexpr std::uint64_t apart = 0xd1342543de82ef95u;  // odd: gives each round its own seed
    RandomNumbers random(seed ^ (static_cast<std::uint64_t>(round) * apart));
    for (std::size_t i = count; i > 1; --i)
        std::swap(order[i - 1],
                  order[static_cast<std::size_t>(random.choose(static_cast<double>(i)))]);
    return order;
}
}  // namespace

std::size_t playlist_index(std::int64_t step, std::size_t count, bool is_shuffled,
                           std::uint64_t seed) {
    const auto length = static_cast<std::int64_t>(count);
    const std::int64_t within = ((step % length) + length) % length;
    if (!is_shuffled || count < 3)
        return static_cast<std::size_t>(within);
    const std::int64_t round = (step - within) / length;
    std::vector<std::size_t> order = shuffled_round(round, count, seed);
    // Only the first two are exchanged, and there are at least three, so the last one of the
    // previous round is the one of its own shuffle.
    if (order.front() == shuffled_round(round - 1, count, seed).back())
        std::swap(order[0], order[1]);
    return order[static_cast<std::size_t>(within)];
}
