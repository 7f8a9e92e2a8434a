#pragma once

#include "io/system/locked_file.h"
#include "lab/storage/roots.h"

#include <string>

/// The number of this window among those that run with the same state folder, from 1. The number is
/// free again when the object or the process ends, also after a crash.
class InstanceLock {
public:
    /// Takes the lowest free number. If the state folder cannot be written, it is 1.
    static InstanceLock take(const Roots& roots);

    int number() const { return m_number; }

private:
    LockedFile m_file;
    int m_number = 1;
};

/// The name of a window's own file: "session.json" of the first, then "session-2.json".
std::string instance_file_name(const std::string& name, int instance);

/// The folders as the first window sees them.
Roots first_instance(Roots roots);
