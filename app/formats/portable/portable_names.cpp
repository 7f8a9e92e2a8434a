#include "formats/portable/portable_names.h"

const Choices<BuiltIn>& built_in_names() {
    static const Choices<BuiltIn> names{{"time", BuiltIn::time},
                                        {"time_delta", BuiltIn::time_delta},
                                        {"frame", BuiltIn::frame},
                                        {"samples", BuiltIn::samples},
                                        {"target_size", BuiltIn::target_size},
                                        {"output_size", BuiltIn::output_size},
                                        {"source_size", BuiltIn::source_size},
                                        {"source_lines", BuiltIn::source_lines},
                                        {"source_columns", BuiltIn::source_columns},
                                        {"mouse", BuiltIn::mouse},
                                        {"view", BuiltIn::view},
                                        {"camera", BuiltIn::camera},
                                        {"drawn_onto", BuiltIn::drawn_onto},
                                        {"frame_index", BuiltIn::frame_index},
                                        {"microseconds", BuiltIn::microseconds},
                                        {"source_aspect", BuiltIn::source_aspect},
                                        {"time_before", BuiltIn::time_before},
                                        {"delta_before", BuiltIn::delta_before},
                                        {"date", BuiltIn::date},
                                        {"date_from_0", BuiltIn::date_from_0},
                                        {"quad_to_clip", BuiltIn::quad_to_clip},
                                        {"frame_rate", BuiltIn::frame_rate},
                                        {"press", BuiltIn::press},
                                        {"peak", BuiltIn::peak},
                                        {"hdr_mode", BuiltIn::hdr_mode},
                                        {"paper_white", BuiltIn::paper_white},
                                        {"subframe", BuiltIn::subframe},
                                        {"subframe_number", BuiltIn::subframe_number},
                                        {"subframes", BuiltIn::subframes},
                                        {"source_frame_index", BuiltIn::source_frame_index},
                                        {"target_resolution", BuiltIn::target_resolution},
                                        {"input_resolution", BuiltIn::input_resolution},
                                        {"target_extent", BuiltIn::target_extent},
                                        {"output_extent", BuiltIn::output_extent},
                                        {"input_extent", BuiltIn::input_extent}};
    return names;
}

const Choices<Input::From>& texture_names() {
    static const Choices<Input::From> names{{"pass", Input::From::pass},
                                            {"source", Input::From::source},
                                            {"image", Input::From::image},
                                            {"keyboard", Input::From::keyboard},
                                            {"sound", Input::From::sound}};
    return names;
}

const Choices<OrbitPart>& orbit_names() {
    static const Choices<OrbitPart> names{{"none", OrbitPart::none},
                                          {"turn", OrbitPart::turn},
                                          {"azimuth", OrbitPart::azimuth},
                                          {"elevation", OrbitPart::elevation},
                                          {"distance", OrbitPart::distance}};
    return names;
}

const Choices<SoundTexture::Holds>& sound_names() {
    using Holds = SoundTexture::Holds;
    static const Choices<Holds> names{
        {"wave", Holds::wave}, {"spectrum", Holds::spectrum}, {"analyser", Holds::analyser}};
    return names;
}

const Choices<RowOrder>& row_order_names() {
    static const Choices<RowOrder> names{{"bottom-first", RowOrder::bottom_first},
                                         {"top-first", RowOrder::top_first}};
    return names;
}

const Choices<PictureShape>& shape_names() {
    static const Choices<PictureShape> names{{"flat", PictureShape::flat},
                                             {"cube", PictureShape::cube},
                                             {"volume", PictureShape::volume}};
    return names;
}
