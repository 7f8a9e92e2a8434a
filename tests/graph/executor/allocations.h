#pragma once

/// Starts or stops counting what this thread allocates with `new`; the driver's own threads do not
/// count.
void count_allocations(bool is_on);
/// So many were counted so far.
int allocations();
