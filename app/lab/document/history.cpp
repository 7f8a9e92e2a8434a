#include "lab/document/history.h"

#include "lab/document/changes.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
std::string details_of(const std::vector<Change>& changes) {
    constexpr std::size_t most = 24;
    std::string text;
    for (std::size_t i = 0; i < std::min(changes.size(), most); ++i)
        text += (i > 0 ? "\n" : "") + line_of(changes[i]);
    return changes.size() > most ? fmt::format("{}\nand {} more", text, changes.size() - most)
                                 : text;
}
}  // namespace

std::size_t history_size(const Document& document) {
    return document.history().past().size() + document.history().future().size() + 1;
}

std::size_t history_index(const Document& document) {
    return document.history().past().size();
}

// The undone states are in reverse order: the next redo is the last.
const DocumentState& history_state(const Document& document, std::size_t place) {
    const auto& history = document.history();
    const std::size_t present = history.past().size();
    if (place < present)
        return history.past()[place].state;
    if (place == present)
        return history.current();
    return history.future()[history.future().size() - (place - present)].state;
}

HistoryStep history_step(const Document& document, std::size_t place) {
    const auto& history = document.history();
    const std::size_t present = history.past().size();
    const int distance = static_cast<int>(place) - static_cast<int>(present);
    if (place == 0)
        return {"Start", {}, {}, distance};
    const std::string& name =
        place <= present ? history.past()[place - 1].name
                         : history.future()[history.future().size() - (place - present)].name;
    const auto changes = changes_between(document.look(), history_state(document, place - 1),
                                         history_state(document, place));
    return {name, summary_of(changes, name), details_of(changes), distance};
}
