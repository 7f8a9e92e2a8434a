#include "gpu/objects/pixel_query.h"

namespace gpu {

void delete_pixel_query(GLuint id) {
    glDeleteQueries(1, &id);
}

namespace {
GLuint new_query() {
    GLuint id = 0;
    glGenQueries(1, &id);
    return id;
}
}  // namespace

PixelQuery::PixelQuery() : m_name(new_query()) {}

void PixelQuery::begin() {
    glBeginQuery(GL_ANY_SAMPLES_PASSED, m_name.get());
}

void PixelQuery::end() {
    glEndQuery(GL_ANY_SAMPLES_PASSED);
}

bool PixelQuery::is_available() const {
    GLuint is_here = 0;
    glGetQueryObjectuiv(m_name.get(), GL_QUERY_RESULT_AVAILABLE, &is_here);
    return is_here != 0;
}

bool PixelQuery::is_any_passed() const {
    GLuint any = 0;
    glGetQueryObjectuiv(m_name.get(), GL_QUERY_RESULT, &any);
    return any != 0;
}

void PixelQuery::begin_condition() const {
    glBeginConditionalRender(m_name.get(), GL_QUERY_WAIT);
}

void PixelQuery::end_condition() {
    glEndConditionalRender();
}

}  // namespace gpu
