#include "lab/views/main_view.h"

#include "gpu/objects/readback.h"
#include "lab/previews/previews.h"

#include <cmath>

namespace {
constexpr Levels all_black{1e30, 2e30};  // above all stored numbers

// HDR light is tone-mapped for this display. The picture of scRGB has light in units of 80 cd/m2.
ViewOptions with_hdr(ViewOptions options, const Executors& executors) {
    const auto& hdr = executors.inputs().hdr;
    if (!hdr)
        return options;
    options.headroom = hdr->headroom();
    if (executors.picture().look().is_scrgb_in_hdr) {
        options.encoding = Encoding::linear;
        options.exposure_stops = std::log2(80.0 / hdr->paper_white);
    }
    return options;
}
}  // namespace

Result<MainView> MainView::make() {
    auto compared = ComparedPictures::make();
    if (!compared)
        return fail(compared.error());
    auto limiter = FlashLimiter::make();
    if (!limiter)
        return fail(limiter.error());
    return MainView(std::move(*compared), std::move(*limiter));
}

void MainView::set_context(std::shared_ptr<ContextViews> context) {
    m_shown = {};
    m_context = std::move(context);
    if (!m_context)
        m_compared.stop();
}

Picture MainView::read_picture() const {
    return m_context && m_context->picture ? gpu::read_picture(m_context->picture->texture())
                                           : Picture();
}

void MainView::update(const Subject& subject, bool is_moving) {
    draw_picture(subject);
    draw_output(subject);
    limit_flashes(subject, is_moving);
}

void MainView::measure(const Subject& subject, TexelInspector& texels) {
    const WindowState& window = subject.window;
    const DisplayedTexture shown = displayed(subject);
    const auto number = subject.renderer.executor().textures().number();
    const TexelValues::Subject cells =
        shown.cells(window.views.sizes.picture, window.views.sizes.cell, number);
    const bool is_itself = subject.frames.comparison().mode() == CompareMode::off &&
                           !subject.frames.comparison().selection().is_reference_shown() &&
                           !subject.frames.previews().probe().picture();
    texels.update_picture(is_itself && !window.layout.is_picture_only ? &cells : nullptr,
                          subject.seconds);
    const bool has_waveform = window.layout.sees(panel_id::waveform);
    const Waveform::Subject along{*shown.texture, shown.name, window.probes.scan_line, number};
    texels.update_waveform(has_waveform ? &along : nullptr, subject.seconds);
    count_flashes(subject);
}

// Measures the look's own picture, independent of the display settings.
void MainView::count_flashes(const Subject& subject) {
    if (!subject.window.flashes.shows_meter || subject.window.layout.is_picture_only)
        return m_context->flash_meter.stop();
    const Executor& executor = subject.renderer.executor();
    const int last = static_cast<int>(executor.look().passes.size()) - 1;
    const gpu::ContextScope scope(m_context->context.get());
    m_context->flash_meter.update({executor.target(last), encoding_of(executor.look(), last),
                                   executor.textures().number(), executor.drawer().subframe()},
                                  subject.seconds);
}

// Independent of the panels; the whole picture at the largest integer zoom that fits. Over another
// window it has the size of that window.
void MainView::draw_output(const Subject& subject) {
    const WindowState& window = subject.window;
    const bool is_black = window.output.is_black || subject.renderer.executors().inputs().is_black;
    const Extent extent = is_black ? Extent{} : window.views.sizes.output;
    if (extent.is_empty())
        return m_context->output.reset();
    const Executor& executor = subject.renderer.executor();
    const int shown = subject.frames.passes().picture_pass();
    const int last = static_cast<int>(executor.look().passes.size()) - 1;
    draw_view(*m_context, executor.target(shown), m_context->output, extent,
              {.texture = &executor.target(shown),
               .pass = shown,
               .whole = executor.target(last).extent(),
               .view = {.fit = window.output.is_overlay ? PictureView::Fit::whole
                                                        : PictureView::Fit::integer},
               .options = with_hdr({.encoding = encoding_of(executor.look(), shown)},
                                   subject.renderer.executors())});
}

// Applies the flash limiter to all displayed pictures.
void MainView::limit_flashes(const Subject& subject, bool is_moving) {
    const FlashLimit& limit = subject.window.flashes.limit;
    if (is_moving || !limit.is_on)
        m_limiter.note_moving(limit, subject.seconds);
    const std::array views{&m_context->picture, &m_context->reference, &m_context->output};
    for (std::size_t i = 0; i < views.size(); ++i) {
        const gpu::Texture* own = *views[i] ? &(*views[i])->texture() : nullptr;
        m_shown[i] = own ? &m_limiter.shown(i, *own, limit, subject.seconds) : nullptr;
    }
}

bool MainView::is_transitioning(double seconds) const {
    return (m_context && m_context->flash_meter.is_counting()) ||
           m_limiter.is_transitioning(seconds);
}

DisplayedTexture MainView::displayed(const Subject& subject) const {
    if (subject.inspected && subject.window.views.shows_pass_large)
        return *subject.inspected;
    const Executor& executor = subject.renderer.executor();
    const int last = static_cast<int>(executor.look().passes.size()) - 1;
    const int shown = subject.frames.passes().picture_pass();
    const Pass& pass = executor.look().passes[static_cast<std::size_t>(shown)];
    const bool is_black = subject.renderer.executors().inputs().is_black;
    return {&executor.target(shown),
            pass.name,
            shown,
            executor.target(last).extent(),
            subject.window.views.picture,
            with_hdr({.levels = is_black ? all_black : Levels{},
                      .encoding = encoding_of(executor.look(), shown),
                      .is_over_checker = pass.has_alpha && !is_black},
                     subject.renderer.executors())};
}

// Updates the reference of the texture. A picture from a file can only be compared with the
// picture.
void MainView::compare(const Subject& subject, const DisplayedTexture& shown) {
    const ComparisonView& comparison = subject.frames.comparison();
    const Executor* variant = subject.renderer.executors().variant();
    const bool is_picture = shown.pass == subject.frames.passes().picture_pass();
    const bool is_file = comparison.selection().chosen().other.kind == Other::Kind::file;
    const bool has_variant = variant && !variant->plan().targets.empty() && shown.pass >= 0;
    const bool has_other = is_file ? is_picture : has_variant;
    if (!comparison.sides() || !has_other)
        return m_compared.stop();
    m_compared.update({.ours = *shown.texture,
                       .other = is_file ? nullptr : &variant->target(shown.pass),
                       .reference = comparison.selection().reference().picture(),
                       .encoding = shown.options.encoding},
                      comparison.selection().chosen(), subject.seconds);
}

// Draws the reference over its side of the picture.
void MainView::draw_wiped(const Subject& subject, DisplayedTexture shown) {
    const WindowState& window = subject.window;
    const Extent size = window.views.sizes.picture;
    const int line = wipe_column(position_of(shown.view, shown.whole, size), shown.whole, size,
                                 window.views.wipe_share);
    shown.options.columns = subject.frames.comparison().sides()->is_other_left
                                ? std::array{0, line}
                                : std::array{line, size.width};
    draw_view(*m_context, *m_compared.other(), m_context->picture, size, shown);
}

// Displays the values without conversion, because they are not light.
void MainView::draw_difference(const Subject& subject, DisplayedTexture shown) {
    if (!m_compared.difference())
        return;
    const double stops = subject.frames.comparison().selection().chosen().gain_stops;
    shown.options = {.levels = {0.0, std::exp2(-stops)}, .encoding = Encoding::display};
    draw_view(*m_context, *m_compared.difference(), m_context->picture,
              subject.window.views.sizes.picture, shown);
}

// Draws the effect of a previewed step; false: no preview.
bool MainView::draw_step(const Subject& subject) {
    const gpu::Texture* step = subject.frames.previews().probe().picture();
    if (!step || subject.window.views.shows_pass_large)
        return false;
    draw_view(*m_context, *step, m_context->picture, subject.window.views.sizes.picture,
              {.texture = step,
               .whole = step->extent(),
               .view = subject.window.views.picture,
               .options = {.encoding = Encoding::display}});
    m_context->reference.reset();
    return true;
}

void MainView::draw_picture(const Subject& subject) {
    if (draw_step(subject))
        return;
    const ComparisonView& comparison = subject.frames.comparison();
    const CompareMode mode = comparison.mode();
    const Extent size = size_of_one(subject.window.views.sizes.picture, mode);
    const DisplayedTexture shown = displayed(subject);
    compare(subject, shown);
    const gpu::Texture* other = m_compared.other();
    const bool is_reference_shown = other && comparison.selection().is_reference_shown();
    draw_view(*m_context, is_reference_shown ? *other : *shown.texture, m_context->picture, size,
              shown);
    if (other && mode == CompareMode::side_by_side)
        draw_view(*m_context, *other, m_context->reference, size, shown);
    else
        m_context->reference.reset();
    if (other && !is_reference_shown && mode == CompareMode::wipe)
        draw_wiped(subject, shown);
    if (other && !is_reference_shown && mode == CompareMode::difference)
        draw_difference(subject, shown);
}
