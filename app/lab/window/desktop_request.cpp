#include "lab/window/desktop_request.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

FileRequest desktop_request(const Dialog& dialog, const FileDialogChoices& choices,
                            const Document* document) {
    const FileDialogKind* kind = file_dialog_kind(dialog.kind);
    if (!kind)
        return {};
    const FileRules rules = rules_of(*kind);
    const FileBrowser first = first_browser(dialog, choices, document);
    FileRequest request{.kind = kind->is_saving ? FileRequest::Kind::save : FileRequest::Kind::open,
                        .title = kind->title,
                        .folder = first.folder,
                        .name = first.text};
    if (!rules.extensions.empty())
        request.groups.push_back({kind->content, rules.extensions});
    if (!kind->is_saving)
        request.groups.push_back({"All files", {}});
    return request;
}

std::string take_reply(Dialog& dialog, const FileReply& reply) {
    if (reply.kind == FileReply::Kind::cancelled) {
        dialog = {};
        return {};
    }
    dialog.host = Dialog::Host::own;
    dialog.is_new = true;
    if (reply.kind == FileReply::Kind::failed || reply.files.empty())
        return fmt::format("The desktop's file dialog failed: {}. Using Afterglow's.",
                           reply.problem);
    const FileDialogKind* kind = file_dialog_kind(dialog.kind);
    const fs::path& file = reply.files.front();
    const FileRules rules = kind ? rules_of(*kind) : FileRules();
    dialog.browser = FileBrowser{.folder = file.parent_path(), .text = file.filename().string()};
    if (!rules.is_saving) {
        dialog.answer = file;
        return {};
    }
    // The desktop's dialog has asked about the name without the extension.
    dialog.browser.replaced = file;
    const FileChoice choice = accepted(dialog.browser, rules, {});
    if (choice.kind == FileChoice::Kind::choose)
        dialog.answer = choice.path;
    else
        apply_choice(dialog.browser, rules, choice);
    return {};
}
