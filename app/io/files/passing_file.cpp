#include "io/files/passing_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <mutex>
#include <unistd.h>

namespace {
// A signal's handler can reach nothing else.
constexpr std::size_t most_kept = 16;
constexpr std::size_t longest_name = 4096;
struct PassingName {
    std::atomic<bool> is_set = false;
    std::array<char, longest_name> text{};  // here, as the owner's may end beside the handler
};
std::array<PassingName, most_kept> passing_names{};

// Of whoever makes or ends such a file, on any thread; the handler never takes it.
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

// Without a free one, or for a longer name, the file only goes with its owner. To be called with
// the mutex held.
std::size_t take_slot(const std::string& name) {
    if (name.size() >= longest_name)
        return most_kept;
    std::size_t slot = 0;
    while (slot < most_kept && passing_names[slot].is_set)
        ++slot;
    if (slot < most_kept) {
        *std::copy(name.begin(), name.end(), passing_names[slot].text.begin()) = '\0';
        passing_names[slot].is_set = true;
    }
    return slot;
}

bool is_any_left() {
    return std::any_of(passing_names.begin(), passing_names.end(),
                       [](const PassingName& name) { return name.is_set.load(); });
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
    m_slot = take_slot(m_name);
    replace_handlers(SIG_DFL, remove_and_end);
}

PassingFile::~PassingFile() {
    ::unlink(m_name.c_str());
    const std::lock_guard lock(passing_mutex());
    if (m_slot < most_kept)
        passing_names[m_slot].is_set = false;
    if (!is_any_left())  // the next one's handlers are the same
        replace_handlers(remove_and_end, SIG_DFL);
}
