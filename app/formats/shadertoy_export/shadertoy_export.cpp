#include "formats/shadertoy_export/shadertoy_export.h"

#include "formats/effect/effect_files.h"
#include "formats/shadertoy_export/shadertoy_code.h"
#include "formats/shadertoy_export/shadertoy_document.h"
#include "formats/shadertoy_export/shadertoy_words.h"
#include "glsl/compile/built_in_names.h"
#include "glsl/es/es_check.h"
#include "glsl/text/interface_statements.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
// What the site puts around a pass.
constexpr const char* site_start =
    "#version 300 es\n"
    "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
    "uniform vec3 iResolution;\nuniform float iTime;\nuniform float iTimeDelta;\n"
    "uniform float iFrameRate;\nuniform int iFrame;\nuniform float iChannelTime[4];\n"
    "uniform vec3 iChannelResolution[4];\nuniform vec4 iMouse;\nuniform vec4 iDate;\n"
    "uniform float iSampleRate;\n"
    "uniform sampler2D iChannel0;\nuniform sampler2D iChannel1;\n"
    "uniform sampler2D iChannel2;\nuniform sampler2D iChannel3;\n"
    "out vec4 shadertoy_output;\n";
constexpr const char* site_end =
    "\nvoid main() {\n    vec4 color = vec4(1e20);\n    mainImage(color, gl_FragCoord.xy);\n"
    "    shadertoy_output = color;\n}\n";

/// Writes the file of one look.
class ShadertoyWriter {
public:
    // `values`: of the reduced look.
    ShadertoyWriter(const EffectRequest& request, Effect effect, const Values& values,
                    std::optional<ShadertoyBeam> beam)
        : m_request(request),
          m_values(values),
          m_beam(std::move(beam)),
          m_effect(std::move(effect)),
          m_plan(shadertoy_plan(m_effect, m_beam ? m_beam->pass.name : "")) {
        m_output.losses = m_effect.losses;
        if (m_beam)
            m_output.losses.insert(m_output.losses.end(), m_beam->losses.begin(),
                                   m_beam->losses.end());
    }

    Result<EffectOutput> write() {
        if (std::string obstacle = shadertoy_obstacle(m_plan, m_request.size, m_request.source);
            !obstacle.empty())
            return fail({{}, 0, std::move(obstacle)});
        if (auto found = find_uniforms(); !found)
            return fail(found.error());
        if (auto added = add_constants(); !added)
            return fail(added.error());
        if (auto written = add_passes(); !written)
            return fail(written.error());
        m_document.passes.front().code = notice_comment(m_request.look, m_request.notices) + "\n" +
                                         m_document.passes.front().code;
        if (auto good = check(); !good)
            return fail(good.error());
        add_losses();
        const Look& look = m_request.look;
        m_document.name = look.name;
        m_document.author = look.author;
        m_document.about = look.about;
        m_document.is_upright = look.source_rows == RowOrder::bottom_first;
        m_output.texts[m_request.name + ".json"] = shadertoy_json(m_document);
        return std::move(m_output);
    }

private:
    const Look& look() const { return m_effect.look; }

    Result<void> find_uniforms() {
        for (std::size_t i = 0; i < look().passes.size(); ++i) {
            m_uniforms.emplace_back();
            if (look().passes[i].name == m_plan.source_pass)
                continue;
            auto uniforms = effect_uniforms(look(), i, m_values, m_effect.fixed);
            if (!uniforms)
                return fail(uniforms.error());
            m_uniforms.back() = std::move(*uniforms);
        }
        return {};
    }

    // How many passes read each parameter, by its name. A pass that is drawn in others counts
    // twice.
    std::map<std::string, int> readers() const {
        std::map<std::string, int> count;
        for (std::size_t i = 0; i < m_uniforms.size(); ++i) {
            const EffectUniforms& uniforms = m_uniforms[i];
            std::set<std::string> names;
            const auto note = [&](const EffectNumber& number) {
                if (const auto* parameter = std::get_if<const Parameter*>(&number.setter))
                    names.insert((*parameter)->name);
            };
            std::ranges::for_each(uniforms.numbers, note);
            for (const EffectStruct& of : uniforms.structs)
                std::ranges::for_each(of.members, note);
            for (const std::string& name : names)
                count[name] += m_plan.inlined.contains(look().passes[i].name) ? 2 : 1;
        }
        return count;
    }

    // A parameter that only other passes read.
    bool is_unread(const Pass& pass, const EffectNumber& number) const {
        return !std::holds_alternative<BuiltInUniform>(number.setter) &&
               !pass.set.contains(number.name) && find_parameter(look(), number.name);
    }

    // Names that no constant may have. Uniforms are not among them.
    Result<std::set<std::string, std::less<>>> taken_names() const {
        auto taken = shadertoy_reserved_names();
        const BuiltInNames& of_glsl = find_built_in_names({.version = 450, .is_vulkan = true});
        taken.insert(of_glsl.functions.begin(), of_glsl.functions.end());
        for (std::size_t i = 0; i < look().passes.size(); ++i) {
            const Pass& pass = look().passes[i];
            if (pass.name == m_plan.source_pass)
                continue;
            auto files = effect_files(m_request.look, pass);
            if (!files)
                return fail(files.error());
            std::set<std::string> uniforms;
            for (const EffectNumber& number : m_uniforms[i].numbers)
                if (std::holds_alternative<const Parameter*>(number.setter) ||
                    is_unread(pass, number))
                    uniforms.insert(number.name);
            for (const std::string& name : global_names(joined_text(*files)))
                if (!uniforms.contains(name))
                    taken.insert(name);
        }
        return taken;
    }

    // Constants of several passes are in Common.
    Result<void> add_constants() {
        auto taken = taken_names();
        if (!taken)
            return fail(taken.error());
        EffectNames names(std::move(*taken));
        const std::map<std::string, int> count = readers();
        std::string common;
        for (ShadertoyConstant& constant : shadertoy_constants(
                 look(), effect_controls(look(), m_values, m_effect.fixed, names), names)) {
            const std::string name = constant.control.parameter->name;
            const auto found = count.find(name);
            if (found == count.end())
                continue;
            if (found->second > 1) {
                common += constant.text;
                m_in_common.insert(name);
            }
            m_constants.emplace(name, std::move(constant));
        }
        if (!common.empty())
            m_document.common = "// Parameters that several passes read.\n\n" + common;
        return {};
    }

    Result<void> add_passes() {
        const ShadertoyShared shared{m_plan,      m_request.look, m_uniforms,
                                     m_constants, m_in_common,    m_beam ? &*m_beam : nullptr};
        const std::size_t last = look().passes.size() - 1;
        if (m_plan.has_levels)
            m_document.passes.push_back(
                {0,
                 "// Mip levels of the picture.\n" + shadertoy_levels_code(),
                 {ShadertoyConnection{}}});
        for (std::size_t i = 0; i <= last; ++i) {
            const Pass& pass = look().passes[i];
            const bool is_table = pass.name == m_plan.beam;
            if (pass.name == m_plan.source_pass ||
                (m_plan.inlined.contains(pass.name) && !is_table))
                continue;
            ShadertoyImages images(m_plan, i);
            auto code = is_table ? shadertoy_table_code(i, shared, images)
                                 : shadertoy_code(i, shared, images);
            if (!code)
                return fail(code.error());
            if (is_table) {
                m_document.passes.push_back({0,
                                             "// The points of the beam.\n" + *code,
                                             {ShadertoyConnection{.buffer = 0, .sampler = {}}}});
                continue;
            }
            if (std::string obstacle = images.obstacle(); !obstacle.empty())
                return fail({{}, 0, std::move(obstacle)});
            m_document.passes.push_back({i == last ? -1 : m_plan.buffers.at(pass.name),
                                         fmt::format("// Pass {}.\n", pass.name) + *code,
                                         images.channels()});
        }
        std::rotate(m_document.passes.begin(), m_document.passes.end() - 1,
                    m_document.passes.end());  // the image is first
        return {};
    }

    // The site compiles each pass, and also Common alone.
    Result<void> check() const {
        const auto refuse = [](const std::string& pass, const std::string& error) {
            return fail({{},
                         0,
                         fmt::format("{} isn't valid in GLSL ES 3.00, which Shadertoy uses: {}. "
                                     "Export the look with --to web.",
                                     pass, error)});
        };
        for (const ShadertoyDocument::Pass& pass : m_document.passes)
            if (const std::string error =
                    es_error(site_start + m_document.common + pass.code + site_end, true);
                !error.empty())
                return refuse(pass.buffer < 0 ? "the image" : shadertoy_buffer_name(pass.buffer),
                              error);
        return {};
    }

    void add_losses() {
        for (const Pass& pass : look().passes)
            for (const Side& side : pass.size)
                if (pass.name != m_plan.source_pass && side.by != Side::By::viewport) {
                    m_output.losses.push_back(fmt::format(
                        "The size of the pass '{}', if it is larger than the picture.", pass.name));
                    break;
                }
    }

    const EffectRequest& m_request;
    const Values& m_values;
    std::optional<ShadertoyBeam> m_beam;
    Effect m_effect;
    ShadertoyPlan m_plan;
    std::vector<EffectUniforms> m_uniforms;                // of each pass
    std::map<std::string, ShadertoyConstant> m_constants;  // by name of the parameter
    std::set<std::string, std::less<>> m_in_common;        // parameters
    ShadertoyDocument m_document;
    EffectOutput m_output;
};
}  // namespace

const EffectHost& shadertoy_host() {
    static const EffectHost host{.name = "Shadertoy",
                                 .rows = RowOrder::bottom_first,
                                 .has_integers = false,
                                 .has_images = false,
                                 .has_mouse = true,
                                 .keeps_constants = true};
    return host;
}

Result<EffectOutput> shadertoy_files(const EffectRequest& request) {
    auto plain = without_beam(request);
    if (!plain)
        return fail(plain.error());
    auto effect =
        effect_of(plain->look, plain->values, request.size, request.source, shadertoy_host());
    if (!effect)
        return fail(effect.error());
    if (plain->beam)
        put_back(*plain->beam, effect->look);
    return ShadertoyWriter(request, std::move(*effect), plain->values, std::move(plain->beam))
        .write();
}
