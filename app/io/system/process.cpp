#include "io/system/process.h"

#include <csignal>
#include <cstdlib>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

extern char** environ;

namespace {
constexpr const char* program_link = "/proc/self/exe";
}

int process_id() {
    return ::getpid();
}

std::filesystem::path program_file() {
    std::error_code error;
    return std::filesystem::read_symlink(program_link, error);
}

std::string program_command() {
    return program_link;
}

bool is_in_path(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (::access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0)
            return true;
    return false;
}

int start_detached(const std::vector<std::string>& command, std::function<void(int)> ended) {
    std::vector<char*> arguments;
    for (const std::string& word : command)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_t process = 0;
    const int error =
        ::posix_spawnp(&process, arguments[0], nullptr, nullptr, arguments.data(), environ);
    if (error == 0)
        std::thread([process, ended = std::move(ended)] {
            int status = 0;
            if (::waitpid(process, &status, 0) == process && ended)
                ended(WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status));
        }).detach();
    return error;
}

void crash_process() {
    std::raise(SIGSEGV);
}
