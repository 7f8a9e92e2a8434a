#include "formats/shadertoy/shadertoy_files.h"

#include "base/text.h"
#include "formats/glsl/modern_glsl.h"
#include "formats/shadertoy/shadertoy_directives.h"
#include "glsl/text/include.h"
#include "glsl/text/tokens.h"

#include <algorithm>
#include <array>

namespace fs = std::filesystem;

namespace {
using Kind = ShadertoyPass::Kind;

constexpr std::array extensions{".glsl", ".frag", ".fsh", ".fs", ".txt"};

/// The pass that a file's name indicates.
struct NamedPass {
    Kind kind = Kind::image;
    int index = 0;
    std::string shader;  // the part of the name before the pass
};

// "Buffer A", "buf_a" and "BufferA" are equivalent.
std::string plain_name(const fs::path& file) {
    std::string plain;
    for (const char c : to_lower(file.stem().string()))
        if (std::string_view(" _-.").find(c) == std::string_view::npos)
            plain += c;
    return plain;
}

std::optional<NamedPass> pass_named(const fs::path& file) {
    struct Word {
        std::string_view word;
        Kind kind;
        int index;
    };
    constexpr auto words = std::to_array<Word>({{"common", Kind::common, 0},
                                                {"buffera", Kind::buffer, 0},
                                                {"bufferb", Kind::buffer, 1},
                                                {"bufferc", Kind::buffer, 2},
                                                {"bufferd", Kind::buffer, 3},
                                                {"bufa", Kind::buffer, 0},
                                                {"bufb", Kind::buffer, 1},
                                                {"bufc", Kind::buffer, 2},
                                                {"bufd", Kind::buffer, 3},
                                                {"cubea", Kind::cube, shadertoy_cube_index},
                                                {"cubemapa", Kind::cube, shadertoy_cube_index},
                                                {"image", Kind::image, 0},
                                                {"sound", Kind::sound, 0}});
    if (std::ranges::find(extensions, to_lower(file.extension().string())) == extensions.end())
        return std::nullopt;
    const std::string plain = plain_name(file);
    for (const Word& word : words)
        if (plain.ends_with(word.word))
            return NamedPass{word.kind, word.index,
                             plain.substr(0, plain.size() - word.word.size())};
    return std::nullopt;
}

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error);
         entry != fs::directory_iterator(); entry.increment(error)) {
        if (error)
            break;
        if (entry->is_regular_file(error))
            files.push_back(folder / entry->path().filename());
    }
    std::ranges::sort(files);
    return files;
}

bool defines(const std::vector<Token>& tokens, std::string_view function) {
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i)
        if (tokens[i].is("void") && tokens[i + 1].is(function) && tokens[i + 2].is("("))
            return true;
    return false;
}

/// Reads the passes of one shader.
class ShadertoyFolder {
public:
    ShadertoyFolder(const fs::path& file, const IncludeFolders& includes,
                    std::vector<fs::path>& files, Diagnostics& warnings)
        : m_roots{file.parent_path(), includes}, m_files(files), m_warnings(warnings) {}

    Result<Shadertoy> load(const fs::path& file) {
        const auto named = pass_named(file);
        const std::vector<fs::path> others =
            named ? siblings(file, *named) : std::vector<fs::path>();
        const bool has_image = std::ranges::any_of(
            others, [](const fs::path& other) { return pass_named(other)->kind == Kind::image; });
        if (has_image)
            for (const fs::path& other : others)
                add(other, *pass_named(other));
        else
            add(file, {});
        add_named_buffers();
        m_shadertoy.name = named && !named->shader.empty() ? named->shader
                           : named                         ? folder_name(file)
                                                           : file.stem().string();
        if (!m_problems.empty())
            return fail(std::move(m_problems));
        return std::move(m_shadertoy);
    }

private:
    static std::string folder_name(const fs::path& file) {
        std::error_code error;
        return fs::absolute(file, error).parent_path().filename().string();
    }

    // The files of the shader, one per pass, including this one.
    static std::vector<fs::path> siblings(const fs::path& file, const NamedPass& named) {
        std::vector<fs::path> found{file};
        for (const fs::path& other : files_in(file.parent_path())) {
            const auto pass = pass_named(other);
            const bool is_new = pass && pass->shader == named.shader &&
                                std::ranges::none_of(found, [&](const fs::path& known) {
                                    const auto had = pass_named(known);
                                    return had->kind == pass->kind && had->index == pass->index;
                                });
            if (is_new)
                found.push_back(other);
        }
        return found;
    }

    void add(const fs::path& file, const NamedPass& named) {
        auto code = load_stage(file, m_roots, m_files);
        if (!code) {
            m_problems.insert(m_problems.end(), code.error().begin(), code.error().end());
            return;
        }
        ShadertoyPass pass;
        pass.kind = named.kind;
        pass.index = named.index;
        pass.name = shadertoy_pass_name(named.kind, named.index);
        pass.code = std::move(*code);
        pass.has_explicit_inputs = false;
        const fs::path own = file.lexically_normal();
        read_shadertoy_directives(
            pass, [&](const fs::path& named_file) { return buffer_of(named_file, own, pass); },
            m_warnings);
        m_shadertoy.passes.push_back(std::move(pass));
    }

    // A pass that reads itself is a buffer. Another file read by a pass is a buffer, too.
    int buffer_of(const fs::path& file, const fs::path& own, const ShadertoyPass& pass) {
        const fs::path named = file.lexically_normal();
        if (named == own && pass.kind != Kind::image)
            return pass.index;
        if (std::ranges::find(m_buffers, named) == m_buffers.end())
            m_buffers.push_back(named);
        const auto at = std::ranges::find(m_buffers, named) - m_buffers.begin();
        return at < shadertoy_cube_index ? static_cast<int>(at) : -1;
    }

    // Adds the files named by directives, recursively.
    void add_named_buffers() {
        for (std::size_t i = 0; i < m_buffers.size() && i < shadertoy_cube_index; ++i) {
            const fs::path file = m_buffers[i];
            const auto image =
                std::ranges::find(m_shadertoy.passes, Kind::image, &ShadertoyPass::kind);
            if (image != m_shadertoy.passes.end() && image->code.file.lexically_normal() == file)
                show_as_buffer(*image, static_cast<int>(i));
            else
                add(file, {Kind::buffer, static_cast<int>(i), {}});
        }
    }

    // An Image pass that reads itself becomes a buffer, and a new Image shows it unchanged.
    void show_as_buffer(ShadertoyPass& image, int index) {
        image.kind = Kind::buffer;
        image.index = index;
        image.name = shadertoy_pass_name(Kind::buffer, index);
        ShadertoyPass shown;
        shown.name = shadertoy_pass_name(Kind::image, 0);
        shown.code = builtin_stage(
            "void mainImage(out vec4 color, in vec2 at) {\n"
            "    color = texelFetch(iChannel0, ivec2(at), 0);\n"
            "}\n");
        shown.code.file = image.code.file;
        ShadertoyInput input;
        input.kind = ShadertoyKind::buffer;
        input.buffer = index;
        input.declared = {image.code.file, 1};
        shown.inputs.push_back(std::move(input));
        m_shadertoy.passes.push_back(std::move(shown));
    }

    IncludeRoots m_roots;
    std::vector<fs::path>& m_files;
    Diagnostics& m_warnings;
    std::vector<fs::path> m_buffers;  // named by directives, in order of their places
    Diagnostics m_problems;
    Shadertoy m_shadertoy;
};
}  // namespace

bool is_shadertoy_text(std::string_view text) {
    std::vector<Token> tokens;
    for (const Token& token : scan(text).all)
        if (token.kind != Token::Kind::comment)
            tokens.push_back(token);
    return defines(tokens, "mainImage") && !defines(tokens, "main");
}

std::optional<fs::path> find_shadertoy_image(const fs::path& folder) {
    for (const fs::path& file : files_in(folder)) {
        const auto named = pass_named(file);
        if (named && named->kind == Kind::image)
            return file;
    }
    return std::nullopt;
}

bool is_shown_by_another(const fs::path& file) {
    const auto named = pass_named(file);
    if (!named || named->kind == Kind::image)
        return false;
    return std::ranges::any_of(files_in(file.parent_path()), [&](const fs::path& other) {
        const auto pass = pass_named(other);
        return pass && pass->kind == Kind::image && pass->shader == named->shader;
    });
}

Result<Shadertoy> load_shadertoy_files(const fs::path& file, const IncludeFolders& includes,
                                       std::vector<fs::path>& files, Diagnostics& warnings) {
    return ShadertoyFolder(file, includes, files, warnings).load(file);
}
