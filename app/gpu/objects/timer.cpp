#include "gpu/objects/timer.h"

namespace gpu {

void delete_query(GLuint id) {
    glDeleteQueries(1, &id);
}

GLuint Timer::new_query() {
    GLuint id = 0;
    glGenQueries(1, &id);
    return id;
}

Timer::Timer()
    : m_queries{Name<delete_query>(new_query()), Name<delete_query>(new_query()),
                Name<delete_query>(new_query()), Name<delete_query>(new_query())} {}

void Timer::begin(int parts) {
    collect();
    m_is_open = m_begun - m_read < ring;  // skips this frame if all queries are pending
    if (!m_is_open)
        return;
    m_parts[m_begun % ring] = parts;
    glBeginQuery(GL_TIME_ELAPSED, m_queries[m_begun++ % ring].get());
}

void Timer::end() {
    if (m_is_open)
        glEndQuery(GL_TIME_ELAPSED);
    m_is_open = false;
}

void Timer::set_elapsed(double milliseconds, int parts) {
    m_read = m_begun;  // pending queries are older
    m_milliseconds = milliseconds;
    m_measured_parts = parts;
}

void Timer::collect() {
    while (m_read < m_begun) {
        const GLuint query = m_queries[m_read % ring].get();
        GLint is_there = 0;
        glGetQueryObjectiv(query, GL_QUERY_RESULT_AVAILABLE, &is_there);
        if (!is_there)
            return;
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
        if (m_read > 0) {  // skips the first query, which includes shader compilation
            m_milliseconds = static_cast<double>(nanoseconds) * 1e-6;
            m_measured_parts = m_parts[m_read % ring];
        }
        ++m_read;
    }
}

std::optional<double> Timer::milliseconds() {
    if (!m_is_open)
        collect();
    return m_milliseconds;
}

std::optional<double> Timer::milliseconds_per_part() {
    const auto all = milliseconds();
    if (!all)
        return all;
    return *all / m_measured_parts;
}

}  // namespace gpu
