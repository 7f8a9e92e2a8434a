#include "io/passing_file.h"

#include <atomic>
#include <unistd.h>

namespace {
// A signal's handler can reach nothing else.
constexpr std::size_t most = 4;
std::array<std::atomic<const char*>, most> passing_names{};

void remove_and_end(int number) {
    for (const std::atomic<const char*>& name : passing_names)
        if (const char* file = name.load())
            ::unlink(file);
    (void)std::signal(number, SIG_DFL);
    (void)std::raise(number);
}

std::size_t take_slot(const char* name) {
    std::size_t slot = 0;
    for (; slot < most; ++slot) {
        const char* nothing = nullptr;
        if (passing_names[slot].compare_exchange_strong(nothing, name))
            break;
    }
    return slot;  // without a free one the file only goes with its owner
}
}  // namespace

PassingFile::PassingFile(const std::filesystem::path& file)
    : m_name(file.string()), m_slot(take_slot(m_name.c_str())) {
    struct sigaction action = {};
    action.sa_handler = remove_and_end;
    for (std::size_t i = 0; i < endings.size(); ++i) {
        ::sigaction(endings[i], nullptr, &m_before[i]);
        if (m_before[i].sa_handler == SIG_DFL)
            ::sigaction(endings[i], &action, nullptr);
    }
}

PassingFile::~PassingFile() {
    for (std::size_t i = 0; i < endings.size(); ++i)
        if (m_before[i].sa_handler == SIG_DFL)
            ::sigaction(endings[i], &m_before[i], nullptr);
    if (m_slot < most)
        passing_names[m_slot] = nullptr;
    ::unlink(m_name.c_str());
}
