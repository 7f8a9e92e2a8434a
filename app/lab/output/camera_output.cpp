#include "lab/output/camera_output.h"

#include "gpu/objects/readback.h"
#include "lab/messages/messages.h"
#include "lab/rendering/renderer.h"
#include "lab/window/output_state.h"

#include <fmt/format.h>

#include <utility>

namespace {
constexpr double rate = 60.0;  // pictures per second
}

bool CameraOutput::open(Extent extent, Messages& messages) {
    const bool is_again = m_feed != nullptr;  // the size has changed
    m_feed.reset();
    m_shown.reset();
    const VirtualCameraSpec spec = usual_virtual_camera();
    auto camera = open_virtual_camera(spec, extent, frame_rate_fraction(rate));
    if (!camera) {
        messages.say(fmt::format("Can't open a virtual camera: {}", camera.error().front().message),
                     true, "virtual camera");
        return false;
    }
    m_feed = std::make_unique<CameraFeed>(std::move(*camera), rate, m_wake);
    m_extent = extent;
    if (!is_again)
        messages.say(fmt::format(
            "Virtual camera on. Choose the camera \"{}\" in the other program.", spec.name));
    return true;
}

void CameraOutput::show(const Renderer& renderer, const Shown& wanted) {
    const Executor& executor = renderer.executor();
    RawPicture picture;
    gpu::read_raw(executor.target(wanted.pass), picture);
    picture.encoding = encoding_of(executor.look(), wanted.pass);
    m_feed->show(std::move(picture));
    m_shown = wanted;
}

void CameraOutput::keep_black() {
    if (!std::exchange(m_shown, std::nullopt) && !m_feed->needs_picture())
        return;
    RawPicture black{m_extent, 3, Encoding::display, RawPicture::Bytes()};
    std::get<RawPicture::Bytes>(black.pixels)
        .resize(black.row_length() * static_cast<std::size_t>(m_extent.height));
    m_feed->show(std::move(black));
}

// Programs lose a camera that is opened again, so its size must have been steady for a while.
bool CameraOutput::is_changing(Extent extent) {
    constexpr auto steady = std::chrono::milliseconds(300);  // updates continue for longer
    const auto now = std::chrono::steady_clock::now();
    if (!m_feed || extent == m_extent || extent != m_wanted_extent)
        m_wanted_since = now;
    m_wanted_extent = extent;
    return m_feed && extent != m_extent && now - m_wanted_since < steady;
}

void CameraOutput::update(OutputState& state, const Renderer* renderer, int pass,
                          Messages& messages) {
    if (!state.is_camera_on) {
        m_feed.reset();
        return;
    }
    if (std::string problem = m_feed ? m_feed->problem() : ""; !problem.empty()) {
        m_feed.reset();
        state.is_camera_on = false;
        return messages.say(std::move(problem), true, "virtual camera");
    }
    const bool is_black = state.is_black || (renderer && renderer->executors().inputs().is_black);
    if (m_feed && is_black)
        return keep_black();  // also while a frame is drawn slowly
    if (!renderer || !renderer->has_whole_picture())
        return;
    const Extent extent = renderer->executor().target(pass).extent();
    if (is_changing(extent))
        return;
    if ((!m_feed || extent != m_extent) && !open(extent, messages)) {
        state.is_camera_on = false;
        return;
    }
    if (is_black)
        return keep_black();
    const Shown wanted{renderer->executor().textures().number(), pass};
    if (m_feed->needs_picture() || (m_feed->is_watched() && wanted != m_shown))
        show(*renderer, wanted);
}
