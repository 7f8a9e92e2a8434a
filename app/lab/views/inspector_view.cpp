#include "lab/views/inspector_view.h"

void InspectorView::set_context(std::shared_ptr<ContextViews> context) {
    m_context = std::move(context);
    m_selected.reset();
}

void InspectorView::select(const Executor& executor, const WindowState& window,
                           TexelInspector& texels) {
    const bool has_panel = window.layout.sees(panel_id::inspector);
    const auto inspected = has_panel || window.views.shows_pass_large
                               ? inspected_texture(executor, window.views.inspected)
                               : std::nullopt;
    m_selected.reset();
    if (!inspected)
        return;
    const gpu::Texture& texture = texels.level_of(*inspected);
    m_selected = DisplayedTexture{&texture,
                                  inspected->choice.label(),
                                  inspected->choice.is_present_pass() ? inspected->pass : -1,
                                  texture.extent(),
                                  window.views.inspected.view,
                                  options_for(window.views.inspected, inspected->encoding)};
}

void InspectorView::update(const Executor& executor, const WindowState& window,
                           TexelInspector& texels, double seconds) {
    if (!m_selected || !window.layout.sees(panel_id::inspector)) {
        m_context->inspected.reset();
        m_context->inspection.stop();
        texels.update_inspected(nullptr, 0.0);
        return;
    }
    DisplayedTexture shown = *m_selected;
    shown.view = inspector_view(window.views);
    const Extent room = window.views.sizes.inspector;
    {
        const gpu::ContextScope scope(m_context->context.get());
        draw_view(*m_context, *shown.texture, m_context->inspected, room, shown);
        m_context->inspection.update(
            *shown.texture, {shown.name, shown.options.channels, shown.options.levels}, seconds);
    }
    const TexelValues::Subject cells =
        shown.cells(room, window.views.sizes.cell, executor.textures().number());
    texels.update_inspected(&cells, seconds);
}

ViewOptions options_for(const PassView& view, Encoding encoding) {
    return {.levels = view.levels,
            .exposure_stops = view.exposure,
            .channels = view.channels,
            .encoding = encoding,
            .marks_flaws = view.marks_flaws,
            .marks_clipping = view.marks_clipping,
            .is_false_color = view.is_false_color};
}

int inspected_pass(const Look& look, const PassView& inspected) {
    const int last = static_cast<int>(look.passes.size()) - 1;
    return find_pass(look, inspected.pass).value_or(last);
}

PictureView inspector_view(const ViewState& views) {
    return views.shows_pass_large ? PictureView{PictureView::Fit::whole} : views.inspected.view;
}
