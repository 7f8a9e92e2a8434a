#pragma once

/// Sets a variable of this process's environment, also for its later children. Call it while no
/// other thread reads the environment.
void set_environment(const char* name, const char* value);

/// Removes a variable; false on failure.
bool unset_environment(const char* name);
