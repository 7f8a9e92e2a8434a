// For LD_PRELOAD: writes the sockets that a program opens, other than those on this machine, and
// the programs that it starts, to the file $AFTERGLOW_CALL_LOG. One call per line.
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <string>
#include <sys/socket.h>
#include <unistd.h>

namespace {
void log_call(const std::string& line) {
    const int error = errno;
    if (const char* file = std::getenv("AFTERGLOW_CALL_LOG")) {
        const int log = ::open(file, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
        const std::string text = line + "\n";
        if (log < 0 || ::write(log, text.data(), text.size()) < 0)
            std::abort();
        ::close(log);
    }
    errno = error;
}

template <class Function>
Function* original(const char* name) {
    void* found = ::dlsym(RTLD_NEXT, name);
    Function* function = nullptr;
    std::memcpy(&function, &found, sizeof(function));
    return function;
}

using Exec = int(const char*, char* const[], char* const[]);
using ExecPath = int(const char*, char* const[]);
using Spawn = int(pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*,
                  char* const[], char* const[]);
}  // namespace

extern "C" int socket(int domain, int type, int protocol) noexcept {
    if (domain != AF_UNIX && domain != AF_NETLINK)
        log_call("socket " + std::to_string(domain));
    return original<int(int, int, int)>("socket")(domain, type, protocol);
}

extern "C" int execve(const char* path, char* const arguments[], char* const variables[]) noexcept {
    log_call(std::string("start ") + path);
    return original<Exec>("execve")(path, arguments, variables);
}

extern "C" int execv(const char* path, char* const arguments[]) noexcept {
    log_call(std::string("start ") + path);
    return original<ExecPath>("execv")(path, arguments);
}

extern "C" int execvp(const char* file, char* const arguments[]) noexcept {
    log_call(std::string("start ") + file);
    return original<ExecPath>("execvp")(file, arguments);
}

extern "C" int execvpe(const char* file, char* const arguments[],
                       char* const variables[]) noexcept {
    log_call(std::string("start ") + file);
    return original<Exec>("execvpe")(file, arguments, variables);
}

extern "C" int posix_spawn(pid_t* process, const char* path,
                           const posix_spawn_file_actions_t* actions,
                           const posix_spawnattr_t* attributes, char* const arguments[],
                           char* const variables[]) {
    log_call(std::string("start ") + path);
    return original<Spawn>("posix_spawn")(process, path, actions, attributes, arguments, variables);
}

extern "C" int posix_spawnp(pid_t* process, const char* file,
                            const posix_spawn_file_actions_t* actions,
                            const posix_spawnattr_t* attributes, char* const arguments[],
                            char* const variables[]) {
    log_call(std::string("start ") + file);
    return original<Spawn>("posix_spawnp")(process, file, actions, attributes, arguments,
                                           variables);
}
