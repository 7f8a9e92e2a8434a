#include "lab/commands/look_commands.h"

#include "formats/look/manifest_edit.h"
#include "formats/pack/pack_format.h"
#include "io/system/file_status.h"
#include "lab/commands/duplicate_offer.h"
#include "lab/document/opened_preset.h"
#include "lab/document/stack_edits.h"
#include "lab/storage/display_name.h"
#include "lab/storage/include_store.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

LookCommands::LookCommands(Workspace& work, LookLoader& loader, ContentCommands& content)
    : m_work(work),
      m_loader(loader),
      m_content(content),
      m_includes(load_include_folders(work.library.roots())),
      m_stash(work.library.roots()) {
    search_includes();
}

void LookCommands::open(const std::string& argument) {
    if (is_pack(argument))
        return m_packs.install(argument);
    const auto request = resolve(argument, m_work.library);
    if (m_work.messages.succeeded(request))
        m_loader.open(*request);
}

void LookCommands::open_with_content(const std::string& argument) {
    auto request = resolve(argument, m_work.library);
    if (!m_work.messages.succeeded(request))
        return;
    request->brings_content = true;
    m_loader.open(*request);
}

void LookCommands::open_file(const fs::path& file) {
    if (ContentCommands::is_content(file))
        return m_content.open(file);
    if (is_pack(file))
        return m_packs.install(file);
    const auto request = resolve(file.string(), m_work.library);
    if (m_work.messages.succeeded(request))
        m_loader.open(*request, [this, file] { m_work.opened_files.add(file); });
}

void LookCommands::cancel_opening() {
    if (!m_work.document || !m_work.document->has_pending_stack())
        m_loader.cancel();
}

void LookCommands::dismiss_problems() {
    m_work.messages.dismiss_problems();
    m_loader.dismiss_failed();
}

void LookCommands::create(const std::string& id, const std::string& template_id) {
    const auto folder = m_work.library.new_look(id, template_id);
    if (m_work.messages.succeeded(folder))
        m_loader.open(OpenRequest{*folder, {}, {}},
                      [this, created = *folder] { report_created(created); });
}

std::string LookCommands::problem_of_id(const std::string& id) const {
    const auto checked = m_work.library.check_look_name(id);
    return checked ? std::string() : checked.error().front().message;
}

std::string LookCommands::proposed_id() const {
    std::string id = "my-look";
    for (int n = 2; m_work.library.find_look(id); ++n)
        id = fmt::format("my-look-{}", n);
    return id;
}

void LookCommands::report_created(const fs::path& folder) {
    if (!m_work.document)
        return;
    const Location shader{m_work.document->look().passes.back().fragment.file, 1};
    m_work.messages.append(fmt::format("Created {}", display_folder(folder)),
                           {{.name = "Open shader", .commands = {[shader](LookCommands& looks) {
                                                        looks.open_in_editor(shader);
                                                    }}},
                            {.name = "Open folder",
                             .commands = {[](LookCommands& looks) { looks.show_in_folder(); }}}});
}

void LookCommands::show_in_folder() {
    if (!m_work.document)
        return;
    const fs::path& manifest = m_work.document->look().manifest;
    m_work.programs.open_folder(manifest.parent_path());
}

void LookCommands::duplicate(const std::string& id) {
    if (!m_work.document)
        return;
    if (m_work.document->look().stack.size() > 1)
        return m_work.messages.say("A stack can't be duplicated. Open one of its looks first.",
                                   true);
    if (is_foreign_look(m_work.document->look().manifest))
        return m_work.messages.say("Looks of other programs can't be duplicated", true);
    const auto folder =
        m_work.library.duplicate_look(m_work.document->look().manifest.parent_path(), id);
    if (!m_work.messages.succeeded(folder))
        return;
    Preset current = preset_of(*m_work.document);
    current.look = id;
    m_loader.open(OpenRequest{*folder, current, {}});
}

void LookCommands::write_overrides() {
    if (!m_work.document || m_work.document->state().overrides.empty())
        return;
    const Stack& stack = m_work.document->look().stack;
    for (const StackPart& part : stack)
        if (m_work.library.is_shipped(manifest_of(part.path)))
            return offer_duplicate(
                m_work, fmt::format("\"{}\" is a shipped look and can't be changed", part.look));
    for (std::size_t i = 0; i < stack.size(); ++i) {
        PassOverrides own;
        const std::string scope = name_prefix(stack, i);
        for (const auto& [pass, override] : m_work.document->state().overrides)
            if (pass.starts_with(scope))
                own.emplace(pass.substr(scope.size()), override);
        if (!own.empty() && is_foreign_look(stack[i].path))
            return m_work.messages.say("Pass settings can't be saved to looks of other programs",
                                       true);
        if (!own.empty() &&
            !m_work.messages.succeeded(::write_overrides(manifest_of(stack[i].path), own)))
            return;
    }
    clear_overrides(*m_work.document);
    m_work.messages.say("Saved to look.json");
}

// Whether it is a shipped file that the user may not write to.
bool LookCommands::must_duplicate(const fs::path& file) const {
    return m_work.library.is_shipped(file) && !is_writable(file);
}

void LookCommands::open_in_editor(const Location& location) {
    if (m_work.document && must_duplicate(location.file))
        return offer_duplicate(m_work, fmt::format("\"{}\" is a shipped look in a read-only folder",
                                                   m_work.document->look().name));
    m_work.programs.open_in_editor(location);
}

void LookCommands::search_includes() {
    IncludeFolders folders = m_work.library.roots().include_folders();
    folders.named.insert(folders.named.end(), m_includes.begin(), m_includes.end());
    m_loader.worker().reader().set_include_folders(std::move(folders));
    m_loader.reload();
}

void LookCommands::set_include_folders(const std::vector<fs::path>& folders) {
    for (const fs::path& folder : folders) {
        std::error_code error;
        if (!fs::is_directory(folder, error))
            return m_work.messages.say(
                {folder, 0, "is not a folder. Includes are searched for in folders."});
    }
    m_includes = folders;
    m_work.messages.succeeded(save_include_folders(m_work.library.roots(), m_includes));
    search_includes();
}

void LookCommands::stash_unsaved(const Session& session,
                                 const std::function<std::optional<Picture>()>& picture) {
    const auto stored = m_stash.keep(session, picture);
    if (m_work.messages.succeeded(stored) && *stored)
        m_work.messages.say("Your unsaved changes are kept. Restore them in the File menu.");
}
