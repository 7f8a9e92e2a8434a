#include "formats/isf/stages.h"

#include "base/text.h"
#include "formats/isf/body.h"
#include "glsl/text/include.h"
#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace {
constexpr const char* built_ins =
    "uniform vec2 RENDERSIZE;\n"
    "uniform float TIME;\n"
    "uniform float TIMEDELTA;\n"
    "uniform int FRAMEINDEX;\n"
    "uniform vec4 DATE;\n";

// {0} is the texture function; {1} and {2} are the extra arguments without and with a bias.
constexpr const char* picture_functions =
    "vec4 IMG_NORM_PIXEL(sampler2D i, vec2 at) {{ return {0}(i, at{1}); }}\n"
    "vec4 IMG_NORM_PIXEL(sampler2D i, vec2 at, float bias) {{ return {0}(i, at{2}); }}\n"
    "vec2 IMG_SIZE(sampler2D i) {{ return vec2(textureSize(i, 0)); }}\n"
    "vec4 IMG_PIXEL(sampler2D i, vec2 at) {{ return IMG_NORM_PIXEL(i, at / IMG_SIZE(i)); }}\n"
    "vec4 IMG_PIXEL(sampler2D i, vec2 at, float bias) {{\n"
    "    return IMG_NORM_PIXEL(i, at / IMG_SIZE(i), bias);\n"
    "}}\n"
    "vec4 IMG_THIS_NORM_PIXEL(sampler2D i) {{ return IMG_NORM_PIXEL(i, isf_FragNormCoord); }}\n"
    "vec4 IMG_THIS_PIXEL(sampler2D i) {{ return IMG_NORM_PIXEL(i, isf_FragNormCoord); }}\n";

constexpr const char* whole_target =
    "void isf_vertShaderInit() {\n"
    "    isf_FragNormCoord = isf_corner;\n"
    "    gl_Position = vec4(isf_corner * 2.0 - 1.0, 0.0, 1.0);\n"
    "}\n";

constexpr const char* no_vertex_code = "void main() { isf_vertShaderInit(); }\n";

constexpr const char* stretching =
    "#version 410 core\n"
    "in vec2 isf_FragNormCoord;\n"
    "uniform sampler2D image;\n"
    "out vec4 color;\n"
    "void main() { color = texture(image, isf_FragNormCoord); }\n";

const char* uniform_type(IsfInput::Type type) {
    switch (type) {
        case IsfInput::Type::floating:
            return "float";
        case IsfInput::Type::boolean:
        case IsfInput::Type::event:
            return "bool";
        case IsfInput::Type::integer:
            return "int";
        case IsfInput::Type::point:
            return "vec2";
        case IsfInput::Type::color:
            return "vec4";
        case IsfInput::Type::cube:
            return "samplerCube";
        case IsfInput::Type::image:
        case IsfInput::Type::audio:
        case IsfInput::Type::audio_fft:
            break;
    }
    return "sampler2D";
}

/// The declarations that the program adds to a shader.
class Declarations {
public:
    Declarations(const IsfHeader& header, std::string_view code) {
        for (const Token& token : scan(code).all)
            if (token.kind == Token::Kind::word && token.text.starts_with('_'))
                m_asked.insert(token.text);
        names = {"RENDERSIZE", "TIME",      "TIMEDELTA",         "FRAMEINDEX",
                 "DATE",       "PASSINDEX", "isf_FragNormCoord", "vv_FragNormCoord"};
        for (const IsfInput& input : header.inputs)
            declare(uniform_type(input.type), input.name);
        for (const IsfImport& import : header.imports)
            declare(import.is_cube ? "samplerCube" : "sampler2D", import.name);
        for (const IsfPass& pass : header.passes)
            if (!pass.target.empty() && !is_declared(pass.target))
                declare("sampler2D", pass.target);
    }

    std::string text;
    std::vector<std::string> names;

private:
    bool is_declared(const std::string& name) const {
        return std::ranges::find(names, name) != names.end();
    }

    void declare(const std::string& type, const std::string& name) {
        names.push_back(name);
        text += fmt::format("uniform {} {};\n", type, isf_declared_name(name));
        if (type == "sampler2D")
            add_info(name);
    }

    // Not in the specification, but provided by hosts and used by shaders.
    void add_info(const std::string& name) {
        const auto add = [&](const char* fact, const std::string& value) {
            const std::string asked = fmt::format("_{}_{}", name, fact);
            if (m_asked.contains(asked))
                text += fmt::format("#define {} {}\n", asked, value);
        };
        add("imgRect", "vec4(0.0, 0.0, 1.0, 1.0)");
        add("imgSize", fmt::format("vec2(textureSize({}, 0))", isf_declared_name(name)));
        add("flip", "false");
    }

    std::set<std::string_view> m_asked;  // words of the code that may be such names
};

Stage stage_of(const std::filesystem::path& file, const std::string& prefix,
               const std::string& body, int first_line) {
    Stage stage{file, prefix + body, {}};
    stage.lines.append({{}, 1}, split_lines(prefix).size());
    stage.lines.append({file, first_line}, split_lines(body).size());
    return stage;
}

std::string prefix_of(std::size_t pass, const std::string& varyings, const Declarations& declared) {
    // Lets drivers with this extension accept "return 1;" in a float function, as older hosts did.
    return "#version 410 core\n#extension GL_ARB_shading_language_420pack : enable\n" + varyings +
           fmt::format("const int PASSINDEX = {};\n", pass) + built_ins + declared.text;
}
}  // namespace

Stage isf_fragment_stage(const IsfSource& source, const IsfHeader& header, std::size_t pass) {
    const std::string_view code = std::string_view(source.text).substr(header.code_begin);
    const Declarations declared(header, code);
    const std::string prefix =
        prefix_of(pass, "in vec2 isf_FragNormCoord;\nout vec4 isf_FragColor;\n", declared) +
        fmt::format(fmt::runtime(picture_functions), "texture", "", ", bias");
    return stage_of(source.file, prefix, isf_body(code, IsfStage::fragment, declared.names),
                    header.code_line);
}

Stage isf_vertex_stage(const IsfSource& source, const IsfHeader& header, std::size_t pass) {
    if (source.vertex_file.empty())
        return builtin_stage(std::string("#version 410 core\nout vec2 isf_FragNormCoord;\n"
                                         "#define isf_corner vec2((gl_VertexID << 1) & 2, "
                                         "gl_VertexID & 2)\n") +
                             whole_target + no_vertex_code);
    const Declarations declared(header, source.vertex_text);
    const std::string prefix =
        prefix_of(pass, "layout(location = 0) in vec2 isf_corner;\nout vec2 isf_FragNormCoord;\n",
                  declared) +
        fmt::format(fmt::runtime(picture_functions), "textureLod", ", 0.0", ", 0.0") + whole_target;
    return stage_of(source.vertex_file, prefix,
                    isf_body(source.vertex_text, IsfStage::vertex, declared.names), 1);
}

Stage isf_stretching_stage() {
    return builtin_stage(stretching);
}
