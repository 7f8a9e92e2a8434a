#include "io/passing_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <mutex>
#include <unistd.h>

namespace {
// A signal's handler can reach nothing else.
constexpr std::size_t most_kept = 16;
std::array<std::atomic<const char*>, most_kept> passing_names{};

// Of whoever makes or ends such a file, on any thread; the handler never takes it.
std::mutex& passing_mutex() {
    static std::mutex mutex;
    return mutex;
}

void remove_and_end(int number) {
    for (const std::atomic<const char*>& name : passing_names)
        if (const char* file = name.load())
            ::unlink(file);
    (void)std::signal(number, SIG_DFL);
    (void)std::raise(number);
}

std::size_t take_slot(const char* name) {
    std::size_t slot = 0;
    for (; slot < most_kept; ++slot) {
        const char* nothing = nullptr;
        if (passing_names[slot].compare_exchange_strong(nothing, name))
            break;
    }
    return slot;  // without a free one the file only goes with its owner
}

bool is_any_left() {
    return std::any_of(passing_names.begin(), passing_names.end(),
                       [](const std::atomic<const char*>& name) { return name != nullptr; });
}

// From one handler to another; one that the program or its parent has chosen stays.
void replace_handlers(void (*from)(int), void (*to)(int)) {
    struct sigaction action = {};
    action.sa_handler = to;
    for (const int ending : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction present = {};
        ::sigaction(ending, nullptr, &present);
        if (present.sa_handler == from)
            ::sigaction(ending, &action, nullptr);
    }
}
}  // namespace

PassingFile::PassingFile(const std::filesystem::path& file) : m_name(file.string()) {
    const std::lock_guard lock(passing_mutex());
    m_slot = take_slot(m_name.c_str());
    replace_handlers(SIG_DFL, remove_and_end);
}

PassingFile::~PassingFile() {
    ::unlink(m_name.c_str());
    const std::lock_guard lock(passing_mutex());
    if (m_slot < most_kept)
        passing_names[m_slot] = nullptr;
    if (!is_any_left())  // the next one's handlers are the same
        replace_handlers(remove_and_end, SIG_DFL);
}
