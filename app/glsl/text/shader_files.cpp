#include "glsl/text/shader_files.h"

#include "base/file.h"
#include "glsl/text/tokens.h"

#include <ctime>
#include <functional>

namespace fs = std::filesystem;

namespace {
// Compilers disagree on whether a single CR ends a line; LF is unambiguous.
std::string with_plain_line_ends(std::string_view text) {
    std::string plain;
    plain.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_pair = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
        if (!is_pair)
            plain += text[i] == '\r' ? '\n' : text[i];
    }
    return plain;
}

bool is_once(const Directive& directive) {
    return directive.name == "pragma" && directive.arguments.size() == 1 &&
           directive.arguments.front().is("once");
}

// Parses `<`, words, `>`.
std::string name_between(const std::vector<Token>& signs) {
    const char* const begin = signs.front().text.data() + 1;
    return {begin, signs.back().text.data()};
}

ShaderText::Include include_of(const Directive& directive) {
    const auto& arguments = directive.arguments;
    ShaderText::Include include;
    include.begin = directive.begin;
    include.end = directive.end;
    include.line = directive.line;
    include.last_line = arguments.empty() ? directive.line : arguments.back().line;
    if (arguments.size() == 1 && arguments.front().kind == Token::Kind::string)
        include.file = arguments.front().text.substr(1, arguments.front().text.size() - 2);
    if (arguments.size() > 2 && arguments.front().is("<"))
        include.given = name_between(arguments);
    return include;
}

ShaderText text_from(std::string_view bytes) {
    ShaderText found;
    found.file_size = bytes.size();
    if (bytes.size() > ShaderFiles::max_bytes)
        return found;
    const std::string scanned = without_line_directives(with_plain_line_ends(bytes));
    found.text = scanned;
    const Tokens tokens = scan(scanned);
    found.unclosed_comment = tokens.unclosed_comment;
    for (const Directive& directive : find_directives(scanned, tokens)) {
        if (is_once(directive)) {
            found.is_once = true;
            blank_out(found.text, directive.begin, directive.end);
        }
        if (directive.name == "include")
            found.includes.push_back(include_of(directive));
    }
    return found;
}
}  // namespace

void ShaderFiles::begin_reading() {
    std::erase_if(m_known, [this](const auto& known) { return known.second.asked < m_reading; });
    m_canonical_paths.clear();
    ++m_reading;
    for (auto& [file, known] : m_known) {
        if (!known.stamp || known.stamp != stamp_of(file))
            continue;
        known.reading = m_reading;
        m_canonical_paths.emplace(file, known.canonical);
    }
}

// File timestamps have a resolution of up to two seconds. A file written twice within one tick has
// the same stamp, so recent stamps are not used.
std::optional<FileStamp> ShaderFiles::stamp_of(const fs::path& file) const {
    constexpr std::int64_t longest_tick = 3;  // seconds
    const std::optional<FileStamp> stamp = m_read_stamp ? m_read_stamp(file) : std::nullopt;
    if (!stamp || std::time(nullptr) - stamp->newest_seconds() <= longest_tick)
        return std::nullopt;
    return stamp;
}

const fs::path& ShaderFiles::canonical_path(const fs::path& path) {
    const auto [known, is_new] = m_canonical_paths.try_emplace(path.native());
    std::error_code missing;
    if (is_new)
        known->second = fs::canonical(path, missing);
    return known->second;
}

ShaderFiles::Known& ShaderFiles::known(const fs::path& file) {
    const auto [at, is_new] = m_known.try_emplace(file.native());
    Known& known = at->second;
    known.asked = m_reading;
    if (!is_new && known.reading == m_reading)
        return known;
    known.reading = m_reading;
    known.stamp = stamp_of(file);
    known.canonical = canonical_path(file);
    ++m_reads;
    Result<std::string> bytes = read_text(file);
    if (is_new || bytes != known.bytes) {
        known.found.reset();
        known.bytes = std::move(bytes);
    }
    return known;
}

const Result<ShaderText>& ShaderFiles::read(const fs::path& file) {
    Known& text = known(file);
    if (!text.found && text.bytes)
        text.found = text_from(*text.bytes);
    else if (!text.found)
        text.found = fail(text.bytes.error());
    if (*text.found)
        (*text.found)->canonical = canonical_path(file);
    return *text.found;
}

const Result<std::string>& ShaderFiles::read_plain(const fs::path& file) {
    return known(file).bytes;
}

bool ShaderFiles::exists(const fs::path& file) {
    return !canonical_path(file).empty();
}
