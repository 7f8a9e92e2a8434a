#pragma once

#include "formats/json/object_reader.h"
#include "model/look/look.h"

#include <string_view>

// Names of the model's enum values in look.json and `describe`.
const Choices<Draw>& draw_names();
const Choices<Blend>& blend_names();
const Choices<Filter>& filter_names();
const Choices<Wrap>& wrap_names();
const Choices<Format>& format_names();
const Choices<Driver>& driver_names();
const Choices<Encoding>& encoding_names();

/// The name of an enum value; each value has one.
template <class T>
std::string_view name_of(const Choices<T>& names, T value) {
    std::size_t at = 0;
    while (names[at].second != value)
        ++at;
    return names[at].first;
}
