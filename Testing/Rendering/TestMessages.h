/**
 * Everything that VTK and OpenGL complain about while a test runs. A test fails that leaves messages behind.
 */
#ifndef VITRINE_TEST_MESSAGES_H
#define VITRINE_TEST_MESSAGES_H

#include <string>
#include <vector>

class vtkRenderWindow;

/** Catch VTK's errors and warnings from now on, and let tests fail that leave any. */
void InstallMessageChecks();

/** Catch the errors and the undefined behaviour that OpenGL reports (KHR_debug) in the window's context. */
void WatchOpenGL(vtkRenderWindow* window);

/** The messages so far, VTK's and OpenGL's. A test that expects some takes them. */
std::vector<std::string> TakeMessages();

#endif
