#pragma once

#include "lab/compare/compared_pictures.h"
#include "lab/frame/frame_loop.h"
#include "lab/inspect/flash_limiter.h"
#include "lab/inspect/texel_inspector.h"
#include "lab/views/displayed_texture.h"
#include "lab/views/view_image.h"

#include <array>
#include <memory>

/// The main view of the window: the picture or the inspected texture, its comparison with a
/// reference, and the picture for the output window. Passes them through the flash limiter.
class MainView {
public:
    static Result<MainView> make();

    struct Subject {
        const Renderer& renderer;
        const FrameLoop& frames;
        const WindowState& window;
        const DisplayedTexture* inspected = nullptr;  // null: nothing is inspected
        double seconds = 0.0;
    };
    /// Uses the view programs of another look; null: nothing is displayed.
    void set_context(std::shared_ptr<ContextViews> context);
    /// Draws the view. `is_moving`: the picture may change.
    void update(const Subject& subject, bool is_moving);
    /// Updates texel values over the view, values along the waveform's line, and flashes.
    void measure(const Subject& subject, TexelInspector& texels);

    ViewImage picture() const { return image_of(m_shown[0]); }
    /// The reference in a side-by-side comparison; both pictures have the size of size_of_one().
    ViewImage reference() const { return image_of(m_shown[1]); }
    /// The picture in the size of the output window; null: not drawn.
    const gpu::Texture* output() const { return m_shown[2]; }
    /// The content of picture() in memory, without the flash limiter; empty: not drawn. Waits for
    /// the GPU.
    Picture read_picture() const;
    /// The pictures and measured differences of a comparison.
    const ComparedPictures& compared() const { return m_compared; }
    /// Flashes within the last second; 0 while they are not measured.
    Flashes flashes() const { return m_context ? m_context->flash_meter.flashes() : Flashes{}; }
    /// Whether the view still changes for a while although the lab is idle.
    bool is_transitioning(double seconds) const;

private:
    MainView(ComparedPictures compared, FlashLimiter limiter)
        : m_compared(std::move(compared)), m_limiter(std::move(limiter)) {}

    DisplayedTexture displayed(const Subject& subject) const;
    void draw_picture(const Subject& subject);
    bool draw_step(const Subject& subject);
    void compare(const Subject& subject, const DisplayedTexture& shown);
    void draw_wiped(const Subject& subject, DisplayedTexture shown);
    void draw_difference(const Subject& subject, DisplayedTexture shown);
    void draw_output(const Subject& subject);
    void limit_flashes(const Subject& subject, bool is_moving);
    void count_flashes(const Subject& subject);

    std::shared_ptr<ContextViews> m_context;  // of the displayed look; null: not created
    ComparedPictures m_compared;
    FlashLimiter m_limiter;
    std::array<const gpu::Texture*, 3>
        m_shown{};  // limited picture, reference and output; null: not drawn
};
