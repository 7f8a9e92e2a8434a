#include "lab/views/displayed_passes.h"

#include "lab/lab.h"
#include "lab/window/window_state.h"

PassSelection displayed_passes(const Lab& lab, const WindowState& window) {
    PassSelection displayed{.are_all = false};
    if (const Document* document = lab.document())
        displayed.names.push_back(
            document->look()
                .passes.at(static_cast<std::size_t>(lab.frames().passes().picture_pass()))
                .name);
    if (window.views.shows_pass_large || window.layout.sees(panel_id::inspector)) {
        displayed.names.push_back(window.views.inspected.pass);
        if (const auto& other = window.views.inspected.other;
            other && other->from == Input::From::pass)
            displayed.names.push_back(other->name);
    }
    if (window.probes.pointer)
        displayed.names.push_back(window.probes.pointer->pass);
    return displayed;
}
