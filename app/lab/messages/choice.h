#pragma once

#include "model/look/parameter.h"

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

class Document;
class Lab;
struct WindowState;

/// An effect on the document, the lab or the window.
using MenuCommand = std::variant<std::function<void(Document&)>, std::function<void(Lab&)>,
                                 std::function<void(WindowState&)>>;
using MenuCommands = std::vector<MenuCommand>;

/// A number that the user must type for a choice.
struct AskedNumber {
    double present = 0.0;
    std::string unit = {};
    Limit limit = {};
    bool is_whole = false;
    std::string help = {};
    std::function<MenuCommands(double)> answer = {};  // for a number within the limit
};

/// A text that the user must type for a choice.
struct AskedText {
    std::string present;
    std::function<MenuCommands(const std::string&)> answer;
};

/// An entry of a menu, a panel or the command palette.
struct Choice {
    std::string name;  // "Lissajous"; "Frequency…" if a value must be typed first
    MenuCommands commands = {};
    bool is_present = false;  // it is the current state
    std::optional<AskedNumber> number = {};
    std::optional<AskedText> text = {};
};

/// A list of choices of one kind, named by `word`.
struct ChoiceList {
    enum class Place { palette, edit, view, compare, pass, file };  // the menu that also shows it

    std::string word;  // "Signal"
    Place place = Place::palette;
    std::vector<Choice> choices = {};

    /// "Signal: Lissajous".
    std::string label_of(const Choice& choice) const { return word + ": " + choice.name; }
};
