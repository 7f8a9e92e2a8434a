#include "formats/shadertoy_export/shadertoy_beam.h"

#include "formats/shadertoy_export/shadertoy_signal.h"
#include "glsl/text/include.h"
#include "glsl/text/interface_statements.h"
#include "model/plan/parameter_use.h"
#include "model/plan/plan.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr int points_in_box = 64;
constexpr const char* other_kinds = "Export it with --to web.";

constexpr const char* table_text = R"(
// Texel 0: the state of the signal at the end of the frame. Then boxes around 64 points each, then the points.

// The frame's time in 1/60 s. Whole numbers are exact, so that phases do not drift.
float frame_time() {{
    float time = 60.0 * iTimeDelta;
    return abs(time - round(time)) < 1e-5 ? round(time) : time;
}}

// Draws point k of the frame. Afterwards xy is the middle of its square, and z half a side, px.
vec3 drawn_point(int k, vec4 start) {{
    float part = float(k + 1) / float({points});
    vec3 point = signal_point(start, frame_time() * part, frame_time() / float({points}));
    float point_age = iTimeDelta * (1.0 - part);
    float point_light = point.z * 4096.0 * frame_time() / float({points});
{inputs}    draw_pass();
    vec3 place = point_clip.xyz / point_clip.w;
    bool is_seen = all(lessThanEqual(abs(place), vec3(1.0)));
    vec3 square = vec3((0.5 + 0.5 * place.xy) * iResolution.xy, max(point_size, 1.0));
    square = floor(square * 256.0 + 0.5) / 256.0;  // as GPUs round points
    return vec3(square.xy, is_seen ? 0.5 * square.z : -1.0);
}}

vec4 drawn_box(int box, vec4 start) {{
    vec4 bounds = vec4(1e9, 1e9, -1e9, -1e9);
    for (int i = 0; i < {in_box}; ++i) {{
        vec3 square = drawn_point(min({in_box} * box + i, {points} - 1), start);
        if (square.z > 0.0)
            bounds = vec4(min(bounds.xy, square.xy - square.z), max(bounds.zw, square.xy + square.z));
    }}
    return bounds;
}}

void mainImage(out vec4 shadertoy_color, in vec2 shadertoy_place) {{
    int texel = int(shadertoy_place.x) + int(shadertoy_place.y) * int(iResolution.x);
    vec4 start = iFrame == 0 ? vec4(0.0) : texelFetch(iChannel0, ivec2(0), 0);
{settings}    int first = {boxes} + 1;
    shadertoy_color = vec4(0.0);
    if (texel == 0) {{
        shadertoy_color = signal_state(start, frame_time());
    }} else if (texel < first) {{
        shadertoy_color = drawn_box(texel - 1, start);
    }} else if (texel < first + {points} * {texels}) {{
        vec3 square = drawn_point((texel - first) / {texels}, start);
        float values[{count}] = float[{count}](square.x, square.y, square.z{values});
        int at = 4 * ((texel - first) % {texels});
        shadertoy_color = vec4(values[at], values[at + 1], values[at + 2], values[at + 3]);
    }}
}}
)";

constexpr const char* sum_text = R"(
vec4 point_texel(int texel) {{
    int width = int(iResolution.x);
    return texelFetch(iChannel{channel}, ivec2(texel % width, texel / width), 0);
}}

// The light of all points whose square has the pixel. The points of a box that is elsewhere are
// left out.
vec4 drawn_{name}(ivec2 at) {{
    vec2 pixel = vec2(at) + 0.5;
    vec4 sum = vec4(0.0);
    for (int box = 0; box < {boxes}; ++box) {{
        vec4 bounds = point_texel(box + 1);
        if (any(lessThan(pixel, bounds.xy)) || any(greaterThan(pixel, bounds.zw)))
            continue;
        for (int i = 0; i < {in_box} && {in_box} * box + i < {points}; ++i) {{
            int first = {boxes} + 1 + {texels} * ({in_box} * box + i);
            vec4 texel_0 = point_texel(first);
            vec2 away = pixel - texel_0.xy;
            if (any(lessThan(away, vec2(-texel_0.z))) || any(greaterThanEqual(away, texel_0.zz)))
                continue;
{unpack}            {prefix}fragcoord = vec4(pixel, 0.5, 1.0);
            {prefix}pointcoord = 0.5 + 0.5 * vec2(away.x, -away.y) / texel_0.z;
            {prefix}main();
            sum += {result};
        }}
    }}
    return sum;
}}
)";

int components_of(const std::string& type) {
    return type == "float" ? 1 : type.back() - '0';
}

int boxes_of(const ShadertoyBeam& beam) {
    return (beam.points + points_in_box - 1) / points_in_box;
}

// The square has three numbers.
int texels_of(const std::vector<ShadertoyPassedValue>& passed) {
    int count = 3;
    for (const ShadertoyPassedValue& value : passed)
        count += components_of(value.type);
    return (count + 3) / 4;
}

// A pyramid of pictures becomes a blur tap by tap.
bool choose_taps(const Look& look, Values& values) {
    const Parameter* const kind = find_parameter(look, "bloom_kind");
    const Item* const taps = [&]() -> const Item* {
        if (!kind)
            return nullptr;
        const auto found = std::ranges::find(kind->items, "Taps", &Item::label);
        return found == kind->items.end() ? nullptr : &*found;
    }();
    if (!taps || value_of(*kind, values) == Value(taps->value))
        return false;
    values[kind->name] = Value(taps->value);
    return true;
}

constexpr const char* no_beam = "#version 410 core\nvoid main() {}  // without its beam\n";

void fill_screen(Pass& pass, const char* fragment) {
    pass.draw = Draw::fullscreen;
    pass.vertex = fullscreen_vertex_stage();
    pass.fragment = builtin_stage(fragment);
}
}  // namespace

Result<BeamlessLook> without_beam(const EffectRequest& request) {
    BeamlessLook made{request.look, request.values, std::nullopt};
    Look& look = made.look;
    const auto has_beam = [](const Pass& pass) { return is_of_beam(pass.draw); };
    if (std::ranges::none_of(look.passes, has_beam) || !request.signal)
        return made;
    ShadertoyBeam beam;
    if (choose_taps(look, made.values))
        beam.losses.emplace_back("The bloom's pyramid. The bloom is read tap by tap.");
    const auto plan = plan_targets(look, request.size, request.source, made.values);
    if (!plan)
        return fail(plan.error());
    std::vector<std::string> idle;
    for (std::size_t i = 0; i < look.passes.size(); ++i) {
        Pass& pass = look.passes[i];
        pass.one_channel.clear();  // colour texels hold the same light
        pass.half_floats.clear();
        if (is_idle(look, i, plan->targets[i].extent)) {
            idle.push_back(pass.name);
            fill_screen(pass, "#version 410 core\nvoid main() {}\n");
        } else if (has_beam(pass)) {
            const bool is_sum = pass.draw == Draw::points && pass.blend == Blend::add;
            if (!is_sum || !beam.pass.name.empty())
                return made;  // which is refused as a beam
            beam.pass = pass;
            fill_screen(pass, no_beam);
        }
    }
    for (Pass& pass : look.passes)
        std::erase_if(pass.inputs, [&](const Input& input) {
            return input.from == Input::From::pass &&
                   std::ranges::find(idle, input.name) != idle.end();
        });
    auto signal = shadertoy_signal(*request.signal);
    if (!signal)
        return fail(signal.error());
    beam.points = signal->points;
    beam.signal = std::move(signal->text);
    const auto passed = shadertoy_passed_values(beam.pass);
    if (!passed)
        return fail(passed.error());
    const int texels = 1 + boxes_of(beam) + beam.points * texels_of(*passed);
    if (texels > request.size.width * request.size.height)
        return fail({{},
                     0,
                     fmt::format("the signal has {} points, which need a larger picture: {} px. "
                                 "Export with a larger --size, or set the signal's points.",
                                 beam.points, texels)});
    made.beam = std::move(beam);
    return made;
}

void put_back(ShadertoyBeam& beam, Look& reduced) {
    for (Pass& pass : reduced.passes)
        if (*pass.fragment.text == no_beam) {
            pass.draw = beam.pass.draw;
            pass.vertex = beam.pass.vertex;
            pass.fragment = beam.pass.fragment;
            beam.pass.name = pass.name;
        }
}

Result<std::vector<ShadertoyPassedValue>> shadertoy_passed_values(const Pass& pass) {
    std::vector<ShadertoyPassedValue> passed;
    for (const InterfaceStatement& input : find_interface_statements(pass.fragment.text)) {
        if (input.kind != InterfaceStatement::Kind::input)
            continue;
        for (const Declarator& name : input.declarators) {
            const bool is_number = input.type == "float" || input.type == "vec2" ||
                                   input.type == "vec3" || input.type == "vec4";
            if (!is_number || !name.size.empty())
                return fail({{},
                             0,
                             fmt::format("the pass '{}' gives {} to its points, which isn't a "
                                         "float or a vector of floats. {}",
                                         pass.name, name.name, other_kinds)});
            passed.push_back({name.name, input.type});
        }
    }
    return passed;
}

std::string shadertoy_table_entry(const ShadertoyBeam& beam,
                                  const std::vector<ShadertoyPassedValue>& passed,
                                  const std::string& settings, const std::string& inputs) {
    const int texels = texels_of(passed);
    std::string values;
    int count = 3;
    for (const ShadertoyPassedValue& value : passed)
        for (int i = 0; i < components_of(value.type); ++i, ++count)
            values += ", " + value.name + (value.type == "float" ? "" : fmt::format("[{}]", i));
    for (; count < 4 * texels; ++count)
        values += ", 0.0";
    return fmt::format(table_text, fmt::arg("texels", texels), fmt::arg("points", beam.points),
                       fmt::arg("inputs", inputs), fmt::arg("in_box", points_in_box),
                       fmt::arg("boxes", boxes_of(beam)), fmt::arg("settings", settings),
                       fmt::arg("count", count), fmt::arg("values", values));
}

std::string shadertoy_beam_sum(const ShadertoyBeam& beam,
                               const std::vector<ShadertoyPassedValue>& passed,
                               const std::string& prefix, const std::string& result, int channel) {
    std::string unpack;
    const int texels = texels_of(passed);
    for (int i = 1; i < texels; ++i)
        unpack += fmt::format("            vec4 texel_{0} = point_texel(first + {0});\n", i);
    int at = 3;
    for (const ShadertoyPassedValue& value : passed) {
        std::string parts;
        for (int i = 0; i < components_of(value.type); ++i, ++at)
            parts += fmt::format("{}texel_{}[{}]", i > 0 ? ", " : "", at / 4, at % 4);
        unpack +=
            fmt::format("            {}{} = {}({});\n", prefix, value.name, value.type, parts);
    }
    return fmt::format(sum_text, fmt::arg("channel", channel), fmt::arg("name", beam.pass.name),
                       fmt::arg("boxes", boxes_of(beam)), fmt::arg("in_box", points_in_box),
                       fmt::arg("points", beam.points), fmt::arg("texels", texels),
                       fmt::arg("unpack", unpack), fmt::arg("prefix", prefix),
                       fmt::arg("result", result));
}
