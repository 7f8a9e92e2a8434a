#include "formats/look_format.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <string>

namespace {
/// A shader file with one wrong statement, and what is reported for it.
struct WrongFile {
    const char* name;
    std::string text;
    const char* expected;  // after the path of its folder
};

std::string slang(const std::string& statement) {
    return "#version 450\n"
           "layout(push_constant) uniform Push { vec4 SourceSize; float GLOW; } params;\n"
           "#pragma parameter GLOW \"Glow\" 0.5 0.0 1.0 0.1\n"
           "layout(std140, set = 0, binding = 0) uniform UBO { mat4 MVP; } global;\n"
           "#pragma stage vertex\n"
           "layout(location = 0) in vec4 Position;\n"
           "layout(location = 1) in vec2 TexCoord;\n"
           "layout(location = 0) out vec2 vTexCoord;\n"
           "void main() { gl_Position = global.MVP * Position; vTexCoord = TexCoord; }\n"
           "#pragma stage fragment\n"
           "layout(location = 0) in vec2 vTexCoord;\n"
           "layout(location = 0) out vec4 FragColor;\n"
           "layout(set = 0, binding = 2) uniform sampler2D Source;\n"
           "void main() {\n    " +
           statement + "\n}\n";
}

std::string isf(const std::string& statement) {
    return "/*{ \"ISFVSN\": \"2\",\n"
           "  \"INPUTS\": [{ \"NAME\": \"level\", \"TYPE\": \"float\", \"DEFAULT\": 0.5 }] }*/\n"
           "void main() {\n    " +
           statement + "\n}\n";
}

std::string shadertoy(const std::string& statement) {
    return "// a comment\n"
           "float ring(vec2 p, float r) { return length(p) - r; }\n"
           "void mainImage(out vec4 fragColor, in vec2 fragCoord) {\n    " +
           statement + "\n}\n";
}

const WrongFile wrong_files[] = {
    {"a.slang", slang("FragColor = texture(Source, vTexCoord) * params.GLOV;"),
     "a.slang:15: error: pass 'a': 'GLOV' is not a field of 'params' (did you mean 'GLOW'?)"},
    {"a.slang", slang("FragColor = texure(Source, vTexCoord);"),
     "a.slang:15: error: pass 'a': 'texure' is not a function (did you mean 'texture'?)"},
    {"a.slang", slang("vec3 c = params.SourceSize;"),
     "a.slang:15: error: pass 'a': '=': cannot convert vec4 to vec3"},
    {"a.fs", isf("gl_FragColor = vec4(levle);"),
     "a.fs:4: error: 'levle' is undeclared (did you mean 'level'?)"},
    {"a.fs", isf("gl_FragColor = vec4(TIMR);"),
     "a.fs:4: error: 'TIMR' is undeclared (did you mean 'TIME'?)"},
    {"a.fs", isf("gl_FragColor = vec3(1.0);"), "a.fs:4: error: '=': cannot convert vec3 to vec4"},
    {"a.glsl", shadertoy("fragColor = vec4(rnig(fragCoord, 1.0));"),
     "a.glsl:4: error: 'rnig' is not a function (did you mean 'ring'?)"},
    {"a.glsl", shadertoy("fragColor = vec4(iTme);"),
     "a.glsl:4: error: 'iTme' is undeclared (did you mean 'iTime'?)"},
    {"a.glsl", shadertoy("fragColor = vec4(fragCoord.xyz, 1.0);"),
     "a.glsl:4: error: 'xyz' has a component that vec2 does not have"},
    {"a.frag",
     "#version 410 core\nuniform float decay = 0.5;\nin vec2 uv;\nout vec4 color;\n"
     "void main() {\n    color = vec4(dacay);\n}\n",
     "a.frag:6: error: 'dacay' is undeclared (did you mean 'decay'?)"},
};
}  // namespace

TEST_CASE("compiler messages of every kind of shader have the author's file, line and names") {
    for (const WrongFile& wrong : wrong_files) {
        CAPTURE(wrong.text);
        const TemporaryFolder folder;
        const std::filesystem::path file = folder.write(wrong.name, wrong.text);
        const LoadedLook loaded = load_look(file, {}, {});
        REQUIRE_FALSE(loaded.look.has_value());
        CHECK(to_string(loaded.look.error().front()) ==
              file.parent_path().string() + "/" + wrong.expected);
    }
}
