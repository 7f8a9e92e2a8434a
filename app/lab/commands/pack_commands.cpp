#include "lab/commands/pack_commands.h"

#include "lab/commands/look_commands.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

namespace {
// What the notice offers to open: a new look, otherwise a new preset, otherwise the first look.
const InstalledItem* item_to_open(const InstalledPack& installed, bool& is_preset) {
    const auto first_new = [](const std::vector<InstalledItem>& items) -> const InstalledItem* {
        for (const InstalledItem& item : items)
            if (item.status != InstalledItem::Status::present)
                return &item;
        return nullptr;
    };
    is_preset = false;
    if (const InstalledItem* look = first_new(installed.looks))
        return look;
    if (const InstalledItem* preset = first_new(installed.presets)) {
        is_preset = true;
        return preset;
    }
    return installed.looks.empty() ? nullptr : &installed.looks.front();
}
}  // namespace

void PackCommands::install(const fs::path& pack) {
    if (m_work_on_pack.is_running())
        return m_work.messages.say("Another pack is being installed. Try again when it is done.",
                                   true);
    m_work.messages.say(fmt::format("Installing \"{}\"…", pack.filename().string()));
    m_is_reported = false;
    m_work_on_pack.start(
        [pack, library = m_work.library](JobProgress&) { return install_pack(pack, library); });
}

void PackCommands::update() {
    m_work_on_pack.update();
    const auto& outcome = m_work_on_pack.outcome();
    if (!outcome || m_is_reported)
        return;
    m_is_reported = true;
    if (!m_work.messages.succeeded(*outcome))
        return;
    bool is_preset = false;
    const InstalledItem* item = item_to_open(**outcome, is_preset);
    if (!item)
        return m_work.messages.say(summary(**outcome));
    const fs::path file = m_work.library.roots().user / "presets" / (item->id + ".json");
    m_work.messages.offer(summary(**outcome),
                          {.name = "Open " + item->name,
                           .commands = {[argument = is_preset ? file.string() : item->id](
                                            LookCommands& looks) { looks.open(argument); }}});
}
