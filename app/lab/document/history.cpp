#include "lab/document/history.h"

#include "lab/document/changes.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
std::string details_of(const std::vector<Change>& changes) {
    constexpr std::size_t maximum = 24;
    std::string text;
    for (std::size_t i = 0; i < std::min(changes.size(), maximum); ++i)
        text += (i > 0 ? "\n" : "") + line_of(changes[i]);
    return changes.size() > maximum ? fmt::format("{}\nand {} more", text, changes.size() - maximum)
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
    const std::size_t current = history.past().size();
    if (index < current)
        return history.past()[index].state;
    if (index == current)
        return history.current();
    return history.future()[history.future().size() - (index - current)].state;
}

HistoryStep history_step(const Document& document, std::size_t index) {
    const auto& history = document.history();
    const std::size_t current = history.past().size();
    const int distance = static_cast<int>(index) - static_cast<int>(current);
    if (index == 0)
        return {"Start", {}, {}, distance};
    const std::string& name =
        index <= current ? history.past()[index - 1].name
                         : history.future()[history.future().size() - (index - current)].name;
    const auto changes = changes_between(document.look(), history_state(document, index - 1),
                                         history_state(document, index));
    return {name, summary_of(changes, name), details_of(changes), distance};
}
