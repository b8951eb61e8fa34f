#pragma once

// OpenGL with its functions, as OSMesa exports them.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>

#include <GL/glext.h>
