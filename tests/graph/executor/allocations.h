#pragma once

/// Starts or stops counting the allocations of this thread by `new`. Threads of the driver do not
/// count.
void count_allocations(bool is_on);
/// The number of allocations counted so far.
int allocations();
