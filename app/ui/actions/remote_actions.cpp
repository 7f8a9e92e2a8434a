#include "ui/actions/remote_actions.h"

#include "base/text.h"
#include "lab/remote/remote_control.h"
#include "ui/actions/shortcuts.h"
#include "ui/dialogs/palette_list.h"
#include "ui/frame/action_name.h"

#include <fmt/format.h>

namespace {
std::string similar_action(const std::string& name, const ActionTable& actions) {
    std::vector<std::string> names;
    for (const Action& action : actions.rows())
        names.push_back(action_name(action));
    return did_you_mean(name, names);
}

bool opens_dialog(const Action& action) {
    return std::string_view(action.label).ends_with("…");
}

Result<void> run_named(const RequestedAction& asked, const Scene& scene, Edits& edits) {
    const auto reject = [](std::string reason) { return fail({{}, 0, std::move(reason)}); };
    const Action* action = find_action(asked.name, scene.actions);
    if (!action)
        return reject(fmt::format("unknown action '{}'{}", asked.name,
                                  similar_action(asked.name, scene.actions)));
    if (!asked.is_down) {
        if (action->on_release)
            action->on_release(scene, edits);
        return {};
    }
    if (const std::string reason = disabled_reason(*action, scene); !reason.empty())
        return reject(fmt::format("\"{}\" isn't available: {}", action->label, reason));
    const bool has_dialog = scene.window.dialog.kind != Dialog::Kind::none;
    if (has_dialog && opens_dialog(*action))
        return reject(fmt::format("\"{}\" isn't available: a dialog is open", action->label));
    act_with_undo_notice(*action, scene, edits);
    return {};
}
}  // namespace

void run_requested_action(const Scene& scene, Edits& edits) {
    const auto& asked = scene.lab.remote.requested_action();
    if (!asked)
        return;
    const Result<void> done = run_named(*asked, scene, edits);
    edits.change([done](RemoteControl& remote) { remote.finish_action(done); });
}
