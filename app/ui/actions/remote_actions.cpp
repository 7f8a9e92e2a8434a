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

Result<void> run_named(const RequestedAction& request, const Scene& scene, Edits& edits) {
    const auto reject = [](std::string reason) { return fail({{}, 0, std::move(reason)}); };
    const Action* action = find_action(request.name, scene.actions);
    if (!action)
        return reject(fmt::format("unknown action '{}'{}", request.name,
                                  similar_action(request.name, scene.actions)));
    if (!request.is_down) {
        if (action->on_release)
            action->on_release(scene, edits);
        return {};
    }
    if (const std::string reason = disabled_reason(*action, scene); !reason.empty())
        return reject(fmt::format("\"{}\" isn't available: {}", action->label, reason));
    const bool has_dialog = scene.window.dialog.kind != Dialog::Kind::none;
    Edits acted;
    act_with_undo_notice(*action, scene, acted);
    if (has_dialog && acted.requests().shows_dialog)
        return reject(fmt::format("\"{}\" isn't available: a dialog is open", action->label));
    edits.append(std::move(acted));
    return {};
}
}  // namespace

void run_requested_action(const Scene& scene, Edits& edits) {
    const auto& request = scene.lab.remote.requested_action();
    if (!request)
        return;
    const Result<void> done = run_named(*request, scene, edits);
    edits.change([done](RemoteControl& remote) { remote.finish_action(done); });
}
