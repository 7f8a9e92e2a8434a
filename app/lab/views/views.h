#pragma once

#include "gpu/objects/canvas.h"
#include "lab/compare/compared_pictures.h"
#include "lab/inspect/context_views.h"
#include "lab/inspect/flash_limiter.h"
#include "lab/inspect/pins.h"
#include "lab/inspect/texel_inspector.h"
#include "lab/inspect/thumbnails.h"
#include "lab/lab.h"
#include "lab/window/window_state.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

/// The pictures of the open look for the window: picture and inspected texture in their views,
/// thumbnails of all passes, and the probed values.
class Views {
public:
    static Result<Views> make();

    /// Draws the visible views. Call it after Lab::update().
    void update(const Lab& lab, const WindowState& window);

    /// A texture for ImGui, row 0 at the bottom; a handle of 0: not drawn yet.
    struct Image {
        std::uintptr_t handle = 0;
        Extent extent;
    };
    Image picture() const { return image_of(m_shown[0]); }
    /// The reference in a side-by-side comparison; both pictures have the size of room_of_one().
    Image beside() const { return image_of(m_shown[1]); }
    /// Flashes within the last second; 0 while they are not measured.
    Flashes flashes() const { return m_home ? m_home->flash_meter.flashes() : Flashes{}; }
    /// Whether displays still change for a while although the lab is idle.
    bool is_specializing() const;
    /// The pictures and measured differences of a comparison.
    const ComparedPictures& compared() const { return m_compared; }
    /// The content of picture() in memory, without the flash limiter; empty: not drawn. Waits for
    /// the GPU.
    Picture read_picture() const;
    /// The picture in the size of the output window; null: not drawn.
    const gpu::Texture* output() const { return m_shown[2]; }
    Image inspected() const { return m_home ? image_of(m_home->inspected) : Image{}; }
    /// The statistics of the inspected target; nullopt: the inspector is closed, or they are
    /// pending.
    std::optional<Statistics> statistics() const {
        return m_home ? m_home->inspection.statistics() : std::nullopt;
    }
    /// The histogram between the inspector's levels; empty: as for statistics().
    Histogram histogram() const { return m_home ? m_home->inspection.histogram() : Histogram{}; }
    /// The values of all passes at the pins; empty while the pins are hidden.
    const Pins& pins() const { return m_pins; }
    /// Texel values and values along a line; empty while hidden.
    const CloserLook& closer() const { return m_closer; }
    Image thumbnail(std::size_t pass) const;
    /// The level of a pass; null: not measured.
    const Gain* gain(std::size_t pass) const { return m_home ? m_home->gains.gain(pass) : nullptr; }
    /// A display-encoded thumbnail of a pass; nullopt: no memory, or the views belong to another
    /// look.
    std::optional<gpu::Texture> small_picture(const Lab& lab, int pass, Extent extent);
    /// Whether some views do not show the current picture yet. Calls of update() draw them, even
    /// while paused.
    bool is_owing() const {
        return m_thumbnails.is_owing() || m_closer.is_owing() ||
               (m_home && m_home->gains.is_owing());
    }
    /// The stored values of the pixel at WindowState::probe.
    const std::optional<std::array<float, 4>>& probed() const { return m_probed; }

private:
    struct Parts {
        Pins pins;
        ComparedPictures compared;
        FlashLimiter comfort;
        CloserLook closer;
    };
    explicit Views(Parts parts);
    static Image image_of(const gpu::Texture* texture);
    static Image image_of(const std::optional<gpu::Canvas>& canvas);
    bool fit(std::optional<gpu::Canvas>& canvas, Extent extent);
    struct Part {
        const gpu::Texture* texture = nullptr;  // never null
        std::string name = {};                  // of the texture's content
        int pass = 0;  // of the look; negative: not the current picture of a pass
        Extent whole;  // displayed size in px; that of the picture if it replaces it
        PictureView view;
        ViewOptions options;

        CellNumbers::Subject cells(Extent room, Extent least, std::uint64_t picture) const;
    };
    void draw_part(const gpu::Texture& from, std::optional<gpu::Canvas>& to, Extent size,
                   const Part& part);
    Part large_part(const Lab& lab, const WindowState& window) const;
    void draw_picture(const Lab& lab, const WindowState& window);
    void count_flashes(const Lab& lab, const WindowState& window);
    void show_strip(const Lab& lab, int height);
    void show_in_comfort(const Lab& lab, const FlashLimit& clamp);
    bool draw_step(const Lab& lab, const WindowState& window);
    void compare(const Lab& lab, const Part& part);
    void draw_wiped(const Lab& lab, Part part, const WindowState& window);
    void draw_difference(const Lab& lab, Part part, const WindowState& window);
    void draw_output(const Lab& lab, Extent extent);
    void inspect(const Executor& executor, const WindowState& window);
    void draw_inspected(const Executor& executor, const WindowState& window);
    void look_closer(const Lab& lab, const WindowState& window);
    void probe(const Lab& lab, const std::optional<Probe>& probe);

    void move_to(const Programs& programs);
    void stop();

    std::unique_ptr<ContextViews> m_home;  // of the displayed look; null: not created
    Pins m_pins;
    Thumbnails m_thumbnails;
    bool m_is_first = true;        // before the first update
    bool m_measures_gains = true;  // alternates with thumbnails
    ComparedPictures m_compared;
    FlashLimiter m_comfort;
    CloserLook m_closer;
    std::optional<Part> m_inspected_part;  // of this update; nullopt: not visible
    std::array<const gpu::Texture*, 3>
        m_shown{};  // limited picture, beside and output; null: not drawn
    std::optional<std::array<float, 4>> m_probed;
};

/// The display options for a target with this encoding.
ViewOptions options_for(const PassView& view, Encoding encoding);

/// The probed texel of the displayed pass at a position of the picture, px from the top left.
Probe picture_probe(const Lab& lab, const std::array<double, 2>& place);

/// The inspected pass; the last one if the chosen pass is empty or no longer exists.
int inspected_pass(const Look& look, const WindowState& window);

/// The view of the inspector; fits everything while the large view is used for navigation.
PictureView inspector_view(const WindowState& window);
