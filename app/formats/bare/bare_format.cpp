#include "formats/bare/bare_format.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/bare/bare_names.h"
#include "formats/bare/varyings.h"
#include "formats/modern_glsl.h"
#include "glsl/declarations.h"
#include "glsl/include.h"
#include "glsl/parameters.h"
#include "glsl/tokens.h"
#include "glsl/turned_constants.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace fs = std::filesystem;

namespace {
constexpr std::size_t most_varyings = 256;
constexpr int frames_shown = 120;  // two seconds: many begin with black
constexpr const char* source_pattern = "pattern:harbour";

constexpr std::array bare_endings{".frag", ".fsh", ".fs", ".glsl"};

bool defines_main(std::string_view text) {
    std::string_view before;
    for (const Token& token : scan(text).all) {
        if (token.kind == Token::Kind::comment)
            continue;
        if (before == "void" && token.is("main"))
            return true;
        before = token.text;
    }
    return false;
}

// ES 1.00 and old desktop versions have outputs of their own.
Stage modern_stage(const Stage& written) {
    WordChanges changes{{"varying", "in"}};
    GlslWords words;
    add_words(written.text, words);
    std::string start = modern_glsl_start(words);
    if (words.contains("gl_FragColor")) {
        changes["gl_FragColor"] = "afterglow_color";
        start += "out vec4 afterglow_color;\n";
    }
    if (words.contains("gl_FragData")) {
        changes["gl_FragData"] = "afterglow_data";
        start += "out vec4 afterglow_data[1];\n";
    }
    Stage stage;
    stage.file = written.file;
    stage.text = start + modern_glsl(written.text, changes);
    stage.lines.append({{}, 1}, static_cast<std::size_t>(std::ranges::count(start, '\n')));
    for (std::size_t line = 0; line < written.lines.size(); ++line)
        stage.lines.push_back(written.lines[line]);
    return stage;
}

// Of samplers: the picture that the shader works on, and for the others the sizes that it asks for.
void feed_bare(Pass& pass, Look& look) {
    for (const Declaration& declared : find_declarations(pass.fragment.text)) {
        if (is_bare_source(declared.name)) {
            look.driven_by = Driver::picture;
            look.default_source = source_pattern;
            const bool is_known =
                std::ranges::find(pass.inputs, declared.name, &Input::uniform) != pass.inputs.end();
            if (!is_known)
                pass.inputs.push_back({declared.name, Input::From::source, {}, 0, {}});
        }
        constexpr std::string_view asks_size = "Resolution";
        if (declared.name.starts_with("u_tex") && declared.name.ends_with(asks_size)) {
            const std::string sampler =
                declared.name.substr(0, declared.name.size() - asks_size.size());
            pass.built_ins.push_back({declared.name, BuiltIn::input_resolution,
                                      Input{sampler, Input::From::image, sampler, 0, {}}});
        }
    }
}

Result<Look> read_bare_look(const fs::path& file, const fs::path& shared, const ReadingHelp& help,
                            LoadedLook& loaded) {
    const auto written = load_stage(file, {file.parent_path(), shared}, loaded.files);
    if (!written)
        return fail(written.error());
    Look look;
    Pass pass;
    pass.name = "picture";
    pass.built_ins.clear();
    pass.declared = {file, 1};
    pass.format = Format::rgba8;
    pass.output = Encoding::display;
    pass.fragment = modern_stage(*written);
    GlslWords words;
    add_words(pass.fragment.text, words);
    for (const BuiltInUniform& told : bare_built_ins())
        if (words.contains(told.name))
            pass.built_ins.push_back(told);
    const std::vector<BareVarying> varyings = find_varyings(pass.fragment.text);
    if (varyings.size() > most_varyings) {
        const Location at = place_in(pass.fragment, varyings[most_varyings].line);
        return fail({at.file, at.line,
                     fmt::format("more than {} values come from a vertex shader", most_varyings)});
    }
    pass.vertex = vertex_stage_for(varyings, pass.fragment, loaded.warnings);
    feed_bare(pass, look);
    look.passes.push_back(std::move(pass));
    loaded.is_parsed = true;
    if (auto problems = turn_constants(look, help.values); !problems.empty())
        return fail(std::move(problems));
    auto parameters = find_parameters(look, help.cache, loaded.warnings);
    if (!parameters)
        return fail(std::move(parameters.error()));
    look.parameters.insert(look.parameters.begin(), parameters->begin(), parameters->end());
    for (Parameter& parameter : look.parameters)
        if (parameter.control == Control::image)
            parameter.initial = Value::of_path(bare_stand_in(parameter.name));
    look.id = foreign_look_id(file);
    look.name = file.stem().string();
    look.manifest = file;
    look.source_encoding = Encoding::display;
    look.output = Encoding::display;
    look.settle_frames = frames_shown;
    return look;
}
}  // namespace

bool is_bare_file(const fs::path& file) {
    constexpr std::size_t most_of_text = std::size_t{4} << 20;
    if (std::ranges::find(bare_endings, to_lower(file.extension().string())) == bare_endings.end())
        return false;
    std::error_code error;
    const auto text = read_start(file, most_of_text);
    return text ? defines_main(*text) : !fs::exists(file, error);
}

LoadedLook load_bare_look(const fs::path& file, const fs::path& shared_includes,
                          const ReadingHelp& help) {
    LoadedLook loaded;
    loaded.look = read_bare_look(file, shared_includes, help, loaded);
    return loaded;
}
