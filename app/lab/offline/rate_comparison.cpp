#include "lab/offline/rate_comparison.h"

#include "lab/offline/offline.h"
#include "model/look/color.h"
#include "signals/signal_table.h"

#include <algorithm>
#include <cmath>

double comparison_seconds(const Look& look) {
    constexpr double common = 6.0;  // greatest common divisor of all rates
    constexpr double shortest = 0.5;
    constexpr double longest = 10.0;
    const double specialized = std::clamp(look.settle_frames / 60.0, shortest, longest);
    return std::ceil(specialized * common - 1e-9) / common;
}

Extent size_to_compare(Extent picture) {
    constexpr int max_lines = 360;
    if (picture.height <= max_lines)
        return picture;
    const double scale = static_cast<double>(max_lines) / picture.height;
    return {std::max(1, static_cast<int>(std::lround(picture.width * scale))), max_lines};
}

std::size_t RateComparison::worst_index() const {
    const auto worst = std::ranges::max_element(
        pairs, {}, [](const RatePair& pair) { return pair.difference.largest; });
    return static_cast<std::size_t>(worst - pairs.begin());
}

const Picture& RateComparison::picture(double fps) const {
    const auto* const rate = std::ranges::find(compared_rates, fps);
    return pictures.at(static_cast<std::size_t>(rate - compared_rates.begin()));
}

namespace {
Result<void> check_driver(const Document& document) {
    if (document.look().driven_by != Driver::signal)
        return {};
    const SignalKind* kind = find_kind(document.state().signal.kind);
    if (kind && (kind->is_live || kind->is_sent))
        return fail({{},
                     0,
                     "live input can't be replayed. Choose another signal to compare frame "
                     "rates."});
    return {};
}

int frames_in(double seconds, double fps) {
    return static_cast<int>(std::lround(seconds * fps));
}

// The picture as a display shows it.
Picture shown(Picture picture) {
    const bool is_linear = picture.encoding == Encoding::linear;
    for (float& number : picture.pixels) {
        const double light = std::clamp(static_cast<double>(number), 0.0, 1.0);
        number = static_cast<float>(is_linear ? srgb_encode(light) : light);
    }
    return picture;
}
}  // namespace

Result<RateComparison> compare_rates(const Document& document, Extent picture, JobProgress& work) {
    if (auto good = check_driver(document); !good)
        return fail(good.error());
    RateComparison comparison{
        comparison_seconds(document.look()), size_to_compare(picture), {}, {}};
    auto offline = Offline::create({document, {}}, comparison.size, compared_rates.front());
    if (!offline)
        return fail(offline.error());
    double all = 0.0;
    for (const double fps : compared_rates)
        all += frames_in(comparison.seconds, fps);
    double done = 0.0;
    std::vector<Picture>& pictures = comparison.pictures;
    for (const double fps : compared_rates) {
        if (auto begun = offline->start_again(document, fps); !begun)
            return fail(begun.error());
        const int frames = frames_in(comparison.seconds, fps);
        for (int frame = 1; frame <= frames; ++frame) {
            if (work.is_cancelled)
                return fail({{}, 0, "the comparison was cancelled"});
            frame < frames ? offline->advance_unseen() : offline->advance();
            work.share = ++done / all;
        }
        pictures.push_back(shown(offline->picture()));
    }
    if (const Diagnostics problems = offline->take_problems(); has_errors(problems))
        return fail(problems);
    for (std::size_t i = 0; i < pictures.size(); ++i)
        for (std::size_t j = i + 1; j < pictures.size(); ++j) {
            auto difference = difference_between(pictures[i], pictures[j], 1.0 / 255.0);
            if (!difference)
                return fail(difference.error());
            comparison.pairs.push_back({compared_rates[i], compared_rates[j], *difference});
        }
    return comparison;
}
