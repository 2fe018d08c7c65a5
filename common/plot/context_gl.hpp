#pragma once
/// OpenGL with all functions declared: the libraries that are linked export them, no loader is needed.
#define GL_GLEXT_PROTOTYPES 1
#include <GL/gl.h>
#include <GL/glext.h>
