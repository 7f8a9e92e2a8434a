#include "lab/views/views.h"

#include "gpu/objects/readback.h"
#include "lab/lab.h"
#include "lab/window/window_state.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

Views::Views(MainView main_view, Pins pins, Readouts readouts, TexelInspector texels)
    : m_main(std::move(main_view)),
      m_pins(std::move(pins)),
      m_readouts(std::move(readouts)),
      m_texels(std::move(texels)) {}

Result<Views> Views::make() {
    auto main_view = MainView::make();
    if (!main_view)
        return fail(main_view.error());
    auto pins = Pins::make();
    if (!pins)
        return fail(pins.error());
    auto readouts = Readouts::make();
    if (!readouts)
        return fail(readouts.error());
    auto texels = TexelInspector::make();
    if (!texels)
        return fail(texels.error());
    return Views(std::move(*main_view), std::move(*pins), std::move(*readouts), std::move(*texels));
}

std::optional<gpu::Texture> Views::thumbnail(const Lab& lab, int pass, Extent extent) {
    const Executor& executor = lab.renderer()->executor();
    if (!m_context || !m_context->serve(executor.programs().generic()))
        return std::nullopt;
    const gpu::ContextScope scope(m_context->context.get());
    auto canvas = gpu::Canvas::make(extent, Format::rgba8);
    if (!canvas)
        return std::nullopt;
    m_context->viewer.draw(executor.target(pass), *canvas,
                           {.encoding = encoding_of(executor.look(), pass)});
    return std::move(*canvas).take_texture();
}

void Views::set_context(std::shared_ptr<ContextViews> context) {
    m_main.set_context(context);
    m_inspector.set_context(context);
    m_strip.set_context(context);
    m_context = std::move(context);
}

void Views::probe(const Executor& executor, const std::optional<Probe>& probe) {
    m_probed.reset();
    const auto pass = probe ? find_pass(executor.look(), probe->pass) : std::nullopt;
    const DisplayedTexture* inspected = m_inspector.selected();
    const bool is_inspected = probe && inspected && probe->pass == inspected->name;
    if (!pass && !is_inspected)
        return;
    const gpu::Texture* other = m_main.compared().other();
    const bool is_of_other = probe->is_of_variant && other;
    const gpu::Texture& target = is_of_other    ? *other
                                 : is_inspected ? *inspected->texture
                                                : executor.target(*pass);
    if (probe->x >= 0 && probe->y >= 0 && probe->x < target.extent().width &&
        probe->y < target.extent().height)
        m_probed = gpu::read_pixel(target, probe->x, probe->y);
}

Probe picture_probe(const Executor& executor, int pass, Extent picture,
                    const std::array<double, 2>& position) {
    const Extent own = executor.target(pass).extent();
    const auto texel = [](double at, int whole, int length) {
        return static_cast<int>(std::floor(at * length / std::max(whole, 1)));
    };
    return {.pass = executor.look().passes[static_cast<std::size_t>(pass)].name,
            .x = texel(position[0], picture.width, own.width),
            .y = texel(position[1], picture.height, own.height),
            .extent = own};
}

namespace {
double current_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}
}  // namespace

bool Views::is_transitioning() const {
    return m_main.is_transitioning(current_seconds());
}

void Views::update(const Lab& lab, const WindowState& window) {
    if (lab.frames().awaits_source())
        return;  // the previous views stay
    if (!lab.renderer() || lab.renderer()->executor().plan().targets.empty()) {
        set_context(nullptr);
        m_probed.reset();
        m_pins.stop();
        m_readouts.stop();
        return m_texels.stop();
    }
    if (lab.renderer()->replay().is_running() || !lab.renderer()->has_whole_picture())
        return;  // the previous views stay until the replay or the first frame is complete
    const Executor& executor = lab.renderer()->executor();
    if (!m_context || !m_context->serve(executor.programs().generic()))
        set_context(std::make_shared<ContextViews>(executor.programs().generic()));
    const double now = current_seconds();
    m_inspector.select(executor, window, m_texels);
    const MainView::Subject subject{*lab.renderer(), lab.frames(), window, m_inspector.selected(),
                                    now};
    m_main.update(subject, lab.is_moving());
    if (std::exchange(m_is_first, false))
        return;  // the picture is displayed first, the remaining views in the next update
    m_main.measure(subject, m_texels);
    m_strip.update(executor, lab.document()->values(),
                   window.layout.sees(panel_id::strip) ? window.views.sizes.thumbnail_height : 0,
                   now);
    m_inspector.update(executor, window, m_texels, now);
    if (window.layout.sees(panel_id::pins))
        m_pins.update(executor, window.probes.pins, now);
    else
        m_pins.stop();
    m_readouts.update(executor, now);
    probe(executor, window.probes.pointer);
}
