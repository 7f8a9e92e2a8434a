#pragma once

#include "formats/json/object_reader.h"
#include "model/look/look.h"

#include <string_view>

// Names of the model's enum values in look.json and `describe`.
const Choices<Draw>& draw_words();
const Choices<Blend>& blend_words();
const Choices<Filter>& filter_words();
const Choices<Wrap>& wrap_words();
const Choices<Format>& format_words();
const Choices<Driver>& driver_words();
const Choices<Encoding>& encoding_words();

/// The word for an enum value; each value has one.
template <class T>
std::string_view word_of(const Choices<T>& words, T choice) {
    std::size_t at = 0;
    while (words[at].second != choice)
        ++at;
    return words[at].first;
}
