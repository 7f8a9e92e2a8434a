#include "lab/window/desktop_file_dialog.h"

#include "lab/messages/messages.h"
#include "lab/window/desktop_request.h"

bool DesktopFileDialog::can_ask(const WindowState& window) const {
    const FileDialogKind* kind = file_dialog_kind(window.dialog.kind);
    return kind && window.file_dialogs.uses_desktop && window.file_dialogs.has_desktop;
}

void DesktopFileDialog::update(WindowState& window, const Document* document, Messages& messages,
                               std::uint64_t parent_window) {
    if (window.file_dialogs.uses_desktop && !m_chooser)
        m_chooser.emplace(m_wake);
    if (!m_chooser)
        return void(window.dialog.host = Dialog::Host::own);
    window.file_dialogs.has_desktop = m_chooser->is_available();
    Dialog& dialog = window.dialog;
    if (m_is_asked && dialog.host != Dialog::Host::desktop) {  // it was closed or replaced
        m_chooser->cancel();
        m_is_asked = false;
    }
    if (dialog.host == Dialog::Host::undecided && can_ask(window)) {
        FileRequest request = desktop_request(dialog, window.file_dialogs, document);
        request.parent_window = parent_window;
        m_chooser->ask(std::move(request));
        m_is_asked = true;
        dialog.host = Dialog::Host::desktop;
    } else if (dialog.host == Dialog::Host::undecided) {
        dialog.host = Dialog::Host::own;
    }
    const auto reply = m_is_asked ? m_chooser->take_reply() : std::nullopt;
    if (!reply)
        return;
    m_is_asked = false;
    if (std::string problem = take_reply(dialog, *reply); !problem.empty())
        messages.say(std::move(problem), true);
}
