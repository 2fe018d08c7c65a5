#include "common/plot/context.hpp"

#include <cstdlib>

#include "common/app/error.hpp"
#include "common/plot/context_gl.hpp"

#ifdef SPH_RENDERER_EGL
#define EGL_NO_X11  // keeps the headers of a window system out
#include <EGL/egl.h>
#include <EGL/eglext.h>
#else
#include <GL/osmesa.h>

#include <array>
#endif

#ifdef SPH_SANITIZED
// Read by the leak detector: Mesa keeps some bytes of each context until the process ends.
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() {
    return "print_suppressions=0";
}
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libOSMesa\nleak:libEGL_mesa\nleak:libEGL\nleak:swrast_dri\nleak:libgallium\n";
}
#endif

namespace plot {

#ifdef SPH_RENDERER_EGL

struct Context::Handle {
    static constexpr const char* name = "EGL";
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    Handle() {
        // Without this, EGL may draw on a graphics card, whose pictures differ from machine to machine.
        ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
        display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) ||
            !eglBindAPI(EGL_OPENGL_API))
            fail();
        // clang-format off
        constexpr EGLint attributes[] = {
            EGL_CONTEXT_MAJOR_VERSION, 3,
            EGL_CONTEXT_MINOR_VERSION, 3,
            EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
            EGL_NONE};
        // clang-format on
        context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
        if (context == EGL_NO_CONTEXT) fail();
    }
    // The display belongs to the process, not to one context: eglTerminate would end the other contexts too.
    ~Handle() {
        if (is_current()) eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    bool is_current() const { return context != EGL_NO_CONTEXT && eglGetCurrentContext() == context; }
    bool take() const { return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE; }
    [[noreturn]] static void fail() {
        throw app::IoError{
            "EGL gives no OpenGL 3.3 context without a window; on Debian: "
            "apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri"};
    }
};

#else

struct Context::Handle {
    static constexpr const char* name = "OSMesa";
    OSMesaContext context = nullptr;
    mutable std::array<GLubyte, 4> picture{};  // OSMesa demands a pixel; nothing is drawn there

    Handle() {
        // clang-format off
        constexpr int attributes[] = {
            OSMESA_FORMAT, OSMESA_RGBA,
            OSMESA_PROFILE, OSMESA_CORE_PROFILE,
            OSMESA_CONTEXT_MAJOR_VERSION, 3,
            OSMESA_CONTEXT_MINOR_VERSION, 3,
            0};
        // clang-format on
        context = OSMesaCreateContextAttribs(attributes, nullptr);
        if (context == nullptr) fail();
    }
    ~Handle() {
        if (is_current()) OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        OSMesaDestroyContext(context);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    bool is_current() const { return OSMesaGetCurrentContext() == context; }
    bool take() const {
        return OSMesaMakeCurrent(context, picture.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_TRUE;
    }
    [[noreturn]] static void fail() {
        throw app::IoError{"OSMesa gives no OpenGL 3.3 context; on Debian: apt-get install libosmesa6"};
    }
};

#endif

Context::Context() : handle_{std::make_unique<Handle>()} {
    make_current();
}

Context::~Context() = default;

void Context::make_current() const {
    if (!handle_->is_current() && !handle_->take()) Handle::fail();
}

std::string Context::description() const {
    make_current();
    const auto text = [](GLenum what) {
        const auto* bytes = reinterpret_cast<const char*>(glGetString(what));
        return std::string{bytes == nullptr ? "?" : bytes};
    };
    // "4.5 (Core Profile) Mesa 22.3.6"
    std::string version = text(GL_VERSION);
    const std::string profile = " (Core Profile) ";
    if (const auto at = version.find(profile); at != std::string::npos)
        version.replace(at, profile.size(), " core, ");
    return std::string{Handle::name} + ", " + version + ", " + text(GL_RENDERER);
}

}  // namespace plot
