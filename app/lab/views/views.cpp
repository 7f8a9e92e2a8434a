#include "lab/views/views.h"

#include "gpu/objects/readback.h"
#include "lab/previews/previews.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace {
// Creates a part unless an earlier one failed; stores its errors.
template <class Part>
bool made(std::optional<Part>& part, Diagnostics& problems) {
    if (!problems.empty())
        return false;
    auto result = Part::make();
    if (result)
        part.emplace(std::move(*result));
    else
        problems = std::move(result.error());
    return part.has_value();
}
}  // namespace

Views::Views(Parts parts)
    : m_pins(std::move(parts.pins)),
      m_compared(std::move(parts.compared)),
      m_comfort(std::move(parts.comfort)),
      m_closer(std::move(parts.closer)) {}

Result<Views> Views::make() {
    Diagnostics problems;
    std::optional<Pins> pins;
    std::optional<ComparedPictures> compared;
    std::optional<FlashLimiter> comfort;
    std::optional<CloserLook> closer;
    if (!made(pins, problems) || !made(compared, problems) || !made(comfort, problems) ||
        !made(closer, problems))
        return fail(std::move(problems));
    return Views({std::move(*pins), std::move(*compared), std::move(*comfort), std::move(*closer)});
}

Views::Image Views::image_of(const gpu::Texture* texture) {
    return texture ? Image{texture->handle(), texture->extent()} : Image{};
}

Views::Image Views::image_of(const std::optional<gpu::Canvas>& canvas) {
    return image_of(canvas ? &canvas->texture() : nullptr);
}

Picture Views::read_picture() const {
    return m_home && m_home->picture ? gpu::read_picture(m_home->picture->texture()) : Picture();
}

Views::Image Views::thumbnail(std::size_t pass) const {
    const gpu::Texture* picture = m_thumbnails.picture(pass);
    return picture ? Image{picture->handle(), picture->extent()} : Image{};
}

// Without memory the view stays empty, because the passes need the memory.
bool Views::fit(std::optional<gpu::Canvas>& canvas, Extent extent) {
    if (canvas && canvas->texture().extent() == extent)
        return true;
    canvas.reset();
    if (extent.is_empty())
        return false;
    auto made = gpu::Canvas::make(extent, Format::rgba8);
    if (made)
        canvas.emplace(std::move(*made));
    return made.has_value();
}

void Views::draw_part(const gpu::Texture& from, std::optional<gpu::Canvas>& to, Extent size,
                      const Part& part) {
    const gpu::ContextScope home(m_home->home.get());
    if (!fit(to, size))
        return;
    const PicturePlace place = place_of(part.view, part.whole, size);
    const double across = static_cast<double>(from.extent().width) / part.whole.width;
    const double up = static_cast<double>(from.extent().height) / part.whole.height;
    ViewOptions options = part.options;
    options.width = size.width / place.zoom * across;
    options.height = size.height / place.zoom * up;
    options.left = -place.left / place.zoom * across;
    options.bottom = from.extent().height + place.top / place.zoom * up - options.height;
    m_home->viewer.draw(from, *to, options);
}

std::optional<gpu::Texture> Views::small_picture(const Lab& lab, int pass, Extent extent) {
    const Executor& executor = lab.renderer()->executor();
    if (!m_home || !m_home->serve(executor.programs().generic()))
        return std::nullopt;
    const gpu::ContextScope home(m_home->home.get());
    auto canvas = gpu::Canvas::make(extent, Format::rgba8);
    if (!canvas)
        return std::nullopt;
    m_home->viewer.draw(executor.target(pass), *canvas,
                        {.encoding = encoding_of(executor.look(), pass)});
    return std::move(*canvas).take_texture();
}

// Switches to the view programs of another look.
void Views::move_to(const Programs& programs) {
    if (m_home && m_home->serve(programs))
        return;
    m_shown = {};
    m_home = std::make_unique<ContextViews>(programs);
}

void Views::probe(const Lab& lab, const std::optional<Probe>& probe) {
    m_probed.reset();
    const Executor& executor = lab.renderer()->executor();
    const auto pass = probe ? find_pass(executor.look(), probe->pass) : std::nullopt;
    const bool is_inspected = probe && m_inspected_part && probe->pass == m_inspected_part->name;
    if (!pass && !is_inspected)
        return;
    const bool is_of_other = probe->is_of_variant && m_compared.other();
    const gpu::Texture& target = is_of_other    ? *m_compared.other()
                                 : is_inspected ? *m_inspected_part->texture
                                                : executor.target(*pass);
    if (probe->x >= 0 && probe->y >= 0 && probe->x < target.extent().width &&
        probe->y < target.extent().height)
        m_probed = gpu::read_pixel(target, probe->x, probe->y);
}

ViewOptions options_for(const PassView& view, Encoding encoding) {
    return {.levels = view.levels,
            .exposure_stops = view.exposure,
            .channels = static_cast<ChannelChoice>(view.channels),
            .encoding = encoding,
            .marks_flaws = view.marks_flaws,
            .marks_clipping = view.marks_clipping,
            .is_false_color = view.is_false_color};
}

Probe picture_probe(const Lab& lab, const std::array<double, 2>& place) {
    const Executor& executor = lab.renderer()->executor();
    const int shown = lab.frames().passes().picture_pass();
    const Extent seen_as = lab.work().size.extent();
    const Extent own = executor.target(shown).extent();
    const auto texel = [](double at, int whole, int length) {
        return static_cast<int>(std::floor(at * length / std::max(whole, 1)));
    };
    return {.pass = executor.look().passes[static_cast<std::size_t>(shown)].name,
            .x = texel(place[0], seen_as.width, own.width),
            .y = texel(place[1], seen_as.height, own.height),
            .extent = own};
}

int inspected_pass(const Look& look, const WindowState& window) {
    const int last = static_cast<int>(look.passes.size()) - 1;
    return find_pass(look, window.inspected.pass).value_or(last);
}

PictureView inspector_view(const WindowState& window) {
    return window.shows_pass_large ? PictureView{PictureView::Fit::all} : window.inspected.view;
}

namespace {
double present_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}
}  // namespace

CellNumbers::Subject Views::Part::cells(Extent room, Extent least, std::uint64_t picture) const {
    return {.texture = *texture,
            .name = name,
            .whole = whole,
            .place = place_of(view, whole, room),
            .size = room,
            .least = least,
            .picture = picture,
            .options = options};
}

// Selects the inspected texture for the inspector and for the picture.
void Views::inspect(const Executor& executor, const WindowState& window) {
    const bool has_panel = !window.is_picture_only && window.shows_inspector;
    const auto inspected = has_panel || window.shows_pass_large
                               ? inspected_texture(executor, window.inspected)
                               : std::nullopt;
    m_inspected_part.reset();
    if (!inspected)
        return;
    const gpu::Texture& texture = m_closer.level_of(*inspected);
    m_inspected_part = Part{&texture,
                            inspected->choice.label(),
                            inspected->choice.is_present_pass() ? inspected->pass : -1,
                            texture.extent(),
                            window.inspected.view,
                            options_for(window.inspected, inspected->encoding)};
}

void Views::draw_inspected(const Executor& executor, const WindowState& window) {
    if (!m_inspected_part || window.is_picture_only || !window.shows_inspector) {
        m_home->inspected.reset();
        m_home->inspection.stop();
        m_closer.update_inspected(nullptr, 0.0);
        return;
    }
    Part part = *m_inspected_part;
    part.view = inspector_view(window);
    const double now = present_seconds();
    const Extent room = window.views.inspector;
    {
        const gpu::ContextScope home(m_home->home.get());
        draw_part(*part.texture, m_home->inspected, room, part);
        m_home->inspection.update(*part.texture,
                                  {part.name, part.options.channels, part.options.levels}, now);
    }
    const CellNumbers::Subject cells =
        part.cells(room, window.views.cell, executor.textures().number());
    m_closer.update_inspected(&cells, now);
}

// Updates texel values over the picture, and values along the waveform's line.
void Views::look_closer(const Lab& lab, const WindowState& window) {
    const Part part = large_part(lab, window);
    const double now = present_seconds();
    const auto number = lab.renderer()->executor().textures().number();
    const CellNumbers::Subject cells = part.cells(window.views.picture, window.views.cell, number);
    const bool is_itself = lab.frames().comparison().mode() == CompareMode::off &&
                           !lab.frames().comparison().selection().is_flashing() &&
                           !lab.frames().previews().probe().picture();
    m_closer.update_picture(is_itself && !window.is_picture_only ? &cells : nullptr, now);
    const bool has_waveform = !window.is_picture_only && window.shows_bottom &&
                              window.bottom_part == BottomPart::waveform;
    const Waveform::Subject along{*part.texture, part.name, window.scan_line, number};
    m_closer.update_waveform(has_waveform ? &along : nullptr, now);
}

void Views::stop() {
    m_shown = {};
    m_home.reset();
    m_compared.stop();
    m_thumbnails.stop();
    m_probed.reset();
    m_pins.stop();
    m_closer.stop();
    m_inspected_part.reset();
}

void Views::update(const Lab& lab, const WindowState& window) {
    if (lab.frames().awaits_source())
        return;  // the previous views stay
    if (!lab.renderer() || lab.renderer()->executor().plan().targets.empty())
        return stop();
    if (lab.renderer()->replay().is_running() || !lab.renderer()->has_whole_picture())
        return;  // the previous views stay until the replay or the first frame is complete
    const Executor& executor = lab.renderer()->executor();
    move_to(executor.programs().generic());
    inspect(executor, window);
    draw_picture(lab, window);
    draw_output(lab, window.output.is_black ? Extent{} : window.views.output);
    show_in_comfort(lab, window.comfort);
    if (std::exchange(m_is_first, false))
        return;  // the picture is displayed first, the remaining views in the next update
    look_closer(lab, window);
    count_flashes(lab, window);
    const bool is_whole = !window.is_picture_only;
    show_strip(lab, is_whole && window.shows_strip ? window.views.thumbnail_height : 0);
    draw_inspected(executor, window);
    if (is_whole && window.shows_bottom && window.bottom_part == BottomPart::pins)
        m_pins.update(executor, window.pins, present_seconds());
    else
        m_pins.stop();
    probe(lab, window.probe);
}

// Alternates between thumbnails and meters: the first of each can be slow with some drivers.
void Views::show_strip(const Lab& lab, int height) {
    if (height <= 0) {
        m_thumbnails.stop();
        return m_home->gains.stop();
    }
    const Executor& executor = lab.renderer()->executor();
    const gpu::ContextScope home(m_home->home.get());
    m_measures_gains = !m_measures_gains;
    if (m_measures_gains)
        m_home->gains.update(executor, lab.document()->values(), present_seconds());
    else
        m_thumbnails.update(m_home->viewer, executor, height, present_seconds());
}

// Independent of the panels; the whole picture at the largest integer zoom that fits.
void Views::draw_output(const Lab& lab, Extent extent) {
    if (extent.is_empty())
        return m_home->output.reset();
    const Executor& executor = lab.renderer()->executor();
    const int shown = lab.frames().passes().picture_pass();
    const int last = static_cast<int>(executor.look().passes.size()) - 1;
    draw_part(executor.target(shown), m_home->output, extent,
              {.texture = &executor.target(shown),
               .pass = shown,
               .whole = executor.target(last).extent(),
               .view = {},
               .options = {.encoding = encoding_of(executor.look(), shown)}});
}

// Measures the look's own picture, independent of the display settings.
void Views::count_flashes(const Lab& lab, const WindowState& window) {
    if (!window.shows_flashes || window.is_picture_only)
        return m_home->flash_meter.stop();
    const Executor& executor = lab.renderer()->executor();
    const int last = static_cast<int>(executor.look().passes.size()) - 1;
    const gpu::ContextScope home(m_home->home.get());
    m_home->flash_meter.update(
        {executor.target(last), encoding_of(executor.look(), last), executor.textures().number()},
        present_seconds());
}

// Applies the flash limiter to all displayed pictures.
void Views::show_in_comfort(const Lab& lab, const FlashLimit& clamp) {
    const double now = present_seconds();
    if (lab.is_moving() || !clamp.is_on)
        m_comfort.note_moving(clamp, now);
    const std::array views{&m_home->picture, &m_home->beside, &m_home->output};
    for (std::size_t i = 0; i < views.size(); ++i) {
        const gpu::Texture* own = *views[i] ? &(*views[i])->texture() : nullptr;
        m_shown[i] = own ? &m_comfort.shown(i, *own, clamp, now) : nullptr;
    }
}

bool Views::is_specializing() const {
    return (m_home && m_home->flash_meter.is_counting()) ||
           m_comfort.is_specializing(present_seconds());
}

Views::Part Views::large_part(const Lab& lab, const WindowState& window) const {
    if (m_inspected_part && window.shows_pass_large)
        return *m_inspected_part;
    const Executor& executor = lab.renderer()->executor();
    const int last = static_cast<int>(executor.look().passes.size()) - 1;
    const int shown = lab.frames().passes().picture_pass();
    const Pass& pass = executor.look().passes[static_cast<std::size_t>(shown)];
    return {&executor.target(shown),
            pass.name,
            shown,
            executor.target(last).extent(),
            window.picture,
            {.encoding = encoding_of(executor.look(), shown), .is_over_checker = pass.has_alpha}};
}

// Updates the reference of the part. A picture from a file can only be compared with the picture.
void Views::compare(const Lab& lab, const Part& part) {
    const Executor* variant = lab.renderer()->executors().variant();
    const bool is_picture = part.pass == lab.frames().passes().picture_pass();
    const bool is_file =
        lab.frames().comparison().selection().chosen().other.kind == Other::Kind::file;
    const bool has_variant = variant && !variant->plan().targets.empty() && part.pass >= 0;
    const bool has_other = is_file ? is_picture : has_variant;
    if (!lab.frames().comparison().sides() || !has_other)
        return m_compared.stop();
    m_compared.update({.ours = *part.texture,
                       .other = is_file ? nullptr : &variant->target(part.pass),
                       .reference = lab.frames().comparison().selection().reference().picture(),
                       .encoding = part.options.encoding},
                      lab.frames().comparison().selection().chosen(), present_seconds());
}

// Draws the reference over its side of the picture.
void Views::draw_wiped(const Lab& lab, Part part, const WindowState& window) {
    const Extent size = window.views.picture;
    const int line =
        wipe_column(place_of(part.view, part.whole, size), part.whole, size, window.wipe_share);
    part.options.columns = lab.frames().comparison().sides()->is_other_left
                               ? std::array{0, line}
                               : std::array{line, size.width};
    draw_part(*m_compared.other(), m_home->picture, size, part);
}

// Displays the values without conversion, because they are not light.
void Views::draw_difference(const Lab& lab, Part part, const WindowState& window) {
    if (!m_compared.difference())
        return;
    part.options = {
        .levels = {0.0, std::exp2(-lab.frames().comparison().selection().chosen().gain_stops)},
        .encoding = Encoding::display};
    draw_part(*m_compared.difference(), m_home->picture, window.views.picture, part);
}

// Draws the effect of a previewed step; false: no preview.
bool Views::draw_step(const Lab& lab, const WindowState& window) {
    const gpu::Texture* step = lab.frames().previews().probe().picture();
    if (!step || window.shows_pass_large)
        return false;
    draw_part(*step, m_home->picture, window.views.picture,
              {.texture = step,
               .whole = step->extent(),
               .view = window.picture,
               .options = {.encoding = Encoding::display}});
    m_home->beside.reset();
    return true;
}

void Views::draw_picture(const Lab& lab, const WindowState& window) {
    if (draw_step(lab, window))
        return;
    const CompareMode mode = lab.frames().comparison().mode();
    const Extent size = room_of_one(window.views.picture, mode);
    const Part part = large_part(lab, window);
    compare(lab, part);
    const gpu::Texture* other = m_compared.other();
    const bool is_flashing = other && lab.frames().comparison().selection().is_flashing();
    draw_part(is_flashing ? *other : *part.texture, m_home->picture, size, part);
    if (other && mode == CompareMode::side_by_side)
        draw_part(*other, m_home->beside, size, part);
    else
        m_home->beside.reset();
    if (other && !is_flashing && mode == CompareMode::wipe)
        draw_wiped(lab, part, window);
    if (other && !is_flashing && mode == CompareMode::difference)
        draw_difference(lab, part, window);
}
