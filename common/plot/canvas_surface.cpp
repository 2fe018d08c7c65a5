#include "common/plot/canvas_surface.hpp"

#include <fmt/format.h>

#include "common/app/error.hpp"

namespace plot {

Surface::Surface(int width, int height, Format format) : width_{width}, height_{height}, format_{format} {
    const bool colour = format == Format::colour;
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, colour ? GL_RGBA8 : GL_R8, width, height, 0, colour ? GL_RGBA : GL_RED,
                 GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (glGetError() != GL_NO_ERROR || !complete) {
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteTextures(1, &texture_);
        throw app::IoError{fmt::format("OpenGL has no memory for {} x {} pixels", width, height)};
    }
}

Surface::~Surface() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &texture_);
}

void Surface::draw_here() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width_, height_);
}

void Surface::read_here() const {
    glBindTexture(GL_TEXTURE_2D, texture_);
}

void Surface::load(const void* bytes) const {
    glBindTexture(GL_TEXTURE_2D, texture_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RED, GL_UNSIGNED_BYTE, bytes);
}

VertexStream::VertexStream(std::size_t stride, std::initializer_list<Attribute> attributes, Step step)
    : stride_{stride} {
    glGenVertexArrays(1, &array_);
    glGenBuffers(1, &vertices_);
    glGenBuffers(1, &indices_);
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    GLuint location = 0;
    for (const Attribute& attribute : attributes) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, attribute.components, attribute.type, attribute.normalised,
                              static_cast<GLsizei>(stride), reinterpret_cast<const void*>(attribute.offset));
        glVertexAttribDivisor(location, step == Step::quad ? 1 : 0);
        ++location;
    }
}

VertexStream::~VertexStream() {
    glDeleteBuffers(1, &indices_);
    glDeleteBuffers(1, &vertices_);
    glDeleteVertexArrays(1, &array_);
}

void VertexStream::load(const void* data, std::size_t count) const {
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(stride_ * count), data, GL_STREAM_DRAW);
}

void VertexStream::draw_quads(const void* data, std::size_t count) const {
    load(data, count);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
}

void VertexStream::draw_triangles(const unsigned* indices, std::size_t count) const {
    glBindVertexArray(array_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(sizeof(unsigned) * count), indices,
                 GL_STREAM_DRAW);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT, nullptr);
}

}  // namespace plot
