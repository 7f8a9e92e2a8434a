#pragma once

#include "lab/document/document.h"

/// A step of a document's past or future as a list shows it.
struct HistoryStep {
    std::string name;     // "Decay"
    std::string change;   // "0.92 → 0.61 per 1/60 s"
    std::string details;  // the same in full, a line for each change
    int distance = 0;     // redo steps from the present one; below 0 undo steps
};

/// How many states there are to go to: the first, and one behind each step.
std::size_t history_size(const Document& document);
/// The place of the present one.
std::size_t history_place(const Document& document);
const DocumentState& history_state(const Document& document, std::size_t place);
/// The step that led to a state; of the first one nothing is known.
HistoryStep history_step(const Document& document, std::size_t place);
