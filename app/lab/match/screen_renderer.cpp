#include "lab/match/screen_renderer.h"

#include "lab/offline/output_precision.h"

namespace {
// Looks whose picture depends on earlier frames are drawn until they have settled.
int frames_of(const Look& look) {
    for (const Pass& pass : look.passes)
        for (const Input& input : pass.inputs)
            if (input.frames_ago > 0)
                return std::max(look.settle_frames, 1);
    return 1;
}
}  // namespace

Result<ScreenRenderer> ScreenRenderer::create(PreparedLook prepared, Extent size,
                                              std::set<std::string> moving) {
    constexpr double fps = 60.0;
    raise_precision(prepared.document);
    auto offline = Offline::create(std::move(prepared), size, fps);
    if (!offline)
        return fail(offline.error());
    if (auto off = offline->set_nan_policy(NanPolicy::off); !off)  // the reader clamps NaN
        return fail(off.error());
    auto reader = SampleReader::make();
    if (!reader)
        return fail(reader.error());
    return ScreenRenderer(std::move(*offline), std::move(*reader), size, std::move(moving));
}

ScreenRenderer::ScreenRenderer(Offline offline, SampleReader reader, Extent size,
                               std::set<std::string> moving)
    : m_offline(std::move(offline)),
      m_reader(std::move(reader)),
      m_layout(size),
      m_document(m_offline.document()),
      m_frames(frames_of(m_document.look())),
      m_moving(std::move(moving)) {}

Result<void> ScreenRenderer::draw(const Values& values) {
    m_document.amend([&](DocumentState& state) {
        for (const auto& [name, value] : values)
            state.values[name] = value;
    });
    if (auto begun = m_offline.start_again(m_document); !begun)
        return begun;
    if (auto done = specialize(); !done)
        return done;
    for (int frame = 0; frame < m_frames; ++frame)
        m_offline.advance();
    ++m_count;
    return {};
}

// A mask that is only tried is not worth the time that programs take to compile.
Result<void> ScreenRenderer::specialize() {
    constexpr int tried = 6;  // pictures
    const bool is_specialized = m_offline.executor().programs().is_specialized();
    m_generic_count = is_specialized ? 0 : m_generic_count + 1;
    if (!m_moving.empty() && m_generic_count == tried)  // once, even if it is refused
        return m_offline.specialize({}, m_moving);
    return {};
}

Result<ScreenLight> ScreenRenderer::light(const Values& values, const SampleLayout& layout) {
    if (auto drawn = draw(values); !drawn)
        return fail(drawn.error());
    const int last = static_cast<int>(look().passes.size()) - 1;
    const Encoding encoding = m_offline.executor().look().output;
    return m_reader.read(m_offline.executor().target(last), encoding, layout);
}

Result<Picture> ScreenRenderer::picture(const Values& values) {
    if (auto drawn = draw(values); !drawn)
        return fail(drawn.error());
    return m_offline.picture();
}
