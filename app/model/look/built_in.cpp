#include "model/look/built_in.h"

const std::vector<BuiltInUniform>& own_built_ins() {
    static const std::vector<BuiltInUniform> all{{"u_time", BuiltIn::time},
                                                 {"u_time_delta", BuiltIn::time_delta},
                                                 {"u_frame", BuiltIn::frame},
                                                 {"u_resolution", BuiltIn::target_size},
                                                 {"u_output_resolution", BuiltIn::output_size},
                                                 {"u_source_resolution", BuiltIn::source_size},
                                                 {"u_source_lines", BuiltIn::source_lines},
                                                 {"u_source_columns", BuiltIn::source_columns},
                                                 {"u_mouse", BuiltIn::mouse},
                                                 {"u_samples", BuiltIn::samples},
                                                 {"u_view", BuiltIn::view},
                                                 {"u_camera", BuiltIn::camera},
                                                 {"u_drawn_onto", BuiltIn::drawn_onto},
                                                 {"u_subframe", BuiltIn::subframe},
                                                 {"u_subframes", BuiltIn::subframes},
                                                 {"u_peak", BuiltIn::peak}};
    return all;
}

bool tells_time(BuiltIn kind) {
    switch (kind) {
        case BuiltIn::time:
        case BuiltIn::time_delta:
        case BuiltIn::frame:
        case BuiltIn::frame_index:
        case BuiltIn::source_frame_index:
        case BuiltIn::subframe:
        case BuiltIn::subframe_number:
        case BuiltIn::microseconds:
        case BuiltIn::time_before:
        case BuiltIn::frame_rate:
        case BuiltIn::delta_before:
        case BuiltIn::date:
        case BuiltIn::date_from_0:
            return true;
        default:
            return false;
    }
}
