#pragma once

#include "lab/frame/workspace.h"
#include "lab/packs/pack_installer.h"
#include "lab/storage/background_work.h"

#include <filesystem>

/// Installs packs in the background, one at a time.
class PackCommands {
public:
    explicit PackCommands(Workspace& work) : m_work(work) {}

    /// Adds the looks and presets of a pack to the user's folder. The notice at the end offers to
    /// open one of them; until then nothing of the pack is compiled or drawn.
    void install(const std::filesystem::path& pack);

    void update();
    bool is_running() const { return m_work_on_pack.is_running(); }

private:
    Workspace& m_work;
    BackgroundWork<InstalledPack> m_work_on_pack;
    bool m_is_reported = true;
};
