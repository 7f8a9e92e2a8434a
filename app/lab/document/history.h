#pragma once

#include "lab/document/document.h"

/// An undo or redo step as it is listed.
struct HistoryStep {
    std::string name;     // "Decay"
    std::string change;   // "0.92 → 0.61 per 1/60 s"
    std::string details;  // in full, one line for each change
    int distance = 0;     // redo steps from the current state; negative: undo steps
};

/// The number of states: the first one, and one after each step.
std::size_t history_size(const Document& document);
/// The index of the current state.
std::size_t history_index(const Document& document);
const DocumentState& history_state(const Document& document, std::size_t index);
/// The step that led to a state; for the first state only its name and distance.
HistoryStep history_step(const Document& document, std::size_t index);
