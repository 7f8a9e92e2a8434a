#include "parity/pair.h"

#include "parity/moving_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace plain {

Difference difference_of(const std::vector<float>& a, const std::vector<float>& b) {
    assert(a.size() == b.size());
    Difference difference;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double apart = std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
        difference.mean += apart / static_cast<double>(a.size());
        difference.largest = std::max(difference.largest, apart);
    }
    return difference;
}

Result<Pair> Pair::open(const std::filesystem::path& preset, Extent original, Extent viewport) {
    const auto roots = find_roots({});
    if (!roots)
        return fail(roots.error());
    RenderRequest request;
    request.look = preset.string();
    request.size = viewport;
    request.source = fmt::format("pattern:harbour,size={}x{}", original.width, original.height);
    auto prepared = prepare(request, Library(*roots));
    if (!prepared)
        return fail(prepared.error());
    auto ours = Offline::create(std::move(*prepared), viewport, 60.0);
    if (!ours)
        return fail(ours.error());
    Pair pair;
    pair.m_original = original;
    pair.m_ours = std::make_unique<Offline>(std::move(*ours));
    if (auto off = pair.m_ours->set_nan_policy(NanPolicy::off); !off)
        return fail(off.error());
    const auto parsed = parse_chain(preset);
    if (!parsed)
        return fail(parsed.error());
    const Names names = names_of(*parsed);
    pair.m_reads_the_past = history_of(*parsed, names) > 0;
    for (int i = 0; i < static_cast<int>(parsed->preset.passes.size()); ++i)
        pair.m_reads_the_past = pair.m_reads_the_past || has_feedback(*parsed, names, i);
    auto chain = Chain::make(*parsed, original, viewport);
    if (!chain)
        return fail(chain.error());
    pair.m_plain = std::make_unique<Chain>(std::move(*chain));
    return pair;
}

Result<void> Pair::set_original(const Bytes& picture) {
    m_plain->set_original(picture);
    return m_ours->override_source(picture_of(picture));
}

Difference Pair::difference() const {
    return difference_of(m_ours->picture().pixels, m_plain->picture());
}

Result<Difference> Pair::compare(int frames) {
    Difference worst;
    for (int frame = 0; frame < frames; ++frame) {
        if (auto set = set_original(moving_picture(m_original, frame)); !set)
            return fail(set.error());
        draw_ours();
        draw_plain();
        if (frame > 0 && frame + 1 < frames)
            continue;
        const Difference now = difference();
        worst = {std::max(worst.mean, now.mean), std::max(worst.largest, now.largest)};
    }
    return worst;
}

}  // namespace plain
