#include "io/virtual_camera/pipewire_camera.h"

#include "io/pipewire/pipewire_video.h"

#include <algorithm>
#include <mutex>

namespace {
class PipeWireCamera final : public VirtualCamera {
public:
    Result<void> open(const std::string& name, Extent extent, FrameRateFraction rate) {
        auto video = PipeWireVideo::offer(name, extent, rate,
                                          [this](const PipeWirePixels& pixels) { fill(pixels); });
        if (!video)
            return fail(video.error());
        m_video = std::move(*video);
        return {};
    }

    Result<bool> is_watched() override {
        if (const std::string problem = m_video->problem(); !problem.empty())
            return fail({{}, 0, problem});
        return m_video->is_streaming();
    }

    Result<void> show(std::string_view rgb) override {
        {
            const std::lock_guard lock(m_mutex);
            m_rgb = rgb;
        }
        m_video->send();
        if (const std::string problem = m_video->problem(); !problem.empty())
            return fail({{}, 0, problem});
        return {};
    }

private:
    void fill(const PipeWirePixels& pixels) {
        const std::lock_guard lock(m_mutex);
        const std::size_t count = static_cast<std::size_t>(pixels.extent.width) *
                                  static_cast<std::size_t>(pixels.extent.height);
        if (m_rgb.size() != count * 3) {  // there was none yet
            std::ranges::fill(pixels.bytes, std::uint8_t{0});
            return;
        }
        const auto* from = reinterpret_cast<const std::uint8_t*>(m_rgb.data());
        std::uint8_t* to = pixels.bytes.data();
        for (std::size_t i = 0; i < count; ++i, from += 3, to += 4) {
            to[0] = from[2];
            to[1] = from[1];
            to[2] = from[0];
            to[3] = 255;
        }
    }

    std::mutex m_mutex;
    std::string m_rgb;
    std::unique_ptr<PipeWireVideo> m_video;  // its thread calls fill()
};
}  // namespace

Result<std::unique_ptr<VirtualCamera>> open_pipewire_camera(const std::string& name, Extent extent,
                                                            FrameRateFraction rate) {
    auto camera = std::make_unique<PipeWireCamera>();
    if (auto opened = camera->open(name, extent, rate); !opened)
        return fail(opened.error());
    return camera;
}
