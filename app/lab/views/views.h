#pragma once

#include "gpu/objects/canvas.h"
#include "lab/compare/compared_pictures.h"
#include "lab/inspect/closer_look.h"
#include "lab/inspect/comfort.h"
#include "lab/inspect/home_views.h"
#include "lab/inspect/pins.h"
#include "lab/inspect/thumbnails.h"
#include "lab/lab.h"
#include "lab/window/window_state.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

/// What the window shows of the open look, ready for the screen: the picture and the inspected pass
/// as they lie in their views, a thumbnail of each pass, and the numbers under the pointer.
class Views {
public:
    static Result<Views> make();

    /// Draws those that the window shows. To be called after Lab::update.
    void update(const Lab& lab, const WindowState& window);

    /// A texture as a toolkit takes it (row 0 at the bottom); 0: nothing to show yet.
    struct Image {
        std::uintptr_t handle = 0;
        Extent extent;
    };
    Image picture() const { return image_of(m_shown[0]); }
    /// The other picture of two that are seen side by side; each has room_of_one() to itself.
    Image beside() const { return image_of(m_shown[1]); }
    /// How often the picture flashed within the last second; 0 while nobody wants to know.
    Flashes flashes() const { return m_home ? m_home->flash_meter.flashes() : Flashes{}; }
    /// Whether what is shown changes yet for a while, though the lab rests.
    bool is_settling() const;
    /// What the two pictures of a comparison come to.
    const ComparedPictures& compared() const { return m_compared; }
    /// What there is to show in picture(), as numbers without a person's clamp; empty when nothing.
    /// Waits for the GPU.
    Picture read_picture() const;
    /// The picture as the output window shows it, its size; null: nothing.
    const gpu::Texture* output() const { return m_shown[2]; }
    Image inspected() const { return m_home ? image_of(m_home->inspected) : Image{}; }
    /// What the inspected target's numbers come to; none while the inspector is closed, or until
    /// they have come.
    std::optional<Statistics> statistics() const {
        return m_home ? m_home->inspection.statistics() : std::nullopt;
    }
    /// How they are spread between the inspector's levels; empty likewise.
    Histogram histogram() const { return m_home ? m_home->inspection.histogram() : Histogram{}; }
    /// What each pass has at the pinned points; nothing while they are not shown.
    const Pins& pins() const { return m_pins; }
    /// Numbers of single texels, and along a line; nothing where they are not shown.
    const CloserLook& closer() const { return m_closer; }
    Image thumbnail(std::size_t pass) const;
    /// How loud a pass is; null: not known yet, or nobody asks.
    const Gain* gain(std::size_t pass) const { return m_home ? m_home->gains.gain(pass) : nullptr; }
    /// A small picture of a pass, display values; none where there is no memory, or another look
    /// is seen yet.
    std::optional<gpu::Texture> small_picture(const Lab& lab, int pass, Extent extent);
    /// What is shown of the passes is not all from the present picture yet: it comes when update()
    /// is called again, also while nothing moves.
    bool is_owing() const {
        return m_thumbnails.is_owing() || m_closer.is_owing() ||
               (m_home && m_home->gains.is_owing());
    }
    /// The stored numbers of WindowState::probe's pixel.
    const std::optional<std::array<float, 4>>& probed() const { return m_probed; }

private:
    struct Parts {
        Pins pins;
        ComparedPictures compared;
        Comfort comfort;
        CloserLook closer;
    };
    explicit Views(Parts parts);
    static Image image_of(const gpu::Texture* texture);
    static Image image_of(const std::optional<gpu::Canvas>& canvas);
    bool fit(std::optional<gpu::Canvas>& canvas, Extent extent);
    struct Part {
        const gpu::Texture* texture = nullptr;  // never null
        std::string name = {};                  // of what it holds
        int pass = 0;  // of the look; below 0: it is no pass's present picture
        Extent whole;  // px that it is seen as: of the picture, where it stands in its place
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
    void show_in_comfort(const Lab& lab, const ComfortClamp& clamp);
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

    std::unique_ptr<HomeViews> m_home;  // of the look that is seen; null: none is
    Pins m_pins;
    Thumbnails m_thumbnails;
    bool m_is_first = true;        // nothing was shown yet
    bool m_measures_gains = true;  // in this update; else small pictures are drawn
    ComparedPictures m_compared;
    Comfort m_comfort;
    CloserLook m_closer;
    std::optional<Part> m_inspected_part;  // of this update; none: nobody looks
    std::array<const gpu::Texture*, 3>
        m_shown{};  // picture, beside and output, or what stands for them
    std::optional<std::array<float, 4>> m_probed;
};

/// How a target whose texels have this encoding is seen.
ViewOptions options_for(const PassView& view, Encoding encoding);

/// The texel of what is seen as the picture that lies at a place of it, px from the top left.
Probe picture_probe(const Lab& lab, const std::array<double, 2>& place);

/// The pass that is looked into: the last one where none is chosen, or one that is no more.
int inspected_pass(const Look& look, const WindowState& window);

/// How the small view of the inspected pass lies: all of it while the large one is moved about in.
PictureView inspector_view(const WindowState& window);
