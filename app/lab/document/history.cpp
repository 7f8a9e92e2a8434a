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
const DocumentState& history_state(const Document& document, std::size_t index) {
    const auto& history = document.history();
    const std::size_t present = history.past().size();
    if (index < present)
        return history.past()[index].state;
    if (index == present)
        return history.current();
    return history.future()[history.future().size() - (index - present)].state;
}

HistoryStep history_step(const Document& document, std::size_t index) {
    const auto& history = document.history();
    const std::size_t present = history.past().size();
    const int distance = static_cast<int>(index) - static_cast<int>(present);
    if (index == 0)
        return {"Start", {}, {}, distance};
    const std::string& name =
        index <= present ? history.past()[index - 1].name
                         : history.future()[history.future().size() - (index - present)].name;
    const auto changes = changes_between(document.look(), history_state(document, index - 1),
                                         history_state(document, index));
    return {name, summary_of(changes, name), details_of(changes), distance};
}
