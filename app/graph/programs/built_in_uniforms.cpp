#include "graph/programs/built_in_uniforms.h"

#include <algorithm>
#include <cmath>
#include <span>

BuiltInUniforms::BuiltInUniforms(const Look& look, int pass, const gpu::Program& program) {
    for (const BuiltInUniform& built_in : look.passes[static_cast<std::size_t>(pass)].built_ins) {
        const gpu::Uniform* uniform = program.find_uniform(built_in.name);
        const bool is_turned = built_in.kind == BuiltIn::view || built_in.kind == BuiltIn::camera;
        if (!uniform || is_turned)  // ParameterUniforms writes the matrices of the orbit
            continue;
        if (built_in.kind == BuiltIn::samples)
            m_samples = uniform;
        else
            m_uniforms.push_back(
                {uniform, built_in.kind,
                 built_in.of ? bound_input(look, pass, *built_in.of) : BoundInput{}});
    }
}

namespace {
using Sixteen = std::array<double, 16>;

double width_of(Extent extent) {
    return extent.width;
}

double height_of(Extent extent) {
    return extent.height;
}

Sixteen with_reciprocals(Extent extent) {
    const double width = std::max(extent.width, 1);
    const double height = std::max(extent.height, 1);
    return {width, height, 1.0 / width, 1.0 / height};
}

Sixteen resolution(Extent extent) {
    return {width_of(extent), height_of(extent), 1.0};
}

Sixteen pair(Extent extent) {
    return {width_of(extent), height_of(extent)};
}

Sixteen lines(const RasterAxis& axis) {
    return {axis.start, axis.pitch, axis.count * 1.0};
}

Sixteen widened(const std::array<double, 4>& numbers) {
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

Sixteen date_numbers(const Date& date, int first_month) {
    return {date.year * 1.0, date.month - 1.0 + first_month, date.day * 1.0, date.seconds};
}

// From 0..1 to clip space, column-major. The quad's y points down from the top of the picture. In a
// target that stores the top row first, this direction is up.
Sixteen quad_to_clip(RowOrder rows) {
    const double down = rows == RowOrder::top_first ? 1.0 : -1.0;
    return {2.0, 0.0, 0.0, 0.0, 0.0,  2.0 * down, 0.0, 0.0,
            0.0, 0.0, 1.0, 0.0, -1.0, -down,      0.0, 1.0};
}
}  // namespace

// Empty if the value does not depend on time.
BuiltInUniforms::Numbers BuiltInUniforms::time_numbers(BuiltIn kind, const Frame& frame,
                                                       const PassInfo& info) {
    switch (kind) {
        case BuiltIn::time:
            return {{frame.time}, 1};
        case BuiltIn::time_delta:
            return {{frame.time_delta}, 1};
        case BuiltIn::frame_rate:
            return {{frame.time_delta > 0.0 ? 1.0 / frame.time_delta : 0.0}, 1};
        case BuiltIn::frame:
            return {{info.number}, 1};
        case BuiltIn::frame_index:
            return {{info.index_of_frame}, 1};
        case BuiltIn::source_frame_index:
            return {{info.source_index}, 1};
        case BuiltIn::subframe:
            return {{static_cast<double>(shown_subframe(frame).index)}, 1};
        case BuiltIn::subframe_number:
            return {{static_cast<double>(shown_subframe(frame).index + 1)}, 1};
        case BuiltIn::subframes:
            return {{static_cast<double>(shown_subframe(frame).count)}, 1};
        case BuiltIn::microseconds:
            return {{std::round(frame.time_delta * 1e6)}, 1};
        case BuiltIn::time_before:
            return {{frame.time - frame.time_delta}, 1};
        case BuiltIn::delta_before:
            return {{frame.number > 1 ? frame.time_delta : 0.0}, 1};
        case BuiltIn::date:
            return {date_numbers(frame.date, 1), 4};
        case BuiltIn::date_from_0:
            return {date_numbers(frame.date, 0), 4};
        default:
            return {{}, 0};
    }
}

BuiltInUniforms::Numbers BuiltInUniforms::numbers_of(const BoundBuiltIn& bound, const Frame& frame,
                                                     const PassInfo& info) {
    switch (bound.kind) {
        case BuiltIn::target_size:
            return {pair(info.target), 2};
        case BuiltIn::output_size:
            return {pair(info.output), 2};
        case BuiltIn::source_size:
            return {pair(info.source), 2};
        case BuiltIn::source_aspect:
            return {{width_of(info.source) * frame.pixel_aspect /
                     std::max(height_of(info.source), 1.0)},
                    1};
        case BuiltIn::source_lines:
            return {lines(info.raster.rows), 3};
        case BuiltIn::source_columns:
            return {lines(info.raster.columns), 3};
        case BuiltIn::peak:
            return {{frame.hdr ? frame.hdr->headroom() : 1.0}, 1};
        case BuiltIn::hdr_mode:
            return {{frame.hdr ? 2.0 : 0.0}, 1};
        case BuiltIn::paper_white:
            return {{frame.hdr ? frame.hdr->paper_white : 200.0}, 1};
        case BuiltIn::mouse:
            return {{frame.mouse[0], frame.mouse[1]}, 2};
        case BuiltIn::quad_to_clip:
            return {quad_to_clip(info.rows), 16};
        case BuiltIn::target_extent:
            return {with_reciprocals(info.target), 4};
        case BuiltIn::output_extent:
            return {with_reciprocals(info.output), 4};
        case BuiltIn::input_extent:
            return {with_reciprocals(info.extent_of(bound.of)), 4};
        case BuiltIn::target_resolution:
            return {resolution(info.target), 3};
        case BuiltIn::input_resolution:
            return {resolution(info.extent_of(bound.of)), 3};
        case BuiltIn::press:
            return {widened(frame.press.numbers()), 4};
        case BuiltIn::drawn_onto:
            return {{info.is_drawn_onto ? 1.0 : 0.0}, 1};
        default:  // write_samples() writes samples, ParameterUniforms the orbit
            return time_numbers(bound.kind, frame, info);
    }
}

void BuiltInUniforms::write(const gpu::Program& program, const Frame& frame,
                            const PassInfo& info) const {
    for (const BoundBuiltIn& bound : m_uniforms) {
        const Numbers value = numbers_of(bound, frame, info);
        program.write(*bound.uniform, std::span(value.numbers).first(value.count));
    }
}

void BuiltInUniforms::write_samples(const gpu::Program& program, int samples) const {
    if (m_samples)
        program.write(*m_samples, std::array{static_cast<double>(samples)});
}

std::vector<BuiltInReport> BuiltInUniforms::report(const Frame& frame, const PassInfo& info,
                                                   int samples) const {
    std::vector<BuiltInReport> all;
    for (const BoundBuiltIn& bound : m_uniforms) {
        const Numbers value = numbers_of(bound, frame, info);
        const auto end = value.numbers.begin() + static_cast<std::ptrdiff_t>(value.count);
        all.push_back({bound.uniform->name, {value.numbers.begin(), end}});
    }
    if (m_samples)
        all.push_back({m_samples->name, {static_cast<double>(samples)}});
    return all;
}

bool BuiltInUniforms::uses_time() const {
    return std::ranges::any_of(m_uniforms, tells_time, &BoundBuiltIn::kind);
}

bool BuiltInUniforms::uses_mouse() const {
    return std::ranges::any_of(m_uniforms, [](const BoundBuiltIn& bound) {
        return bound.kind == BuiltIn::mouse || bound.kind == BuiltIn::press;
    });
}
