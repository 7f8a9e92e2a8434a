#include "glsl/compile/spirv.h"

#include "glsl/compile/check.h"
#include "glsl/compile/compiler_log.h"
#include "glsl/compile/plain_messages.h"
#include "glsl/limits/start.h"
#include "glsl/text/tokens.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

namespace {
constexpr int default_version = 100;
constexpr int vulkan_version = 450;  // of the built-in functions that messages suggest
constexpr auto vulkan_messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);

/// A stage that is compiled to SPIR-V.
class VulkanStage {
public:
    VulkanStage(const Stage& stage, EShLanguage language)
        : m_stage(stage), m_text(without_line_directives(stage.text)), m_shader(language) {
        m_pieces[0] = m_text.c_str();
        m_sizes[0] = static_cast<int>(m_text.size());
        m_shader.setStringsWithLengths(m_pieces, m_sizes, 1);
        m_shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
        m_shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
        m_shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
    }

    void parse(Diagnostics& problems) {
        const bool is_good = m_shader.parse(GetDefaultResources(), default_version, ENoProfile,
                                            false, false, vulkan_messages);
        add_messages(m_shader.getInfoLog(), problems);
        if (!is_good && !has_errors(problems))
            problems.push_back({m_stage.file, 1, refused_without_reason});
    }

    void add_messages(const char* log, Diagnostics& problems) const {
        std::vector<CompilerMessage> messages = parse_compiler_log(log);
        explain(messages, m_text,
                {.stage = m_shader.getStage(), .version = vulkan_version, .is_vulkan = true});
        for (const CompilerMessage& message : messages) {
            const Location at =
                message.line > 0 ? location_in(m_stage, message.line) : Location{m_stage.file, 0};
            problems.push_back({at.file, at.line, message.text,
                                message.is_warning ? Severity::warning : Severity::error});
        }
    }

    glslang::TShader& shader() { return m_shader; }

private:
    const Stage& m_stage;
    std::string m_text;
    const char* m_pieces[1];
    int m_sizes[1];
    glslang::TShader m_shader;
};

// Linked separately: blocks with the same name may have different members in the two stages.
std::vector<std::uint32_t> code_of(VulkanStage& stage, Diagnostics& problems) {
    glslang::TProgram program;
    program.addShader(&stage.shader());
    if (!program.link(vulkan_messages)) {
        stage.add_messages(program.getInfoLog(), problems);
        return {};
    }
    glslang::SpvOptions options;
    options.disableOptimizer = true;
    options.generateDebugInfo = true;
    spv::SpvBuildLogger logger;
    std::vector<std::uint32_t> code;
    glslang::GlslangToSpv(*program.getIntermediate(stage.shader().getStage()), code, &logger,
                          &options);
    return code;
}
}  // namespace

Result<SpirvPair> compile_for_vulkan(const Stage& vertex, const Stage& fragment,
                                     const ShaderLimits& limits) {
    Diagnostics problems;
    check_bounds(vertex, limits, problems);
    check_bounds(fragment, limits, problems);
    if (!problems.empty())
        return fail(std::move(problems));

    start_glslang();
    VulkanStage vertex_stage(vertex, EShLangVertex);
    VulkanStage fragment_stage(fragment, EShLangFragment);
    vertex_stage.parse(problems);
    fragment_stage.parse(problems);
    if (has_errors(problems))
        return fail(std::move(problems));
    check_cost(vertex_stage.shader(), vertex, limits, problems);
    check_cost(fragment_stage.shader(), fragment, limits, problems);
    if (has_errors(problems))
        return fail(std::move(problems));
    SpirvPair pair{code_of(vertex_stage, problems), code_of(fragment_stage, problems), {}};
    if (has_errors(problems))
        return fail(std::move(problems));
    pair.warnings = std::move(problems);
    return pair;
}
