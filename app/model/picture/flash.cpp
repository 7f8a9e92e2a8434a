#include "model/picture/flash.h"

#include <algorithm>
#include <cassert>
#include <utility>

double luminance(const Light& light) {
    return 0.2126 * static_cast<double>(light[0]) + 0.7152 * static_cast<double>(light[1]) +
           0.0722 * static_cast<double>(light[2]);
}

namespace {
constexpr auto cell_count =
    static_cast<std::size_t>(flash_cells.width) * static_cast<std::size_t>(flash_cells.height);
constexpr std::size_t quarter =
    static_cast<std::size_t>(flash_field.width * flash_field.height) / 4;
constexpr double period_seconds = 1.0;
constexpr double same_moment = 1e-6;  // s; an event exactly one period ago does not count
constexpr float rounding = 1e-5f;     // a change of 0.1 that floats round to 0.0999999 counts

float red_number(const Light& light) {
    return std::max(0.0f, (light[0] - light[1] - light[2]) * 320.0f);
}

bool is_saturated_red(const Light& light) {
    const float sum = light[0] + light[1] + light[2];
    return sum > 0.0f && light[0] >= 0.8f * sum;
}
}  // namespace

// A reversal since the last extreme by at least the counted amount is a change. The new extremes
// start there.
template <class Counts>
bool FlashCounter::Swing::add(const State& now, Counts counts) {
    if (std::exchange(is_new, false))
        low = high = now;
    const bool is_up = direction <= 0 && counts(low, now);
    const bool is_down = direction >= 0 && !is_up && counts(now, high);
    if (is_up || is_down) {
        direction = is_up ? 1 : -1;
        low = high = now;
        return true;
    }
    if (now.number < low.number)
        low = now;
    if (now.number > high.number)
        high = now;
    return false;
}

FlashCounter::FlashCounter() {
    for (Tally* tally : {&m_general, &m_red}) {
        tally->swings.resize(cell_count);
        tally->changes.resize(cell_count);
    }
}

Flashes FlashCounter::add(double seconds, std::span<const Light> cells) {
    assert(cells.size() == cell_count);
    const auto is_general = [](const Swing::State& dark, const Swing::State& light) {
        return light.number - dark.number >= 0.1f - rounding && dark.number < 0.8f - rounding;
    };
    const auto is_red = [](const Swing::State& less, const Swing::State& more) {
        return more.number - less.number > 20.0f && (more.is_red || less.is_red);
    };
    std::vector<std::uint16_t> general;
    std::vector<std::uint16_t> red;
    for (std::size_t cell = 0; cell < cell_count; ++cell) {
        const Light& light = cells[cell];
        const auto bright = static_cast<float>(luminance(light));
        if (m_general.swings[cell].add({bright, false}, is_general))
            general.push_back(static_cast<std::uint16_t>(cell));
        if (m_red.swings[cell].add({red_number(light), is_saturated_red(light)}, is_red))
            red.push_back(static_cast<std::uint16_t>(cell));
    }
    m_general.note(seconds, std::move(general));
    m_red.note(seconds, std::move(red));
    return {m_general.flashes(), m_red.flashes()};
}

void FlashCounter::Tally::note(double seconds, std::vector<std::uint16_t> cells) {
    for (const std::uint16_t cell : cells)
        ++changes[cell];
    if (!cells.empty())
        latest.push_back({seconds, std::move(cells)});
    while (!latest.empty() && latest.front().seconds <= seconds - period_seconds + same_moment) {
        for (const std::uint16_t cell : latest.front().cells)
            --changes[cell];
        latest.pop_front();
    }
}

// The largest number of flashes that more than a quarter of the cells of a field have.
int FlashCounter::Tally::flashes() const {
    const int maximum = *std::ranges::max_element(changes) / 2;  // two changes are a flash
    const int width = flash_cells.width;
    for (int wanted = maximum; wanted > 0; --wanted) {
        // A summed-area table gives the count of any field with three additions.
        const auto row = static_cast<std::size_t>(width) + 1;
        std::vector<std::size_t> sums(row * (static_cast<std::size_t>(flash_cells.height) + 1));
        const auto at = [&](int x, int y) -> std::size_t& {
            return sums[static_cast<std::size_t>(y) * row + static_cast<std::size_t>(x)];
        };
        for (int y = 0; y < flash_cells.height; ++y)
            for (int x = 0; x < width; ++x) {
                const bool counts = changes[static_cast<std::size_t>(y) * (row - 1) +
                                            static_cast<std::size_t>(x)] >= 2 * wanted;
                at(x + 1, y + 1) = at(x, y + 1) + at(x + 1, y) - at(x, y) + (counts ? 1 : 0);
                const int left = x + 1 - flash_field.width;
                const int top = y + 1 - flash_field.height;
                if (left >= 0 && top >= 0 &&
                    at(x + 1, y + 1) - at(left, y + 1) - at(x + 1, top) + at(left, top) > quarter)
                    return wanted;
            }
    }
    return 0;
}
