#include "formats/slang/files.h"

#include "base/file.h"
#include "base/text.h"

#include <algorithm>

namespace fs = std::filesystem;

namespace {
constexpr std::size_t max_text_bytes = std::size_t{4} << 20;
constexpr std::size_t max_settings_bytes = std::size_t{8} << 20;

// "\r\n", a single "\r" and "\n" are line ends.
std::string with_newlines(std::string text) {
    if (text.find('\r') != std::string::npos) {
        std::size_t end = 0;
        for (std::size_t i = 0; i < text.size(); ++i) {
            const bool is_pair = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
            if (!is_pair)
                text[end++] = text[i] == '\r' ? '\n' : text[i];
        }
        text.resize(end);
    }
    if (!text.empty() && text.back() != '\n')
        text += '\n';
    return text;
}

std::shared_ptr<const SlangParameter> parameter_of(const SlangDirective& directive,
                                                   const fs::path& file) {
    if (directive.kind != SlangDirective::Kind::parameter)
        return nullptr;
    auto parameter = parse_slang_parameter(directive.argument, {file, directive.line});
    return parameter ? std::make_shared<const SlangParameter>(std::move(*parameter)) : nullptr;
}
}  // namespace

Result<const SlangText*> SlangFiles::read(const fs::path& file) {
    const auto known = m_by_name.find(file.native());
    if (known != m_by_name.end())
        return known->second;
    note(file);
    return m_by_name.emplace(file.native(), read_anew(file)).first->second;
}

Result<const SlangText*> SlangFiles::read_anew(const fs::path& file) {
    std::error_code error;
    fs::path real = fs::canonical(file, error);
    if (error)
        real = file;
    const auto known = m_by_real_name.find(real.native());
    if (known != m_by_real_name.end())
        return known->second.get();
    auto text = read_text(file);
    if (!text)
        return fail(text.error());
    if (text->size() > max_text_bytes)
        return fail({file, 0, "the file is larger than the limit of 4 MiB"});
    auto made = std::make_unique<SlangText>();
    made->file = file;
    made->real = real;
    made->text = with_newlines(std::move(*text));
    made->line_count = static_cast<int>(std::ranges::count(made->text, '\n'));
    made->directives = find_slang_directives(made->text);
    for (const SlangDirective& directive : made->directives)
        made->parameters.push_back(parameter_of(directive, file));
    return m_by_real_name.emplace(real.native(), std::move(made)).first->second.get();
}

std::string SlangFiles::count_settings(const SlangText& text) {
    m_settings_bytes += text.text.size();
    return m_settings_bytes <= max_settings_bytes
               ? std::string()
               : "the preset with its references and includes is larger than the limit of 8 MiB";
}

void SlangFiles::note(const fs::path& file) {
    if (m_noted.insert(file.native()).second)
        m_seen.push_back(file);
}

bool is_slang_shader(const fs::path& file) {
    return to_lower(file.extension().string()) == ".slang";
}

fs::path sibling_path(const fs::path& file, std::string_view written) {
    std::string path(written);
    std::ranges::replace(path, '\\', '/');
    return (file.parent_path() / path).lexically_normal();
}
