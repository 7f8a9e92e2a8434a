#include "ui/dialogs/add_pass_dialog.h"

#include "lab/commands/look_commands.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/name_field.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

void draw_add_pass_dialog(const Scene& scene, Edits& edits) {
    const PassCommands& passes = scene.lab.looks.passes();
    const std::string& after = scene.window.dialog.subject;
    if (passes.refusal(after))
        return close_dialog(edits);
    const DialogFrame frame("Add pass", 26.0f, scene, edits);
    if (!frame.is_open())
        return;
    dim_text(fmt::format("Name of the pass after \"{}\"", after));
    const std::string name = draw_name_field(scene, edits);
    const std::string problem = passes.problem_of_name(after, name);
    if (problem.empty())
        wrapped_dim_text(fmt::format("Creates {}.frag and an entry in look.json.", name));
    else
        draw_dialog_problem(problem, edits);
    if (!draw_dialog_buttons("Add", problem.empty(), edits))
        return;
    close_dialog(edits);
    edits.change([after, name](LookCommands& looks) { looks.passes().add(after, name); });
}
