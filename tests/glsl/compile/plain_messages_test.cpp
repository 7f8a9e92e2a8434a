#include "base/text.h"
#include "glsl/compile/check.h"
#include "glsl/compile/spirv.h"
#include "glsl/compile/type_names.h"
#include "glsl/shader_texts.h"
#include "glsl/text/field_access.h"
#include "glsl/text/shader_names.h"

#include <doctest/doctest.h>

#include <string>
#include <utility>

namespace {
// Line 1 is the #version. Statements of a test are on line 13.
constexpr const char* declarations =
    "struct Params { float gain; vec3 tint; float bloom[3]; };\n"
    "struct Ray { vec3 origin; vec3 dir; };\n"
    "uniform Params params;\n"
    "uniform Blk { float decay; vec2 shape; } blk;\n"
    "uniform sampler2D tex;\n"
    "uniform float exposure = 1.0;\n"
    "const float third = 1.0 / 3.0;\n"
    "in vec2 uv; out vec4 color;\n"
    "#define TWICE(x) ((x) * 2.0)\n"
    "Ray make() { return Ray(vec3(0), vec3(1)); }\n"
    "float glow(vec2 p, float r) { return r; }\n";

// Wrong statements and their messages.
/// The errors of a statement in main().
Diagnostics errors_of(const std::string& statement) {
    const auto checked =
        check_program(stage_of("a.vert",
                               "#version 410 core\nout vec2 uv;\n"
                               "void main() { uv = vec2(0); gl_Position = vec4(0); }\n"),
                      stage_of("a.frag", std::string("#version 410 core\n") + declarations +
                                             "void main() { " + statement + " }\n"));
    return checked ? Diagnostics() : checked.error();
}
struct WrongStatement {
    const char* statement;
    const char* message;
};

constexpr WrongStatement wrong_statements[] = {
    // Variables, uniforms, macros, built-in variables, types and keywords.
    {"float e = exposur;", "'exposur' is undeclared (did you mean 'exposure'?)"},
    {"float bright = 1.0; color.r = brigth;", "'brigth' is undeclared (did you mean 'bright'?)"},
    {"color = gl_FragCoor;", "'gl_FragCoor' is undeclared (did you mean 'gl_FragCoord'?)"},
    {"flaot x = 1.0;", "'flaot' is undeclared (did you mean 'float'?)"},
    {"discrad;", "'discrad' is undeclared (did you mean 'discard'?)"},
    {"color.r = UV.x;", "'UV' is undeclared (did you mean 'uv'?)"},
    {"color.r = b;", "'b' is undeclared"},
    // Functions of the file and of GLSL.
    {"float g = glwo(uv, 1.0);", "'glwo' is not a function (did you mean 'glow'?)"},
    {"color = texure(tex, uv);", "'texure' is not a function (did you mean 'texture'?)"},
    {"float s = smothstep(0.0, 1.0, 0.5);",
     "'smothstep' is not a function (did you mean 'smoothstep'?)"},
    {"float s = TWIC(1.0);", "'TWIC' is not a function (did you mean 'TWICE'?)"},
    {"vec3 v = vce3(1.0);", "'vce3' is not a function (did you mean 'vec3'?)"},
    {"float g = glow(uv);", "'glow' does not accept these arguments: it takes (vec2, float)"},
    {"vec3 m = mix(vec3(1), uv, 0.5);", "'mix' does not accept these arguments"},
    {"float t = tex(uv);", "'tex' is a variable, not a function"},
    // Fields and components.
    {"float a = params.gian;", "'gian' is not a field of 'params' (did you mean 'gain'?)"},
    {"float a = blk.decai;", "'decai' is not a field of 'blk' (did you mean 'decay'?)"},
    {"float a = params.zoom;", "'zoom' is not a field of 'params' (it has gain, tint, bloom)"},
    {"float k = make().dri.x;", "'dri' is not a field of Ray (did you mean 'dir'?)"},
    {"Ray rays[2]; float f = rays[1].orign.x;",
     "'orign' is not a field of 'rays' (did you mean 'origin'?)"},
    {"vec2 q = uv.xyz;", "'xyz' has a component that vec2 does not have"},
    {"float q = params.tint.w;", "'w' has a component that vec3 does not have"},
    {"float n = third.y;", "'y' has a component that float does not have"},
    {"float s = uv.foo;", "'foo' is not a component of vec2; components are xyzw, rgba or stpq"},
    {"vec2 s = uv.rx;", "'rx' mixes names of components; use either xyzw, rgba or stpq"},
    {"int n = params.bloom.lenght();",
     "'lenght' cannot be read from an array (did you mean 'length'?)"},
    // Types.
    {"vec3 v = third;", "'=': cannot convert float to vec3"},
    {"color = vec3(1.0);", "'=': cannot convert vec3 to vec4"},
    {"mat3 m = mat2(1.0);", "'=': cannot convert mat2 to mat3"},
    {"mat3x2 m = mat2x3(1.0);", "'=': cannot convert mat2x3 to mat3x2"},
    {"float a[3] = float[2](1.0, 2.0);", "'=': cannot convert float[2] to float[3]"},
    {"vec3 v[2]; vec2 w[2]; v = w;", "'=': cannot convert vec2[2] to vec3[2]"},
    {"vec3 v = tex;", "'=': cannot convert sampler2D to vec3"},
    {"uint u = -1.5;", "'=': cannot convert float to uint"},
    {"Ray r = params;", "'=': cannot convert Params to Ray"},
    {"float f = blk;", "'=': cannot convert Blk to float"},
    {"bool b = vec3(1) == uv;", "'==' cannot combine vec3 and vec2"},
    {"vec4 v = mat4(1) * vec3(1);", "'*' cannot combine mat4 and vec3"},
    {"int i = 3 % 2.0;", "'%' cannot combine int and float"},
    {"bool z = !exposure;", "'!' cannot be applied to float"},
    {"vec2 v = -make();", "'-' cannot be applied to Ray"},
    {"if (uv) color = vec4(1);", "the condition must be a bool"},
    // Constructors and assignments.
    {"vec3 v = vec3(1.0, 2.0);", "the constructor needs more values"},
    {"vec2 v = vec2(1.0, 2.0, 3.0);", "the constructor has too many values"},
    {"Ray r = Ray(vec3(1));", "the constructor needs one value for each field of the struct"},
    {"vec4 v = vec4(make());", "'vec4' cannot be constructed from these values"},
    {"exposure = 1.0;", "'exposure' is a uniform, which cannot be changed"},
    {"uv = vec2(1.0);", "'uv' is a shader input, which cannot be changed"},
    {"third = 2.0;", "'=': the left side is a constant, which cannot be changed"},
    {"float half;", "'half' is a reserved word; choose another name"},
    {"float a; float a;", "'a' is declared twice"},
    {"cosnt float k = 1.0;", "'cosnt' is undeclared (did you mean 'const'?)"},
};
}  // namespace

TEST_CASE("a message names similar declarations and uses GLSL's type names") {
    for (const auto& [statement, message] : wrong_statements) {
        CAPTURE(statement);
        const Diagnostics errors = errors_of(statement);
        REQUIRE(errors.size() == 1);
        CHECK(to_string(errors.front()) == "a.frag:13: error: " + std::string(message));
    }
}

TEST_CASE("a keyword with a mistake is named in a syntax error") {
    const auto error_of = [](const std::string& line) {
        const auto checked = check_program(fullscreen_vertex_stage(), fragment_with(line));
        REQUIRE_FALSE(checked.has_value());
        return to_string(checked.error().front());
    };
    CHECK(
        error_of("unifrom float z;") ==
        "a.frag:2: error: syntax error, unexpected a name, at 'unifrom' (did you mean 'uniform'?)");
    CHECK(error_of("uniform flaot z;") ==
          "a.frag:2: error: syntax error, unexpected a name, expecting '{' or ',' or ';', "
          "at 'flaot' (did you mean 'float'?)");
    CHECK(error_of("float a b;").find("did you mean") == std::string::npos);
}

TEST_CASE("a name of a closed block is not suggested") {
    const auto error_of = [](const std::string& line) {
        const auto checked = check_program(
            fullscreen_vertex_stage(),
            stage_of("a.frag",
                     "#version 410 core\nvoid main() {\n  { float inner = 1.0; }\n" + line));
        REQUIRE_FALSE(checked.has_value());
        return to_string(checked.error().front());
    };
    CHECK(error_of("  float a = innner;\n}\n") == "a.frag:4: error: 'innner' is undeclared");
    CHECK(error_of("  { float inner = 1.0; float a = innner; }\n}\n") ==
          "a.frag:4: error: 'innner' is undeclared (did you mean 'inner'?)");
}

TEST_CASE("a shader for Vulkan gets the same suggestions") {
    const auto compiled = [](const std::string& statement) {
        return compile_for_vulkan(
            stage_of("a.slang",
                     "#version 450\nlayout(location = 0) out vec2 vTexCoord;\n"
                     "void main() { vTexCoord = vec2(0); gl_Position = vec4(0); }\n"),
            stage_of("a.slang",
                     "#version 450\n"
                     "layout(push_constant) uniform Push { vec4 SourceSize; float GAIN; } params;\n"
                     "layout(location = 0) in vec2 vTexCoord;\n"
                     "layout(location = 0) out vec4 FragColor;\n"
                     "layout(set = 0, binding = 2) uniform sampler2D Source;\n"
                     "#define OutSize params.SourceSiz\n"
                     "void main() { " +
                         statement + " }\n"));
    };
    const std::pair<const char*, const char*> rows[] = {
        {"FragColor = vec4(params.GAIM);",
         "'GAIM' is not a field of 'params' (did you mean 'GAIN'?)"},
        {"FragColor = OutSize;",
         "'SourceSiz' is not a field of 'params' (did you mean 'SourceSize'?)"},
        {"FragColor = texure(Source, vTexCoord);",
         "'texure' is not a function (did you mean 'texture'?)"},
        {"vec3 x = params.SourceSize;", "'=': cannot convert vec4 to vec3"},
        {"FragColor = vec4(vTexCord, 0, 1);",
         "'vTexCord' is undeclared (did you mean 'vTexCoord'?)"},
    };
    for (const auto& [statement, message] : rows) {
        CAPTURE(statement);
        const auto result = compiled(statement);
        REQUIRE_FALSE(result.has_value());
        CHECK(to_string(result.error().front()) == "a.slang:7: error: " + std::string(message));
    }
}

TEST_CASE("glslang's descriptions of types become GLSL's names") {
    const std::pair<const char*, const char*> rows[] = {
        {" temp float", "float"},
        {" const (read only) int", "int"},
        {" temp highp 3-component vector of highp float", "vec3"},
        {"layout( location=0) smooth in 2-component vector of uint", "uvec2"},
        {" global 4X4 matrix of double", "dmat4"},
        {" const 2X3 matrix of float", "mat2x3"},
        {" uniform 2-element array of 3-element array of 4-component vector of bool",
         "bvec4[2][3]"},
        {" temp unsized 1-element array of float", "float[]"},
        {" uniform isampler3D", "isampler3D"},
        {" uniform structure{ global float gain,  global 3-element array of float bloom}",
         "struct"},
        {"layout( column_major std430 push_constant) uniform block{layout( offset=0) uniform highp "
         "float GAIN}",
         "block"},
        {"", ""},
    };
    for (const auto& [description, name] : rows) {
        CAPTURE(description);
        CHECK(glsl_type_name(description) == name);
    }
    CHECK(described_fields(rows[9].first) == std::vector<std::string>{"gain", "bloom"});
    CHECK(described_fields(rows[10].first) == std::vector<std::string>{"GAIN"});
    CHECK(described_fields(" temp float").empty());
}

TEST_CASE("names are visible from their declaration to the end of their block") {
    const std::string text =
        "uniform float a[2], b = max(1.0, 2.0);\n"
        "float f(in vec2 p, const float[3] q);\n"
        "float f(in vec2 p, const float[3] q) {\n"
        "  for (int i = 0; i < 3; ++i) { vec3 inner = vec3(i); }\n"
        "  Unknown last;\n"
        "}\n"
        "float later;\n";
    const auto variables = [&text](int line) {
        std::string all;
        for (const TypedName& variable : names_at(text, line).variables)
            all += variable.type + ' ' + variable.name + ';';
        return all;
    };
    CHECK(variables(2) == "float a;float b;");
    CHECK(variables(5) == "float a;float b;vec2 p;float q;int i;Unknown last;");
    CHECK(variables(7) == "float a;float b;float later;");
    const ShaderNames names = names_at(text, 7);
    REQUIRE(names.functions.size() == 2);
    CHECK(names.functions.front().parameters == std::vector<std::string>{"vec2", "float"});
}

TEST_CASE("the type before a field follows calls, arrays and nested structs") {
    const std::string text =
        "struct Light { vec3 color; }; struct Scene { Light lights[4]; } scene;\n"
        "Scene make(int n);\n"
        "float a = make(max(1, 2)).lights[1].colr.x + (scene).foo + 1.0.x;\n";
    const ShaderNames names = names_at(text, 3);
    CHECK(type_before_field(text, 3, "colr", names) == "Light");
    CHECK(type_before_field(text, 3, "lights", names) == "Scene");
    CHECK(type_before_field(text, 3, "foo", names).empty());
    CHECK(type_before_field(text, 3, "absent", names).empty());
}
