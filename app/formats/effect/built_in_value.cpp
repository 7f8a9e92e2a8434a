#include "formats/effect/built_in_value.h"

#include "formats/effect/effect_uniforms.h"

#include <fmt/format.h>

namespace {
// The type of the expressions below.
NumberType natural_type(BuiltIn kind) {
    switch (kind) {
        case BuiltIn::target_size:
        case BuiltIn::output_size:
        case BuiltIn::source_size:
        case BuiltIn::mouse:
            return {Scalar::floating, 2, 1};
        case BuiltIn::source_lines:
        case BuiltIn::source_columns:
        case BuiltIn::target_resolution:
        case BuiltIn::input_resolution:
            return {Scalar::floating, 3, 1};
        case BuiltIn::press:
        case BuiltIn::date:
        case BuiltIn::date_from_0:
        case BuiltIn::target_extent:
        case BuiltIn::output_extent:
        case BuiltIn::input_extent:
            return {Scalar::floating, 4, 1};
        case BuiltIn::view:
        case BuiltIn::camera:
        case BuiltIn::quad_to_clip:
            return {Scalar::floating, 4, 4};
        case BuiltIn::frame:
        case BuiltIn::frame_index:
        case BuiltIn::source_frame_index:
        case BuiltIn::subframe:
        case BuiltIn::subframe_number:
        case BuiltIn::subframes:
        case BuiltIn::samples:
            return {Scalar::integer, 1, 1};
        case BuiltIn::drawn_onto:
            return {Scalar::boolean, 1, 1};
        default:
            return {};
    }
}

std::string extent_of(const HostSize& size) {
    return size.extent.empty() ? fmt::format("vec4({0}, 1.0 / {0})", size.pixels) : size.extent;
}

std::string resolution_of(const HostSize& size) {
    return fmt::format("vec3({}, 1.0)", size.pixels);
}

// "": not a size.
std::string size_value(const BuiltInUniform& uniform, HostValues& host) {
    switch (uniform.kind) {
        case BuiltIn::target_size:
            return host.target().pixels;
        case BuiltIn::target_resolution:
            return resolution_of(host.target());
        case BuiltIn::target_extent:
            return extent_of(host.target());
        case BuiltIn::output_size:
            return host.output().pixels;
        case BuiltIn::output_extent:
            return extent_of(host.output());
        case BuiltIn::source_size:
            return host.source().pixels;
        case BuiltIn::source_lines:
            return fmt::format("vec3(0.0, 1.0 / {0}.y, {0}.y)", host.raster().pixels);
        case BuiltIn::source_columns:
            return fmt::format("vec3(0.0, 1.0 / {0}.x, {0}.x)", host.raster().pixels);
        case BuiltIn::source_aspect:
            return host.aspect();
        case BuiltIn::input_extent:
            return extent_of(host.input(uniform.of.value_or(Input{})));
        case BuiltIn::input_resolution:
            return resolution_of(host.input(uniform.of.value_or(Input{})));
        default:
            return {};
    }
}

std::string counted(const std::string& frames, int modulo) {
    return modulo > 0 ? fmt::format("(({}) % {})", frames, modulo) : frames;
}

// "": does not change with time.
std::string time_value(BuiltIn kind, const Pass& pass, HostValues& host) {
    switch (kind) {
        case BuiltIn::time:
            return host.time();
        case BuiltIn::time_before:
            return host.time_before();
        case BuiltIn::time_delta:
            return host.time_delta();
        case BuiltIn::delta_before:
            return fmt::format("({} == 0 ? 0.0 : {})", host.frames_before(), host.time_delta());
        case BuiltIn::microseconds:
            return fmt::format("round(1e6 * ({}))", host.time_delta());
        case BuiltIn::frame_rate:
            return fmt::format("1.0 / max({}, 0.001)", host.time_delta());
        case BuiltIn::frame:
            return counted(host.frames_before() + " + 1", pass.frame_modulo);
        case BuiltIn::frame_index:
        case BuiltIn::source_frame_index:
            return counted(host.frames_before(), pass.frame_modulo);
        case BuiltIn::subframe:
            return host.subframe_number() + " - 1";
        case BuiltIn::subframe_number:
            return host.subframe_number();
        case BuiltIn::subframes:
            return host.subframes();
        case BuiltIn::peak:  // without HDR
            return "1.0";
        case BuiltIn::paper_white:
            return "200.0";
        case BuiltIn::date:
            return host.date();
        case BuiltIn::date_from_0:
            return host.date().empty() ? std::string()
                                       : host.date() + " - vec4(0.0, 1.0, 0.0, 0.0)";
        default:
            return {};
    }
}

// "": not of the mouse, or the program has none.
std::string mouse_value(BuiltIn kind, HostValues& host) {
    const std::string press = host.press();
    if (press.empty())
        return {};
    if (kind == BuiltIn::mouse)
        return press + ".xy";
    return kind == BuiltIn::press ? press : std::string();
}

// From the quad's corners to the target, with the picture's top at the top.
std::string quad_to_clip(RowOrder rows) {
    const bool is_down = rows == RowOrder::top_first;
    return fmt::format(
        "mat4(2.0, 0.0, 0.0, 0.0, 0.0, {}2.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, "
        "{}1.0, 0.0, 1.0)",
        is_down ? "" : "-", is_down ? "-" : "");
}
}  // namespace

std::string HostValues::aspect() {
    return fmt::format("{0}.x / {0}.y", raster().pixels);
}

std::string built_in_value(const BuiltInUniform& uniform, const NumberType& type, const Pass& pass,
                           HostValues& host) {
    std::string value = size_value(uniform, host);
    if (value.empty())
        value = time_value(uniform.kind, pass, host);
    if (value.empty())
        value = mouse_value(uniform.kind, host);
    if (uniform.kind == BuiltIn::quad_to_clip)
        value = quad_to_clip(pass.rows);
    if (uniform.kind == BuiltIn::samples)
        value = "1";
    if (value.empty())
        return glsl_zero(type);
    return natural_type(uniform.kind) == type ? value
                                              : fmt::format("{}({})", glsl_name(type), value);
}
