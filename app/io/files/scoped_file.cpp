#include "io/files/scoped_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <mutex>
#include <unistd.h>

namespace {
// Static data only: a signal handler can access nothing else.
constexpr std::size_t max_kept = 16;
constexpr std::size_t longest_name = 4096;
struct PassingName {
    std::atomic<bool> is_set = false;
    std::array<char, longest_name> text{};  // a copy: the owner's text may be destroyed while the
                                            // handler runs
};
std::array<PassingName, max_kept> passing_names{};

// Locked to add or remove a file, on any thread; the handler never locks it.
std::mutex& passing_mutex() {
    static std::mutex mutex;
    return mutex;
}

void remove_and_end(int number) {
    for (const PassingName& name : passing_names)
        if (name.is_set)
            ::unlink(name.text.data());
    (void)std::signal(number, SIG_DFL);
    (void)std::raise(number);
}

// Without a free slot, or if the name is too long, only the destructor removes the file. Call with
// the mutex locked.
std::size_t take_slot(const std::string& name) {
    if (name.size() >= longest_name)
        return max_kept;
    std::size_t slot = 0;
    while (slot < max_kept && passing_names[slot].is_set)
        ++slot;
    if (slot < max_kept) {
        *std::copy(name.begin(), name.end(), passing_names[slot].text.begin()) = '\0';
        passing_names[slot].is_set = true;
    }
    return slot;
}

bool is_any_left() {
    return std::any_of(passing_names.begin(), passing_names.end(),
                       [](const PassingName& name) { return name.is_set.load(); });
}

// Replaces one handler by another; keeps any other handler of the program or its parent.
void replace_handlers(void (*from)(int), void (*to)(int)) {
    struct sigaction action = {};
    action.sa_handler = to;
    for (const int ending : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction current = {};
        ::sigaction(ending, nullptr, &current);
        if (current.sa_handler == from)
            ::sigaction(ending, &action, nullptr);
    }
}
}  // namespace

ScopedFile::ScopedFile(const std::filesystem::path& file) : m_name(file.string()) {
    const std::lock_guard lock(passing_mutex());
    m_slot = take_slot(m_name);
    replace_handlers(SIG_DFL, remove_and_end);
}

ScopedFile::~ScopedFile() {
    ::unlink(m_name.c_str());
    const std::lock_guard lock(passing_mutex());
    if (m_slot < max_kept)
        passing_names[m_slot].is_set = false;
    if (!is_any_left())  // the next file installs the handlers again
        replace_handlers(remove_and_end, SIG_DFL);
}
