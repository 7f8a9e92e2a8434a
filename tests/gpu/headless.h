#pragma once

#include "gpu/error_log.h"
#include "gpu/headless_context.h"

#include <doctest/doctest.h>

/// A context for one test case. It fails on any GL error.
struct Headless {
    Headless() {
        REQUIRE(context.has_value());
        log = std::make_unique<gpu::ErrorLog>();
    }
    ~Headless() {
        for (const std::string& error : log->take())
            FAIL_CHECK(error);
    }
    Headless(const Headless&) = delete;
    Headless& operator=(const Headless&) = delete;

    Result<std::unique_ptr<gpu::Context>> context = gpu::create_headless_context();
    std::unique_ptr<gpu::ErrorLog> log;
};
