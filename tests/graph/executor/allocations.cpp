#include "graph/executor/allocations.h"

#include <cstdlib>
#include <new>

namespace {
thread_local bool is_counting = false;
thread_local int counted = 0;
}  // namespace

void count_allocations(bool is_on) {
    is_counting = is_on;
}

int allocations() {
    return counted;
}

// In a separate file, so that the compiler does not optimise only one function of the pair.
void* operator new(std::size_t size) {
    if (is_counting)
        ++counted;
    if (void* memory = std::malloc(size))
        return memory;
    throw std::bad_alloc();
}

void operator delete(void* memory) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
