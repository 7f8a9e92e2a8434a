#include "formats/stack/stacked_look.h"

#include "base/text.h"
#include "formats/stack/conversion_stage.h"
#include "glsl/text/include.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
Format format_after(const Pass& pass) {
    const FormatInfo& info = info_of(pass.format);
    const bool is_fine = info.is_float && info.bytes / info.channels >= 4;
    return is_fine ? Format::rgba32f : Format::rgba16f;
}

// Adds the looks from the first drawn one to the last.
class Stacking {
public:
    Stacking(const std::vector<Look>& looks, const Stack& stack)
        : m_looks(looks), m_stack(stack), m_keys(stack_keys(stack)) {}

    Look stacked(Diagnostics& warnings) {
        const std::size_t first = first_drawn(warnings);
        find_subframes(first);
        add_words();
        for (std::size_t i = 0; i < m_looks.size(); ++i) {
            const bool is_drawn = i >= first && !m_stack[i].is_bypassed;
            if (is_drawn)
                add_passes(i);
            add_parameters(i, is_drawn);
        }
        if (m_look.passes.empty())
            add_nothing();
        return std::move(m_look);
    }

private:
    const Look& driving() const { return m_looks[m_driving]; }

    // Drawing starts at the last look that does not use a picture, or at the first look.
    std::size_t first_drawn(Diagnostics& warnings) {
        std::vector<std::size_t> drawn;
        for (std::size_t i = 0; i < m_looks.size(); ++i)
            if (!m_stack[i].is_bypassed)
                drawn.push_back(i);
        std::size_t first = drawn.empty() ? 0 : drawn.front();
        for (const std::size_t i : drawn)
            if (m_looks[i].driven_by != Driver::picture)
                first = i;
        m_driving = first;
        for (const std::size_t i : drawn)
            if (i < first)
                warnings.push_back({m_looks[first].manifest, 0,
                                    fmt::format("'{}' isn't drawn because the later look '{}' "
                                                "doesn't use a picture",
                                                m_keys[i], m_keys[first]),
                                    Severity::warning});
        return first;
    }

    // The sub-frames are those of the last look that has any. A picture goes through the looks
    // before it once per source frame. The beam of a signal moves in each sub-frame.
    void find_subframes(std::size_t first) {
        for (std::size_t i = first; i < m_looks.size(); ++i) {
            if (m_stack[i].is_bypassed || m_looks[i].subframes == Count(1))
                continue;
            m_look.subframes = scoped(m_looks[i].subframes, name_prefix(m_stack, i));
            m_whole_parts = driving().driven_by == Driver::signal ? 0 : i;
        }
    }

    static Count scoped(Count count, const std::string& scope) {
        if (auto* name = std::get_if<std::string>(&count))
            name->insert(0, scope);
        return count;
    }

    void add_words() {
        std::vector<std::string> names;
        std::vector<std::string> licenses;
        for (const Look& look : m_looks) {
            names.push_back(look.name);
            if (!look.license.empty() &&
                std::ranges::find(licenses, look.license) == licenses.end())
                licenses.push_back(look.license);
            if (m_look.author.find(look.author) == std::string::npos)
                m_look.author += (m_look.author.empty() ? "" : ", ") + look.author;
            m_look.has_orbit = m_look.has_orbit || look.has_orbit;
            for (const auto& file : look.files)
                if (std::ranges::find(m_look.files, file) == m_look.files.end())
                    m_look.files.push_back(file);
        }
        m_look.id = stack_id(m_stack);
        m_look.name = fmt::format("{}", fmt::join(names, " + "));
        m_look.license = fmt::format("{}", fmt::join(licenses, " AND "));
        m_look.manifest = m_looks.front().manifest;
        m_look.stack = m_stack;
        m_look.driven_by = driving().driven_by;
        m_look.has_other_driver = std::ranges::any_of(m_looks, &Look::has_other_driver);
        m_look.default_signal = driving().default_signal;
        m_look.default_source = driving().default_source;
        m_look.source_encoding = driving().source_encoding;
        m_look.source_format = driving().source_format;
        m_look.settle_frames = 1;
    }

    // Each look settles after its source has settled.
    void add_specialization(const Look& look) {
        m_look.settle_frames =
            std::min(m_look.settle_frames + look.settle_frames - 1, max_settle_frames);
    }

    void add_passes(std::size_t part) {
        const Look& look = m_looks[part];
        const std::string scope = name_prefix(m_stack, part);
        m_source.clear();
        if (!m_look.passes.empty()) {
            for (Pass& pass : m_look.passes)  // it writes display values for this look
                std::erase_if(pass.built_ins, [](const BuiltInUniform& uniform) {
                    return uniform.kind == BuiltIn::hdr_mode;
                });
            keep_light(m_look.passes.back());
            m_source = add_conversion(look, scope);
            if (part <= m_whole_parts)
                m_look.passes.back().per_source_frame = true;
        }
        m_first_pass = static_cast<int>(m_look.passes.size());
        for (const Pass& pass : look.passes)
            m_look.passes.push_back(in_scope(pass, scope));
        for (auto i = static_cast<std::size_t>(m_first_pass);
             part < m_whole_parts && i < m_look.passes.size(); ++i)
            m_look.passes[i].per_source_frame = true;
        for (Image image : look.images) {
            image.name = scope + image.name;
            image.encoding = look.source_encoding;
            m_look.images.push_back(std::move(image));
        }
        m_look.passes.back().output = m_look.output = look.output;
        m_look.is_scrgb_in_hdr = look.is_scrgb_in_hdr;
        add_specialization(look);
    }

    // 8 bits are only for the screen. For another look, keeps light above 1 and fine steps.
    static void keep_light(Pass& last) {
        if (last.format == Format::rgba8)
            last.format = Format::rgba16f;
    }

    // Adds the pass that is the source of the next look.
    std::string add_conversion(const Look& look, const std::string& scope) {
        const Pass& before = m_look.passes.back();
        // A repeated pass that reads itself advances its ring of targets within a frame. "source@1"
        // then needs a copy.
        const bool is_once = before.repeat == std::variant<int, std::string>(1);
        if (m_look.output == look.source_encoding && is_once)
            return before.name;
        Pass pass;
        pass.name = scope + "source";
        pass.vertex = fullscreen_vertex_stage();
        pass.fragment = conversion_stage(m_look.output, look.source_encoding);
        pass.format = format_after(before);
        pass.size = before.size;
        pass.scope = before.scope;
        pass.source = before.source;
        pass.output = look.source_encoding;
        pass.inputs = {{"image", Input::From::pass, before.name, 0, {Filter::nearest}}};
        pass.declared = look.passes.front().declared;
        m_look.passes.push_back(pass);
        return pass.name;
    }

    Pass in_scope(Pass pass, const std::string& scope) const {
        pass.name = scope + pass.name;
        pass.scope = scope;
        pass.source = m_source;
        for (Input& input : pass.inputs) {
            if (input.from == Input::From::sound || input.from == Input::From::keyboard)
                continue;
            if (input.from != Input::From::source) {
                input.name = scope + input.name;
            } else if (!m_source.empty()) {
                input.from = Input::From::pass;
                input.name = m_source;
            }
        }
        for (auto& [uniform, parameter] : pass.rename)
            parameter.insert(0, scope);
        if (pass.onto)
            pass.onto->pass.insert(0, scope);
        pass.repeat = scoped(pass.repeat, scope);
        if (pass.converge)
            pass.converge = scoped(*pass.converge, scope);
        return pass;
    }

    void add_parameters(std::size_t part, bool is_drawn) {
        const Look& look = m_looks[part];
        const std::string scope = name_prefix(m_stack, part);
        for (Parameter parameter : look.parameters) {
            parameter.group = group_of(part, parameter);
            parameter.name = scope + parameter.name;
            if (!parameter.was.empty())
                parameter.was = scope + parameter.was;
            for (Binding& binding : parameter.bindings) {
                binding.pass += m_first_pass;
                if (is_drawn && !parameter.is_constant)
                    m_look.passes[static_cast<std::size_t>(binding.pass)].rename[binding.uniform] =
                        parameter.name;
            }
            if (!is_drawn)
                parameter.bindings.clear();
            m_look.parameters.push_back(std::move(parameter));
        }
        for (const std::string& name : look.other_parameters)
            m_look.other_parameters.push_back(scope + name);
        for (const auto& [name, value] : look.constants)
            m_look.constants[scope + name] = value;
    }

    std::string group_of(std::size_t part, const Parameter& parameter) const {
        std::string group = heading_of(m_looks[part], parameter);
        if (m_stack.size() < 2)
            return group;
        const std::size_t copy = m_keys[part].find('#');
        const std::string name =
            m_looks[part].name +
            (copy == std::string::npos ? "" : ' ' + m_keys[part].substr(copy + 1));
        return group.empty() ? name : name + ": " + group;
    }

    // All parts are bypassed: shows the source, or black.
    void add_nothing() {
        Pass pass;
        pass.name = "bypass";
        pass.vertex = fullscreen_vertex_stage();
        pass.fragment = builtin_stage(
            "#version 410 core\n"
            "// Every look of the stack is bypassed: shows the source. Display-encoded.\n"
            "uniform sampler2D image;\n"
            "in vec2 uv;\n"
            "out vec4 color;\n"
            "void main() { color = vec4(texture(image, uv).rgb, 1.0); }\n");
        pass.format = Format::rgba8;
        pass.inputs = {{"image", Input::From::source, "", 0, {}}};
        pass.declared = {m_look.manifest, 0};
        m_look.passes.push_back(std::move(pass));
        m_look.source_encoding = m_look.output = Encoding::display;
    }

    const std::vector<Look>& m_looks;
    const Stack& m_stack;
    std::vector<std::string> m_keys;
    std::size_t m_driving = 0;
    std::size_t m_whole_parts = 0;  // the first looks, which are drawn once per source frame
    Look m_look;
    std::string m_source;  // of the current look; "": the original source
    int m_first_pass = 0;  // of the current look
};
}  // namespace

Look stacked_look(const std::vector<Look>& looks, const Stack& stack, Diagnostics& warnings) {
    return Stacking(looks, stack).stacked(warnings);
}
