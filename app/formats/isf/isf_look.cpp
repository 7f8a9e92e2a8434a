#include "formats/isf/isf_look.h"

#include "base/text.h"
#include "formats/isf/body.h"
#include "formats/isf/controls.h"
#include "glsl/cache/check_cache.h"
#include "glsl/parameters/constant_parameters.h"
#include "model/plan/expression.h"
#include "model/plan/parameter_use.h"
#include "model/plan/plan.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
using InputType = IsfInput::Type;

constexpr const char* usual_source = "pattern:harbour";
constexpr const char* usual_picture = "pattern:harbour";
constexpr const char* other_picture = "pattern:smpte";  // distinguishes a second picture from the
                                                        // first
constexpr const char* usual_cube = "solid:sky";
constexpr const char* usual_sound = "waveform:mode=xy,ch1=saw,f1=12,ch2=sine,f2=5";
constexpr int wave_samples = 512;
constexpr int spectrum_bins = 256;
constexpr int max_sound_columns = 8192;
constexpr Extent usual_extent{1280, 720};  // for checking expressions
constexpr int frames_until_seen = 60;      // for animations, which often start black

bool is_sound(const IsfInput& input) {
    return input.type == InputType::audio || input.type == InputType::audio_fft;
}

bool is_picture(const IsfInput& input) {
    return input.type == InputType::image;
}

bool is_cube(const IsfInput& input) {
    return input.type == InputType::cube;
}

SoundTexture sound_texture_of(const IsfInput& input) {
    const bool is_wave = input.type == InputType::audio;
    const double usual = is_wave ? wave_samples : spectrum_bins;
    const double columns = input.high.empty() ? usual : input.high.front();
    return {is_wave ? SoundTexture::Holds::wave : SoundTexture::Holds::spectrum,
            static_cast<int>(std::clamp(columns, 1.0, 1.0 * max_sound_columns))};
}

// Sizes are whole texels, at least 1. A value that is not finite becomes 1, as in ISF's hosts.
Side side_of(const std::string& expression) {
    if (expression.empty())
        return {};
    return {Side::By::expression, 1.0, fmt::format("max(1, floor(finite({})))", expression)};
}

bool is_whole(const std::string& expression, std::string_view side) {
    return expression.empty() || trim(expression) == side;
}

std::vector<BuiltInUniform> isf_built_ins() {
    return {{"RENDERSIZE", BuiltIn::target_size},
            {"TIME", BuiltIn::time_before},
            {"TIMEDELTA", BuiltIn::delta_before},
            {"FRAMEINDEX", BuiltIn::frame_index},
            {"DATE", BuiltIn::date}};
}

bool tells_time_in_isf(const std::string& uniform) {
    const std::vector<BuiltInUniform> all = isf_built_ins();
    const auto found = std::ranges::find(all, uniform, &BuiltInUniform::name);
    return found != all.end() && tells_time(found->kind);
}

class LookMaker {
public:
    LookMaker(const IsfSource& source, const IsfHeader& header, const LoadOptions& help,
              std::vector<fs::path>& files, Diagnostics& warnings)
        : m_source(source),
          m_header(header),
          m_cache(help.cache),
          m_constants(help.values, help.cache),
          m_files(files),
          m_warnings(warnings),
          m_listens(std::ranges::any_of(header.inputs, is_sound)) {}

    Result<Look> make() {
        choose_driver();
        name_passes();
        add_images();
        for (const IsfInput& input : m_header.inputs)
            if (!is_sound(input) && input.name != m_source_input)
                add_parameter(input);
        // The passes share one text, so the errors of the first occur in all.
        const std::size_t before = m_problems.size();
        for (std::size_t i = 0; i < m_header.passes.size() && m_problems.size() == before; ++i)
            make_pass(i);
        if (m_problems.empty() && is_stretched())
            add_stretch();
        if (m_problems.empty())
            finish();
        if (!m_problems.empty())
            return fail(std::move(m_problems));
        return std::move(m_look);
    }

private:
    void problem(const Location& at, std::string message) {
        m_problems.push_back({at.file, at.line, std::move(message)});
    }

    void choose_driver() {
        const IsfHeader::Kind kind = m_header.kind();
        if (m_listens) {
            m_look.driven_by = Driver::signal;
            m_look.default_signal = parse_spec(usual_sound).value();
        } else if (kind != IsfHeader::Kind::generator) {
            m_look.driven_by = Driver::picture;
            m_look.default_source = usual_source;
            m_source_input = kind == IsfHeader::Kind::filter ? "inputImage" : "startImage";
        }
    }

    void add_parameter(const IsfInput& input) {
        Parameter made = isf_control(input);
        const bool is_first = input.name == "inputImage" || input.name == "startImage";
        if (is_picture(input))
            made.initial = Value::of_path(is_first ? usual_picture : other_picture);
        if (is_cube(input)) {
            made.initial = Value::of_path(usual_cube);
            Image faces;
            faces.name = input.name;
            faces.rows = RowOrder::top_first;
            faces.shape = PictureShape::cube;
            m_look.images.push_back(std::move(faces));
        }
        m_look.parameters.push_back(std::move(made));
    }

    std::string unique_name(const std::string& wanted) const {
        std::string name = wanted;
        for (int copy = 2; std::ranges::find(m_names, name) != m_names.end(); ++copy)
            name = fmt::format("{}-{}", wanted, copy);
        return name;
    }

    void name_passes() {
        for (std::size_t i = 0; i < m_header.passes.size(); ++i) {
            const std::string& target = m_header.passes[i].target;
            const bool is_picture = i + 1 == m_header.passes.size() && !is_stretched();
            m_names.push_back(unique_name(!target.empty() ? target
                                          : is_picture    ? "picture"
                                                          : fmt::format("pass-{}", i + 1)));
        }
    }

    // Whether the last pass has its own size and is stretched to the picture.
    bool is_stretched() const {
        const IsfPass& last = m_header.passes.back();
        return !is_whole(last.width, "$WIDTH") || !is_whole(last.height, "$HEIGHT");
    }

    void add_stretch() {
        Pass pass;
        pass.name = unique_name("picture");
        pass.vertex = isf_vertex_stage({}, m_header, 0);
        pass.fragment = isf_stretching_stage();
        pass.format = m_look.passes.back().format;
        pass.inputs = {{"image", Input::From::pass, m_look.passes.back().name, 0, {}}};
        pass.output = Encoding::display;
        pass.has_alpha = true;
        pass.declared = m_look.passes.back().declared;
        pass.built_ins.clear();
        m_look.passes.push_back(std::move(pass));
    }

    void add_images() {
        const fs::path folder = m_source.file.parent_path();
        for (const IsfImport& import : m_header.imports) {
            if (import.is_cube) {
                add_cube(import, folder);
                continue;
            }
            const fs::path file = folder / import.path;
            m_files.push_back(file);
            std::error_code error;
            if (!fs::is_regular_file(file, error)) {
                m_warnings.push_back({import.declared.file, import.declared.line,
                                      fmt::format("can't find the picture '{}'; '{}' is black",
                                                  import.path, import.name),
                                      Severity::warning});
                continue;
            }
            Image image{import.name, file, {}};
            image.is_linear = true;
            image.is_needed = false;
            m_look.images.push_back(std::move(image));
        }
    }

    // A file that cannot be read is reported when the pictures are loaded, and is black.
    void add_cube(const IsfImport& import, const fs::path& folder) {
        Image image{import.name, folder / import.path, {}};
        for (const std::string& face : import.faces)
            image.faces.push_back(folder / face);
        m_files.push_back(image.file);
        m_files.insert(m_files.end(), image.faces.begin(), image.faces.end());
        image.is_linear = true;
        image.is_needed = false;
        image.rows = RowOrder::top_first;
        image.shape = PictureShape::cube;
        m_look.images.push_back(std::move(image));
    }

    void make_pass(std::size_t index) {
        const IsfPass& declared = m_header.passes[index];
        Pass pass;
        pass.name = m_names[index];
        pass.fragment = isf_fragment_stage(m_source, m_header, index);
        pass.vertex = isf_vertex_stage(m_source, m_header, index);
        m_constants.write_into(pass, index);
        pass.draw = m_source.vertex_file.empty() ? Draw::fullscreen : Draw::quad;
        pass.format = declared.is_float ? Format::rgba32f : Format::rgba8;
        pass.size = {side_of(declared.width), side_of(declared.height)};
        pass.built_ins = isf_built_ins();
        pass.declared = declared.declared;
        pass.output = Encoding::display;
        pass.has_alpha = true;
        pass.keeps_when_resized = declared.is_persistent;
        const auto checked = m_cache ? m_cache->check(pass.vertex, pass.fragment)
                                     : check_program(pass.vertex, pass.fragment);
        if (!checked) {
            add_new(m_problems, checked.error());
            return;
        }
        add_new(m_warnings, checked->warnings);
        for (const std::string& name : checked->live)
            bind(name, index, pass);
        m_moves = m_moves || std::ranges::any_of(checked->live, tells_time_in_isf);
        warn_of_others(*checked);
        m_look.passes.push_back(std::move(pass));
    }

    // Binds a live uniform of a pass to its parameter or input.
    void bind(const std::string& uniform, std::size_t index, Pass& pass) {
        const std::string name(isf_author_word(uniform));
        const auto parameter = std::ranges::find(m_look.parameters, name, &Parameter::name);
        if (parameter != m_look.parameters.end()) {
            parameter->bindings.push_back({static_cast<int>(index), uniform});
        } else if (auto input = input_of(name, index)) {
            input->uniform = uniform;
            pass.inputs.push_back(std::move(*input));
        }
    }

    std::optional<Input> input_of(const std::string& name, std::size_t reader) const {
        if (name == m_source_input)
            return Input{{}, Input::From::source, {}, 0, {}};
        if (const IsfInput* input = m_header.find_input(name); input && is_sound(*input))
            return Input{{}, Input::From::sound, {}, 0, {}, sound_texture_of(*input)};
        if (std::ranges::find(m_look.images, name, &Image::name) != m_look.images.end())
            return Input{{}, Input::From::image, name, 0, {}};
        return target_input(name, reader);
    }

    // The last pass drawn into a target before `reader`, in this frame or the previous one.
    std::optional<Input> target_input(const std::string& target, std::size_t reader) const {
        std::optional<std::size_t> drawn;
        std::optional<std::size_t> drawn_before;
        for (std::size_t i = 0; i < m_header.passes.size(); ++i) {
            if (m_header.passes[i].target != target)
                continue;
            if (i < reader)
                drawn = i;
            if (m_header.passes[i].is_persistent)
                drawn_before = i;
        }
        if (drawn)
            return Input{{}, Input::From::pass, m_names[*drawn], 0, {}};
        if (drawn_before)
            return Input{{}, Input::From::pass, m_names[*drawn_before], 1, {}};
        return std::nullopt;  // not drawn yet: transparent black
    }

    // Warns of the author's own uniforms, which are never set.
    void warn_of_others(const Reflection& reflection) {
        for (const Uniform& uniform : reflection.uniforms) {
            const Location& at = uniform.declared.front();
            if (!at.file.empty())
                add_new(m_warnings,
                        {at.file, at.line,
                         fmt::format("'{}' isn't an input in the header; it stays 0", uniform.name),
                         Severity::warning});
        }
    }

    void finish() {
        const bool has_past =
            std::ranges::any_of(m_header.passes, [](const IsfPass& p) { return p.is_persistent; });
        m_look.settle_frames = has_past || m_moves ? frames_until_seen : 1;
        m_look.about = m_header.about;
        m_look.author = m_header.credit;
        m_look.source_encoding = Encoding::display;
        m_look.output = Encoding::display;
        for (Parameter& parameter : m_look.parameters) {
            parameter.is_hidden = true;
            for (std::size_t i = 0; i < m_look.passes.size(); ++i)
                parameter.is_hidden = parameter.is_hidden && !is_used_by(m_look, i, parameter);
        }
        add_new(m_problems, m_constants.add_to(m_look));
        if (const auto plan = plan_targets(m_look, usual_extent, usual_extent, {}); !plan)
            add_new(m_problems, plan.error());
        else
            warn_of_infinite_sizes();
    }

    void warn_of_infinite_sizes() {
        std::map<std::string, double> names{{"WIDTH", usual_extent.width},
                                            {"HEIGHT", usual_extent.height}};
        for (const Parameter& parameter : m_look.parameters)
            names[parameter.name] = parameter.initial.number();
        for (std::size_t i = 0; i < m_header.passes.size(); ++i) {
            const IsfPass& pass = m_header.passes[i];
            for (const std::string& side : {pass.width, pass.height})
                if (!side.empty() && !evaluate(side, names))
                    add_new(m_warnings,
                            {pass.declared.file, pass.declared.line,
                             fmt::format("size of pass '{}': '{}' isn't a finite number; 1 is used",
                                         m_names[i], side),
                             Severity::warning});
        }
    }

    const IsfSource& m_source;
    const IsfHeader& m_header;
    CheckCache* m_cache;
    ConstantParameters m_constants;
    std::vector<fs::path>& m_files;
    Diagnostics& m_warnings;
    bool m_listens;
    bool m_moves = m_listens;
    std::string m_source_input;  // "": no input reads the source
    std::vector<std::string> m_names;
    Look m_look;
    Diagnostics m_problems;
};
}  // namespace

Result<Look> look_of_isf(const IsfSource& source, const IsfHeader& header, const LoadOptions& help,
                         std::vector<fs::path>& files, Diagnostics& warnings) {
    return LookMaker(source, header, help, files, warnings).make();
}
