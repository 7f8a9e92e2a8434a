#pragma once

#include <cstdio>
#include <string>
#include <unistd.h>

/// Captures what the process, libraries included, writes to stderr while this object exists.
class CapturedErrors {
public:
    CapturedErrors() : m_stderr(dup(STDERR_FILENO)), m_file(std::tmpfile()) {
        dup2(fileno(m_file), STDERR_FILENO);
    }
    ~CapturedErrors() {
        put_back();
        std::fclose(m_file);
    }
    CapturedErrors(const CapturedErrors&) = delete;
    CapturedErrors& operator=(const CapturedErrors&) = delete;

    std::string text() {
        put_back();
        std::rewind(m_file);
        std::string all;
        for (int letter = std::fgetc(m_file); letter != EOF; letter = std::fgetc(m_file))
            all += static_cast<char>(letter);
        return all;
    }

private:
    void put_back() {
        if (m_stderr < 0)
            return;
        std::fflush(stderr);
        dup2(m_stderr, STDERR_FILENO);
        close(m_stderr);
        m_stderr = -1;
    }

    int m_stderr;
    std::FILE* m_file;
};
