// The reference of start_bench.py: a GLFW window with an OpenGL 4.1 context, cleared and shown.
// Prints a line once it is shown, and stays open until its stdin is closed.
#include <epoxy/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cstdio>
#include <cstdlib>

int main() {
    if (!glfwInit())
        return EXIT_FAILURE;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    GLFWwindow* window = glfwCreateWindow(1280, 720, "plain", nullptr, nullptr);
    if (!window)
        return EXIT_FAILURE;
    glfwMakeContextCurrent(window);
    glClear(GL_COLOR_BUFFER_BIT);
    glfwSwapBuffers(window);
    std::puts("shown");
    std::fflush(stdout);
    static_cast<void>(std::getchar());
    glfwTerminate();
    return EXIT_SUCCESS;
}
