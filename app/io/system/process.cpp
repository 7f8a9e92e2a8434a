#include "io/system/process.h"

#include <csignal>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

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

int start_detached(const std::vector<std::string>& command) {
    std::vector<char*> arguments;
    for (const std::string& word : command)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_t process = 0;
    const int error =
        ::posix_spawnp(&process, arguments[0], nullptr, nullptr, arguments.data(), environ);
    if (error == 0)
        std::thread([process] { ::waitpid(process, nullptr, 0); }).detach();
    return error;
}

void crash_process() {
    std::raise(SIGSEGV);
}
