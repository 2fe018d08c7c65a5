#pragma once
#include <memory>
#include <string>

namespace plot {

/// An OpenGL 3.3 core context without a window: OSMesa, or EGL without a surface (chosen when CMake runs).
/// It has no usable framebuffer of its own; everything is drawn into framebuffer objects.
class Context {
  public:
    /// Throws app::IoError naming what is missing and its Debian package. The context is current afterwards.
    Context();
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// Makes OpenGL calls of this thread go here. Cheap if they do already.
    void make_current() const;
    /// "OSMesa, 4.5 core, Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string description() const;

  private:
    struct Handle;
    std::unique_ptr<Handle> handle_;
};

}  // namespace plot
