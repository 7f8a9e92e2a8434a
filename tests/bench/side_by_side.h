#pragma once

#include "bench/figure.h"
#include "gpu/objects/draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

namespace bench {

/// CPU time of the whole process, including the driver's threads. With AFTERGLOW_BENCH_CLOCK=wall
/// it is elapsed time, because a GPU works while the CPU waits.
inline double busy_seconds() {
    static const char* const wanted = std::getenv("AFTERGLOW_BENCH_CLOCK");
    static const bool is_wall = wanted && std::string_view(wanted) == "wall";
    timespec now{};
    clock_gettime(is_wall ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double median(std::vector<double> numbers) {
    std::ranges::sort(numbers);
    return numbers[numbers.size() / 2];
}

/// CPU time of a number of frames, each ending in glFinish.
template <class Draw>
double seconds_of(int frames, Draw draw) {
    const double start = busy_seconds();
    for (int i = 0; i < frames; ++i) {
        draw();
        gpu::finish();
    }
    return busy_seconds() - start;
}

/// Cost of our frame compared with the reference's: medians over rounds.
struct Cost {
    double plain_milliseconds = 0.0;
    double our_milliseconds = 0.0;
    double ratio = 0.0;   // ours to plain
    double more = 0.0;    // ms, ours over plain
    double itself = 0.0;  // the reference before ours relative to the reference after
    bool counts() const { return is_itself(itself); }
};

/// Rounds of the reference, with our rounds between them.
class CostOfTurns {
public:
    explicit CostOfTurns(int frames) : m_frames(frames) {}

    void add(double before, double between, double behind) {
        m_ratios.push_back(2.0 * between / (before + behind));
        m_more.push_back(milliseconds(between - 0.5 * (before + behind)));
        m_itself.push_back(before / behind);
        m_plain.push_back(milliseconds(before));
        m_ours.push_back(milliseconds(between));
    }
    Cost cost() const {
        return {median(m_plain), median(m_ours), median(m_ratios), median(m_more),
                median(m_itself)};
    }

private:
    double milliseconds(double seconds) const { return 1e3 * seconds / m_frames; }

    int m_frames;
    std::vector<double> m_ratios;
    std::vector<double> m_more;
    std::vector<double> m_itself;
    std::vector<double> m_plain;
    std::vector<double> m_ours;
};

constexpr int warm_up_frames = 5;

/// Alternates reference, ours, reference, ours and so on, ending with the reference. A round is
/// ours with the reference before and after it.
template <class Plain, class Ours>
Cost side_by_side(int rounds, int frames, Plain plain, Ours ours) {
    seconds_of(warm_up_frames, plain);
    seconds_of(warm_up_frames, ours);
    CostOfTurns turns(frames);
    double before = seconds_of(frames, plain);
    for (int i = 0; i < rounds; ++i) {
        const double between = seconds_of(frames, ours);
        const double behind = seconds_of(frames, plain);
        turns.add(before, between, behind);
        before = behind;
    }
    return turns.cost();
}

/// The same within a number of seconds of CPU time, in many short rounds, because the clock rate of
/// a machine may change within seconds.
template <class Plain, class Ours>
Cost side_by_side_for(double seconds, Plain plain, Ours ours) {
    constexpr double turn_seconds = 0.02;
    constexpr int min_rounds = 9;
    constexpr int max_rounds = 301;
    seconds_of(warm_up_frames, plain);
    seconds_of(warm_up_frames, ours);
    const double plain_frame = seconds_of(warm_up_frames, plain) / warm_up_frames;
    const double our_frame = seconds_of(warm_up_frames, ours) / warm_up_frames;
    const int frames = std::max(1, static_cast<int>(turn_seconds / plain_frame));
    const double round_seconds = frames * (plain_frame + our_frame);
    return side_by_side(
        std::clamp(static_cast<int>(seconds / round_seconds), min_rounds, max_rounds), frames,
        plain, ours);
}

/// Our cost relative to plain.
inline Figure ratio_figure(std::string key, std::string what, const Cost& cost,
                           std::optional<Bound> bound = {}) {
    return {.key = std::move(key),
            .what = std::move(what),
            .value = cost.ratio,
            .bound = bound,
            .itself = cost.itself,
            .detail = fmt::format("{:.4g} ms, reference {:.4g} ms", cost.our_milliseconds,
                                  cost.plain_milliseconds)};
}

/// The same over the valid ones of several openings. The location of code and textures in memory
/// makes either side faster or slower for as long as it is open.
inline Figure ratio_figure(std::string key, std::string what, const std::vector<Cost>& openings,
                           std::optional<Bound> bound = {}) {
    std::vector<Cost> costs;
    std::ranges::copy_if(openings, std::back_inserter(costs), &Cost::counts);
    const std::size_t counting = costs.size();
    if (costs.empty())
        costs.push_back(openings.front());
    const auto middle = [&costs](double Cost::*number) {
        std::vector<double> numbers;
        for (const Cost& cost : costs)
            numbers.push_back(cost.*number);
        return median(std::move(numbers));
    };
    const Cost cost{middle(&Cost::plain_milliseconds), middle(&Cost::our_milliseconds),
                    middle(&Cost::ratio), middle(&Cost::more), middle(&Cost::itself)};
    const auto [minimum, maximum] = std::ranges::minmax(costs, {}, &Cost::ratio);
    Figure figure = ratio_figure(std::move(key), std::move(what), cost, bound);
    figure.detail += fmt::format("; {:.3f} to {:.3f}, {} of {} openings valid", minimum.ratio,
                                 maximum.ratio, counting, openings.size());
    return figure;
}

/// Our cost minus plain.
inline Figure more_figure(std::string key, std::string what, const Cost& cost, Bound bound) {
    Figure figure = ratio_figure(std::move(key), std::move(what), cost, bound);
    figure.value = cost.more;
    figure.unit = "ms";
    return figure;
}

}  // namespace bench
