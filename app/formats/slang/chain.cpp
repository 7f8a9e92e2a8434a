#include "formats/slang/chain.h"

#include "formats/slang/similar_file.h"
#include "formats/slang/slang_text.h"
#include "formats/slang/wildcards.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace fs = std::filesystem;

namespace {
constexpr std::size_t max_open_presets = 16;
constexpr int max_references = 256;

class ChainReader {
public:
    ChainReader(const fs::path& opened, SlangFiles& files, Diagnostics& warnings)
        : m_opened(opened), m_files(files), m_warnings(warnings) {}

    // The settings of `file` and of its references, in the order of application, the owner first.
    // If passes are `wanted`, the first file must be an owner; otherwise none may be.
    Result<std::vector<SlangSettings>> read(const fs::path& file, bool are_passes_wanted) {
        auto own = read_slang_settings(file, m_files, m_warnings);
        if (!own)
            return fail(own.error());
        const SlangSetting* shaders = own->find("shaders");
        if (own->references.empty() && are_passes_wanted && !shaders)
            return fail(without_passes(file));
        if (shaders && !are_passes_wanted)
            return fail(
                {shaders->declared.file, shaders->declared.line,
                 "this file has passes, but only the first #reference of a preset may lead to "
                 "passes"});
        if (shaders && !own->references.empty())
            m_warnings.push_back(
                {shaders->declared.file, shaders->declared.line,
                 "the passes of this file are ignored; those of its #reference are used",
                 Severity::warning});
        std::vector<SlangSettings> all;
        m_open.push_back(real_path(file));
        for (std::size_t i = 0; i < own->references.size(); ++i) {
            auto more = follow(own->references[i], are_passes_wanted && i == 0);
            if (!more)
                return more;
            std::ranges::move(*more, std::back_inserter(all));
        }
        m_open.pop_back();
        all.push_back(std::move(*own));
        return all;
    }

private:
    Result<std::vector<SlangSettings>> follow(const SlangSetting& reference,
                                              bool are_passes_wanted) {
        const Location& at = reference.declared;
        const auto refuse = [&](std::string message) {
            return fail({at.file, at.line, std::move(message)});
        };
        if (std::string fault = fault_of_slang_path(reference.value); !fault.empty())
            return refuse(std::move(fault));
        const fs::path file = find_slang_file(reference.value, at.file, m_opened, m_files);
        const auto text = m_files.read(file);
        if (!text) {
            const std::string& reason = text.error().front().message;
            const std::string hint = similar_file(file, at.file);
            if (are_passes_wanted)
                return refuse(fmt::format("can't read '{}' ({}): {}{}", reference.value,
                                          file.string(), reason, hint));
            // Like RetroArch, ignores a missing file of values.
            m_warnings.push_back({at.file, at.line,
                                  fmt::format("can't read '{}' ({}): {}{}; its values are ignored",
                                              reference.value, file.string(), reason, hint),
                                  Severity::warning});
            return std::vector<SlangSettings>();
        }
        if (std::string fault = m_files.count_settings(**text); !fault.empty())
            return refuse(std::move(fault));
        if (const auto open = std::ranges::find(m_open, real_path(file)); open != m_open.end()) {
            std::string chain;
            for (auto link = open; link != m_open.end(); ++link)
                chain += link->filename().string() + " -> ";
            return refuse(
                fmt::format("circular #reference: {}{}", chain, open->filename().string()));
        }
        if (m_open.size() >= max_open_presets)
            return refuse(fmt::format("references are nested deeper than the limit of {} levels",
                                      max_open_presets));
        if (++m_followed > max_references)
            return refuse(
                fmt::format("the preset has more references than the limit of {}", max_references));
        return read(file, are_passes_wanted);
    }

    static fs::path real_path(const fs::path& file) {
        std::error_code unknown;
        const fs::path real = fs::canonical(file, unknown);
        return real.empty() ? file : real;
    }

    Diagnostic without_passes(const fs::path& file) const {
        if (m_open.empty())
            return {file, 1,
                    "this preset contains values but no passes ('shaders'). Open a preset that "
                    "references it."};
        return {file, 1,
                fmt::format(
                    "this preset contains values but no passes ('shaders'), so '{}' has nothing "
                    "to draw",
                    m_opened.filename().string())};
    }

    const fs::path& m_opened;
    SlangFiles& m_files;
    Diagnostics& m_warnings;
    std::vector<fs::path> m_open;  // from the opened preset to the current one
    int m_followed = 0;
};
}  // namespace

Result<SlangChain> read_slang_chain(const fs::path& file, SlangFiles& files,
                                    Diagnostics& warnings) {
    if (const auto text = files.read(file))
        files.count_settings(**text);  // a single file is never too large
    auto all = ChainReader(file, files, warnings).read(file, true);
    if (!all)
        return fail(all.error());
    SlangChain chain;
    chain.owner = std::move(all->front());
    chain.changes.assign(std::make_move_iterator(all->begin() + 1),
                         std::make_move_iterator(all->end()));
    return chain;
}
