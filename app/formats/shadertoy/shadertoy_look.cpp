#include "formats/shadertoy/shadertoy_look.h"

#include "formats/shadertoy/shadertoy_assets.h"
#include "formats/shadertoy/shadertoy_stage.h"
#include "glsl/text/include.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace fs = std::filesystem;

namespace {
using Kind = ShadertoyPass::Kind;

constexpr double sample_rate = 44100.0;  // Hz; the site's default
constexpr int frames_of_a_past = 60;
constexpr int frames_of_a_picture = 120;  // two seconds: many shaders start black
constexpr const char* moving_picture = "pattern:harbour";
constexpr const char* usual_sound = "waveform:mode=xy,ch1=saw,f1=12,ch2=sine,f2=5";
constexpr double cube_side = 1024.0;  // px
constexpr const char* group_of_pictures = "Pictures";

/// Converts a shader to a look, one pass at a time.
class ShadertoyLook {
public:
    ShadertoyLook(const Shadertoy& shadertoy, const fs::path& folder, Diagnostics& warnings)
        : m_shadertoy(shadertoy), m_folder(folder), m_warnings(warnings) {}

    Result<Look> make();

private:
    std::optional<std::size_t> find_drawn(int index) const;
    void order_passes();
    void make_pass(const ShadertoyPass& shadertoy_pass);
    ShadertoyChannel feed(const ShadertoyPass& shadertoy_pass, const GlslWords& words, int channel,
                          Pass& pass);
    std::optional<Input> input_of(const ShadertoyPass& shadertoy_pass, const ShadertoyInput& wired);
    std::optional<Input> buffer_of(const ShadertoyPass& shadertoy_pass,
                                   const ShadertoyInput& wired);
    Input texture_of(const ShadertoyInput& wired);
    std::string add_picture(const ShadertoyInput& wired);
    Input sound_of(const ShadertoyInput& wired);
    Input source_of(const ShadertoyInput& wired);
    std::string free_name(const std::string& wanted) const;
    void warn(const Location& at, std::string message);
    void choose_driver();
    void finish();

    const Shadertoy& m_shadertoy;
    const fs::path& m_folder;
    Diagnostics& m_warnings;
    const ShadertoyPass* m_common = nullptr;
    std::vector<const ShadertoyPass*> m_drawn;      // in drawing order
    std::map<std::string, std::string> m_pictures;  // parameter by asset and row order
    bool m_hears = false;
    bool m_sees = false;
    Look m_look;
};

PictureShape shape_of(const ShadertoyInput& wired) {
    return wired.kind == ShadertoyKind::cubemap  ? PictureShape::cube
           : wired.kind == ShadertoyKind::volume ? PictureShape::volume
                                                 : PictureShape::flat;
}

void ShadertoyLook::warn(const Location& at, std::string message) {
    m_warnings.push_back({at.file, at.line, std::move(message), Severity::warning});
}

void ShadertoyLook::order_passes() {
    for (const ShadertoyPass& pass : m_shadertoy.passes) {
        if (pass.kind == Kind::common)
            m_common = &pass;
        else if (pass.kind == Kind::sound)
            warn({pass.code.file, 1}, "Sound passes aren't supported; this pass is ignored");
        else
            m_drawn.push_back(&pass);
    }
    std::ranges::stable_sort(m_drawn, {}, [](const ShadertoyPass* pass) {
        return std::pair(pass->kind == Kind::image, pass->index);
    });
}

std::optional<std::size_t> ShadertoyLook::find_drawn(int index) const {
    for (std::size_t i = 0; i < m_drawn.size(); ++i)
        if (m_drawn[i]->kind != Kind::image && m_drawn[i]->index == index)
            return i;
    return std::nullopt;
}

std::string ShadertoyLook::free_name(const std::string& wanted) const {
    std::string name = wanted;
    for (int copy = 2; find_parameter(m_look, name) ||
                       std::ranges::find(m_look.images, name, &Image::name) != m_look.images.end();
         ++copy)
        name = fmt::format("{}_{}", wanted, copy);
    return name;
}

namespace {
// Replacements for the site's pictures.
ShadertoyAsset asset_of(const ShadertoyInput& wired) {
    if (wired.kind == ShadertoyKind::cubemap)
        return {"sky", "Sky", "solid:sky"};
    ShadertoyAsset asset = shadertoy_asset(wired.asset);
    if (wired.kind == ShadertoyKind::volume && !asset.made.starts_with("solid:"))
        return {"noise_volume", "RGBA noise volume", "solid:noise-volume"};
    return asset;
}
}  // namespace

// One per picture and row order; shared by channels and passes.
std::string ShadertoyLook::add_picture(const ShadertoyInput& wired) {
    const PictureShape shape = shape_of(wired);
    const bool is_turned = wired.is_flipped && shape == PictureShape::flat;
    const std::string key =
        fmt::format("{} {} {}", wired.asset, is_turned, static_cast<int>(shape));
    if (const auto known = m_pictures.find(key); known != m_pictures.end())
        return known->second;
    const ShadertoyAsset asset = asset_of(wired);
    Parameter parameter;
    parameter.name = free_name(asset.name);
    parameter.label = asset.label;
    parameter.group = group_of_pictures;
    parameter.control = Control::image;
    parameter.declared = wired.declared;
    const fs::path asset_file(wired.asset);
    const fs::path sibling =
        (m_folder / (wired.is_file ? asset_file : asset_file.filename())).lexically_normal();
    std::error_code error;
    const bool is_there = !wired.asset.empty() && fs::is_regular_file(sibling, error);
    if (wired.is_file && !is_there)
        warn(wired.declared,
             fmt::format("can't find the picture '{}'; a built-in picture replaces it",
                         wired.asset));
    parameter.initial = Value::of_path(is_there ? sibling.string() : asset.made);
    if (!is_turned) {
        Image rows;
        rows.name = parameter.name;
        rows.rows = RowOrder::top_first;
        rows.shape = shape;
        m_look.images.push_back(std::move(rows));
    }
    m_pictures.emplace(key, parameter.name);
    m_look.parameters.push_back(parameter);
    return parameter.name;
}

Input ShadertoyLook::texture_of(const ShadertoyInput& wired) {
    return {{}, Input::From::image, add_picture(wired), 0, wired.sampler};
}

std::optional<Input> ShadertoyLook::buffer_of(const ShadertoyPass& shadertoy_pass,
                                              const ShadertoyInput& wired) {
    const auto read = find_drawn(wired.buffer);
    if (!read) {
        const Kind kind = wired.buffer == shadertoy_cube_index ? Kind::cube : Kind::buffer;
        warn(wired.declared,
             wired.buffer < 0
                 ? fmt::format("iChannel{} of '{}' reads a missing buffer; it is black",
                               wired.channel, shadertoy_pass.name)
                 : fmt::format("iChannel{} of '{}' reads {}, which is missing; it is black",
                               wired.channel, shadertoy_pass.name,
                               shadertoy_pass_name(kind, wired.buffer)));
        return std::nullopt;
    }
    const auto reader = std::ranges::find(m_drawn, &shadertoy_pass) - m_drawn.begin();
    const bool is_of_last_frame = static_cast<std::ptrdiff_t>(*read) >= reader;
    return Input{
        {}, Input::From::pass, m_drawn[*read]->name, is_of_last_frame ? 1 : 0, wired.sampler};
}

// The user's sound. The author's choice of music is unknown.
Input ShadertoyLook::sound_of(const ShadertoyInput& wired) {
    m_hears = true;
    Input input{{}, Input::From::sound, {}, 0, wired.sampler};
    input.sound = {SoundTexture::Holds::analyser, 512};
    return input;
}

// The user's picture. All inputs have the same row order.
Input ShadertoyLook::source_of(const ShadertoyInput& wired) {
    const RowOrder rows = wired.is_flipped ? RowOrder::bottom_first : RowOrder::top_first;
    if (m_sees && rows != m_look.source_rows)
        warn(wired.declared,
             "the video is used with and without vflip; the first setting is used for both");
    else
        m_look.source_rows = rows;
    m_sees = true;
    return {{}, Input::From::source, {}, 0, wired.sampler};
}

std::optional<Input> ShadertoyLook::input_of(const ShadertoyPass& shadertoy_pass,
                                             const ShadertoyInput& wired) {
    switch (wired.kind) {
        case ShadertoyKind::buffer:
            return buffer_of(shadertoy_pass, wired);
        case ShadertoyKind::texture:
        case ShadertoyKind::volume:
            return texture_of(wired);
        case ShadertoyKind::cubemap:
            return find_drawn(wired.buffer) ? buffer_of(shadertoy_pass, wired) : texture_of(wired);
        case ShadertoyKind::keyboard:
            return Input{{}, Input::From::keyboard, "keyboard", 0, {Filter::nearest}};
        case ShadertoyKind::video:
        case ShadertoyKind::webcam:
            return source_of(wired);
        case ShadertoyKind::music:
        case ShadertoyKind::music_stream:
        case ShadertoyKind::microphone:
            return sound_of(wired);
        case ShadertoyKind::nothing:
            break;
    }
    return std::nullopt;
}

ShadertoyChannel ShadertoyLook::feed(const ShadertoyPass& shadertoy_pass, const GlslWords& words,
                                     int channel, Pass& pass) {
    ShadertoyChannel fed;
    auto wired = std::ranges::find(shadertoy_pass.inputs, channel, &ShadertoyInput::channel);
    ShadertoyInput guessed;
    if (wired == shadertoy_pass.inputs.end() && shadertoy_pass.has_explicit_inputs)
        return fed;
    if (wired == shadertoy_pass.inputs.end()) {
        const bool is_buffer = find_drawn(channel).has_value();
        guessed = {channel, is_buffer ? ShadertoyKind::buffer : ShadertoyKind::texture,
                   channel, {},
                   {},      true,
                   false,   {shadertoy_pass.code.file, 1}};
        guessed.sampler.wrap = is_buffer ? Wrap::edge : Wrap::repeat;
        guessed.sampler.mipmap = !is_buffer;
    }
    const ShadertoyInput& input = wired == shadertoy_pass.inputs.end() ? guessed : *wired;
    fed.shape = shape_of(input);
    const std::string uniform = fmt::format("iChannel{}", channel);
    if (!words.contains(uniform) && !words.contains("iChannelResolution") &&
        !words.contains(fmt::format("iCh{}", channel)))
        return fed;
    auto made = input_of(shadertoy_pass, input);
    fed.is_connected = made.has_value();
    if (!made)
        return fed;
    made->uniform = uniform;
    pass.inputs.push_back(std::move(*made));
    return fed;
}

// Draws the six faces side by side into one target. Inputs of type cube read it as a cubemap.
void make_faces(Pass& pass) {
    constexpr double faces = 6.0;
    pass.format = Format::rgba16f;
    pass.size = {Side{Side::By::pixels, faces * cube_side, {}},
                 Side{Side::By::pixels, cube_side, {}}};
    pass.set["iResolution"] = Value(std::vector<double>{cube_side, cube_side, 1.0});
    std::erase_if(pass.built_ins,
                  [](const BuiltInUniform& built_in) { return built_in.name == "iResolution"; });
}

void ShadertoyLook::make_pass(const ShadertoyPass& shadertoy_pass) {
    Pass pass;
    pass.name = shadertoy_pass.name;
    pass.declared = {shadertoy_pass.code.file, 1};
    pass.output = Encoding::display;
    pass.format = shadertoy_pass.kind == Kind::image ? Format::rgba8 : Format::rgba32f;
    const GlslWords words = shadertoy_words(shadertoy_pass, m_common);
    ShadertoyChannels channels;
    for (int channel = 0; channel < shadertoy_channels; ++channel)
        channels[static_cast<std::size_t>(channel)] = feed(shadertoy_pass, words, channel, pass);
    pass.vertex = fullscreen_vertex_stage();
    pass.fragment = shadertoy_fragment_stage(shadertoy_pass, m_common, channels);
    pass.built_ins = shadertoy_built_ins(pass.inputs, pass.fragment);
    if (shadertoy_pass.kind == Kind::cube)
        make_faces(pass);
    if (words.contains("iSampleRate"))
        pass.set["iSampleRate"] = Value(sample_rate);
    m_look.passes.push_back(std::move(pass));
}

// A look has a single driver.
void ShadertoyLook::choose_driver() {
    if (m_hears) {
        m_look.driven_by = Driver::signal;
        m_look.default_signal = parse_spec(usual_sound).value();
    } else if (m_sees) {
        m_look.driven_by = Driver::picture;
        m_look.default_source = moving_picture;
    }
    if (m_hears && m_sees)
        warn({m_drawn.back()->code.file, 1},
             "a look can't use both sound and video; the video is black");
}

// Binds picture parameters to the inputs that read them.
void ShadertoyLook::finish() {
    for (Parameter& parameter : m_look.parameters)
        for (std::size_t pass = 0; pass < m_look.passes.size(); ++pass)
            for (const Input& input : m_look.passes[pass].inputs)
                if (input.from == Input::From::image && input.name == parameter.name)
                    parameter.bindings.push_back({static_cast<int>(pass), input.uniform});
    const bool has_past = std::ranges::any_of(m_look.passes, [](const Pass& pass) {
        return std::ranges::any_of(pass.inputs,
                                   [](const Input& input) { return input.frames_ago > 0; });
    });
    m_look.settle_frames = has_past ? frames_of_a_past : frames_of_a_picture;
    choose_driver();
    m_look.name = m_shadertoy.name;
    m_look.author = m_shadertoy.author;
    m_look.about = m_shadertoy.about;
    m_look.source_encoding = Encoding::display;
    m_look.output = Encoding::display;
}

Result<Look> ShadertoyLook::make() {
    order_passes();
    if (m_drawn.empty() || m_drawn.back()->kind != Kind::image) {
        const fs::path file =
            m_shadertoy.passes.empty() ? m_folder : m_shadertoy.passes.front().code.file;
        return fail({file, 0, "the shader has no Image pass"});
    }
    for (const ShadertoyPass* pass : m_drawn)
        make_pass(*pass);
    finish();
    return std::move(m_look);
}
}  // namespace

Result<Look> look_of_shadertoy(const Shadertoy& shadertoy, const fs::path& folder,
                               Diagnostics& warnings) {
    return ShadertoyLook(shadertoy, folder, warnings).make();
}
