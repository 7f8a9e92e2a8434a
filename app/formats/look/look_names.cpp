#include "formats/look/look_names.h"

const Choices<Draw>& draw_names() {
    static const Choices<Draw> words{
        {"fullscreen", Draw::fullscreen}, {"points", Draw::points}, {"segments", Draw::segments}};
    return words;
}

const Choices<Blend>& blend_names() {
    static const Choices<Blend> words{{"replace", Blend::replace},
                                      {"add", Blend::add},
                                      {"alpha", Blend::alpha},
                                      {"multiply", Blend::multiply},
                                      {"maximum", Blend::maximum}};
    return words;
}

const Choices<Filter>& filter_names() {
    static const Choices<Filter> words{{"nearest", Filter::nearest}, {"linear", Filter::linear}};
    return words;
}

const Choices<Wrap>& wrap_names() {
    static const Choices<Wrap> words{{"edge", Wrap::edge},
                                     {"border", Wrap::border},
                                     {"repeat", Wrap::repeat},
                                     {"mirror", Wrap::mirror}};
    return words;
}

const Choices<Format>& format_names() {
    static const Choices<Format> words = [] {
        Choices<Format> made;
        for (const FormatInfo& info : all_formats())
            made.emplace_back(info.name, info.format);
        return made;
    }();
    return words;
}

const Choices<Driver>& driver_names() {
    static const Choices<Driver> words{
        {"signal", Driver::signal}, {"picture", Driver::picture}, {"nothing", Driver::nothing}};
    return words;
}

const Choices<Encoding>& encoding_names() {
    static const Choices<Encoding> words{{"display", Encoding::display},
                                         {"linear", Encoding::linear}};
    return words;
}
