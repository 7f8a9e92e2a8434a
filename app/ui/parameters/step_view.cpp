#include "ui/parameters/step_view.h"

#include "lab/previews/previews.h"
#include "ui/widgets/scoped.h"

void ask_for_step(const Pointed& pointed, bool is_up, Edits& edits) {
    edits.change([question = StepQuestion{pointed.parameter, pointed.component, is_up}](
                     Previews& previews) { previews.probe().ask(question); });
}

void follow_pointer(const Scene& scene, Edits& edits) {
    const auto& question = scene.lab.frames.previews().probe().question();
    const auto& pointed = scene.window.parameters.pointed;
    if (!question || !pointed || !ImGui::IsKeyDown('U') || ImGui::GetIO().WantTextInput)
        return;
    const Pointed present{question->parameter, question->component};
    if (*pointed != present)
        ask_for_step(*pointed, question->is_up, edits);
}

void draw_step_items(const std::string& parameter, Edits& edits) {
    if (ImGui::MenuItem("Preview one step up", "U"))
        ask_for_step({parameter, 0}, true, edits);
    edits.mark("step_up_item");
    if (ImGui::MenuItem("Preview one step down", "Shift+U"))
        ask_for_step({parameter, 0}, false, edits);
    edits.mark("step_down_item");
}
