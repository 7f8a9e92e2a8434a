#include "ui/parameters/step_view.h"

#include "lab/previews/previews.h"
#include "ui/widgets/scoped.h"

void ask_for_step(const Pointed& pointed, bool is_up, Edits& edits) {
    edits.change([request = StepRequest{pointed.parameter, pointed.component, is_up}](
                     Previews& previews) { previews.probe().ask(request); });
}

void follow_pointer(const Scene& scene, Edits& edits) {
    const auto& request = scene.lab.frames.previews().probe().request();
    const auto& pointed = scene.window.parameters.pointed;
    if (!request || !pointed || !ImGui::IsKeyDown('U') || ImGui::GetIO().WantTextInput)
        return;
    const Pointed current{request->parameter, request->component};
    if (*pointed != current)
        ask_for_step(*pointed, request->is_up, edits);
}

void draw_step_items(const std::string& parameter, Edits& edits) {
    if (ImGui::MenuItem("Preview one step up", "U"))
        ask_for_step({parameter, 0}, true, edits);
    edits.mark("step_up_item");
    if (ImGui::MenuItem("Preview one step down", "Shift+U"))
        ask_for_step({parameter, 0}, false, edits);
    edits.mark("step_down_item");
}
