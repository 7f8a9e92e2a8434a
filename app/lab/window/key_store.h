#pragma once

#include "lab/messages/messages.h"
#include "lab/storage/roots.h"
#include "lab/window/key_bindings.h"

#include <filesystem>
#include <span>

/// Reads and writes the user's keys.json in the configuration folder.
class KeyStore {
public:
    explicit KeyStore(const Roots& roots);

    /// Reads the bindings. A file with errors gives none. It is then never overwritten.
    KeyBindings load(std::span<const KeyedAction> actions, Diagnostics& problems);
    /// Saves the bindings if they differ from the last ones. Reports a failure.
    void update(const KeyBindings& bindings, Messages& messages);

    const std::filesystem::path& file() const { return m_file; }

private:
    std::filesystem::path m_file;
    std::vector<KeyChoice> m_unknown;  // of a newer program: kept in the file
    KeyBindings m_saved;
    bool m_is_broken = false;
};
