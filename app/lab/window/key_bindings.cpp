#include "lab/window/key_bindings.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>

Chord KeyBindings::chord_of(const KeyedAction& action) const {
    const auto found = m_changed.find(action.name);
    return found == m_changed.end() ? action.initial : found->second;
}

const KeyedAction* KeyBindings::find_conflict(std::span<const KeyedAction> actions,
                                              const KeyedAction& action, const Chord& chord) const {
    if (chord.key == 0)
        return nullptr;
    const auto found = std::ranges::find_if(actions, [&](const KeyedAction& other) {
        return other.name != action.name && chord_of(other) == chord;
    });
    return found == actions.end() ? nullptr : &*found;
}

void KeyBindings::assign(const KeyedAction& action, const Chord& chord) {
    if (chord == action.initial)
        m_changed.erase(action.name);
    else
        m_changed[action.name] = chord;
}

void KeyBindings::set(std::span<const KeyedAction> actions, const KeyedAction& action,
                      const Chord& chord) {
    const Chord before = chord_of(action);
    const KeyedAction* other = find_conflict(actions, action, chord);
    assign(action, chord);
    if (other)
        assign(*other, before);
}

void KeyBindings::reset(std::span<const KeyedAction> actions, const KeyedAction& action) {
    set(actions, action, action.initial);
}

std::vector<KeyChoice> KeyBindings::choices() const {
    std::vector<KeyChoice> choices;
    for (const auto& [name, chord] : m_changed)
        choices.push_back({name, chord_text(chord)});
    return choices;
}

namespace {
std::string unknown_action(const std::string& name, std::span<const KeyedAction> actions) {
    std::vector<std::string> names;
    for (const KeyedAction& action : actions)
        names.push_back(action.name);
    return fmt::format("unknown action '{}'{}", name, did_you_mean(name, names));
}

// Why a choice cannot be used; "": it can.
std::string fault_of(const KeyChoice& choice) {
    const auto chord = parse_chord(choice.key);
    if (!chord)
        return fmt::format("'{}' is not a key. Write it as in 'Ctrl+Shift+S', or '' for no key.",
                           choice.key);
    if (chord->key != 0 && !is_assignable(*chord))
        return fmt::format("'{}' is reserved. Choose another key.", choice.key);
    return {};
}
}  // namespace

KeyBindings bindings_from(std::span<const KeyChoice> choices, std::span<const KeyedAction> actions,
                          const std::filesystem::path& file, Diagnostics& problems) {
    const auto report = [&](const KeyChoice& choice, std::string message) {
        problems.push_back({file, choice.line, std::move(message), Severity::warning});
    };
    const auto action_of = [&](const KeyChoice& choice) {
        return std::ranges::find(actions, choice.action, &KeyedAction::name);
    };
    // Two actions may swap their keys: first, each gives up its own.
    KeyBindings bindings;
    std::vector<KeyChoice> good;
    for (const KeyChoice& choice : choices) {
        const auto action = action_of(choice);
        if (action == actions.end())
            report(choice, unknown_action(choice.action, actions));
        else if (std::string fault = fault_of(choice); !fault.empty())
            report(choice, std::move(fault));
        else if (bindings.set(actions, *action, {}); true)
            good.push_back(choice);
    }
    for (const KeyChoice& choice : good) {
        const KeyedAction& action = *action_of(choice);
        const Chord chord = *parse_chord(choice.key);
        const KeyedAction* other = bindings.find_conflict(actions, action, chord);
        if (other)
            report(choice,
                   fmt::format("{} is already the key of '{}'", chord_text(chord), other->name));
        if (!other)
            bindings.set(actions, action, chord);
        else if (!bindings.find_conflict(actions, action, action.initial))
            bindings.reset(actions, action);
    }
    return bindings;
}
