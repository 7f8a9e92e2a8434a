#include "lab/offline/loop.h"

#include "base/text.h"
#include "lab/offline/offline.h"
#include "lab/playback/played_signal.h"
#include "model/picture/display_bytes.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace {
Repetition repetition_of_signal(const Document& document, const PlayedSignal& signal) {
    Repetition repetition;
    if (document.look().driven_by != Driver::signal || !signal.get())
        return repetition;
    const SignalKind* const kind = find_kind(document.state().signal.kind);
    if (kind && (kind->is_live || kind->is_sent)) {
        repetition.error = "live input never repeats. Choose another signal.";
        return repetition;
    }
    const auto sound = signal.sound_stream();
    if (!sound)
        return signal.get()->repetition();
    if (!sound->loops())
        repetition.error = "the sound plays only once. Set its loop to on.";
    else
        repetition.hertz.push_back({sound->rate(), sound->length()});
    return repetition;
}
}  // namespace

Repetition repetition_of(const Document& document, const PlayedSignal& signal) {
    Repetition repetition = repetition_of_signal(document, signal);
    for (const auto& [name, modulation] : document.state().modulations) {
        if (modulation.kind != ModulationKind::lfo || modulation.depth == 0.0)
            continue;
        if (modulation.shape == LfoShape::random && repetition.error.empty())
            repetition.error = fmt::format(
                "the LFO of '{}' has random steps, which never repeat. Choose another shape.",
                name);
        repetition.add(modulation.is_in_beats
                           ? 1.0 / (modulation.period * document.state().tempo.seconds_per_beat())
                           : modulation.rate);
    }
    return repetition;
}

namespace {
std::string rates_text(const std::vector<double>& rates) {
    std::vector<std::string> texts;
    for (const double rate : rates)
        texts.push_back(format_number(std::round(rate * 1000.0) / 1000.0));
    return fmt::format("{}", fmt::join(texts, ", "));
}
}  // namespace

Result<std::int64_t> loop_frames(const Fraction& seconds, double fps) {
    if (const auto frames = frames_of_period(seconds, fps))
        return *frames;
    return fail({{},
                 0,
                 fmt::format("the picture repeats after {:.6g} s, which is not a whole number of "
                             "frames at {} fps. Frame rates that fit: {}.",
                             seconds.number(), format_number(fps),
                             rates_text(fitting_rates(seconds, fps)))});
}

bool PeriodFinder::is_same(std::int64_t frames_ago) const {
    constexpr int tolerance = 1;  // in 1/255
    const auto at = [&](std::int64_t number) -> const std::vector<std::uint8_t>& {
        return m_pictures[static_cast<std::size_t>(number % (m_longest + 1))];
    };
    const auto& now = at(m_count);
    const auto& before = at(m_count - frames_ago);
    for (std::size_t i = 0; i < now.size(); ++i)
        if (std::abs(int{now[i]} - int{before[i]}) > tolerance)
            return false;
    return true;
}

std::optional<std::int64_t> PeriodFinder::add(std::vector<std::uint8_t> picture) {
    m_pictures.resize(static_cast<std::size_t>(m_longest + 1));
    m_runs.resize(static_cast<std::size_t>(m_longest / m_step), 0);
    m_pictures[static_cast<std::size_t>(m_count % (m_longest + 1))] = std::move(picture);
    std::optional<std::int64_t> found;
    for (std::size_t i = 0; i < m_runs.size() && !found; ++i) {
        const std::int64_t period = m_step * static_cast<std::int64_t>(i + 1);
        if (period > m_count)
            break;
        m_runs[i] = is_same(period) ? m_runs[i] + 1 : 0;
        if (m_runs[i] >= std::max(period, m_least))
            found = period;
    }
    ++m_count;
    return found;
}

namespace {
constexpr double longest_search = 120.0;      // s
constexpr std::int64_t most_pictures = 4096;  // in memory

// A picture of the same shape, large enough to see a change.
Extent small_extent(Extent extent) {
    constexpr int long_side = 128;
    const int longer = std::max(extent.width, extent.height);
    const auto side = [&](int length) {
        return std::max(1, static_cast<int>(std::lround(static_cast<double>(length) *
                                                        std::min(longer, long_side) / longer)));
    };
    return {side(extent.width), side(extent.height)};
}

// The period that is known before drawing; a step of one frame if nothing tells it.
Result<std::int64_t> known_frames(const Repetition& repetition, const LoopSearch& search) {
    if (!repetition.error.empty())
        return fail({{}, 0, fmt::format("can't loop: {}", repetition.error)});
    if (search.seconds > 0.0)
        return loop_frames(fraction_of(search.seconds), search.fps);
    const auto period = common_period(repetition);
    if (!period)
        return fail({{},
                     0,
                     "can't loop: the frequencies of the signal and of the LFOs have no common "
                     "period below an hour. Round the frequencies, or set the period with "
                     "--seconds or in the field Period."});
    return loop_frames(*period, search.fps);
}

tl::unexpected<Diagnostics> not_found() {
    return fail({{},
                 0,
                 fmt::format("can't loop: the picture does not repeat within {} s. Set the period "
                             "with --seconds, or in the field Period.",
                             format_number(longest_search))});
}

// Draws until the picture repeats.
Result<std::optional<ExportPart>> drawn_loop(Offline& small, std::int64_t step, bool is_exact,
                                             const LoopSearch& search) {
    constexpr double longest_unknown = 30.0;  // s
    const auto second = static_cast<std::int64_t>(std::ceil(search.fps));
    const auto limit = std::max(static_cast<std::int64_t>(longest_search * search.fps), 3 * step);
    const auto most =
        std::min(static_cast<std::int64_t>(longest_unknown * search.fps), most_pictures);
    const std::int64_t longest = is_exact ? step : std::max(step, most / step * step);
    const std::int64_t settled = small.document().look().settle_frames;
    PeriodFinder finder(step, longest, second);
    for (std::int64_t drawn = 1; drawn <= limit; ++drawn) {
        if (!search.should_continue(drawn, limit))
            return std::nullopt;
        small.advance();
        const auto period = finder.add(display_bytes(small.picture()));
        if (period && drawn >= settled)
            return ExportPart{drawn, drawn + *period};
    }
    return not_found();
}
}  // namespace

Result<std::optional<ExportPart>> find_loop(const Document& document, const LoopSearch& search) {
    auto small = Offline::create({document, {}}, small_extent(search.extent), search.fps);
    if (!small)
        return fail(small.error());
    const auto step = known_frames(repetition_of(document, small->signal()), search);
    if (!step)
        return fail(step.error());
    if (*step > most_pictures) {
        const auto settled = static_cast<std::int64_t>(document.look().settle_frames);
        return ExportPart{settled, settled + *step};
    }
    return drawn_loop(*small, *step, search.seconds > 0.0, search);
}
