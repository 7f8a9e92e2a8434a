#pragma once

#include "formats/settings/keys_format.h"
#include "lab/window/chord.h"

#include <map>
#include <span>
#include <string>
#include <vector>

/// An action that has a key or can get one.
struct KeyedAction {
    std::string name;  // in keys.json
    std::string label;
    Chord initial;
};

/// The keys that the user chose instead of the initial ones.
class KeyBindings {
public:
    /// The key of an action now.
    Chord chord_of(const KeyedAction& action) const;
    bool is_changed(const KeyedAction& action) const { return m_changed.contains(action.name); }
    bool is_empty() const { return m_changed.empty(); }

    /// The other action that has this key; null: none, or the chord has no key.
    const KeyedAction* find_conflict(std::span<const KeyedAction> actions,
                                     const KeyedAction& action, const Chord& chord) const;
    /// Gives a key to an action. An action that has the key gets the action's previous key.
    void set(std::span<const KeyedAction> actions, const KeyedAction& action, const Chord& chord);
    /// Gives an action its initial key, as set() does.
    void reset(std::span<const KeyedAction> actions, const KeyedAction& action);
    void reset_all() { m_changed.clear(); }

    /// As for keys.json, by name.
    std::vector<KeyChoice> choices() const;

    bool operator==(const KeyBindings&) const = default;

private:
    void assign(const KeyedAction& action, const Chord& chord);

    std::map<std::string, Chord> m_changed;
};

/// The bindings of a file. Reported at its lines, and left out: unknown actions, texts that are not
/// keys, reserved keys, and keys that another action has.
KeyBindings bindings_from(std::span<const KeyChoice> choices, std::span<const KeyedAction> actions,
                          const std::filesystem::path& file, Diagnostics& problems);
