#pragma once

#include "lab/messages/edit.h"
#include "model/look/parameter.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// A number that the user must type for an entry.
struct NumberPrompt {
    double current = 0.0;
    std::string unit = {};
    Limit limit = {};
    bool is_whole = false;
    std::string help = {};
    std::function<std::vector<Edit>(double)> answer = {};  // for a number within the limit
};

/// A text that the user must type for an entry.
struct TextPrompt {
    std::string current;
    std::function<std::vector<Edit>(const std::string&)> answer;
};

/// An entry of a menu, a panel or the command palette.
struct MenuEntry {
    std::string name;  // "Lissajous"; "Frequency…" if a value must be typed first
    std::vector<Edit> commands = {};
    bool is_present = false;  // it is the current state
    std::optional<NumberPrompt> number = {};
    std::optional<TextPrompt> text = {};
};

/// Menu entries of one kind.
struct MenuSection {
    enum class Menu { palette, edit, view, compare, pass, file };  // the menu that also shows it

    std::string title;  // "Signal"
    Menu menu = Menu::palette;
    std::vector<MenuEntry> entries = {};

    /// "Signal: Lissajous".
    std::string label_of(const MenuEntry& entry) const { return title + ": " + entry.name; }
};
