#include "fuzz/fuzz_files.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {
fs::path memory_folder() {
    std::error_code error;
    const fs::path memory = "/dev/shm";
    return fs::is_directory(memory, error) ? memory : fs::temp_directory_path();
}
}  // namespace

FuzzFolder::FuzzFolder(std::vector<std::string> names)
    : m_folder(memory_folder() / fmt::format("afterglow-fuzz-{}", ::getpid())),
      m_names(std::move(names)),
      m_texts(m_names.size()),
      m_is_there(m_names.size(), false) {
    for (std::size_t i = 0; i < m_names.size(); ++i)
        fs::create_directories(file(i).parent_path());
}

FuzzFolder::~FuzzFolder() {
    std::error_code error;
    fs::remove_all(m_folder, error);
}

void FuzzFolder::fill(std::string_view input) {
    const std::vector<std::string_view> pieces = split(input, '\f');
    for (std::size_t i = 0; i < m_names.size(); ++i) {
        const bool is_there = i < pieces.size();
        if (is_there == m_is_there[i] && (!is_there || m_texts[i] == pieces[i]))
            continue;
        m_is_there[i] = is_there;
        if (!is_there) {
            fs::remove(file(i));
            continue;
        }
        m_texts[i] = pieces[i];
        std::ofstream(file(i), std::ios::binary) << m_texts[i];
    }
}

void FuzzFolder::write(std::size_t index, std::string_view bytes) {
    std::ofstream(file(index), std::ios::binary) << bytes;
}

void require(bool is_kept, const char* rule) {
    if (is_kept)
        return;
    std::fprintf(stderr, "a rule is broken: %s\n", rule);
    std::abort();
}

void require_reasons(const Diagnostics& errors) {
    require(has_errors(errors), "what is refused says why");
    for (const Diagnostic& error : errors)
        require(!error.message.empty() && !error.file.empty(), "a reason names its file");
}

void require_messages(const Diagnostics& errors) {
    require(has_errors(errors), "what is refused says why");
    for (const Diagnostic& error : errors)
        require(!error.message.empty(), "an error has a message");
}

void require_locations(const Stage& stage) {
    const auto ends = static_cast<std::size_t>(std::ranges::count(*stage.text, '\n'));
    const bool is_open = !stage.text->empty() && stage.text->back() != '\n';
    require(stage.lines.size() == ends + (is_open ? 1 : 0), "every line has a place");
}

// The name that libFuzzer calls.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,  // NOLINT
                                      std::size_t size) {
    fuzz_one({reinterpret_cast<const char*>(data), size});
    return 0;
}
