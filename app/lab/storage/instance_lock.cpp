#include "lab/storage/instance_lock.h"

#include "io/system/process.h"

#include <fmt/format.h>

InstanceLock InstanceLock::take(const Roots& roots) {
    constexpr int most = 64;
    InstanceLock lock;
    std::error_code error;
    std::filesystem::create_directories(roots.state, error);
    for (int number = 1; number <= most; ++number) {
        LockedFile file(roots.state / fmt::format("window-{}.lock", number));
        if (!file.is_open())
            return lock;
        if (file.replace(std::to_string(process_id()))) {
            lock.m_file = std::move(file);
            lock.m_number = number;
            return lock;
        }
    }
    return lock;
}

std::string instance_file_name(const std::string& name, int instance) {
    return instance <= 1 ? name + ".json" : fmt::format("{}-{}.json", name, instance);
}

Roots first_instance(Roots roots) {
    roots.instance = 1;
    return roots;
}
