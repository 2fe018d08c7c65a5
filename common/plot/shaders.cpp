#include "common/plot/shaders.hpp"

#include <stdexcept>
#include <string>

#include "common/plot/shaders_source.hpp"

namespace plot {
namespace {

GLuint compile(GLenum kind, std::initializer_list<const char*> parts) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, static_cast<GLsizei>(parts.size()), parts.begin(), nullptr);
    glCompileShader(shader);
    return shader;
}

}  // namespace

Program::Program(const char* vertex_source, const char* fragment_source) : id_{glCreateProgram()} {
    const std::array shaders{compile(GL_VERTEX_SHADER, {source::prelude, vertex_source}),
                             compile(GL_FRAGMENT_SHADER, {fragment_source})};
    std::string log;
    const auto note = [&log](auto get_log, GLuint object) {
        std::array<char, 1024> text{};
        get_log(object, static_cast<GLsizei>(text.size()), nullptr, text.data());
        log += text.data();
    };
    for (const GLuint shader : shaders) {
        glAttachShader(id_, shader);
        note(glGetShaderInfoLog, shader);
        glDeleteShader(shader);  // lives on until the program goes
    }
    glLinkProgram(id_);
    note(glGetProgramInfoLog, id_);
    GLint linked = GL_FALSE;
    glGetProgramiv(id_, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        glDeleteProgram(id_);
        throw std::logic_error{"shader: " + log};
    }
}

Program::~Program() {
    glDeleteProgram(id_);
}

void Program::use(int width, int height) const {
    glUseProgram(id_);
    set("target_size", static_cast<float>(width), static_cast<float>(height));
}

GLint Program::location(const char* uniform) const {
    return glGetUniformLocation(id_, uniform);
}
void Program::set(const char* uniform, float a) const {
    glUniform1f(location(uniform), a);
}
void Program::set(const char* uniform, float a, float b) const {
    glUniform2f(location(uniform), a, b);
}
void Program::set(const char* uniform, int a) const {
    glUniform1i(location(uniform), a);
}

void Program::set_colour(const char* uniform, const std::array<std::uint8_t, 4>& colour) const {
    const auto part = [](std::uint8_t value) { return static_cast<float>(value) / 255.0F; };
    const float alpha = part(colour[3]);
    glUniform4f(location(uniform), part(colour[0]) * alpha, part(colour[1]) * alpha, part(colour[2]) * alpha,
                alpha);
}

Programs::Programs()
    : capsules{source::capsule_vertex, source::capsule_fragment},
      mask{source::box_vertex, source::mask_fragment},
      flat{source::box_vertex, source::flat_fragment},
      triangles{source::triangle_vertex, source::triangle_fragment},
      resolve{source::box_vertex, source::resolve_fragment},
      discs{source::disc_vertex, source::disc_fragment},
      markers{source::marker_vertex, source::marker_fragment},
      glyphs{source::glyph_vertex, source::glyph_fragment} {}

}  // namespace plot
