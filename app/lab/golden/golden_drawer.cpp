#include "lab/golden/golden_drawer.h"

#include "gpu/headless_context.h"
#include "io/system/machine_memory.h"
#include "lab/document/live_content.h"
#include "model/picture/display_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace {
constexpr int max_settled_frames = 60;
constexpr double frames_per_second = 60.0;

// A path, also for a folder without '/', which could be the name of a look.
std::string argument_of(const GoldenItem& item) {
    const std::string path = item.file.string();
    return item.preset.empty() && path.find('/') == std::string::npos ? path + '/' : path;
}
}  // namespace

Result<GoldenDriver> read_golden_driver() {
    const auto context = gpu::create_headless_context();
    if (!context)
        return fail(context.error());
    const gpu::DriverInfo& info = (*context)->info();
    return GoldenDriver{info.vendor, info.renderer, info.version};
}

Result<void> GoldenDrawer::start(PreparedLook prepared, Extent size) {
    if (m_offline && m_size == size &&
        m_offline->document().drawn_look() == prepared.document.drawn_look())
        return m_offline->start_again(std::move(prepared.document));
    m_offline.reset();
    auto offline = Offline::create(std::move(prepared), size, frames_per_second);
    if (!offline)
        return fail(offline.error());
    m_offline.emplace(std::move(*offline));
    m_size = size;
    return {};
}

Result<GoldenDrawing> GoldenDrawer::draw(const GoldenItem& item, Extent size,
                                         std::optional<int> frames) {
    auto prepared = prepare({.look = argument_of(item), .size = size}, m_library);
    if (!prepared)
        return fail(prepared.error());
    GoldenDrawing drawing{.size = size, .warnings = std::move(prepared->warnings)};
    drawing.skipped = why_not_repeatable(prepared->document);
    if (!drawing.skipped.empty())
        return drawing;
    if (auto fits = check_memory(*prepared, size, machine_memory()); !fits)
        return fail(fits.error());
    const int settled = std::clamp(prepared->document.look().settle_frames, 1, max_settled_frames);
    drawing.frames = frames.value_or(settled);
    if (auto started = start(std::move(*prepared), size); !started) {
        m_offline.reset();
        return fail(started.error());
    }
    drawing.rgb = display_bytes(m_offline->picture_after(drawing.frames));
    const Diagnostics problems = m_offline->take_problems();
    if (!problems.empty())
        m_offline.reset();  // problems are reported only once
    if (has_errors(problems))
        return fail(problems);
    drawing.warnings.insert(drawing.warnings.end(), problems.begin(), problems.end());
    return drawing;
}
