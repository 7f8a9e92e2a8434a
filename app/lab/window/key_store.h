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

    /// Reads the bindings. A file with errors gives none, and is not overwritten.
    KeyBindings load(std::span<const KeyedAction> actions, Diagnostics& problems);
    /// Saves the bindings that differ from the last ones; others in the file stay. Reports a
    /// failure.
    void update(const KeyBindings& bindings, Messages& messages);

    const std::filesystem::path& file() const { return m_file; }

private:
    /// The choices in the file; empty if it does not exist.
    Result<std::vector<KeyChoice>> read() const;

    std::filesystem::path m_file;
    KeyBindings m_saved;
};
