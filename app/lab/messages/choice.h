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

/// Something to be done to the document, by the lab, or to the window.
using Deed = std::variant<std::function<void(Document&)>, std::function<void(Lab&)>,
                          std::function<void(WindowState&)>>;
using Deeds = std::vector<Deed>;

/// A number that is typed before something can be done with it.
struct AskedNumber {
    double present = 0.0;
    std::string unit = {};
    Limit limit = {};
    bool is_whole = false;
    std::string help = {};
    std::function<Deeds(double)> answer = {};  // of a number within the limit
};

/// The same with words.
struct AskedText {
    std::string present;
    std::function<Deeds(const std::string&)> answer;
};

/// One thing of a list, chosen by its name: by typing that, from a menu or in a panel.
struct Choice {
    std::string name;  // "Lissajous"; "Frequency…" where something is asked first
    Deeds deeds = {};
    bool is_present = false;  // as it is now
    std::optional<AskedNumber> number = {};
    std::optional<AskedText> text = {};
};

/// What there is to choose from, under the word that tells what kind of thing it is.
struct ChoiceList {
    enum class Place { palette, edit, view, compare, pass, file };  // the menu that has it, too

    std::string word;  // "Signal"
    Place place = Place::palette;
    std::vector<Choice> choices = {};

    /// "Signal: Lissajous".
    std::string label_of(const Choice& choice) const { return word + ": " + choice.name; }
};
